//! The folder that clouds are to go into.

use super::{buttons, window};
use crate::theme::{self, icon};
use crate::visible;
use crate::widget::name_it;
use cloudwright_core::scene::{FolderId, Scene};
use egui::{Button, Context, RichText, ScrollArea};

/// Where to.
pub(super) enum Choice {
    Into(FolderId),
    New,
    Cancel,
}

pub(super) fn choose(context: &Context, scene: &Scene, clouds: usize) -> Option<Choice> {
    let clouds = if clouds == 1 { "the cloud".into() } else { format!("{clouds} clouds") };
    window(context, theme::DIALOG_WIDTH, "Move to folder", Choice::Cancel, |ui| {
        ui.label(format!("Where {clouds} go:"));
        let mut chosen = None;
        let area = ScrollArea::vertical().max_height(theme::DIALOG_LIST_HEIGHT).auto_shrink([false, true]);
        area.show_rows(ui, ui.spacing().interact_size.y, scene.folders.len(), |ui, shown| {
            for folder in scene.folders.as_slice().get(shown).unwrap_or_default() {
                let name = visible::one_line(&folder.name);
                let mark = RichText::new(icon::FOLDER).color(theme::of_folder(folder));
                let button = Button::new((mark, name.as_str())).truncate();
                let response = ui.add(button.min_size(egui::vec2(ui.available_width(), 0.0)));
                name_it(ui, &response, &format!("Into {name}"));
                if response.clicked() {
                    chosen = Some(Choice::Into(folder.id));
                }
            }
        });
        let other = buttons(ui, |ui| {
            let new = ui.button("New folder").clicked();
            let cancel = ui.button("Cancel").clicked();
            if new { Some(Choice::New) } else { cancel.then_some(Choice::Cancel) }
        });
        chosen.or(other)
    })
}
