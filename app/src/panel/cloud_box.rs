//! Boxes of a model.

use super::shading_groups::group_name;
use crate::command::Command;
use crate::state::{Action, Item, Reading};
use crate::widget::{Fields, Kept, fields, heading, kept};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{CloudBox, CloudModel, GroupId, ModelId};
use egui::Ui;
use glam::{DQuat, EulerRot};

/// A box and the model that it belongs to.
pub(super) type ModelBox = (ModelId, CloudBox);

/// `boxes` has at least one, the one of `model` whose values are shown.
pub(super) fn fields_of(
    ui: &mut Ui,
    model: &CloudModel,
    boxes: &[ModelBox],
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let rows = |rows: &mut Fields<'_>, (_, edited): &mut ModelBox| {
        rows.text("Name", &mut edited.name);
        rows.vector("Centre", &p::POSITION, &mut edited.center);
        rows.vector("Size", &p::BOX_SIZE, &mut edited.size);
        turn(rows, &mut edited.orientation);
        rows.whole(&p::SPRITE_COUNT, &mut edited.sprite_count);
        rows.range("Width", &p::SPRITE_SIZE, &mut edited.width);
        rows.range("Height", &p::SPRITE_SIZE, &mut edited.height);
        rows.range("Rotation", &p::ROTATION_DEG, &mut edited.rotation_deg);
        rows.category_or(&mut edited.category, model.category, reading.thumbnails);
        let before = edited.key.unwrap_or(edited.id.0);
        let mut key = before;
        rows.seed("Key", "Another number strews this box's sprites anew, and no other's.", &mut key);
        if key != before {
            edited.key = Some(key);
        }
    };
    fields(ui, "Change box", actions, boxes, rows, replace);
    let placed = reading.view.selection.cloud(reading.session.scene());
    match placed.and_then(|cloud| reading.session.placed(cloud.id)) {
        Some(cloud) => {
            let its = boxes.iter().filter(|(of, _)| *of == model.id).map(|(_, each)| each);
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
    shading(ui, model, boxes, actions);
}

fn replace((model, edited): ModelBox) -> Edit {
    Edit::Box(model, ListEdit::Replace(edited))
}

/// The quaternion as heading, pitch and roll; the file keeps the quaternion.
fn turn(rows: &mut Fields<'_>, orientation: &mut DQuat) {
    let (heading, pitch, roll) = orientation.to_euler(EulerRot::YXZ);
    // Adding 0 turns −0 into 0.
    let mut degrees = [-heading, pitch, -roll].map(|angle| angle.to_degrees() + 0.0);
    let before = degrees;
    let [heading, pitch, roll] = &mut degrees;
    rows.labelled("Turn", &p::HEADING_DEG, heading);
    rows.labelled("Tilt", &p::PITCH_DEG, pitch);
    rows.labelled("Bank", &p::ROLL_DEG, roll);
    if degrees != before {
        let [heading, pitch, roll] = degrees.map(f64::to_radians);
        *orientation = DQuat::from_euler(EulerRot::YXZ, -heading, pitch, -roll).normalize();
    }
}

fn shading(ui: &mut Ui, model: &CloudModel, boxes: &[ModelBox], actions: &mut Vec<Action>) {
    let mut groups: Vec<(Option<GroupId>, String)> = vec![(None, "its own".to_owned())];
    groups.extend(model.groups.iter().map(|group| (Some(group.id), group_name(&group.name, group.id))));
    let rows = |rows: &mut Fields<'_>, (_, edited): &mut ModelBox| {
        rows.choice("Group", "Sprites of one group take the sun as one lump.", &mut edited.group, &groups);
        if edited.group.is_none() {
            rows.whole_vector(&p::LUMPS, &mut edited.lumps);
        }
    };
    fields(ui, "Change shading", actions, boxes, rows, replace);
    let panel = Command::GroupsPanel.row();
    if ui.button("Shape its light").on_hover_text(panel.help).clicked() {
        actions.push(Action::Command(panel.command));
    }
}
