//! The ruler over the keys: seconds, and the time of day where that runs. A drag scrubs the clock; with Shift it draws the
//! in and the out mark.

use super::memory::{Gesture, Memory};
use super::span::{Span, seconds};
use crate::state::{Action, ClockChange, Reading, TimeSnap, ViewChange};
use crate::theme;
use crate::widget::name_it;
use cloudwright_core::math::clock;
use cloudwright_core::property::Owner;
use cloudwright_core::scene::Scene;
use egui::accesskit::{self, ActionData, Role};
use egui::{Align2, Color32, CursorIcon, FontId, Painter, Rect, Response, Sense, Shape, Stroke, Ui, pos2};

/// Points.
pub(super) const HEIGHT: f32 = 30.0;
/// From its middle to a corner of the clock's head, points.
const HEAD: f32 = 5.0;

/// Shows it, and does what a hand does in it.
pub(super) fn show(
    ui: &Ui,
    rect: Rect,
    span: &Span,
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let response = ui.interact(rect, ui.scope_id().with("ruler"), Sense::click_and_drag());
    name_it(ui, &response, "Clock in the timeline");
    describe(ui, &response, reading, actions);
    paint(ui, rect, span, reading);
    let (at, shift, command) = ui.input(|input| {
        let at = input.pointer.latest_pos().filter(|_| input.pointer.primary_down());
        (at, input.modifiers.shift, input.modifiers.command)
    });
    let clicked = response.interact_pointer_pos().filter(|_| response.clicked() && !shift);
    let Some(at) = at.filter(|_| response.is_pointer_button_down_on()).or(clicked) else {
        if matches!(memory.gesture, Some(Gesture::Marks(_))) {
            memory.gesture = None;
        }
        response.on_hover_cursor(CursorIcon::ResizeHorizontal).on_hover_text(
            "Drag to put the clock somewhere; it stops at keys, with Ctrl at seconds. Shift-drag: play only from here to there.",
        );
        return;
    };
    let keys = reading.session.scene().tracks.iter().filter(|_| !command);
    let in_sight = |time_s: &f64| *time_s > span.times_s[0] && *time_s < span.times_s[1];
    let keys = keys.flat_map(|track| track.keys.iter().map(|key| key.time_s)).filter(in_sight);
    let snap = if reading.view.timeline.snap == TimeSnap::Seconds { TimeSnap::Seconds } else { TimeSnap::Frames };
    let time_s = span.snapped(span.time_at(at.x), snap, command, keys);
    if response.drag_started() && shift {
        memory.gesture = Some(Gesture::Marks(time_s));
    }
    let change = match memory.gesture {
        Some(Gesture::Marks(from_s)) => ClockChange::Marks(Some([from_s, time_s]).filter(|_| from_s != time_s)),
        _ if shift => return,
        _ => ClockChange::Seek(time_s),
    };
    actions.push(Action::View(ViewChange::Clock(change)));
}

fn describe(ui: &Ui, response: &Response, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ui.ctx().accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Slider);
        node.set_numeric_value(reading.clock.time_s());
        node.add_action(accesskit::Action::SetValue);
    });
    let asked = ui.input(|input| {
        let request = input.accesskit_action_requests(response.id, accesskit::Action::SetValue).last();
        match request.map(|request| &request.data) {
            Some(Some(ActionData::NumericValue(time_s))) => Some(*time_s),
            _ => None,
        }
    });
    actions.extend(asked.map(|time_s| Action::View(ViewChange::Clock(ClockChange::Seek(time_s)))));
}

fn paint(ui: &Ui, rect: Rect, span: &Span, reading: &Reading<'_>) {
    let (painter, visuals) = (ui.painter_at(rect), ui.visuals());
    painter.rect_filled(rect, 0.0, visuals.extreme_bg_color);
    shade(&painter, rect, played(span, reading), visuals.panel_fill);
    let font = FontId::proportional(theme::SMALL_TEXT);
    let (text, fine) = (visuals.text_color(), visuals.widgets.noninteractive.bg_stroke);
    let scene = reading.session.scene();
    let shows_hours = hour_runs(reading, scene);
    let step_s = span.step_s();
    for mark_s in span.marks(step_s / 5.0).filter(|_| step_s / 5.0 / span.s_per_point() > 5.0) {
        painter.vline(span.x_of(mark_s), rect.bottom() - 3.0..=rect.bottom(), fine);
    }
    for mark_s in span.marks(step_s) {
        let x = span.x_of(mark_s);
        painter.vline(x, rect.bottom() - 6.0..=rect.bottom(), Stroke::new(1.0, visuals.weak_text_color()));
        if shows_hours {
            let hour = reading.session.derived().timeline().time_of_day_h(scene, mark_s);
            painter.text(pos2(x, rect.top() + 7.0), Align2::CENTER_CENTER, clock(hour), font.clone(), text);
            let color = visuals.weak_text_color();
            painter.text(pos2(x, rect.top() + 18.0), Align2::CENTER_CENTER, seconds(mark_s), font.clone(), color);
        } else {
            painter.text(pos2(x, rect.center().y - 2.0), Align2::CENTER_CENTER, seconds(mark_s), font.clone(), text);
        }
    }
    marks(&painter, rect, span, reading);
    painter.hline(rect.x_range(), rect.bottom() - 0.5, fine);
    let x = span.x_of(reading.clock.time_s());
    let (top, bottom) = (rect.bottom() - 2.0 * HEAD - 2.0, rect.bottom() - 1.0);
    let corners = [(-HEAD, top), (HEAD, top), (HEAD, bottom - HEAD), (0.0, bottom), (-HEAD, bottom - HEAD)];
    let corners = corners.map(|(by, y)| pos2(x + by, y)).to_vec();
    painter.add(Shape::convex_polygon(corners, theme::NOW, Stroke::NONE));
}

/// Whether hours say more than seconds.
fn hour_runs(reading: &Reading<'_>, scene: &Scene) -> bool {
    let timeline = reading.session.derived().timeline();
    scene.weather.day_speed != 0.0 || timeline.curve(Owner::Scene, "time_of_day_h").is_some()
}

/// From where to where the clock plays, on the screen.
pub(super) fn played(span: &Span, reading: &Reading<'_>) -> [f32; 2] {
    let length_s = reading.clock.length_s(reading.session.scene());
    reading.clock.played_s(length_s).map(|time_s| span.x_of(time_s))
}

/// Dims what the clock does not play.
pub(super) fn shade(painter: &Painter, rect: Rect, [from, to]: [f32; 2], ground: Color32) {
    let dim = ground.gamma_multiply(0.6);
    let cut = |from: f32, to: f32| {
        let (from, to) = (from.max(rect.left()), to.min(rect.right()));
        if from < to {
            painter.rect_filled(Rect::from_x_y_ranges(from..=to, rect.y_range()), 0.0, dim);
        }
    };
    cut(rect.left(), from);
    cut(to, rect.right());
}

/// The in and the out mark.
pub(super) fn marks(painter: &Painter, rect: Rect, span: &Span, reading: &Reading<'_>) {
    for time_s in reading.clock.marks().into_iter().flatten() {
        painter.vline(span.x_of(time_s), rect.y_range(), Stroke::new(1.5, theme::CHOSEN));
    }
}
