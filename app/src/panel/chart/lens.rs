//! How the viewport shows the picture: as it is, beside the truth, or as a map of what it costs or gets wrong.

use crate::state::{Action, Lens, Reading, ViewChange};
use crate::widget::name_it;
use cloudwright_core::method::METHODS;
use cloudwright_core::rules::Rasterizer;
use egui::{ComboBox, Ui};

pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let view = reading.view;
    ui.horizontal(|ui| {
        ui.label("Drawn by");
        let own = "its own way";
        let shown = view.method.map_or(own, |method| method.name);
        let combo = ComboBox::from_id_salt("method").selected_text(shown).show_ui(ui, |ui| {
            if ui.selectable_label(view.method.is_none(), own).clicked() {
                actions.push(Action::View(ViewChange::Method(None)));
            }
            // The device's own is the window's own way, where it has one.
            for each in METHODS.iter().filter(|method| method.rules.rasterizer != Rasterizer::Gpu) {
                let response = ui.selectable_label(view.method == Some(each), each.name).on_hover_text(each.about);
                if response.clicked() {
                    actions.push(Action::View(ViewChange::Method(Some(each))));
                }
            }
        });
        name_it(ui, &combo.response, "Method of the viewport");
    });
    ui.horizontal_wrapped(|ui| {
        for lens in Lens::ALL {
            let response = ui.selectable_label(view.lens == lens, lens.name()).on_hover_text(lens.help());
            if response.clicked() {
                actions.push(Action::View(ViewChange::Lens(lens)));
            }
        }
    });
}
