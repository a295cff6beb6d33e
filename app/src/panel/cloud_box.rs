//! Boxes of a model.

use super::shading_groups::group_name;
use crate::command::Command;
use crate::state::{Action, Item, Reading};
use crate::widget::{Fields, Kept, heading, kept};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{BOX_SHADING, BOX_SHAPE, Kind, Owner, Property, Value};
use cloudwright_core::scene::{CloudBox, CloudModel, ModelId, Thing};
use egui::Ui;

/// A box and the model that it belongs to.
pub(super) type ModelBox<'a> = (ModelId, &'a CloudBox);

/// `boxes` has at least one, the one of `model` whose values are shown.
pub(super) fn fields_of(
    ui: &mut Ui,
    model: &CloudModel,
    boxes: &[ModelBox<'_>],
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let alone: Vec<&CloudBox> = boxes.iter().map(|(_, each)| *each).collect();
    let replace = |at: usize, each| Edit::Box(boxes[at].0, ListEdit::Replace(each));
    // A box without a category has its model's, and one without a key is keyed by its id.
    let inherited = |each: &CloudBox, property: &Property| match property.kind {
        Kind::Category => Some(Value::Text(model.category.name().into())),
        _ => Some(Value::Whole(each.id.0)),
    };
    Fields::of(&alone, reading).inheriting(inherited).show(
        ui,
        "Change box",
        actions,
        |fields, ui| fields.rows(ui, BOX_SHAPE),
        replace,
    );
    let placed = reading.view.selection.cloud(reading.session.scene());
    match placed.and_then(|cloud| reading.session.placed(cloud.id)) {
        Some(cloud) => {
            let its = boxes.iter().filter(|(of, _)| *of == model.id).map(|(_, each)| *each);
            kept::line(ui, &Kept::of_boxes(its, cloud));
        }
        None => {
            ui.weak("Its model is placed nowhere.");
        }
    }
    if ui.button("Select its model").clicked() {
        actions.push(Action::select(Item::Model(model.id)));
    }
    heading(ui, "Shading");
    let groups = model.groups.iter().map(|group| (group.id.0, group_name(&group.name, group.id)));
    let owners = boxes.iter().map(|(of, each)| Owner::Thing(Thing::Box(*of, each.id)));
    Fields::of(&alone, reading).owned(owners).with_groups(groups).show(
        ui,
        "Change shading",
        actions,
        |fields, ui| fields.rows(ui, BOX_SHADING),
        replace,
    );
    let panel = Command::GroupsPanel.row();
    if ui.button("Shape its light").on_hover_text(panel.help).clicked() {
        actions.push(Action::Command(panel.command));
    }
}
