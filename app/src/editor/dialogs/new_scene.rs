//! Skies for a new scene by their pictures, nothing but air first. Enter takes what has the focus: that one, at once.

use super::window;
use crate::starter::Template;
use crate::theme;
use crate::thumbnail::Thumbnails;
use crate::widget::template_choice;

/// Which one; Some(None) if the user left it. The first gets the focus once.
pub(super) fn choose(
    context: &egui::Context,
    thumbnails: Option<&mut Thumbnails>,
    has_focus: &mut bool,
) -> Option<Option<Template>> {
    window(context, theme::START_WIDTH, "New scene", None, |ui| {
        let (chosen, first) = template_choice(ui, thumbnails);
        if let Some(first) = first.filter(|_| !std::mem::replace(has_focus, true)) {
            first.request_focus();
        }
        ui.add_space(theme::GAP);
        let cancelled = ui.button("Cancel").clicked();
        if cancelled { Some(None) } else { chosen.map(Some) }
    })
}
