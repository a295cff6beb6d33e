//! Numbers of sixteen bits, as old formats have them.

use super::ExportError;

/// The largest.
pub(super) const MOST: f64 = i16::MAX as f64;

/// The nearest whole number to that one, and how far off it is. What is no number is 0.
pub(super) fn nearest(number: f64) -> (i16, f64) {
    // `as` stays within the type's range.
    let short = number.round() as i16;
    (short, number - f64::from(short))
}

/// An index.
///
/// # Errors
/// If there are more of `what` than can be told apart.
pub(super) fn index(index: usize, what: &str) -> Result<i16, ExportError> {
    index.try_into().map_err(|_| ExportError::TooMuch {
        what: format!("a cloud of more than {} {what}", i16::MAX),
        most: format!("{} of them", i16::MAX),
    })
}

#[cfg(test)]
mod tests {
    use super::{index, nearest};

    #[test]
    fn the_nearest_there_is() {
        for (number, short) in [(1.4, 1), (-1.6, -2), (1e9, i16::MAX), (-1e9, i16::MIN), (f64::NAN, 0)] {
            assert_eq!(nearest(number).0, short);
        }
        assert!(index(32_767, "boxes").is_ok() && index(32_768, "boxes").is_err());
    }
}
