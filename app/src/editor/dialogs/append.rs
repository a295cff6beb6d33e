//! Clouds of another scene, to be chosen by their names.

use super::{buttons, window};
use crate::theme;
use crate::visible;
use crate::widget::name_it;
use cloudwright_core::scene::{CloudId, Scene};
use egui::{Button, Context, Key, ScrollArea, TextEdit};
use std::collections::BTreeSet;

#[derive(Debug)]
pub(in crate::editor) struct Append {
    /// The other scene, and its file's name.
    pub(in crate::editor) scene: Box<Scene>,
    pub(in crate::editor) name: String,
    pub(in crate::editor) chosen: BTreeSet<CloudId>,
    typed: String,
}

impl Append {
    /// With all clouds chosen.
    pub(in crate::editor) fn new(scene: Scene, name: String) -> Self {
        let chosen = scene.clouds.iter().map(|cloud| cloud.id).collect();
        Self { scene: Box::new(scene), name, chosen, typed: String::new() }
    }

    /// Some(true) if those are to come in.
    pub(super) fn choose(&mut self, context: &Context) -> Option<bool> {
        let Self { scene, name, chosen, typed } = self;
        window(context, theme::DIALOG_WIDTH, &format!("Append from {name}"), false, |ui| {
            let field = ui.add(TextEdit::singleline(typed).hint_text("Find by name").desired_width(f32::INFINITY));
            name_it(ui, &field, "Find clouds");
            // Enter does as the button: at once, or from the search.
            let is_free = ui.memory(|memory| memory.focused().is_none()) || field.lost_focus();
            let entered = is_free && ui.input(|input| input.key_pressed(Key::Enter));
            let sought = typed.trim().to_lowercase();
            let found = scene.clouds.iter().filter(|cloud| cloud.name.to_lowercase().contains(&sought));
            let found: Vec<_> = found.collect();
            ui.horizontal(|ui| {
                if ui.button("All").clicked() {
                    chosen.extend(found.iter().map(|cloud| cloud.id));
                }
                if ui.button("None").clicked() {
                    chosen.retain(|id| !found.iter().any(|cloud| cloud.id == *id));
                }
                ui.weak(format!("{} of {} clouds", chosen.len(), scene.clouds.len()));
            });
            let height = ui.spacing().interact_size.y;
            let area = ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).auto_shrink([false, true]);
            area.show_rows(ui, height, found.len(), |ui, shown| {
                for cloud in found.get(shown).unwrap_or_default() {
                    let mut is_chosen = chosen.contains(&cloud.id);
                    let model = scene.model(cloud.model).map_or("", |model| model.name.as_str());
                    ui.horizontal(|ui| {
                        ui.push_id(cloud.id, |ui| ui.checkbox(&mut is_chosen, visible::one_line(&cloud.name)));
                        ui.weak(visible::one_line(model));
                    });
                    if is_chosen {
                        chosen.insert(cloud.id);
                    } else {
                        chosen.remove(&cloud.id);
                    }
                }
            });
            buttons(ui, |ui| {
                let go = ui.add_enabled(!chosen.is_empty(), Button::new("Append")).clicked()
                    || entered && !chosen.is_empty();
                let cancel = ui.button("Cancel").clicked();
                if go { Some(true) } else { cancel.then_some(false) }
            })
        })
    }
}
