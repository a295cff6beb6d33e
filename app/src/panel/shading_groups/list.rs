//! The groups one by one: the named ones, then the boxes that are groups of their own.
//!
//! A row has the tint, the name, the sprites that the cull left, and a warning where they are too many for one lump. A
//! click selects, a second one the members; a selection of boxes or sprites can be put into a row's group.

use crate::state::{Action, Choose, Item, Reading};
use crate::theme::{self, icon};
use crate::widget::name_it;
use cloudwright_core::arrange::auto_group::MOST_SPRITES;
use cloudwright_core::arrange::delete;
use cloudwright_core::arrange::group::{self, Destination};
use cloudwright_core::scene::{BoxId, CloudModel, GroupId, SpriteEdit};
use cloudwright_core::sprites::{GroupKey, PlacedCloud};
use egui::{Align, Atom, Button, IdSalt, Label, Layout, Response, RichText, Sense, Ui, Vec2, vec2};

/// Whether boxes or sprites are selected.
pub(super) fn has_members(reading: &Reading<'_>) -> bool {
    let is_member = |item: &Item| matches!(item, Item::Box(..) | Item::Sprite(..));
    reading.view.selection.items().iter().any(is_member)
}

/// What a row stands for.
#[derive(Clone, Copy)]
enum Lump {
    Named(GroupId),
    Own(BoxId),
}

struct Row<'a> {
    lump: Lump,
    name: String,
    model: &'a CloudModel,
    placed: Option<&'a PlacedCloud>,
}

/// The list.
pub(super) fn show(ui: &mut Ui, model: &CloudModel, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let cloud = reading.view.selection.cloud(reading.session.scene());
    let placed = cloud.and_then(|cloud| reading.session.placed(cloud.id));
    let row = |lump, name| Row { lump, name, model, placed };
    for group in &model.groups {
        row(Lump::Named(group.id), group_name(&group.name, group.id)).show(ui, reading, actions);
    }
    for each in model.boxes.iter().filter(|each| each.group.is_none()) {
        let name = if each.name.is_empty() { format!("box {}", each.id) } else { each.name.clone() };
        row(Lump::Own(each.id), format!("{name} (its own)")).show(ui, reading, actions);
    }
    if model.boxes.is_empty() && model.groups.is_empty() {
        ui.weak("The model has no boxes yet.");
    }
}

/// As on screen.
pub(in crate::panel) fn group_name(name: &str, id: GroupId) -> String {
    if name.is_empty() { format!("group {id}") } else { name.into() }
}

/// Boxes in the group, and single sprites that were put there.
pub(in crate::panel) fn members(model: &CloudModel, group: GroupId) -> Vec<Item> {
    let mut members = Vec::new();
    for each in &model.boxes {
        members.extend((each.group == Some(group)).then_some(Item::Box(model.id, each.id)));
        let is_in = |edit: &&SpriteEdit| edit.group == Some(group) && edit.index < each.sprite_count;
        let sprites = each.sprite_edits.iter().filter(is_in);
        members.extend(sprites.map(|edit| Item::Sprite(model.id, each.id, edit.index)));
    }
    members
}

impl Row<'_> {
    fn item(&self) -> Item {
        match self.lump {
            Lump::Named(id) => Item::Group(self.model.id, id),
            Lump::Own(id) => Item::Box(self.model.id, id),
        }
    }

    /// The sprites of each of its lumps.
    fn counts(&self) -> impl Iterator<Item = usize> + '_ {
        let groups = self.placed.into_iter().flat_map(|placed| placed.groups.iter());
        let its = |key: GroupKey| match (self.lump, key) {
            (Lump::Named(id), GroupKey::Named(other)) => id == other,
            (Lump::Own(id), GroupKey::Lump(other, _)) => id == other,
            _ => false,
        };
        groups.filter(move |group| its(group.key)).map(|group| group.sprite_count)
    }

    fn members(&self) -> Vec<Item> {
        match self.lump {
            Lump::Named(id) => members(self.model, id),
            Lump::Own(_) => vec![self.item()],
        }
    }

    fn show(&self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let size = vec2(ui.available_width(), ui.spacing().interact_size.y);
        ui.allocate_ui_with_layout(size, Layout::right_to_left(Align::Center), |ui| {
            if let Lump::Named(id) = self.lump {
                self.buttons(ui, id, reading, actions);
            }
            self.count(ui);
            ui.with_layout(Layout::left_to_right(Align::Center).with_main_justify(true), |ui| {
                self.name_button(ui, reading, actions);
            });
        });
    }

    fn name_button(&self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let selected = reading.view.selection.contains(self.item());
        let swatch = IdSalt::new("swatch");
        let mark = Atom::custom(swatch, Vec2::splat(theme::SWATCH));
        let button = Button::selectable(selected, (mark, self.name.as_str(), Atom::grow())).truncate().atom_ui(ui);
        if let Some(rect) = button.rect(swatch) {
            let id = match self.lump {
                Lump::Named(id) => id.0,
                Lump::Own(id) => id.0,
            };
            ui.painter().rect_filled(rect, theme::SWATCH * 0.25, theme::group_tint(id));
        }
        let response = button.response;
        name_it(ui, &response, &format!("Shading of {}", self.name));
        let modifiers = ui.input(|input| input.modifiers);
        let response = response.on_hover_text("Double-click to select its boxes and sprites");
        if response.double_clicked() {
            actions.push(Action::Select { items: self.members(), through: None, how: Choose::Only });
        } else if response.clicked() {
            let how = if modifiers.command || modifiers.shift { Choose::Toggle } else { Choose::Only };
            actions.push(Action::Select { items: vec![self.item()], through: None, how });
        }
    }

    fn count(&self, ui: &mut Ui) {
        let total: usize = self.counts().sum();
        let crowd = self.counts().max().unwrap_or(0);
        let label = ui.label(RichText::new(total.to_string()).weak());
        say(ui, &label, &format!("{total} sprites of {}", self.name));
        if crowd > MOST_SPRITES {
            let mark = RichText::new(icon::WARNING).color(theme::warning(ui));
            let sign = ui.add(Label::new(mark).sense(Sense::hover()));
            let text = format!("{crowd} sprites in one lump of {}: above {MOST_SPRITES} they look flat", self.name);
            say(ui, &sign, &text);
            sign.on_hover_text(text);
        }
    }

    fn buttons(&self, ui: &mut Ui, id: GroupId, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let (scene, model) = (reading.session.scene(), self.model.id);
        if quiet(ui, icon::TRASH, &format!("Delete {}", self.name), true).clicked() {
            let edits = delete::things(scene, &[Item::Group(model, id)]).edits;
            actions.push(Action::Change { name: "Delete shading group", edits, live: false });
        }
        let name = format!("Assign selection to {}", self.name);
        if quiet(ui, icon::PAINT_BUCKET, &name, has_members(reading)).clicked() {
            let things = reading.view.selection.items();
            let edits = group::put(scene, model, things, &Destination::Existing(id)).edits;
            actions.push(Action::Change { name: "Assign to shading group", edits, live: false });
        }
    }
}

/// What screen readers say instead of a text that explains itself by its place only.
fn say(ui: &Ui, label: &Response, text: &str) {
    ui.ctx().accesskit_node_builder(label.id, |node| node.set_value(text));
}

fn quiet(ui: &mut Ui, glyph: &str, name: &str, enabled: bool) -> Response {
    let response = ui.add_enabled(enabled, Button::new(RichText::new(glyph).weak()).frame(false));
    name_it(ui, &response, name);
    response.on_hover_text(name)
}
