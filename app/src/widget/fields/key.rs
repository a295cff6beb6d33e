//! The diamond beside a value that can be keyed: empty where nothing is keyed, half full where its track has no key at the
//! clock's time, full where it has one, and with a dot in it and of another tint where a hand has changed the value since.
//!
//! A click keys the value of all selected things, or takes their keys out; the other button opens what else there is.

use super::name_button;
use crate::state::{Action, ClockChange, Keyed, Reading, TimelineChange, Values, ViewChange};
use crate::theme;
use cloudwright_core::arrange::keys;
use cloudwright_core::property::Target;
use cloudwright_core::scene::Track;
use egui::{Context, Id, Pos2, Rect, Sense, Shape, Stroke, Ui, Vec2, vec2};
use std::collections::BTreeSet;

/// With its room, points.
pub(super) const WIDTH: f32 = 17.0;
/// From its middle to a corner, points.
const RADIUS: f32 = 4.5;
/// Of the dot in the diamond of a value that was changed since, points.
const DOT: f32 = 1.7;

/// The button. What a click on it asks for.
pub(crate) fn key_button(ui: &mut Ui, label: &str, values: &Values, reading: &Reading<'_>) -> Option<Action> {
    let keyed = reading.keyed(values.iter().map(|(target, _)| target));
    let size = vec2(2.0 * RADIUS + 3.0, ui.spacing().interact_size.y);
    let (rect, response) = ui.allocate_exact_size(size, Sense::click());
    name_button(ui, &response, &format!("Key {label}"));
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_value(words(keyed)));
    paint(ui, rect.center(), keyed, response.hovered() || response.has_focus());
    let mut asked = response.clicked().then(|| reading.key_or_not(label, values));
    response.context_menu(|ui| asked = menu(ui, label, values, keyed, reading).or(asked.take()));
    response.on_hover_text(match keyed {
        Keyed::Not => format!("{label} is not keyed. Click to key it at the clock's time."),
        Keyed::Elsewhere => format!("{label} is keyed, with no key here. Click to add one."),
        Keyed::Here => format!("{label} has a key here. Click to take it out."),
        Keyed::Changed => format!("{label} was changed since it was keyed. Click to key what is shown."),
    });
    asked
}

/// The values of the field that the pointer was at last, with its name.
pub(crate) fn field_to_key(context: &Context) -> Option<(String, Values)> {
    context.data(|data| data.get_temp(place()))
}

/// The pointer is at that field.
pub(super) fn point_at(ui: &Ui, row: Rect, label: &str, values: &Values) {
    if ui.rect_contains_pointer(row) {
        ui.data_mut(|data| data.insert_temp(place(), (label.to_owned(), values.clone())));
    }
}

fn place() -> Id {
    Id::unique("field to key")
}

fn words(keyed: Keyed) -> &'static str {
    match keyed {
        Keyed::Not => "not keyed",
        Keyed::Elsewhere => "keyed elsewhere",
        Keyed::Here => "keyed here",
        Keyed::Changed => "changed since",
    }
}

fn menu(ui: &mut Ui, label: &str, values: &Values, keyed: Keyed, reading: &Reading<'_>) -> Option<Action> {
    let label = label.to_lowercase();
    let mut asked = None;
    ui.add_enabled_ui(keyed != Keyed::Not, |ui| {
        let scene = reading.session.scene();
        let targets: Vec<Target> = values.iter().map(|(target, _)| *target).collect();
        let seek = |onwards: bool| {
            let its: BTreeSet<String> = targets.iter().map(Target::to_string).collect();
            let tracks = scene.tracks.iter().filter(|track: &&Track| its.contains(&track.property));
            let time_s = keys::next_key_s(tracks, reading.clock.time_s(), onwards)?;
            Some(Action::View(ViewChange::Clock(ClockChange::Seek(time_s))))
        };
        if ui.button("Previous key").clicked() {
            asked = seek(false);
        }
        if ui.button("Next key").clicked() {
            asked = seek(true);
        }
        if ui.button("Show in timeline").clicked() {
            asked = Some(Action::Timeline(TimelineChange::Show(targets.clone())));
        }
        ui.separator();
        if ui.button("Clear all keys").clicked() {
            let rekeyed = keys::cleared(scene, &targets);
            asked = Some(Action::Keys { name: format!("Clear keys of {label}"), rekeyed, live: false, choose: false });
        }
    });
    asked
}

fn paint(ui: &Ui, middle: Pos2, keyed: Keyed, lit: bool) {
    let corners = [vec2(0.0, -RADIUS), vec2(RADIUS, 0.0), vec2(0.0, RADIUS), vec2(-RADIUS, 0.0)];
    let at = |corners: &[Vec2]| corners.iter().map(|corner| middle + *corner).collect::<Vec<_>>();
    let color = match keyed {
        Keyed::Not if lit => ui.visuals().strong_text_color(),
        Keyed::Not => theme::no_key(ui),
        Keyed::Elsewhere | Keyed::Here => theme::key(ui),
        Keyed::Changed => theme::changed_key(ui),
    };
    let painter = ui.painter();
    match keyed {
        Keyed::Not => {}
        Keyed::Elsewhere => {
            painter.add(Shape::convex_polygon(at(&[corners[0], corners[2], corners[3]]), color, Stroke::NONE));
        }
        Keyed::Here | Keyed::Changed => {
            painter.add(Shape::convex_polygon(at(&corners), color, Stroke::NONE));
        }
    }
    if keyed == Keyed::Changed {
        // The tint alone would not tell it from one that is keyed here.
        painter.circle_filled(middle, DOT, ui.visuals().panel_fill);
    }
    let stroke = Stroke::new(if lit { 1.8 } else { 1.2 }, color);
    painter.add(Shape::closed_line(at(&corners), stroke));
}
