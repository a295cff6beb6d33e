//! A field for each parameter of a plugin, by what the plugin says of it.
//!
//! Each field returns the text that it chose, as on the command line, so that whatever a parameter may be, its own rules
//! judge it. A kind without a field of its own has a line to type that text in.

use super::curve;
use crate::panel::refusals::refusals;
use crate::reports::{self, Line};
use crate::theme::{self, icon};
use crate::units::Units;
use crate::widget::{self, combo, lines_field, name_it, seed_field, span_field, text_field};
use cloudwright_core::color::Rgb;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::parameter::Span;
use cloudwright_scripts::{Parameter, ParameterKind, ParameterValue, Values};
use egui::cache::{ComputerMut, FrameCache};
use egui::{Button, Grid, Slider, SliderClamping, Ui};
use std::sync::Arc;

/// Of a report's text that are shown.
const METAR_ROWS: usize = 2;

/// Rows of all parameters that are shown with these values. What is chosen there is set.
pub(super) fn rows(ui: &mut Ui, parameters: &[Parameter], scene: &Scene, units: Units, values: &mut Values) {
    let mut shown: Vec<&str> = Vec::new();
    Grid::new("parameters").num_columns(3).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
        for parameter in parameters {
            let Some(value) = values.get(&parameter.name).cloned() else { continue };
            if !is_shown(parameter, &shown, values) {
                continue;
            }
            shown.push(&parameter.name);
            let is_flag = matches!(value, ParameterValue::Flag(_));
            let name = ui.label(if is_flag { "" } else { parameter.label.as_str() });
            if !parameter.help.is_empty() && !is_flag {
                name.on_hover_text(&parameter.help);
            }
            let chosen = ui.horizontal_top(|ui| field(ui, parameter, &value, scene, units)).inner;
            let chosen = chosen.or(reset(ui, parameter, &value));
            ui.end_row();
            if let Some(text) = chosen {
                // What its own rules refuse leaves the value as it is.
                let _ = values.set(parameters, &parameter.name, &text);
            }
        }
    });
}

/// Whether the parameter that it hangs on is shown, and has the value that it wants.
fn is_shown(parameter: &Parameter, shown: &[&str], values: &Values) -> bool {
    parameter
        .shown_if
        .as_ref()
        .is_none_or(|(name, wanted)| shown.contains(&name.as_str()) && values.get(name) == Some(wanted))
}

/// The field itself. What was chosen in this frame.
fn field(ui: &mut Ui, parameter: &Parameter, value: &ParameterValue, scene: &Scene, units: Units) -> Option<String> {
    let Parameter { label, help, .. } = parameter;
    match (&parameter.kind, value) {
        (ParameterKind::Number(span), ParameterValue::Number(number)) => {
            let number = Measured { label, help, span, units, whole: false }.field(ui, *number)?;
            Some(number.to_string())
        }
        (ParameterKind::Integer(span), ParameterValue::Whole(whole)) => {
            let number = Measured { label, help, span, units, whole: true }.field(ui, *whole as f64)?;
            Some((number.round() as i64).to_string())
        }
        (ParameterKind::Flag, ParameterValue::Flag(on)) => {
            let mut on = *on;
            let ticked = ui.checkbox(&mut on, label.as_str());
            let clicked = ticked.clicked();
            if !help.is_empty() {
                ticked.on_hover_text(help);
            }
            clicked.then(|| on.to_string())
        }
        (ParameterKind::Choice(names), ParameterValue::Text(chosen)) => {
            let all: Vec<(&String, String)> = names.iter().map(|name| (name, name.replace('_', " "))).collect();
            let text = chosen.replace('_', " ");
            combo(ui, label, help, &text, &all, |name| *name == chosen).cloned()
        }
        (ParameterKind::Color, ParameterValue::Color(channels)) => color(ui, label, *channels),
        (ParameterKind::Seed, ParameterValue::Whole(seed)) => {
            let mut seed = seed.unsigned_abs();
            seed_field(ui, label, &format!("Re-roll {label}"), help, &mut seed).then(|| seed.to_string())
        }
        (ParameterKind::Cloud, ParameterValue::Whole(id)) => {
            thing(ui, parameter, *id, scene.clouds.iter().map(|cloud| (cloud.id.0, cloud.name.as_str())))
        }
        (ParameterKind::Model, ParameterValue::Whole(id)) => {
            thing(ui, parameter, *id, scene.models.iter().map(|model| (model.id.0, model.name.as_str())))
        }
        (ParameterKind::Path, ParameterValue::Whole(id)) => {
            thing(ui, parameter, *id, scene.paths.iter().map(|path| (path.id.0, path.name.as_str())))
        }
        (ParameterKind::Curve(span), ParameterValue::Curve(points)) => {
            let points = ui.vertical(|ui| curve::show(ui, parameter, span, points)).inner?;
            Some(ParameterValue::Curve(points).to_string())
        }
        (ParameterKind::Metar, ParameterValue::Text(text)) => ui.vertical(|ui| metar(ui, label, help, text)).inner,
        _ => text_field(ui, label, "", help, &value.to_string()),
    }
}

/// A thing of the scene by its name, or none: an id is never 0.
fn thing<'a>(
    ui: &mut Ui,
    Parameter { label, help, .. }: &Parameter,
    id: i64,
    things: impl Iterator<Item = (u64, &'a str)>,
) -> Option<String> {
    let id = id.unsigned_abs();
    let mut all = vec![(0, "none".to_owned())];
    all.extend(things.map(|(id, name)| (id, name.to_owned())));
    let text = all
        .iter()
        .find(|(each, _)| *each == id)
        .map_or_else(|| format!("{id}, which is gone"), |(_, name)| name.clone());
    combo(ui, label, help, &text, &all, |each| *each == id).map(|id| id.to_string())
}

/// Weather reports, and beneath them what of them can't be read.
fn metar(ui: &mut Ui, label: &str, help: &str, text: &str) -> Option<String> {
    ui.set_width(theme::PARAMETER_WIDTH);
    let typed = lines_field(ui, label, ["", help], METAR_ROWS, false, text);
    let read = ui.memory_mut(|memory| memory.caches.cache::<FrameCache<Read, Reading>>().get(text).clone());
    refusals(ui, read.as_deref().map_err(String::as_str));
    typed
}

/// Of a text of reports: what was read, or why that is none.
type Read = Result<Arc<[Line]>, String>;

/// Reads a text only once while it is shown.
#[derive(Default)]
struct Reading;

impl ComputerMut<&str, Read> for Reading {
    fn compute(&mut self, text: &str) -> Read {
        reports::lines(text).map(Arc::from).map_err(|error| error.to_string())
    }
}

fn color(ui: &mut Ui, label: &str, channels: [f64; 3]) -> Option<String> {
    let [r, g, b] = channels.map(|channel| channel as f32);
    let mut rgb = Rgb::new(r, g, b);
    let picked = widget::color_field(ui, label, &mut rgb);
    let changed = widget::brightness_field(ui, &format!("{label} brightness"), &mut rgb) || picked;
    let [r, g, b] = rgb.to_array();
    changed.then(|| format!("{r},{g},{b}"))
}

/// Back to what it begins with, if it has another value.
fn reset(ui: &mut Ui, parameter: &Parameter, value: &ParameterValue) -> Option<String> {
    let button = ui.add_visible(*value != parameter.initial, Button::new(icon::ARROW_U_UP_LEFT).frame(false));
    name_it(ui, &button, &format!("Reset {}", parameter.label));
    button.on_hover_text("Back to what it begins with.").clicked().then(|| parameter.initial.to_string())
}

/// A number in the units that the user chose, with a slider as far as it usually goes.
struct Measured<'a> {
    label: &'a str,
    help: &'a str,
    span: &'a Span,
    units: Units,
    whole: bool,
}

impl Measured<'_> {
    fn field(&self, ui: &mut Ui, value: f64) -> Option<f64> {
        let Span { hard, soft, step, .. } = self.span;
        let [hard_shown, soft_shown] = [hard, soft].map(|range| range.map(|end| self.shown(end)));
        let [min, max] = if self.is_converted() { inwards(hard_shown) } else { hard_shown };
        let step = step.filter(|_| !self.is_converted());
        let shown = widget::Span { unit: self.unit(), min, max, doc: self.help, whole: self.whole, step };
        let before = if self.is_converted() { tenths(self.shown(value), f64::round) } else { value };
        let mut number = before;
        span_field(ui, self.label, &shown, &mut number);
        if soft[1] - soft[0] < widget::ENDLESS {
            self.slider(ui, soft_shown, step, &mut number);
        }
        (number != before).then(|| self.meant(number).clamp(hard[0], hard[1]))
    }

    fn slider(&self, ui: &mut Ui, [from, to]: [f64; 2], step: Option<f64>, number: &mut f64) {
        ui.spacing_mut().slider_width = theme::PARAMETER_SLIDER_WIDTH;
        let mut slider = Slider::new(number, from..=to).show_value(false).clamping(SliderClamping::Never);
        if let Some(step) = step {
            slider = slider.step_by(step);
        }
        if self.whole {
            slider = slider.integer();
        }
        let slider = ui.add(slider);
        name_it(ui, &slider, &format!("{} slider", self.label));
        if !self.help.is_empty() {
            slider.on_hover_text(self.help);
        }
    }

    fn is_metres(&self) -> bool {
        self.span.unit == "m"
    }

    /// Whether what is shown is another number than what is meant.
    fn is_converted(&self) -> bool {
        self.is_metres() && self.units != Units::Metric
    }

    fn unit(&self) -> &str {
        if self.is_metres() { self.units.altitude().name } else { &self.span.unit }
    }

    fn shown(&self, meant: f64) -> f64 {
        if self.is_metres() { self.units.altitude().from_si(meant) } else { meant }
    }

    fn meant(&self, shown: f64) -> f64 {
        if self.is_metres() { self.units.altitude().to_si(shown) } else { shown }
    }
}

/// To tenths, so that nobody reads the digits of a conversion.
fn tenths(number: f64, round: fn(f64) -> f64) -> f64 {
    round(number * 10.0) / 10.0
}

/// A range that the same one in other units holds.
fn inwards([min, max]: [f64; 2]) -> [f64; 2] {
    [tenths(min, f64::ceil), tenths(max, f64::floor)]
}
