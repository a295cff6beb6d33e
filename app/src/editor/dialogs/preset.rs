//! Ready-made clouds by their pictures.

use super::window;
use crate::theme;
use crate::thumbnail::Thumbnails;
use crate::widget::preset_choice;
use cloudwright_core::preset::Preset;

/// Which one; none if the user left it.
pub(super) fn choose(context: &egui::Context, thumbnails: &mut Thumbnails) -> Option<Option<&'static Preset>> {
    window(context, theme::GALLERY_WIDTH, "Add a cloud from a preset", None, |ui| {
        let chosen = preset_choice(ui, thumbnails);
        ui.add_space(theme::GAP);
        let cancelled = ui.button("Cancel").clicked();
        if cancelled { Some(None) } else { chosen.map(Some) }
    })
}
