//! A path typed by hand, where the desktop shows no file dialog.

use super::{buttons, window};
use crate::editor::Ask;
use crate::theme;
use egui::{Button, Key, TextEdit};
use std::path::PathBuf;

/// Some(None) if the user changed their mind.
pub(super) fn ask(context: &egui::Context, ask: &Ask, text: &mut String) -> Option<Option<PathBuf>> {
    let (title, verb) = match ask {
        Ask::Open(_) => ("Open scene", "Open"),
        Ask::Save(_) => ("Save scene as", "Save"),
        Ask::SaveScript(_) => ("Save script as", "Save"),
        Ask::Export(_) | Ask::Leave(_) => ("Export as", "Export"),
        Ask::Picture(_) => ("Render picture to", "Render"),
        Ask::Video(_) => ("Render flight to", "Render"),
        Ask::Frames(_) => ("Folder for the frames", "Render"),
        Ask::Arrive(_) => ("Import", "Import"),
        Ask::Report(_) => ("Save report as", "Save"),
        Ask::Append(_) => ("Append from scene", "Choose"),
        Ask::Model(..) => ("Choose model", "Choose"),
    };
    window(context, theme::DIALOG_WIDTH, title, None, |ui| {
        ui.label("This desktop shows no file dialog (it has no portal and no zenity).");
        let label = ui.label("Path of the file");
        let field = ui.add(TextEdit::singleline(text).desired_width(f32::INFINITY)).labelled_by(label.id);
        let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
        // Typing can begin at once.
        if ui.memory(|memory| memory.focused().is_none()) {
            field.request_focus();
        }
        let path = (!text.trim().is_empty()).then(|| PathBuf::from(text.trim()));
        let done = buttons(ui, |ui| {
            let go = ui.add_enabled(path.is_some(), Button::new(verb)).clicked();
            let cancel = ui.button("Cancel").clicked();
            if go { Some(path.clone()) } else { cancel.then_some(None) }
        });
        done.or((entered && path.is_some()).then_some(path))
    })
}
