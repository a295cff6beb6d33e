//! Fields for the properties of one or several things: the rows come from the core's table.
//!
//! Shown are the values of the first thing; where those of the others differ, the field says that they are mixed. What
//! is changed is set in all of them, property by property. Each value has a name, also for screen readers and tests: the
//! property's label, and for parts of a vector or range the label and the part.
//!
//! Of things whose owners are told, values that a track moves are shown as they are at the clock's time ([`keyed`]).

mod choice;
pub(super) mod color;
mod key;
mod keyed;
mod number;
mod picker;
pub(crate) mod refusal;
mod seed;
mod text;

use crate::state::{Action, Reading};
use crate::theme;
use cloudwright_core::document::Edit;
use cloudwright_core::property::{Choice, Described, Kind, Owner, Property, Row, Value};
use egui::{Grid, Response, Ui};

pub(crate) use choice::combo;
pub(crate) use color::{brightness_field, color_field, color32};
pub(crate) use key::{field_to_key, key_button};
pub(crate) use number::{ENDLESS, Span, number_field, span_field};
pub(crate) use seed::seed_field;
pub(crate) use text::{MOST_CHARACTERS, lines_field, text_field};

/// In the place of values that differ.
const MIXED: &str = "mixed";
const MIXED_DOC: &str = "They differ. What is set here, all of them get.";

/// Rows of a name and one or more values of `things`.
pub(crate) struct Fields<'a, T: 'static> {
    things: &'a [&'a T],
    reading: &'a Reading<'a>,
    /// What a thing has that has none of its own.
    inherited: Box<dyn Fn(&T, &Property) -> Option<Value> + 'a>,
    /// The shading groups that there are to choose from.
    groups: Vec<(Value, String)>,
    /// Whose values they are in tracks; none if they have none.
    owners: Vec<Owner>,
    asked: Vec<Action>,
    changes: Vec<Change<T>>,
}

/// What all things are to get.
enum Change<T: 'static> {
    Set(&'static Row<T>, usize, Value),
    /// Each another seed.
    Roll(&'static Row<T>),
    /// Each the seed that it has, as its own or as one that it inherits.
    Own(&'static Row<T>, bool),
}

impl<'a, T: Clone + PartialEq> Fields<'a, T> {
    /// For `things`, of which the first one's values are shown.
    pub(crate) fn of(things: &'a [&'a T], reading: &'a Reading<'a>) -> Self {
        Self {
            things,
            reading,
            inherited: Box::new(|_, _| None),
            groups: Vec::new(),
            owners: Vec::new(),
            asked: Vec::new(),
            changes: Vec::new(),
        }
    }

    /// Where a thing has no value of its own, what `inherited` says is shown.
    pub(crate) fn inheriting(self, inherited: impl Fn(&T, &Property) -> Option<Value> + 'a) -> Self {
        Self { inherited: Box::new(inherited), ..self }
    }

    /// With these shading groups to choose from.
    pub(crate) fn with_groups(self, groups: impl Iterator<Item = (u64, String)>) -> Self {
        Self { groups: groups.map(|(id, name)| (Value::Whole(id), name)).collect(), ..self }
    }

    /// Whose values they are, in the things' order: what can be keyed shows its diamond.
    pub(crate) fn owned(self, owners: impl IntoIterator<Item = Owner>) -> Self {
        Self { owners: owners.into_iter().collect(), ..self }
    }

    /// Shows `rows` in two columns. What was changed there is set in all things, by the edits that `edit` makes of the
    /// changed ones and their positions, under `name`: as part of a gesture while a button is down.
    pub(crate) fn show(
        mut self,
        ui: &mut Ui,
        name: &'static str,
        actions: &mut Vec<Action>,
        rows: impl FnOnce(&mut Self, &mut Ui),
        edit: impl Fn(usize, T) -> Edit,
    ) {
        if self.things.is_empty() {
            return;
        }
        Grid::new(name).num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| rows(&mut self, ui));
        let live = ui.input(|input| input.pointer.any_down());
        self.carry_out(name, live, actions, edit);
    }

    /// Sets a number in all things as its field would, without showing one: for a handle that stands for it.
    pub(crate) fn set_number(
        mut self,
        (row, number): (&'static Row<T>, f64),
        name: &'static str,
        live: bool,
        actions: &mut Vec<Action>,
        edit: impl Fn(usize, T) -> Edit,
    ) {
        self.set(row, 0, Value::Number(number));
        self.carry_out(name, live, actions, edit);
    }

    fn carry_out(mut self, name: &'static str, live: bool, actions: &mut Vec<Action>, edit: impl Fn(usize, T) -> Edit) {
        actions.append(&mut self.asked);
        if self.changes.is_empty() {
            return;
        }
        let mut keyed = keyed::Changed::default();
        let mut edits: Vec<Edit> = Vec::new();
        for (at, thing) in self.things.iter().enumerate() {
            let after = self.changed(at, thing, &mut keyed);
            if after != **thing {
                edits.push(edit(at, after));
            }
        }
        keyed.ask(name, edits, live, self.reading, actions);
    }

    /// `thing` after all changes but those that are set as keys. What it does not have, such as when a cloud begins that
    /// does not form, it does not get.
    fn changed(&self, at: usize, thing: &T, keyed: &mut keyed::Changed) -> T {
        let mut thing = thing.clone();
        for change in &self.changes {
            let _ = match change {
                Change::Set(row, part, value) => self.set_in(&mut thing, at, (*row, *part, value), keyed),
                Change::Roll(row) => self.roll(row, &mut thing),
                Change::Own(row, own) => self.own(row, &mut thing, *own),
            };
        }
        thing
    }

    /// All rows that the things have.
    pub(crate) fn all(&mut self, ui: &mut Ui)
    where
        T: Described,
    {
        T::rows().for_each(|row| self.row(ui, row, row.property.label));
    }

    /// One row after the other.
    pub(crate) fn rows(&mut self, ui: &mut Ui, rows: &'static [Row<T>]) {
        for row in rows {
            self.row(ui, row, row.property.label);
        }
    }

    /// A row under that label; nothing if the first thing does not have it.
    pub(crate) fn row(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str) {
        let Some(value) = self.value(row, 0, 0) else { return };
        match row.property.kind {
            Kind::Number(_) | Kind::Angle(_) | Kind::Integer(_) => self.numbers(ui, row, label),
            Kind::Color(_) => self.color(ui, row, label),
            Kind::Seed => self.seed(ui, row, label),
            Kind::Flag => self.flag(ui, row, label, value == Value::Flag(true)),
            Kind::Text => self.text(ui, row, label, &value),
            Kind::Choice(choices) => {
                let named = |choice: &Choice| (Value::Text(choice.name.into()), choice.label.into());
                self.choice(ui, row, label, choices.iter().map(named).collect());
            }
            Kind::Category => self.category(ui, row, label, &value),
            Kind::Model => {
                let models = self.reading.session.scene().models.iter();
                self.choice(ui, row, label, models.map(|each| (Value::Whole(each.id.0), each.name.clone())).collect());
            }
            Kind::Folder => {
                let folders = self.reading.session.scene().folders.iter();
                self.choice(ui, row, label, folders.map(|each| (Value::Whole(each.id.0), each.name.clone())).collect());
            }
            Kind::Path => {
                let paths = self.reading.session.scene().paths.iter();
                self.choice(ui, row, label, paths.map(|each| (Value::Whole(each.id.0), each.name.clone())).collect());
            }
            Kind::Group => self.choice(ui, row, label, self.groups.clone()),
        }
    }

    /// The part's value in the first thing, or what that inherits.
    fn effective(&self, row: &Row<T>, part: usize, thing: &T) -> Option<Value> {
        row.value(thing, part).map(|value| match value {
            Value::None => (self.inherited)(thing, &row.property).unwrap_or(Value::None),
            own => own,
        })
    }

    /// Whether what `get` reads of the things is not the same in all that have it.
    fn differ(&self, get: impl Fn(&T) -> Option<Value>) -> bool {
        let mut values = self.things.iter().filter_map(|thing| get(thing));
        values.next().is_some_and(|first| values.any(|other| other != first))
    }

    fn set(&mut self, row: &'static Row<T>, part: usize, value: Value) {
        self.changes.push(Change::Set(row, part, value));
    }
}

/// A row's name in the first column, and what `values` puts beside it.
fn row_of(ui: &mut Ui, indent: f32, label: &str, doc: &str, values: impl FnOnce(&mut Ui)) {
    named(ui, indent, label, doc);
    ui.horizontal(values);
    ui.end_row();
}

/// A row's name.
fn named(ui: &mut Ui, indent: f32, label: &str, doc: &str) {
    if indent > 0.0 {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 0.0;
            ui.add_space(indent);
            name_with(ui, label, doc);
        });
    } else {
        name_with(ui, label, doc);
    }
}

fn name_with(ui: &mut Ui, label: &str, doc: &str) {
    let name = ui.label(label);
    if !doc.is_empty() {
        name.on_hover_text(doc);
    }
}

/// A button that is painted by hand, for screen readers and tests.
pub(crate) fn name_button(ui: &Ui, response: &Response, name: &str) {
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(egui::accesskit::Role::Button);
        node.set_label(name);
    });
}

/// What screen readers call it, and tests.
pub(crate) fn name_it(ui: &Ui, response: &Response, name: &str) {
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
}
