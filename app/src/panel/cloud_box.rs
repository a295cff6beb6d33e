//! Boxes of a model.

use super::shading_groups::group_name;
use crate::command::Command;
use crate::state::{Action, Item, Reading};
use crate::theme;
use crate::widget::{Fields, Kept, kept, number_field, section};
use cloudwright_core::arrange::fill;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{BOX_PLACE, BOX_SHADING, BOX_SPRITES, Kind, Number, Owner, Property, Value};
use cloudwright_core::scene::{CloudBox, CloudModel, ModelId, Thing};
use egui::Ui;
use glam::DVec3;

const DENSITY: Number = Number {
    label: "Density",
    unit: "×",
    min: 0.01,
    max: 100.0,
    doc: "How many times as many sprites as usually fill a box of this size. It stays when the box is resized.",
};
const RELATIVE_SIZE: Number = Number {
    label: "Sprite size",
    unit: "×",
    min: 0.01,
    max: 100.0,
    doc: "How many times as large as sprites usually are in a box of this size. It stays when the box is resized.",
};

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
    let keep_fill = reading.view.keep_fill;
    let replace_resized = |at: usize, each: CloudBox| replace(at, resized(boxes[at].1, each, keep_fill));
    // A box without a category has its model's, and one without a key is keyed by its id.
    let inherited = |each: &CloudBox, property: &Property| match property.kind {
        Kind::Category => Some(Value::Text(model.category.name().into())),
        _ => Some(Value::Whole(each.id.0)),
    };
    let fields = || Fields::of(&alone, reading).inheriting(inherited);
    // What is changed most comes first: the place is rather changed by its handles.
    section(ui, "Sprites", |ui| {
        fill_fields(ui, boxes, actions);
        fields().show(ui, "Change sprites", actions, |fields, ui| fields.rows(ui, BOX_SPRITES), replace);
        let row = Command::FitSprites.row();
        if ui.button(row.name).on_hover_text(row.help).clicked() {
            actions.push(Action::Command(row.command));
        }
    });
    section(ui, "Place and size", |ui| {
        fields().show(ui, "Change box", actions, |fields, ui| fields.rows(ui, BOX_PLACE), replace_resized);
    });
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
    section(ui, "Shading", |ui| shading(ui, model, boxes, reading, actions));
}

/// In which group the boxes' sprites are.
fn shading(ui: &mut Ui, model: &CloudModel, boxes: &[ModelBox<'_>], reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let alone: Vec<&CloudBox> = boxes.iter().map(|(_, each)| *each).collect();
    let replace = |at: usize, each| Edit::Box(boxes[at].0, ListEdit::Replace(each));
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

/// `new` as a hand wants it that changed the size of `old` in its field: the base stays where it is and so does how the box
/// is filled.
fn resized(old: &CloudBox, new: CloudBox, keep_fill: bool) -> CloudBox {
    if new.size == old.size {
        return new;
    }
    let center = new.center + new.orientation * (DVec3::Y * ((new.size.y - old.size.y) * 0.5));
    let same_fill = (new.sprite_count, new.width, new.height) == (old.sprite_count, old.width, old.height);
    let filled =
        if keep_fill && same_fill { fill::resized(&CloudBox { size: old.size, ..new.clone() }, new.size) } else { new };
    CloudBox { center, ..filled }
}

/// How densely the boxes are filled and with how large sprites, as shares of what usually fills a box of that size: another
/// way to say *Sprites*, *Width* and *Height*.
fn fill_fields(ui: &mut Ui, boxes: &[ModelBox<'_>], actions: &mut Vec<Action>) {
    type Field = (Number, fn(&CloudBox) -> f64, fn(&CloudBox, f64) -> CloudBox);
    const FIELDS: [Field; 2] =
        [(DENSITY, fill::density, fill::with_density), (RELATIVE_SIZE, fill::sprite_size, fill::with_sprite_size)];
    let Some((_, first)) = boxes.first() else { return };
    egui::Grid::new("fill").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
        for (number, get, set) in FIELDS {
            ui.label(number.label).on_hover_text(number.doc);
            let shown = (get(first) * 100.0).round() / 100.0;
            let mut value = shown;
            if number_field(ui, number.label, &number, &mut value, false) && value != shown {
                let edits = boxes.iter().map(|(of, each)| Edit::Box(*of, ListEdit::Replace(set(each, value))));
                let live = ui.input(|input| input.pointer.any_down());
                actions.push(Action::Change { name: number.label, edits: edits.collect(), live });
            }
            ui.end_row();
        }
    });
}
