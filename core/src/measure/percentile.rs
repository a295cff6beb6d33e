//! Percentiles by nearest rank: the least value that a given share of all values don't exceed. No value is invented
//! between two, and the answer does not depend on the values' order.
//!
//! [`percentile`] is exact. [`Histogram`] takes values as they come, as many as there are, and keeps 2 MB: floats that
//! are not negative are ordered as their bits are, so the upper bits number its bins, 1,024 for each doubling.

/// The value that `share` (0 to 1) of `values` don't exceed; 0 for no values. Values are not negative; NaN counts as
/// larger than all.
pub fn percentile(values: &[f32], share: f64) -> f32 {
    let mut bits: Vec<u32> = values.iter().copied().map(ordered_bits).collect();
    match rank(bits.len() as u64, share) {
        Some(rank) => f32::from_bits(*bits.select_nth_unstable(rank as usize).1),
        None => 0.0,
    }
}

/// Which of `count` sorted values, from 0: the ⌈share · count⌉-th, at least the first; none of none.
fn rank(count: u64, share: f64) -> Option<u64> {
    let nth = libm::ceil(share.clamp(0.0, 1.0) * count as f64) as u64;
    (count > 0).then(|| nth.clamp(1, count) - 1)
}

/// Ordered as the values are; what is below 0, and −0, is 0.
fn ordered_bits(value: f32) -> u32 {
    if value <= 0.0 { 0 } else { value.to_bits() & !(1 << 31) }
}

/// Counts values by size, to ask for percentiles of more of them than memory holds.
#[derive(Debug, Clone)]
pub(super) struct Histogram {
    bins: Vec<u64>,
}

/// Keeps 10 of the 23 bits behind a float's exponent.
const SHIFT: u32 = 13;

impl Histogram {
    pub(super) fn new() -> Self {
        Self { bins: vec![0; 1 << (31 - SHIFT)] }
    }

    /// Counts a value, which is not negative.
    pub(super) fn add(&mut self, value: f32) {
        let bin = (ordered_bits(value) >> SHIFT) as usize;
        if let Some(count) = self.bins.get_mut(bin) {
            *count += 1;
        }
    }

    /// As [`percentile`] of all that was added, within 1/2,048 of itself; exact for 0.
    pub(super) fn percentile(&self, share: f64) -> f32 {
        let Some(rank) = rank(self.bins.iter().sum(), share) else { return 0.0 };
        let mut up_to = 0;
        let reached = |count: &u64| {
            up_to += count;
            up_to > rank
        };
        match self.bins.iter().position(reached) {
            None | Some(0) => 0.0,
            Some(bin) => f32::from_bits(((bin as u32) << SHIFT) + (1 << (SHIFT - 1))),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(values: &[f32], share: f64, wanted: f32) {
        assert_eq!(percentile(values, share), wanted, "{share} of {values:?}");
        let mut histogram = Histogram::new();
        values.iter().for_each(|value| histogram.add(*value));
        let got = histogram.percentile(share);
        // Half a bin of 2⁻¹⁰.
        assert!((got - wanted).abs() <= wanted / 2048.0, "{share} of {values:?} counted: {got}");
    }

    #[test]
    fn nearest_rank() {
        let five = [15.0, 50.0, 20.0, 35.0, 40.0];
        for (share, wanted) in [(0.0, 15.0), (0.05, 15.0), (0.3, 20.0), (0.4, 20.0), (0.41, 35.0), (0.5, 35.0)] {
            check(&five, share, wanted);
        }
        check(&five, 1.0, 50.0);
        check(&five, 7.0, 50.0);
        check(&five, f64::NAN, 15.0);
        check(&[], 0.5, 0.0);
        check(&[0.25], 0.999, 0.25);
        check(&[0.0, -0.0, 0.0, 3.0], 0.75, 0.0);
        let thousand: Vec<f32> = (1..=1000_u16).map(|i| f32::from(i ^ 512)).collect();
        check(&thousand, 0.999, {
            let mut sorted = thousand.clone();
            sorted.sort_unstable_by(f32::total_cmp);
            sorted[998]
        });
    }

    #[test]
    fn what_is_no_number_is_largest() {
        assert!(percentile(&[1.0, f32::NAN, -f32::NAN, f32::INFINITY], 1.0).is_nan());
        assert_eq!(percentile(&[1.0, f32::NAN, 2.0, f32::INFINITY], 0.75), f32::INFINITY);
    }
}
