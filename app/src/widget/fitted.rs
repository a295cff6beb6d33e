//! A dialog's content in a window of any size: no wider than the window, and scrolled where it is higher.

use crate::theme;
use egui::{ScrollArea, Ui};

/// Shows what `add` adds, `width` points wide if the window has room for that.
pub(crate) fn fitted<T>(ui: &mut Ui, width: f32, add: impl FnOnce(&mut Ui) -> T) -> T {
    let room = ui.ctx().content_rect().size() - egui::Vec2::splat(2.0 * theme::DIALOG_MARGIN);
    let width = width.min(room.x);
    ScrollArea::vertical()
        .id_salt("fitted")
        .max_height(room.y)
        .min_scrolled_height(room.y)
        .max_width(width)
        .show(ui, |ui| {
            ui.set_width(width);
            add(ui)
        })
        .inner
}
