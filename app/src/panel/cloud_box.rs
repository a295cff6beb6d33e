//! A box of a model.

use super::fields::{fields, heading};
use super::model::category_name;
use crate::editor::{Action, Selection, Session};
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{Category, CloudBox, CloudModel, GroupCenter};
use egui::Ui;
use glam::{DQuat, EulerRot};

pub(super) fn fields_of(
    ui: &mut Ui,
    model: &CloudModel,
    cloud_box: &CloudBox,
    session: &Session,
    actions: &mut Vec<Action>,
) {
    ui.heading("Box");
    fields(ui, "Change box", actions, |rows| {
        let mut edited = cloud_box.clone();
        rows.text("Name", &mut edited.name);
        rows.vector("Centre", &p::POSITION, &mut edited.center);
        rows.vector("Size", &p::BOX_SIZE, &mut edited.size);
        turn(rows, &mut edited.orientation);
        rows.whole(&p::SPRITE_COUNT, &mut edited.sprite_count);
        rows.range("Width", &p::SPRITE_SIZE, &mut edited.width);
        rows.range("Height", &p::SPRITE_SIZE, &mut edited.height);
        rows.range("Rotation", &p::ROTATION_DEG, &mut edited.rotation_deg);
        let mut categories = vec![(None, format!("the model's: {}", category_name(model.category)))];
        categories.extend(Category::ALL.into_iter().map(|each| (Some(each), category_name(each))));
        rows.choice("Category", "Which tiles its sprites show.", &mut edited.category, &categories);
        Edit::Box(model.id, ListEdit::Replace(edited))
    });
    let kept = |cloud: &cloudwright_core::sprites::PlacedCloud| {
        cloud.sprites.iter().filter(|sprite| sprite.box_id == cloud_box.id).count()
    };
    let cloud = session.scene().clouds.iter().find(|cloud| cloud.model == model.id);
    if let Some(placed) = cloud.and_then(|cloud| session.derived().clouds().iter().find(|each| each.id == cloud.id)) {
        ui.weak(format!("{} of {} sprites kept in “{}”", kept(placed), cloud_box.sprite_count, placed.name));
    }
    if ui.button("Select its model").clicked() {
        actions.push(Action::Select(Selection::Model(model.id)));
    }
    heading(ui, "Shading");
    shading(ui, model, cloud_box, actions);
}

/// The quaternion as heading, pitch and roll; the file keeps the quaternion.
fn turn(rows: &mut super::fields::Fields<'_>, orientation: &mut DQuat) {
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

fn shading(ui: &mut Ui, model: &CloudModel, cloud_box: &CloudBox, actions: &mut Vec<Action>) {
    fields(ui, "Change shading", actions, |rows| {
        let mut edited = cloud_box.clone();
        let mut groups = vec![(None, "its own".to_owned())];
        groups.extend(model.groups.iter().map(|group| {
            let name = if group.name.is_empty() { format!("group {}", group.id) } else { group.name.clone() };
            (Some(group.id), name)
        }));
        rows.choice("Group", "Sprites of one group take the sun as one lump.", &mut edited.group, &groups);
        if edited.group.is_none() {
            rows.whole_vector(&p::LUMPS, &mut edited.lumps);
            rows.number(&p::C_MIN, &mut edited.light.c_min);
            rows.number(&p::C_MED, &mut edited.light.c_med);
            rows.number(&p::C_MAX, &mut edited.light.c_max);
            match &mut edited.light.center {
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
        Edit::Box(model.id, ListEdit::Replace(edited))
    });
}
