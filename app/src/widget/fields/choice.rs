//! One of a few: yes or no, from a list, or a category by its picture.

use super::{Fields, MIXED, MIXED_DOC, name_it, row_of};
use crate::theme;
use crate::widget::picture_choice::{category_choice, category_name};
use cloudwright_core::property::{Row, Value};
use cloudwright_core::scene::Category;
use egui::{Checkbox, Ui};

impl<T: Clone + PartialEq> Fields<'_, T> {
    /// Yes or no.
    pub(super) fn flag(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str, mut on: bool) {
        let mixed = self.differ(|thing| row.value(thing, 0));
        let clicked = check(ui, self.indent(), label, row.property.doc, mixed, &mut on);
        if clicked {
            self.set(row, 0, Value::Flag(on));
        }
    }

    /// One of `all`; or none, if the property may have none.
    pub(super) fn choice(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str, mut all: Vec<(Value, String)>) {
        if let Some(none) = row.property.none {
            all.insert(0, (Value::None, none.into()));
        }
        let value = self.things.first().and_then(|first| row.value(first, 0));
        let mixed = self.differ(|thing| row.value(thing, 0));
        let shown = all.iter().find(|(each, _)| !mixed && Some(each) == value.as_ref());
        let text = shown.map_or(if mixed { MIXED } else { "" }, |(_, name)| name);
        let mut chosen = None;
        row_of(ui, self.indent(), label, row.property.doc, |ui| {
            let is_shown = |each: &Value| shown.is_some_and(|(shown, _)| shown == each);
            chosen = combo(ui, label, if mixed { MIXED_DOC } else { "" }, text, &all, is_shown);
        });
        if let Some(chosen) = chosen {
            self.set(row, 0, chosen);
        }
    }

    /// A category.
    pub(super) fn category(&mut self, ui: &mut Ui, row: &'static Row<T>, label: &str, value: &Value) {
        let doc = row.property.doc;
        let mixed = self.differ(|thing| row.value(thing, 0));
        let own = category_of(value);
        let inherited = self.things.first().and_then(|first| (self.inherited)(first, &row.property));
        let none = row.property.none.zip(inherited.as_ref().and_then(category_of));
        let none = none.map(|(none, category)| format!("{none}: {}", category_name(category)));
        let shown = if mixed { MIXED.into() } else { own.map(category_name).or(none.clone()).unwrap_or_default() };
        let mut chosen = None;
        row_of(ui, self.indent(), label, doc, |ui| {
            let menu = ui.menu_button(shown, |ui| {
                ui.set_width(theme::CATEGORIES_WIDTH);
                if let Some(none) = none
                    && ui.selectable_label(own.is_none() && !mixed, none).clicked()
                {
                    chosen = Some(Value::None);
                }
                let category = category_choice(ui, &mut self.reading.thumbnails.borrow_mut(), own.filter(|_| !mixed));
                chosen = category.map(|category| Value::Text(category.name().into())).or(chosen.take());
            });
            name_it(ui, &menu.response, label);
            menu.response.on_hover_text(if mixed { MIXED_DOC } else { doc });
        });
        if let Some(chosen) = chosen {
            self.set(row, 0, chosen);
        }
    }
}

/// One of `all`, each with its name, from a list that hangs from `text`. Which was chosen in this frame.
pub(crate) fn combo<T: Clone>(
    ui: &mut Ui,
    label: &str,
    doc: &str,
    text: &str,
    all: &[(T, String)],
    is_shown: impl Fn(&T) -> bool,
) -> Option<T> {
    let mut chosen = None;
    let combo = egui::ComboBox::from_id_salt(label).selected_text(text).show_ui(ui, |ui| {
        for (each, name) in all {
            if ui.selectable_label(is_shown(each), name).clicked() {
                chosen = Some(each.clone());
            }
        }
    });
    name_it(ui, &combo.response, label);
    if !doc.is_empty() {
        combo.response.on_hover_text(doc);
    }
    chosen
}

/// A box to tick, in the second column. Whether it was clicked.
pub(super) fn check(ui: &mut Ui, indent: f32, label: &str, doc: &str, mixed: bool, on: &mut bool) -> bool {
    let mut clicked = false;
    row_of(ui, indent, "", "", |ui| {
        let ticked = ui.add(Checkbox::new(on, label).indeterminate(mixed));
        clicked = ticked.clicked();
        ticked.on_hover_text(if mixed { format!("{doc}\n{MIXED_DOC}") } else { doc.into() });
    });
    clicked
}

fn category_of(value: &Value) -> Option<Category> {
    let Value::Text(name) = value else { return None };
    Category::ALL.into_iter().find(|category| category.name() == name)
}
