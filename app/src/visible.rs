//! Text out of files and names, made so that all of it is seen.
//!
//! A name may hold what steers a terminal, turns the line about or hides in it, and a number hundreds of digits. All
//! that the program says goes through here once, where it leaves: on the terminal, in a toast, in a dialog.

use std::ops::RangeInclusive;

/// Longer numbers are cut: a double needs 17 digits, no file's name so many.
const MOST_DIGITS: usize = 40;
/// What is left of them.
const DIGITS_LEFT: usize = 12;

/// Characters without a picture that change how others look: Unicode's Default_Ignorable_Code_Point (16.0), and the
/// separators of lines and paragraphs; without the variation selectors that choose the look of many an emoji.
const UNSEEN: &[RangeInclusive<char>] = &[
    '\u{ad}'..='\u{ad}',
    '\u{34f}'..='\u{34f}',
    '\u{61c}'..='\u{61c}',
    '\u{115f}'..='\u{1160}',
    '\u{17b4}'..='\u{17b5}',
    '\u{180b}'..='\u{180f}',
    '\u{200b}'..='\u{200f}',
    '\u{2028}'..='\u{202e}',
    '\u{2060}'..='\u{206f}',
    '\u{3164}'..='\u{3164}',
    '\u{feff}'..='\u{feff}',
    '\u{ffa0}'..='\u{ffa0}',
    '\u{fff0}'..='\u{fffb}',
    '\u{1bca0}'..='\u{1bca3}',
    '\u{1d173}'..='\u{1d17a}',
    '\u{e0000}'..='\u{e0fff}',
];

fn is_unseen(c: char) -> bool {
    c.is_control() || UNSEEN.iter().any(|range| range.contains(&c))
}

/// One line of it: ends of lines and tabs become spaces, what else can't be seen becomes `\u{202e}`, and of a number of
/// hundreds of digits the first are left.
pub fn one_line(text: &str) -> String {
    let mut line = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        let taken = digits.max(c.len_utf8());
        match c {
            _ if digits > MOST_DIGITS => line.push_str(&format!("{}… ({digits} digits)", &rest[..DIGITS_LEFT])),
            '\n' | '\r' | '\t' => line.push(' '),
            c if is_unseen(c) => line.extend(c.escape_unicode()),
            _ => line.push_str(&rest[..taken]),
        }
        rest = &rest[taken..];
    }
    line
}

/// Each line of it as [`one_line`].
pub fn lines(text: &str) -> String {
    text.lines().map(one_line).collect::<Vec<_>>().join("\n")
}

/// The same JSON, what can't be seen as JSON's own escapes; its line breaks stay.
pub fn json(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        if c != '\n' && is_unseen(c) {
            c.encode_utf16(&mut [0; 2]).iter().for_each(|unit| out.push_str(&format!("\\u{unit:04x}")));
        } else {
            out.push(c);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_steers_or_hides_is_shown() {
        for (text, wanted) in [
            ("Cumulus, “Höhe” 3½ – 雲 ☁\u{fe0f} e\u{301}", "Cumulus, “Höhe” 3½ – 雲 ☁\u{fe0f} e\u{301}"),
            ("a\u{1b}[2Jb\nc\td", "a\\u{1b}[2Jb c d"),
            ("gnp.\u{202e}txt\u{200b}\u{9b}", "gnp.\\u{202e}txt\\u{200b}\\u{9b}"),
            ("\u{e0041}\u{2028}\u{7f}", "\\u{e0041}\\u{2028}\\u{7f}"),
            ("", ""),
        ] {
            assert_eq!(one_line(text), wanted);
        }
        assert_eq!(lines("a\u{7}\nb\n"), "a\\u{7}\nb");
    }

    #[test]
    fn long_numbers_are_cut() {
        let long = format!("-1{}.5 is out of range", "0".repeat(300));
        assert_eq!(one_line(&long), "-100000000000… (301 digits).5 is out of range");
        let stamp = "20261129075345123456 of 18446744073709551615";
        assert_eq!(one_line(stamp), stamp);
    }

    #[test]
    fn json_says_the_same() {
        let text = "{\n  \"name\": \"\u{202e}a\u{e0041}\"\n}";
        let escaped = json(text);
        assert_eq!(escaped, "{\n  \"name\": \"\\u202ea\\udb40\\udc41\"\n}");
        let value = |text: &str| serde_json::from_str::<serde_json::Value>(text).expect("JSON");
        assert_eq!(value(&escaped), value(text));
    }
}
