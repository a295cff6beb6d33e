//! The chosen tracks as curves over the same time, with their keys and handles.
//!
//! Tracks of one property share a scale, so that they can be compared; those of different ones fill the height each by
//! itself. The numbers at the left are the first one's. What of the values is in sight [`super::values`] knows.

use super::lines::Lines;
use super::memory::Memory;
use super::sheet::{curve_of, in_sight, part_name};
use super::span::{Span, seconds};
use super::spot::{self, Spot, What};
use super::values;
use crate::state::{Action, Choose, Reading, TimelineChange};
use crate::theme;
use cloudwright_core::property::Target;
use cloudwright_core::scene::{Track, TrackId};
use cloudwright_core::weather::Curve;
use egui::{Align2, Color32, CursorIcon, FontId, Painter, Pos2, Rect, Shape, Stroke, Ui, pos2};
use std::sync::Arc;

/// More curves than this nobody tells apart.
const MOST: usize = 24;
/// Between two samples, points.
const SAMPLE: f32 = 2.0;
/// Between lines with numbers, points at least.
const TICK: f32 = 34.0;

/// The curves of this frame.
pub(super) struct Plot {
    rect: Rect,
    span: Span,
    curves: Vec<Drawn>,
}

struct Drawn {
    id: TrackId,
    target: Target,
    curve: Arc<Curve>,
    /// Lowest and highest value in sight.
    ends: [f64; 2],
}

impl Drawn {
    fn new(track: &Track, target: Target, reading: &Reading<'_>) -> Option<Self> {
        let curve = curve_of(track, &target, reading)?;
        Some(Self { id: track.id, target, ends: extent(&curve, target.parts()), curve })
    }
}

/// Of a curve's values from its first key to its last.
fn extent(curve: &Curve, parts: usize) -> [f64; 2] {
    const SAMPLES: u32 = 96;
    let [first, last] = curve.ends_s();
    let between = (0..=SAMPLES).map(|i| first + (last - first) * f64::from(i) / f64::from(SAMPLES));
    // Of very many keys, some stand for all.
    let few = curve.times_s().len().div_ceil(500).max(1);
    let times = between.chain(curve.times_s().iter().copied().step_by(few));
    let values = times.flat_map(|time_s| curve.all_at(time_s).into_iter().take(parts));
    values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
}

impl Plot {
    /// Of the chosen tracks among those found.
    pub(super) fn new(rect: Rect, span: Span, lines: &Lines, memory: &mut Memory, reading: &Reading<'_>) -> Self {
        let scene = reading.session.scene();
        let chosen = &reading.view.timeline.tracks;
        let shown = lines.tracks.iter().filter(|shown| chosen.contains(&shown.id)).take(MOST);
        let drawn = |shown: &super::lines::Shown| Drawn::new(scene.tracks.with_id(shown.id)?, shown.target?, reading);
        let mut curves: Vec<Drawn> = shown.filter_map(drawn).collect();
        let natural: Vec<[f64; 2]> = curves.iter().map(|drawn| drawn.ends).collect();
        for at in 0..curves.len() {
            let is_same = |other: &usize| curves[*other].target.property.is_the_same(curves[at].target.property);
            let same: Vec<usize> = std::iter::once(at).chain((0..curves.len()).filter(is_same)).collect();
            let all = same.iter().map(|other| natural[*other]);
            let all = all.fold(natural[at], |[low, high], ends| [low.min(ends[0]), high.max(ends[1])]);
            let ids: Vec<TrackId> = same.iter().map(|other| curves[*other].id).collect();
            curves[at].ends = memory.values.of(&ids, all, memory.gesture.is_some());
        }
        memory.values.keep(curves.iter().map(|drawn| (drawn.id, drawn.ends)));
        Self { rect, span, curves }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.curves.is_empty()
    }

    /// Of a track's curve.
    pub(super) fn value_per_point(&self, id: TrackId) -> f64 {
        let drawn = self.curves.iter().find(|drawn| drawn.id == id);
        drawn.map_or(0.0, |drawn| (drawn.ends[1] - drawn.ends[0]) / f64::from(self.rect.height().max(1.0)))
    }

    /// Where a number of a key is.
    pub(super) fn key_y(&self, id: TrackId, index: usize, part: usize) -> Option<f32> {
        let drawn = self.curves.iter().find(|drawn| drawn.id == id)?;
        let time_s = *drawn.curve.times_s().get(index)?;
        Some(self.y_of(drawn, drawn.curve.at(time_s, part)))
    }

    /// The track whose curve passes a place most nearly.
    pub(super) fn track_near(&self, at: Pos2) -> Option<TrackId> {
        let time_s = self.span.time_at(at.x);
        let apart = |drawn: &Drawn| {
            let numbers = drawn.curve.all_at(time_s).into_iter().take(drawn.target.parts());
            numbers.map(|value| (self.y_of(drawn, value) - at.y).abs()).fold(f32::INFINITY, f32::min)
        };
        self.curves.iter().min_by(|a, b| apart(a).total_cmp(&apart(b))).map(|drawn| drawn.id)
    }

    fn y_of(&self, drawn: &Drawn, value: f64) -> f32 {
        let [low, high] = drawn.ends;
        let up = ((value - low) / (high - low)).clamp(-100.0, 100.0) as f32;
        self.rect.bottom() - up * self.rect.height()
    }

    /// Draws all, and tells what can be taken.
    pub(super) fn show(&self, ui: &Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) -> Vec<Spot> {
        let painter = ui.painter_at(self.rect);
        if let Some(first) = self.curves.first() {
            self.grid(ui, &painter, first);
        }
        let mut spots = Vec::new();
        for drawn in &self.curves {
            let Some(track) = reading.session.scene().tracks.with_id(drawn.id) else { continue };
            for part in 0..drawn.target.parts() {
                self.line(ui, &painter, drawn, part);
                self.keys(ui, &painter, (drawn, part), track, reading, (&mut spots, actions));
            }
        }
        spots
    }

    /// x, y and z, or red, green and blue, as everywhere; one number alone as keys are, several each by its track.
    fn tint(&self, ui: &Ui, drawn: &Drawn, part: usize) -> Color32 {
        match drawn.target.parts() {
            3 => [theme::AXIS_X, theme::AXIS_Y, theme::AXIS_Z][part.min(2)],
            _ if self.curves.len() > 1 => spot::tint_of(drawn.id),
            _ => theme::key(ui),
        }
    }

    fn grid(&self, ui: &Ui, painter: &Painter, first: &Drawn) {
        let [low, high] = first.ends;
        let least = (high - low) * f64::from(TICK / self.rect.height().max(1.0));
        let power = 10_f64.powf(least.log10().floor());
        let step = [1.0, 2.0, 5.0, 10.0].map(|times| times * power).into_iter().find(|step| *step >= least);
        let step = step.filter(|step| step.is_finite() && *step > 0.0).unwrap_or(high - low);
        let fine = ui.visuals().widgets.noninteractive.bg_stroke;
        for time_s in self.span.marks(self.span.step_s()) {
            painter.vline(self.span.x_of(time_s), self.rect.y_range(), Stroke::new(0.5, fine.color));
        }
        // Under the numbers: here the wheel is theirs.
        let axis = self.rect.with_max_x(self.rect.left() + values::AXIS);
        painter.rect_filled(axis, 0.0, ui.visuals().panel_fill.gamma_multiply(0.7));
        if ui.rect_contains_pointer(axis) && ui.input(|input| !input.pointer.any_down()) {
            ui.ctx().set_cursor_icon(CursorIcon::ResizeVertical);
        }
        let count = ((high - low) / step).clamp(0.0, 100.0) as i64;
        for line in 0..=count + 1 {
            let value = ((low / step).ceil() + line as f64) * step;
            let y = self.y_of(first, value);
            painter.hline(self.rect.x_range(), y, Stroke::new(if value == 0.0 { 1.0 } else { 0.5 }, fine.color));
            let text =
                format!("{} {}", short(value, step), first.target.property.kind.number().map_or("", |it| it.unit));
            let font = FontId::proportional(theme::SMALL_TEXT);
            let at = pos2(self.rect.left() + 4.0, y - 1.0);
            painter.text(at, Align2::LEFT_BOTTOM, text, font, ui.visuals().weak_text_color());
        }
    }

    fn line(&self, ui: &Ui, painter: &Painter, drawn: &Drawn, part: usize) {
        let count = (self.rect.width() / SAMPLE).ceil().max(1.0) as u32;
        let points = (0..=count).map(|i| {
            let x = self.rect.left() + self.rect.width() * i as f32 / count as f32;
            pos2(x, self.y_of(drawn, drawn.curve.at(self.span.time_at(x), part)))
        });
        painter.add(Shape::line(points.collect(), Stroke::new(1.6, self.tint(ui, drawn, part))));
    }

    fn keys(
        &self,
        ui: &Ui,
        painter: &Painter,
        (drawn, part): (&Drawn, usize),
        track: &Track,
        reading: &Reading<'_>,
        (spots, actions): (&mut Vec<Spot>, &mut Vec<Action>),
    ) {
        let color = self.tint(ui, drawn, part);
        for (index, key) in in_sight(&track.keys, &self.span) {
            let place = (track.id, index);
            let value = drawn.curve.at(key.time_s, part);
            let at = pos2(self.span.x_of(key.time_s), self.y_of(drawn, value));
            let is_chosen = reading.view.timeline.chosen.contains(&place);
            if let Some(handles) = key.handles.as_ref().filter(|_| is_chosen) {
                for (leaves, slopes, other) in
                    [(false, handles.arrives, index.checked_sub(1)), (true, handles.leaves, index.checked_add(1))]
                {
                    let Some(other) = other.and_then(|other| track.keys.get(other)) else { continue };
                    let by_s = (other.time_s - key.time_s) / 3.0;
                    let Some(slope) = slopes.parts().get(part) else { continue };
                    let end = pos2(self.span.x_of(key.time_s + by_s), self.y_of(drawn, value + slope * by_s));
                    painter.line_segment([at, end], Stroke::new(1.0, theme::CHOSEN));
                    painter.circle(end, 3.5, theme::CHOSEN, Stroke::NONE);
                    let what = What::Handle { key: place, part, leaves };
                    let id = ui.scope_id().with(("handle", place, part, leaves));
                    let side = if leaves { "after" } else { "before" };
                    spot::announce(ui, id, end, false, || format!("handle {side} {}", seconds(key.time_s)));
                    spots.push(Spot { at: end, what, time_s: key.time_s });
                }
            }
            let fill = if is_chosen { theme::CHOSEN } else { color };
            spot::paint(painter, at, key, fill, spot::edge(ui, is_chosen));
            let name = || {
                let label = format!("{} {}", drawn.target.property.label, part_name(&drawn.target, part));
                format!("key of {} at {}", label.trim_end(), seconds(key.time_s))
            };
            if spot::announce(ui, ui.scope_id().with(("curve key", place, part)), at, is_chosen, name) {
                actions.push(Action::Timeline(TimelineChange::Keys(vec![place], Choose::Only)));
            }
            spots.push(Spot { at, what: What::Key(place, Some(part)), time_s: key.time_s });
        }
    }
}

/// A number at a scale of that step.
fn short(value: f64, step: f64) -> String {
    let decimals = (-step.log10().floor()).clamp(0.0, 6.0) as usize;
    format!("{:.decimals$}", if value.abs() < step * 1e-6 { 0.0 } else { value })
}
