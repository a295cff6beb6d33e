//! The last scenes, to be chosen by click, by Tab and Enter, or by their digit.

use super::{buttons, window};
use crate::theme;
use egui::{Button, Key, Modifiers};
use std::path::{Path, PathBuf};

const DIGITS: [Key; 10] =
    [Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9, Key::Num0];

/// Some(None) if the user changed their mind. Scenes that are gone are shown, and can't be chosen.
pub(super) fn choose(context: &egui::Context, scenes: &[(PathBuf, bool)]) -> Option<Option<PathBuf>> {
    window(context, theme::WIDE_DIALOG_WIDTH, "Open recent", None, |ui| {
        let mut chosen = None;
        for (index, (path, there)) in scenes.iter().enumerate() {
            let digit = DIGITS.get(index).copied();
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let text = match digit {
                Some(digit) => format!("{}  {name}", digit.symbol_or_name()),
                None => name.into_owned(),
            };
            let folder = path.parent().unwrap_or(Path::new("")).display();
            let beside = if *there { folder.to_string() } else { format!("gone from {folder}") };
            let button = Button::new(text).right_text(egui::RichText::new(beside).weak()).truncate();
            let size = egui::vec2(ui.available_width(), 0.0);
            let response = ui.add_enabled_ui(*there, |ui| ui.add(button.min_size(size))).inner;
            let response = response.on_hover_text(path.display().to_string());
            let by_key = digit.is_some_and(|key| ui.input_mut(|input| input.consume_key(Modifiers::NONE, key)));
            if *there && (response.clicked() || by_key) {
                chosen = Some(path.clone());
            }
        }
        let cancel = buttons(ui, |ui| ui.button("Cancel").clicked().then_some(None));
        chosen.map(Some).or(cancel)
    })
}
