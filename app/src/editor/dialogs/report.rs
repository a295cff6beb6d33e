//! What is told of a problem: to be read before it is saved.

use super::{buttons, window};
use crate::theme;
use egui::{Context, ScrollArea, TextEdit};

/// What the user says of a problem.
#[derive(Debug, Clone, Default)]
pub(in crate::editor) struct Report {
    pub(in crate::editor) said: String,
    pub(in crate::editor) with_scene: bool,
}

/// What is answered.
pub(super) enum Answer {
    Save,
    Close,
}

/// `text` is all that the file will hold but the scene, which goes along if `with_scene`.
pub(super) fn ask(context: &Context, said: &mut String, with_scene: &mut bool, text: &str) -> Option<Answer> {
    window(context, theme::WIDE_DIALOG_WIDTH, "Report a problem", Answer::Close, |ui| {
        ui.label("Say what you did, what happened, and what you had expected. Nothing leaves this machine: a file is saved, which you may read and send.");
        let label = ui.label("What happened");
        ui.add(TextEdit::multiline(said).desired_rows(4).desired_width(f32::INFINITY).char_limit(20_000))
            .labelled_by(label.id);
        ui.checkbox(with_scene, "With the scene").on_hover_text("The open scene as it is now, saved or not.");
        ui.add_space(theme::GAP);
        ui.label("The file also holds:");
        ScrollArea::vertical().id_salt("report").max_height(theme::REPORT_HEIGHT).show(ui, |ui| {
            let mut text = text;
            let field = TextEdit::multiline(&mut text).font(egui::TextStyle::Monospace).desired_width(f32::INFINITY);
            let field = ui.add(field);
            crate::widget::name_it(ui, &field, "What the report tells");
        });
        buttons(ui, |ui| {
            let save = ui.button("Save…").clicked().then_some(Answer::Save);
            save.or(ui.button("Cancel").clicked().then_some(Answer::Close))
        })
    })
}
