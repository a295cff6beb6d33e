//! Fields of the inspector: every number reads its [`Parameter`] for label, unit, range and tooltip.
//!
//! A [`Fields`] works on a copy of a thing and notes whether a field was touched and whether the gesture still goes
//! on; the panel then returns the copy as one action. Each field has a name for screen readers and tests: the label,
//! and for parts of a vector or range the label and the part.

use crate::editor::Action;
use crate::theme;
use cloudwright_core::color::{Rgb, linear_from_srgb, srgb_from_linear};
use cloudwright_core::document::Edit;
use cloudwright_core::parameter::{self, Parameter};
use egui::{DragValue, Grid, Id, Response, RichText, TextEdit, Ui};
use glam::DVec3;

/// Rows of a name and one or more values.
pub(super) struct Fields<'u> {
    ui: &'u mut Ui,
    touched: bool,
}

/// Shows `rows` in two columns. If one was touched, `edit` is returned under `name`: as part of a gesture while a
/// button is down.
pub(super) fn fields(
    ui: &mut Ui,
    name: &'static str,
    actions: &mut Vec<Action>,
    rows: impl FnOnce(&mut Fields<'_>) -> Edit,
) {
    let grid = Grid::new(name).num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
        let mut fields = Fields { ui, touched: false };
        let edit = rows(&mut fields);
        fields.touched.then_some(edit)
    });
    if let Some(edit) = grid.inner {
        let live = ui.input(|input| input.pointer.any_down());
        actions.push(Action::Change { name, edit: Box::new(edit), live });
    }
}

impl Fields<'_> {
    /// A number under its parameter's own label.
    pub(super) fn number(&mut self, parameter: &Parameter, value: &mut f64) {
        self.labelled(parameter.label, parameter, value);
    }

    /// A number under another label.
    pub(super) fn labelled(&mut self, label: &str, parameter: &Parameter, value: &mut f64) {
        self.row(label, parameter.doc, |ui| drag(ui, label, parameter, value, false));
    }

    /// A whole number.
    pub(super) fn whole(&mut self, parameter: &Parameter, value: &mut u32) {
        let mut number = f64::from(*value);
        self.row(parameter.label, parameter.doc, |ui| drag(ui, parameter.label, parameter, &mut number, true));
        *value = number as u32;
    }

    /// Three whole numbers along the axes.
    pub(super) fn whole_vector(&mut self, parameter: &Parameter, value: &mut [u32; 3]) {
        self.row(parameter.label, parameter.doc, |ui| {
            ["x", "y", "z"].iter().zip(value).fold(false, |touched, (axis, part)| {
                let mut number = f64::from(*part);
                let changed = drag(ui, &format!("{} {axis}", parameter.label), parameter, &mut number, true);
                *part = number as u32;
                touched | changed
            })
        });
    }

    /// A point or an extent.
    pub(super) fn vector(&mut self, label: &str, parameter: &Parameter, value: &mut DVec3) {
        self.row(label, parameter.doc, |ui| {
            let parts = ["x", "y", "z"].into_iter().zip([&mut value.x, &mut value.y, &mut value.z]);
            parts.fold(false, |touched, (axis, part)| {
                touched | drag(ui, &format!("{label} {axis}"), parameter, part, false)
            })
        });
    }

    /// Smallest and largest. One pushes the other along, so that they never cross.
    pub(super) fn range(&mut self, label: &str, parameter: &Parameter, value: &mut [f64; 2]) {
        self.row(label, parameter.doc, |ui| {
            let [low, high] = value;
            let low_touched = drag(ui, &format!("{label} from"), parameter, low, false);
            ui.label("to");
            let high_touched = drag(ui, &format!("{label} to"), parameter, high, false);
            if low_touched {
                *high = high.max(*low);
            }
            if high_touched {
                *low = low.min(*high);
            }
            low_touched || high_touched
        });
    }

    /// A seed: any whole number, no use in dragging it.
    pub(super) fn seed(&mut self, value: &mut u64) {
        const DOC: &str = "Another number strews the sprites anew.";
        self.row("Seed", DOC, |ui| {
            let response = ui.add(DragValue::new(value).speed(0.05).update_while_editing(false));
            name_it(ui, &response, "Seed");
            response.on_hover_text(DOC).changed()
        });
    }

    /// A name. It is taken over when the field is left.
    pub(super) fn text(&mut self, label: &str, value: &mut String) {
        self.row(label, "", |ui| {
            let id: Id = ui.next_auto_id();
            let mut typed = ui.data(|data| data.get_temp(id)).unwrap_or_else(|| value.clone());
            let response = ui.add(TextEdit::singleline(&mut typed).desired_width(f32::INFINITY));
            name_it(ui, &response, label);
            if response.has_focus() {
                ui.data_mut(|data| data.insert_temp(id, typed));
                return false;
            }
            ui.data_mut(|data| data.remove::<String>(id));
            let kept = response.lost_focus() && !ui.input(|input| input.key_pressed(egui::Key::Escape));
            let changed = kept && typed != *value;
            if changed {
                *value = typed;
            }
            changed
        });
    }

    /// One of a few.
    pub(super) fn choice<T: PartialEq + Clone>(&mut self, label: &str, doc: &str, value: &mut T, all: &[(T, String)]) {
        self.row(label, doc, |ui| {
            let shown = all.iter().find(|(each, _)| each == value).map_or("", |(_, name)| name);
            let combo = egui::ComboBox::from_id_salt(label).selected_text(shown).show_ui(ui, |ui| {
                let mut touched = false;
                for (each, name) in all {
                    touched |= ui.selectable_value(value, each.clone(), name).changed();
                }
                touched
            });
            name_it(ui, &combo.response, label);
            combo.inner.unwrap_or(false)
        });
    }

    /// Yes or no.
    pub(super) fn check(&mut self, label: &str, doc: &str, value: &mut bool) {
        self.row("", "", |ui| ui.checkbox(value, label).on_hover_text(doc).changed());
    }

    /// A colour with its brightness beside it: the picker shows sRGB, which ends at white.
    pub(super) fn color(&mut self, label: &str, value: &mut Rgb, alpha: Option<&mut f32>) {
        self.row(label, parameter::COLOR.doc, |ui| {
            let brightness = value.to_array().into_iter().fold(1.0, f32::max);
            let mut srgb = (*value * (1.0 / brightness)).to_array().map(|c| srgb_from_linear(c.clamp(0.0, 1.0)));
            let mut bright = f64::from(brightness);
            let mut bytes = srgb.map(|c| (c * 255.0).round() as u8);
            let response = ui.color_edit_button_srgb(&mut bytes);
            name_it(ui, &response, label);
            let mut touched = response.on_hover_text(parameter::COLOR.doc).changed();
            if touched {
                srgb = bytes.map(|c| f32::from(c) / 255.0);
            }
            let times =
                Parameter { min: 1.0, label: "Brightness", doc: "Above 1: brighter than white.", ..parameter::COLOR };
            touched |= drag(ui, &format!("{label} brightness"), &times, &mut bright, false);
            if touched {
                let [r, g, b] = srgb.map(|c| linear_from_srgb(c) * bright as f32);
                *value = Rgb::new(r, g, b);
            }
            if let Some(alpha) = alpha {
                let mut opacity = f64::from(*alpha);
                if drag(ui, &format!("{label} opacity"), &parameter::ALPHA, &mut opacity, false) {
                    *alpha = opacity as f32;
                    touched = true;
                }
            }
            touched
        });
    }

    /// A row of the caller's own.
    pub(super) fn row(&mut self, label: &str, doc: &str, content: impl FnOnce(&mut Ui) -> bool) {
        let name = self.ui.label(label);
        if !doc.is_empty() {
            name.on_hover_text(doc);
        }
        self.touched |= self.ui.horizontal(content).inner;
        self.ui.end_row();
    }
}

/// A line between groups of rows.
pub(super) fn heading(ui: &mut Ui, text: &str) {
    ui.add_space(theme::GAP);
    ui.label(RichText::new(text).strong());
    ui.separator();
}

/// The one field for a number. Whether it was changed.
fn drag(ui: &mut Ui, name: &str, parameter: &Parameter, value: &mut f64, whole: bool) -> bool {
    let before = *value;
    let mut field = DragValue::new(value)
        .range(parameter.min..=parameter.max)
        .clamp_existing_to_range(false)
        .update_while_editing(false)
        .speed(speed(parameter, before, whole))
        .max_decimals(if whole { 0 } else { 3 })
        .min_size(egui::vec2(theme::NUMBER_WIDTH, ui.spacing().interact_size.y));
    if !parameter.unit.is_empty() {
        let space = if parameter.unit == "°" { "" } else { " " };
        field = field.suffix(format!("{space}{}", parameter.unit));
    }
    let response = ui.add(field);
    name_it(ui, &response, name);
    let changed = response.changed();
    response.on_hover_text(tooltip(name, parameter));
    // "nan" can be typed.
    if !parameter.allows(*value) {
        *value = before;
    }
    changed && *value != before
}

/// What a point of dragging changes: a length by its own size, anything else by its range.
fn speed(parameter: &Parameter, value: f64, whole: bool) -> f64 {
    if whole {
        return 0.25;
    }
    match parameter.unit {
        "m" => (value.abs() * 0.01).clamp(0.1, 1e4),
        "°" => 0.5,
        "h" => 0.02,
        "EV" => 0.02,
        _ => ((parameter.max - parameter.min) * 0.002).min(0.01),
    }
}

fn tooltip(name: &str, parameter: &Parameter) -> String {
    let Parameter { min, max, unit, doc, .. } = parameter;
    format!("{name}: {doc}\n{min} to {max} {unit}").trim_end().into()
}

/// What screen readers call it, and tests.
fn name_it(ui: &Ui, response: &Response, name: &str) {
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(name));
}
