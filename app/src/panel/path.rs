//! Camera paths.

use crate::state::{Action, Reading};
use crate::widget::Fields;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::CameraPath;
use egui::Ui;

/// `paths` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, paths: &[&CameraPath], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    Fields::of(paths, reading)
        .show(ui, "Change path", actions, Fields::all, |_, path| Edit::Path(ListEdit::Replace(path)));
}
