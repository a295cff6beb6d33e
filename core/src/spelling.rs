//! What a misspelt word may have meant.

use std::ops::RangeInclusive;

/// Jaro and Winkler's likeness, 0 to 1, from which on a word is offered: letters swapped, left out or doubled.
const ALIKE: f64 = 0.75;
/// Of words that one letter tells apart: of very short ones the measure thinks less.
const ONE_LETTER_OFF: f64 = 0.9;
/// Shorter words might mean anything; longer ones are no misspelt names, and to compare them might take for ever.
const LETTERS: RangeInclusive<usize> = 2..=64;

/// The one of `names` that is most like `unknown`, if one is at all.
pub fn closest<'a>(unknown: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    if !LETTERS.contains(&unknown.len()) {
        return None;
    }
    let likeness = |name: &'a str| {
        let one_letter_off = name.len() > 1 && strsim::osa_distance(unknown, name) == 1;
        let least = if one_letter_off { ONE_LETTER_OFF } else { 0.0 };
        (strsim::jaro_winkler(unknown, name).max(least), name)
    };
    let alike = names.into_iter().map(likeness).filter(|(likeness, _)| *likeness > ALIKE);
    alike.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::closest;

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let names = ["render", "new", "check", "truth"];
        for (unknown, wanted) in [
            ("rendr", Some("render")),
            ("turth", Some("truth")),
            ("chekc", Some("check")),
            ("nw", Some("new")),
            ("sky", None),
            ("n", None),
            ("", None),
        ] {
            assert_eq!(closest(unknown, names), wanted, "{unknown}");
        }
        assert_eq!(closest(&"render".repeat(20), names), None);
    }
}
