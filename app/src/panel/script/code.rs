//! The text of a script with numbered lines, its words in colours, and the rest of names offered while they are typed.
//!
//! egui_code_editor shows it. Its completer takes keys wherever they are typed, so that it is only asked while the text
//! has the focus.

use crate::state::Script;
use crate::theme;
use crate::widget::name_it;
use cloudwright_scripts::bindings::{SUBJECTS, Usage};
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::{TextEditOutput, TextEditState};
use egui::{Id, Rect, Ui};
use egui_code_editor::{CodeEditor, Completer, Syntax};
use std::collections::BTreeSet;
use std::ops::Range;
use std::sync::{Arc, Mutex, PoisonError};

const KEYWORDS: [&str; 21] = [
    "fn",
    "let",
    "const",
    "if",
    "else",
    "switch",
    "while",
    "loop",
    "do",
    "until",
    "for",
    "in",
    "break",
    "continue",
    "return",
    "throw",
    "try",
    "catch",
    "private",
    "this",
    "is_def_var",
];
const CONSTANTS: [&str; 3] = ["true", "false", "PLUGIN"];

/// Shows it, with `wanted` chosen if there is that. The text, if it was changed.
pub(super) fn show(ui: &mut Ui, script: &Script, wanted: Option<Range<usize>>) -> Option<String> {
    let id = Id::unique("script words");
    let words = ui.data_mut(|data| data.get_temp_mut_or_default::<Arc<Mutex<Words>>>(id).clone());
    // Each holder leaves a whole state.
    let mut words = words.lock().unwrap_or_else(PoisonError::into_inner);
    let Words { syntax, completer, field } = &mut *words;
    let focused = field.is_some_and(|field| ui.memory(|memory| memory.has_focus(field)));
    let rows = (ui.available_height() / (theme::CODE_TEXT * 1.45)) as usize;
    let mut editor = CodeEditor::default()
        .id_source("script")
        .with_rows(rows.max(1))
        .with_fontsize(theme::CODE_TEXT)
        .with_theme_egui(theme::code(ui))
        .with_clickable_links(false);
    if let (Some(field), Some(range)) = (*field, wanted) {
        choose(ui, field, range);
    }
    let mut text = script.text.clone();
    let mut read_only = script.text.as_str();
    let (output, _) = match (script.example, focused) {
        (Some(_), _) => editor.show(ui, &mut read_only, syntax),
        (None, true) => editor.show_with_completer(ui, &mut text, syntax, completer),
        (None, false) => editor.show(ui, &mut text, syntax),
    };
    *field = Some(output.response.id);
    name_it(ui, &output.response, "Script");
    mark_fault(ui, script, &output);
    tell_usage(ui, &script.text, &output);
    (text != script.text).then_some(text)
}

/// What is kept from frame to frame.
struct Words {
    syntax: Syntax,
    completer: Completer,
    /// The text's own id, once it was shown.
    field: Option<Id>,
}

impl Default for Words {
    fn default() -> Self {
        let functions = SUBJECTS.iter().flat_map(|(_, list)| *list).map(|(name, ..)| *name);
        let syntax = Syntax {
            language: "Rhai",
            comment: "//",
            comment_multiline: ["/*", "*/"],
            quotes: BTreeSet::from(['"', '`', '\'']),
            word_start: BTreeSet::from(['_']),
            keywords: KEYWORDS.into(),
            special: CONSTANTS.into(),
            types: functions.collect(),
            hyperlinks: BTreeSet::new(),
            ..Syntax::default()
        };
        let completer = Completer::new_with_syntax(&syntax).with_user_words();
        Self { syntax, completer, field: None }
    }
}

/// Chooses those characters, and shows them.
fn choose(ui: &Ui, field: Id, range: Range<usize>) {
    let mut state = TextEditState::load(ui.ctx(), field).unwrap_or_default();
    let range = CCursorRange::two(CCursor::new(range.start), CCursor::new(range.end));
    state.cursor.set_char_range(Some(range));
    state.store(ui.ctx(), field);
    ui.memory_mut(|memory| memory.request_focus(field));
}

/// Tints the line that is at fault.
fn mark_fault(ui: &Ui, script: &Script, output: &TextEditOutput) {
    let Some(place) = script.fault.as_ref().and_then(|fault| fault.place) else { return };
    let lines = script.text.split_inclusive('\n').take(place.line.saturating_sub(1));
    let start: usize = lines.map(|line| line.chars().count()).sum();
    let at = output.galley.pos_from_cursor(CCursor::new(start)).translate(output.galley_pos.to_vec2());
    let line = Rect::from_x_y_ranges(output.response.rect.x_range(), at.y_range());
    ui.painter().with_clip_rect(output.text_clip_rect).rect_filled(line, 0.0, theme::fault_line(ui));
}

/// How the function at the cursor is called.
fn tell_usage(ui: &Ui, text: &str, output: &TextEditOutput) {
    let Some(cursor) = output.cursor_range.filter(|_| output.response.has_focus()) else { return };
    let usage = usage_at(text, cursor.primary.index.into());
    let told = usage.map(|(_, usage, help)| format!("{usage}: {help}")).unwrap_or_default();
    ui.data_mut(|data| data.insert_temp(usage_id(), told));
}

/// Where what was told last of a function is kept.
pub(super) fn usage_id() -> Id {
    Id::unique("script usage")
}

/// The function whose name stands around the character at `cursor`.
fn usage_at(text: &str, cursor: usize) -> Option<Usage> {
    let is_word = |c: &char| c.is_alphanumeric() || *c == '_';
    let before: Vec<char> = text.chars().take(cursor).collect();
    let start: String = before.iter().rev().take_while(|c| is_word(c)).collect();
    let end: String = text.chars().skip(cursor).take_while(is_word).collect();
    let name: String = start.chars().rev().chain(end.chars()).collect();
    SUBJECTS.iter().flat_map(|(_, list)| *list).find(|(known, ..)| *known == name).copied()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_function_at_the_cursor_is_told() {
        let text = "let a = “” + scatter(1)";
        let at = text.chars().position(|c| c == 's').expect("there");
        for cursor in [at, at + 3, at + 7] {
            assert_eq!(usage_at(text, cursor).map(|(name, ..)| name), Some("scatter"), "{cursor}");
        }
        assert!(usage_at(text, 2).is_none() && usage_at(text, 400).is_none() && usage_at("", 0).is_none());
    }
}
