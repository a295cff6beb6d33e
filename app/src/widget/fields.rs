//! Fields of the inspector: every number reads its [`Parameter`] for label, unit, range and tooltip.
//!
//! [`fields`] shows the rows of the first of several things, and gives the others what was changed in it: the same
//! function that lays the rows out is run over each of them without a window, and finds the changed values by their
//! names. Each value has a name, also for screen readers and tests: the label, and for parts of a vector or range the
//! label and the part.

mod category;
mod color;
mod number;
mod picker;
mod refusal;
mod text;

use crate::state::Action;
use crate::theme;
use cloudwright_core::document::Edit;
use cloudwright_core::parameter::Parameter;
use egui::{Grid, Response, RichText, Ui};
use glam::DVec3;
use std::any::Any;

pub(crate) use color::{brightness_field, color_field, color32};
pub(crate) use number::number_field;

/// What was changed in the thing that is shown: names and values.
type Record = Vec<(String, Box<dyn Any>)>;

/// Rows of a name and one or more values, shown or filled in.
pub(crate) struct Fields<'a> {
    ui: Option<&'a mut Ui>,
    record: &'a mut Record,
}

/// The values of one row.
pub(crate) struct Values<'a> {
    ui: Option<&'a mut Ui>,
    record: &'a mut Record,
}

/// Shows `rows` of the first of `things` in two columns. What was touched there is changed in all of them, by the edits
/// that `edit` makes of the changed things, under `name`: as part of a gesture while a button is down.
pub(crate) fn fields<T: Clone>(
    ui: &mut Ui,
    name: &'static str,
    actions: &mut Vec<Action>,
    things: &[T],
    rows: impl Fn(&mut Fields<'_>, &mut T),
    edit: impl Fn(T) -> Edit,
) {
    let Some((first, others)) = things.split_first() else { return };
    let mut record = Record::new();
    let mut first = first.clone();
    Grid::new(name).num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
        rows(&mut Fields { ui: Some(ui), record: &mut record }, &mut first);
    });
    if record.is_empty() {
        return;
    }
    let mut edits = vec![edit(first)];
    edits.extend(others.iter().map(|other| {
        let mut other = other.clone();
        rows(&mut Fields { ui: None, record: &mut record }, &mut other);
        edit(other)
    }));
    let live = ui.input(|input| input.pointer.any_down());
    actions.push(Action::Change { name, edits, live });
}

impl Fields<'_> {
    /// A row: its name, and what `values` puts beside it.
    pub(crate) fn row(&mut self, label: &str, doc: &str, values: impl FnOnce(&mut Values<'_>)) {
        let record = &mut *self.record;
        let Some(ui) = self.ui.as_deref_mut() else {
            return values(&mut Values { ui: None, record });
        };
        let name = ui.label(label);
        if !doc.is_empty() {
            name.on_hover_text(doc);
        }
        ui.horizontal(|ui| values(&mut Values { ui: Some(ui), record }));
        ui.end_row();
    }

    /// A number under its parameter's own label.
    pub(crate) fn number(&mut self, parameter: &Parameter, value: &mut f64) {
        self.labelled(parameter.label, parameter, value);
    }

    /// A number under another label.
    pub(crate) fn labelled(&mut self, label: &str, parameter: &Parameter, value: &mut f64) {
        self.row(label, parameter.doc, |values| values.number(label, parameter, value));
    }

    /// A whole number.
    pub(crate) fn whole(&mut self, parameter: &Parameter, value: &mut u32) {
        self.row(parameter.label, parameter.doc, |values| values.whole(parameter.label, parameter, value));
    }

    /// Three whole numbers along the axes.
    pub(crate) fn whole_vector(&mut self, parameter: &Parameter, value: &mut [u32; 3]) {
        self.row(parameter.label, parameter.doc, |values| {
            for (axis, part) in AXES.iter().zip(value) {
                values.whole(&format!("{} {axis}", parameter.label), parameter, part);
            }
        });
    }

    /// A point or an extent.
    pub(crate) fn vector(&mut self, label: &str, parameter: &Parameter, value: &mut DVec3) {
        self.row(label, parameter.doc, |values| {
            for (axis, part) in AXES.iter().zip([&mut value.x, &mut value.y, &mut value.z]) {
                values.number(&format!("{label} {axis}"), parameter, part);
            }
        });
    }

    /// Smallest and largest. One pushes the other along, so that they never cross.
    pub(crate) fn range(&mut self, label: &str, parameter: &Parameter, value: &mut [f64; 2]) {
        self.row(label, parameter.doc, |values| {
            let [low, high] = value;
            let before = [*low, *high];
            values.number(&format!("{label} from"), parameter, low);
            values.text("to");
            values.number(&format!("{label} to"), parameter, high);
            if *low != before[0] {
                *high = high.max(*low);
            }
            if *high != before[1] {
                *low = low.min(*high);
            }
        });
    }

    /// One of a few.
    pub(crate) fn choice<T: PartialEq + Clone + 'static>(
        &mut self,
        label: &str,
        doc: &str,
        value: &mut T,
        all: &[(T, String)],
    ) {
        self.row(label, doc, |values| {
            values.value(label, value, |ui, value| {
                let before = value.clone();
                let shown = all.iter().find(|(each, _)| each == value).map_or("", |(_, name)| name);
                let combo = egui::ComboBox::from_id_salt(label).selected_text(shown).show_ui(ui, |ui| {
                    for (each, name) in all {
                        ui.selectable_value(value, each.clone(), name);
                    }
                });
                name_it(ui, &combo.response, label);
                *value != before
            });
        });
    }

    /// Yes or no.
    pub(crate) fn check(&mut self, label: &str, doc: &str, value: &mut bool) {
        self.row("", "", |values| {
            values.value(label, value, |ui, value| ui.checkbox(value, label).on_hover_text(doc).changed());
        });
    }
}

impl Values<'_> {
    /// One value: `show` puts it on the screen and tells whether it was changed.
    pub(crate) fn value<T: Clone + 'static>(
        &mut self,
        name: &str,
        value: &mut T,
        show: impl FnOnce(&mut Ui, &mut T) -> bool,
    ) {
        if let Some(ui) = self.ui.as_deref_mut() {
            if show(ui, value) {
                self.record.push((name.into(), Box::new(value.clone())));
            }
        } else if let Some((_, changed)) = self.record.iter().find(|(each, _)| each == name)
            && let Some(changed) = changed.downcast_ref::<T>()
        {
            *value = changed.clone();
        }
    }

    /// Words between values.
    pub(crate) fn text(&mut self, text: &str) {
        if let Some(ui) = self.ui.as_deref_mut() {
            ui.label(text);
        }
    }
}

const AXES: [&str; 3] = ["x", "y", "z"];

/// A line between groups of rows.
pub(crate) fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(theme::GAP);
    ui.label(RichText::new(text).strong());
    ui.separator();
}

/// What screen readers call it, and tests.
pub(crate) fn name_it(ui: &Ui, response: &Response, name: &str) {
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
}
