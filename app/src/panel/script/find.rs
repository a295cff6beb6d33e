//! Finds words in a script.

use crate::widget::name_it;
use egui::{Id, Key, Modifiers, TextEdit, Ui};
use std::ops::Range;

/// What is sought, and which of its places was shown last.
#[derive(Debug, Clone, Default)]
struct Sought {
    words: String,
    place: usize,
}

/// A field for what is sought. The characters to be shown and chosen now, if Enter was pressed in it.
pub(super) fn show(ui: &mut Ui, text: &str) -> Option<Range<usize>> {
    let id = Id::unique("find in the script");
    let mut sought: Sought = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    let places = places(text, &sought.words);
    let mut wanted = None;
    let field = ui.add(TextEdit::singleline(&mut sought.words).id_source(id).hint_text("Find").desired_width(140.0));
    name_it(ui, &field, "Find in the script");
    if field.changed() {
        sought.place = usize::MAX;
    }
    if field.lost_focus()
        // The text, which gets the focus, is not to have it.
        && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter))
        && !places.is_empty()
    {
        sought.place = sought.place.wrapping_add(1) % places.len();
        wanted = places.get(sought.place).cloned();
    }
    if !sought.words.is_empty() {
        let count = places.len();
        ui.weak(if count == 1 { "1 place".into() } else { format!("{count} places") });
    }
    ui.data_mut(|data| data.insert_temp(id, sought));
    wanted
}

/// Where `words` stand in `text`, capitals or not, counted in characters.
fn places(text: &str, words: &str) -> Vec<Range<usize>> {
    let fold = |text: &str| text.chars().map(|c| c.to_lowercase().next().unwrap_or(c)).collect::<Vec<char>>();
    let (text, words) = (fold(text), fold(words));
    if words.is_empty() || words.len() > text.len() {
        return Vec::new();
    }
    let begins = (0..=text.len() - words.len()).filter(|at| text[*at..].starts_with(&words));
    begins.map(|at| at..at + words.len()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_are_counted_in_characters() {
        assert_eq!(places("“Key” key kEy", "key"), [1..4, 6..9, 10..13]);
        for (text, words) in [("key", ""), ("", "key"), ("ke", "key"), ("x", "y")] {
            assert!(places(text, words).is_empty(), "{words} in {text}");
        }
    }
}
