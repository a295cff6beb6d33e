//! A question in a corner of the window, so that the scene can be seen as it would be.

use crate::theme;
use crate::widget::fitted;
use egui::{Align2, Color32, Context, Id, Key, Modal, Ui, vec2};

/// What is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Answer {
    /// Keep what is shown; of an exporter: write the file.
    Do,
    /// Leave all as it was.
    Cancel,
}

/// Shows what `add` adds, `width` points wide, which returns the answer.
///
/// A click beside it is no answer: the scene is there to be looked at. Esc in a field ends the typing, and no more.
pub(super) fn ask(
    context: &Context,
    id: Id,
    width: f32,
    add: impl FnOnce(&mut Ui) -> Option<Answer>,
) -> Option<Answer> {
    let corner = Modal::default_area(id).anchor(Align2::LEFT_BOTTOM, vec2(1.0, -1.0) * theme::DIALOG_MARGIN);
    let modal = Modal::new(id).area(corner).backdrop_color(Color32::TRANSPARENT).frame(theme::dialog(context));
    let modal = modal.show(context, |ui| fitted(ui, width, add));
    let typed = {
        let types = context.text_edit_focused();
        context.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(id), types))
    };
    let is_in_front = modal.is_top_modal && !modal.any_popup_open;
    let escaped = is_in_front && !typed && context.input(|input| input.key_pressed(Key::Escape));
    modal.inner.or(escaped.then_some(Answer::Cancel))
}

/// The buttons that end it: `go` with that name, if it can be had now.
pub(super) fn buttons(ui: &mut Ui, go: &str, can_go: bool) -> Option<Answer> {
    ui.horizontal(|ui| {
        let go = ui.add_enabled(can_go, egui::Button::new(go)).clicked().then_some(Answer::Do);
        go.or(ui.button("Cancel").clicked().then_some(Answer::Cancel))
    })
    .inner
}
