//! What a misspelt word may have meant.

/// Jaro and Winkler's likeness, 0 to 1, from which on a word is offered: letters swapped, left out or doubled.
const ALIKE: f64 = 0.75;

/// The one of `names` that is most like `unknown`, if one is at all.
pub fn closest<'a>(unknown: &str, names: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let likeness = |name| (strsim::jaro_winkler(unknown, name), name);
    let alike = names.into_iter().map(likeness).filter(|(likeness, _)| *likeness > ALIKE);
    alike.max_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, name)| name)
}

#[cfg(test)]
mod tests {
    use super::closest;

    #[test]
    fn near_words_are_found_and_far_ones_are_not() {
        let names = ["render", "fly", "check", "truth"];
        for (unknown, wanted) in
            [("rendr", Some("render")), ("turth", Some("truth")), ("chekc", Some("check")), ("sky", None), ("", None)]
        {
            assert_eq!(closest(unknown, names), wanted, "{unknown}");
        }
    }
}
