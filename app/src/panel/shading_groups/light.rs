//! How the chosen groups take the sun: the curve, its three numbers and the centre.
//!
//! Chosen are the selected groups, and the groups that selected boxes and sprites are in. The first one's values are
//! shown; what is changed is changed in all.

use super::curve::{self, Shares};
use crate::state::{Action, Item, Reading, box_of, group_of};
use crate::widget::{Fields, fields, heading};
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::parameter as p;
use cloudwright_core::scene::{CloudBox, CloudModel, GroupCenter, GroupLight, ModelId, ShadingGroup};
use cloudwright_core::sprites::GroupKey;
use egui::Ui;
use glam::DVec3;

/// Whose light it is.
#[derive(Debug, Clone, PartialEq)]
enum Owner {
    Group(ShadingGroup),
    Box(Box<CloudBox>),
}

/// A light with its owner.
#[derive(Debug, Clone, PartialEq)]
struct Lit {
    model: ModelId,
    owner: Owner,
    /// Where its centre lies now, metres in the model's space: where a centre put by hand begins.
    center: DVec3,
}

impl Lit {
    fn light(&mut self) -> &mut GroupLight {
        match &mut self.owner {
            Owner::Group(group) => &mut group.light,
            Owner::Box(each) => &mut each.light,
        }
    }

    fn edit(self) -> Edit {
        match self.owner {
            Owner::Group(group) => Edit::Group(self.model, ListEdit::Replace(group)),
            Owner::Box(each) => Edit::Box(self.model, ListEdit::Replace(*each)),
        }
    }

    fn is_the_same(&self, other: &Self) -> bool {
        match (&self.owner, &other.owner) {
            (Owner::Group(a), Owner::Group(b)) => a.id == b.id,
            (Owner::Box(a), Owner::Box(b)) => a.id == b.id,
            _ => false,
        }
    }
}

/// What stands below the list.
pub(super) fn show(ui: &mut Ui, model: &CloudModel, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let mut lights = chosen(reading);
    let Some(first) = lights.first_mut() else {
        heading(ui, "Light");
        ui.weak("Select a group, a box or a sprite to shape how it takes the sun.");
        return;
    };
    let title = match &first.owner {
        Owner::Group(group) => super::list::group_name(&group.name, group.id),
        Owner::Box(each) if each.name.is_empty() => format!("box {}", each.id),
        Owner::Box(each) => each.name.clone(),
    };
    let before = Shares::of(first.light());
    let tint = crate::theme::group_tint(match &first.owner {
        Owner::Group(group) => group.id.0,
        Owner::Box(each) => each.id.0,
    });
    let more = if lights.len() > 1 { format!(" and {} more", lights.len() - 1) } else { String::new() };
    heading(ui, &format!("Light of {title}{more}"));
    ui.push_id(("light", model.id), |ui| {
        if let Some((at, share)) = curve::show(ui, &before, tint) {
            let mut edits = Vec::new();
            for mut each in lights.iter().cloned() {
                curve::set(each.light(), at, share);
                edits.push(each.edit());
            }
            let live = ui.input(|input| input.pointer.any_down());
            actions.push(Action::Change { name: "Shape light", edits, live });
        }
        if let [Lit { model, owner: Owner::Group(group), .. }] = lights.as_slice() {
            let edit = |group| Edit::Group(*model, ListEdit::Replace(group));
            let name = |rows: &mut Fields<'_>, group: &mut ShadingGroup| rows.text("Group name", &mut group.name);
            fields(ui, "Rename shading group", actions, std::slice::from_ref(group), name, edit);
        }
        fields(ui, "Change shading", actions, &lights, rows, Lit::edit);
    });
}

/// The lights of what is selected, the primary's first, each once.
fn chosen(reading: &Reading<'_>) -> Vec<Lit> {
    let mut lights: Vec<Lit> = Vec::new();
    for item in reading.view.selection.items().iter().rev() {
        if let Some(light) = light_of(*item, reading).filter(|new| !lights.iter().any(|old| old.is_the_same(new))) {
            lights.push(light);
        }
    }
    lights
}

fn light_of(item: Item, reading: &Reading<'_>) -> Option<Lit> {
    let scene = reading.session.scene();
    let (model, owner) = match item {
        Item::Group(model, id) => (model, Owner::Group(group_of(scene, model, id)?.clone())),
        Item::Box(model, id) | Item::Sprite(model, id, _) => {
            let each = box_of(scene, model, id)?;
            let single = if let Item::Sprite(.., index) = item {
                each.sprite_edits.iter().find(|edit| edit.index == index).and_then(|edit| edit.group)
            } else {
                None
            };
            let named = single.or(each.group).and_then(|id| group_of(scene, model, id));
            (model, named.map_or_else(|| Owner::Box(Box::new(each.clone())), |group| Owner::Group(group.clone())))
        }
        _ => return None,
    };
    Some(Lit { model, center: center_of(&owner, reading).unwrap_or_default(), owner })
}

fn center_of(owner: &Owner, reading: &Reading<'_>) -> Option<DVec3> {
    let cloud = reading.view.selection.cloud(reading.session.scene())?;
    let placed = reading.session.placed(cloud.id)?;
    let is_its = |key: GroupKey| match (owner, key) {
        (Owner::Group(group), GroupKey::Named(id)) => group.id == id,
        (Owner::Box(each), GroupKey::Lump(id, _)) => each.id == id,
        _ => false,
    };
    let group = placed.groups.iter().find(|group| is_its(group.key))?;
    let center = ModelSpace::of(cloud).from_world(placed.origin + group.center.as_dvec3()).round();
    center.is_finite().then_some(center)
}

fn rows(rows: &mut Fields<'_>, lit: &mut Lit) {
    let start = lit.center;
    let light = lit.light();
    rows.number(&p::C_MAX, &mut light.c_max);
    rows.number(&p::C_MED, &mut light.c_med);
    rows.number(&p::C_MIN, &mut light.c_min);
    let mut by_hand = matches!(light.center, GroupCenter::At(_));
    let was_by_hand = by_hand;
    rows.check("Centre by hand", "The point that the group's sides are seen from stays where it is put.", &mut by_hand);
    if by_hand != was_by_hand {
        light.center = if by_hand { GroupCenter::At(start) } else { GroupCenter::Mean };
    }
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
