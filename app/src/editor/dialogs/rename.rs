//! Names for many things at once: a pattern with a running number, and what comes of it.

use super::{buttons, window};
use crate::theme;
use crate::visible;
use crate::widget::{name_it, number_field};
use cloudwright_core::arrange::rename;
use cloudwright_core::property::Number;
use cloudwright_core::scene::{Scene, Thing};
use egui::{Button, Key, TextEdit};

const FIRST: Number =
    Number { label: "First number", unit: "", min: 0.0, max: 1e6, doc: "What the first of them is counted as." };

#[derive(Debug)]
pub(in crate::editor) struct Rename {
    /// In the order of the scene's lists.
    pub(in crate::editor) things: Vec<Thing>,
    pub(in crate::editor) pattern: String,
    first: f64,
}

impl Rename {
    /// Begins with the name of the first.
    pub(in crate::editor) fn new(scene: &Scene, mut things: Vec<Thing>) -> Self {
        let order: Vec<Thing> = things.first().map(|first| rename_order(scene, *first)).unwrap_or_default();
        things.sort_by_key(|thing| order.iter().position(|other| other == thing));
        let name = things.first().and_then(|first| rename::name_of(scene, *first)).unwrap_or_default();
        let stem = name.trim_end_matches(|last: char| last.is_ascii_digit()).trim_end();
        Self { pattern: format!("{stem} #").trim_start().into(), things, first: 1.0 }
    }

    /// The number that the first one gets.
    pub(in crate::editor) fn first(&self) -> u64 {
        self.first as u64
    }

    /// Some(true) if they are to be renamed so.
    pub(super) fn ask(&mut self, context: &egui::Context, scene: &Scene) -> Option<bool> {
        window(context, theme::DIALOG_WIDTH, "Rename", Some(false), |ui| {
            ui.label(format!("{} things", self.things.len()));
            ui.weak("# is a running number, ## one of two figures, * the old name.");
            ui.add_space(theme::GAP);
            let field = ui.add(TextEdit::singleline(&mut self.pattern).desired_width(f32::INFINITY));
            name_it(ui, &field, "Pattern of the names");
            if ui.memory(|memory| memory.focused().is_none()) {
                field.request_focus();
            }
            let entered = field.lost_focus() && ui.input(|input| input.key_pressed(Key::Enter));
            ui.horizontal(|ui| {
                ui.label(FIRST.label);
                number_field(ui, FIRST.label, &FIRST, &mut self.first, true);
            });
            ui.add_space(theme::GAP);
            let shown = self.things.iter().zip(self.first()..).take(3);
            for (thing, number) in shown {
                let old = rename::name_of(scene, *thing).unwrap_or_default();
                let new = rename::by_pattern(&self.pattern, old, number);
                ui.weak(visible::one_line(&format!("{old} becomes {new}")));
            }
            if self.things.len() > 3 {
                ui.weak("…");
            }
            let can = !self.pattern.trim().is_empty();
            let answer = buttons(ui, |ui| {
                let go = ui.add_enabled(can, Button::new("Rename")).clicked();
                let cancel = ui.button("Cancel").clicked();
                if go { Some(Some(true)) } else { cancel.then_some(Some(false)) }
            });
            answer.or((entered && can).then_some(Some(true)))
        })
        .flatten()
    }
}

fn rename_order(scene: &Scene, first: Thing) -> Vec<Thing> {
    cloudwright_core::arrange::order::list_of(scene, first)
}
