//! How the chosen groups take the sun: the curve, its three numbers and the centre.
//!
//! Chosen are the selected groups, and the groups that selected boxes and sprites are in. The first one's values are
//! shown; what is changed is changed in all.

use super::curve::{self, Shares};
use crate::state::{Action, Item, Reading, box_of, group_of};
use crate::widget::{Fields, section, section_called};
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{self, GROUP_NAME, HasLight, Value};
use cloudwright_core::scene::{CloudBox, CloudModel, GroupCenter, GroupLight, ModelId, ShadingGroup};
use cloudwright_core::sprites::GroupKey;
use egui::Ui;
use glam::DVec3;

/// Of the light's properties, the three shares come first.
const SHARES: usize = 3;

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

impl HasLight for Lit {
    fn light(&self) -> &GroupLight {
        match &self.owner {
            Owner::Group(group) => &group.light,
            Owner::Box(each) => &each.light,
        }
    }

    fn light_mut(&mut self) -> &mut GroupLight {
        match &mut self.owner {
            Owner::Group(group) => &mut group.light,
            Owner::Box(each) => &mut each.light,
        }
    }
}

impl Lit {
    fn is_by_hand(&self) -> bool {
        matches!(self.light().center, GroupCenter::At(_))
    }

    fn edit(self) -> Edit {
        match self.owner {
            Owner::Group(group) => Edit::Group(self.model, ListEdit::Replace(group)),
            Owner::Box(each) => Edit::Box(self.model, ListEdit::Replace(*each)),
        }
    }

    /// Whose its numbers are in tracks.
    fn in_tracks(&self) -> property::Owner {
        property::Owner::Thing(match &self.owner {
            Owner::Group(group) => Item::Group(self.model, group.id),
            Owner::Box(each) => Item::Box(self.model, each.id),
        })
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
    let lights = chosen(reading);
    let Some(first) = lights.first() else {
        section(ui, "Light", |ui| drop(ui.weak("Select a group, a box or a sprite to shape how it takes the sun.")));
        return;
    };
    let title = match &first.owner {
        Owner::Group(group) => super::list::group_name(&group.name, group.id),
        Owner::Box(each) if each.name.is_empty() => format!("box {}", each.id),
        Owner::Box(each) => each.name.clone(),
    };
    let all: Vec<&Lit> = lights.iter().collect();
    let owned = || Fields::of(&all, reading).owned(lights.iter().map(Lit::in_tracks));
    // As tracks have them at the clock's time.
    let before = Shares::of(|at| match curve::row(at).and_then(|row| owned().value(row, 0, 0)) {
        Some(Value::Number(share)) => share,
        _ => 0.0,
    });
    let tint = crate::theme::group_tint(match &first.owner {
        Owner::Group(group) => group.id.0,
        Owner::Box(each) => each.id.0,
    });
    let more = if lights.len() > 1 { format!(" and {} more", lights.len() - 1) } else { String::new() };
    let shown = format!("Light of {title}{more}");
    section_called(ui, "Light", &shown, |ui| {
        ui.push_id(("light", model.id), |ui| {
            // The numbers first: they are in sight where the curve is not.
            let numbers = |fields: &mut Fields<'_, Lit>, ui: &mut Ui| fields.rows(ui, &Lit::LIGHT[..SHARES]);
            owned().show(ui, "Shape light", actions, numbers, |_, lit| lit.edit());
            if let Some((at, share)) = curve::show(ui, &before, tint)
                && let Some(row) = curve::row(at)
            {
                let live = ui.input(|input| input.pointer.any_down());
                owned().set_number((row, share), "Shape light", live, actions, |_, lit| lit.edit());
            }
            if let [Lit { model, owner: Owner::Group(group), .. }] = lights.as_slice() {
                let edit = |_, group| Edit::Group(*model, ListEdit::Replace(group));
                let name = |fields: &mut Fields<'_, ShadingGroup>, ui: &mut Ui| {
                    GROUP_NAME.iter().for_each(|row| fields.row(ui, row, "Group name"));
                };
                Fields::of(&[group], reading).show(ui, "Rename shading group", actions, name, edit);
            }
            // A centre put by hand begins where it lies.
            let edit = |at: usize, mut lit: Lit| {
                if lit.is_by_hand() && !all[at].is_by_hand() {
                    lit.light_mut().center = GroupCenter::At(lit.center);
                }
                lit.edit()
            };
            owned().show(ui, "Change shading", actions, |fields, ui| fields.rows(ui, &Lit::LIGHT[SHARES..]), edit);
        });
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
