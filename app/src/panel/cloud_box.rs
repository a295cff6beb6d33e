//! Boxes of a model.

use super::Reading;
use super::fields::{Fields, fields, heading};
use super::model::category_name;
use crate::editor::{Action, Item};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{BoxId, Category, CloudBox, CloudModel, GroupCenter, GroupId, ModelId};
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
    let mut categories = vec![(None, format!("the model's: {}", category_name(model.category)))];
    categories.extend(Category::ALL.into_iter().map(|each| (Some(each), category_name(each))));
    let rows = |rows: &mut Fields<'_>, (_, edited): &mut ModelBox| {
        rows.text("Name", &mut edited.name);
        rows.vector("Centre", &p::POSITION, &mut edited.center);
        rows.vector("Size", &p::BOX_SIZE, &mut edited.size);
        turn(rows, &mut edited.orientation);
        rows.whole(&p::SPRITE_COUNT, &mut edited.sprite_count);
        rows.range("Width", &p::SPRITE_SIZE, &mut edited.width);
        rows.range("Height", &p::SPRITE_SIZE, &mut edited.height);
        rows.range("Rotation", &p::ROTATION_DEG, &mut edited.rotation_deg);
        rows.choice("Category", "Which tiles its sprites show.", &mut edited.category, &categories);
    };
    fields(ui, "Change box", actions, boxes, rows, replace);
    let Some((_, first)) = boxes.first() else { return };
    ui.weak(kept(model, first.id, reading));
    if ui.button("Select its model").clicked() {
        actions.push(Action::select(Item::Model(model.id)));
    }
    heading(ui, "Shading");
    shading(ui, model, boxes, actions);
}

fn replace((model, edited): ModelBox) -> Edit {
    Edit::Box(model, ListEdit::Replace(edited))
}

/// How many of a box's sprites the cull left.
fn kept(model: &CloudModel, id: BoxId, reading: &Reading<'_>) -> String {
    let tried = model.boxes.iter().find(|each| each.id == id).map_or(0, |each| each.sprite_count);
    let cloud = reading.view.selection.cloud(reading.session.scene());
    match cloud.and_then(|cloud| reading.session.placed(cloud.id)) {
        Some(placed) => {
            let kept = placed.sprites.iter().filter(|sprite| sprite.box_id == id).count();
            format!("{kept} of {tried} sprites kept in “{}”", placed.name)
        }
        None => "its model is placed nowhere".into(),
    }
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
    groups.extend(model.groups.iter().map(|group| {
        let name = if group.name.is_empty() { format!("group {}", group.id) } else { group.name.clone() };
        (Some(group.id), name)
    }));
    let rows = |rows: &mut Fields<'_>, (_, edited): &mut ModelBox| {
        rows.choice("Group", "Sprites of one group take the sun as one lump.", &mut edited.group, &groups);
        if edited.group.is_none() {
            rows.whole_vector(&p::LUMPS, &mut edited.lumps);
            light(rows, &mut edited.light);
        }
    };
    fields(ui, "Change shading", actions, boxes, rows, replace);
}

/// How a group takes the sun.
pub(super) fn light(rows: &mut Fields<'_>, light: &mut cloudwright_core::scene::GroupLight) {
    rows.number(&p::C_MIN, &mut light.c_min);
    rows.number(&p::C_MED, &mut light.c_med);
    rows.number(&p::C_MAX, &mut light.c_max);
    match &mut light.center {
        GroupCenter::At(point) => rows.vector("Group centre", &p::POSITION, point),
        center => {
            let before = if let GroupCenter::Pulled(share) = center { *share } else { 0.0 };
            let mut share = before;
            rows.number(&p::PULL, &mut share);
            if share != before {
                *center = if share == 0.0 { GroupCenter::Mean } else { GroupCenter::Pulled(share) };
            }
        }
    }
}
