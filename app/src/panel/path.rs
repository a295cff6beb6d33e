//! Camera paths.

use crate::state::Action;
use crate::widget::fields;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::CameraPath;
use egui::Ui;

/// `paths` has at least one, the one whose values are shown.
pub(super) fn fields_of(ui: &mut Ui, paths: &[CameraPath], actions: &mut Vec<Action>) {
    fields(
        ui,
        "Change path",
        actions,
        paths,
        |rows, path| {
            rows.text("Name", &mut path.name);
            rows.number(&p::FIELD_OF_VIEW_DEG, &mut path.field_of_view_deg);
        },
        |path| Edit::Path(ListEdit::Replace(path)),
    );
}
