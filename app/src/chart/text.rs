//! Names and numbers as they stand on a page.

use super::report::Figure;

/// What stands where there is no number.
pub const NONE: &str = "–";
/// Between groups of three digits: narrow, and no line breaks there.
const THIN_SPACE: char = '\u{202F}';

/// `text` as text of a document or value of a quoted attribute, in HTML and SVG.
pub fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            // No document may have them.
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// A measured number to three digits: 0.00412, 4.12, 41 200.
pub fn figure(figure: Figure) -> String {
    let Some(x) = figure.filter(|x| x.is_finite()) else { return NONE.into() };
    let size = x.abs();
    if size >= 100.0 {
        return if size < 1e15 { grouped(x.round()) } else { format!("{x:.2e}") };
    }
    if x == 0.0 || size < 1e-5 {
        return if x == 0.0 { "0".into() } else { format!("{x:.1e}") };
    }
    // Digits after the point: two more than zeros stand before the first digit.
    let leading = size.log10().floor() as i32;
    let places = usize::try_from(2 - leading).unwrap_or(0);
    let text = format!("{x:.places$}");
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
}

/// A number that a person chose, such as a tick or a tolerance, with all its digits: 0.02, 500, 10 000.
pub fn round_number(x: f64) -> String {
    match x.abs() {
        size if size >= 1e12 || (size > 0.0 && size < 1e-6) => format!("{x:e}"),
        1e4.. => grouped(x),
        _ => x.to_string(),
    }
}

/// "12 times", "3.4 times".
pub fn times(factor: f64) -> String {
    let places = usize::from(factor < 9.95);
    if factor < 1000.0 { format!("{factor:.places$} times") } else { "over 1000 times".into() }
}

fn grouped(x: f64) -> String {
    let digits = format!("{:.0}", x.abs());
    let mut out = String::from(if x < 0.0 { "−" } else { "" });
    for (i, digit) in digits.chars().enumerate() {
        // Four digits read well as they are.
        if i > 0 && digits.len() > 4 && (digits.len() - i) % 3 == 0 {
            out.push(THIN_SPACE);
        }
        out.push(digit);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers() {
        for (x, want) in [
            (Some(0.0), "0"),
            (Some(-0.0), "0"),
            (Some(0.004_123), "0.00412"),
            (Some(0.02), "0.02"),
            (Some(0.0999), "0.0999"),
            (Some(4.1), "4.1"),
            (Some(41.26), "41.3"),
            (Some(99.96), "100"),
            (Some(412.6), "413"),
            (Some(9999.0), "9999"),
            (Some(1_234_567.0), "1\u{202F}234\u{202F}567"),
            (Some(3.2e-7), "3.2e-7"),
            (Some(1e300), "1.00e300"),
            (Some(f64::NAN), NONE),
            (Some(f64::INFINITY), NONE),
            (None, NONE),
        ] {
            assert_eq!(figure(x), want, "{x:?}");
        }
        for (x, want) in
            [(1.04, "1.0 times"), (9.96, "10 times"), (412.0, "412 times"), (f64::INFINITY, "over 1000 times")]
        {
            assert_eq!(times(x), want);
        }
    }
}
