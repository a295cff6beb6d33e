//! The lines with their keys: names at the left, keys at the right.
//!
//! Only what is in sight is laid out: the lines by their number, the keys of a line by a search for the first and the last.

use super::bands;
use super::lines::{Group, Line, Lines, Shown};
use super::span::{Span, seconds};
use super::spot::{self, Spot, What};
use crate::state::{Action, Choose, Reading, TimelineChange};
use crate::theme;
use crate::widget::name_button;
use cloudwright_core::property::{Kind, Target};
use cloudwright_core::scene::{KeyValue, Track, TrackId, TrackKey};
use cloudwright_core::weather::Curve;
use egui::{Align2, FontId, Rect, Sense, Stroke, TextStyle, Ui, pos2, vec2};
use std::sync::Arc;

/// Of a line, points.
pub(super) const LINE: f32 = 20.0;
/// Of a group's line, keys nearer to one another than this are drawn as one, points.
const MERGED: f32 = 2.0;

/// What the lines are drawn from, and what they ask for.
pub(super) struct Sheet<'a, 'r> {
    pub(super) lines: &'a Lines,
    /// Where keys are; none where curves are shown.
    pub(super) keys: Option<Span>,
    /// From where to where the clock plays.
    pub(super) played: [f32; 2],
    pub(super) reading: &'a Reading<'r>,
    pub(super) actions: &'a mut Vec<Action>,
    pub(super) spots: Vec<Spot>,
    /// To be folded or unfolded.
    pub(super) folded: Option<Group>,
    /// Tracks whose lines are in sight, each with the y of its middle.
    pub(super) in_sight: Vec<(usize, f32)>,
}

impl Sheet<'_, '_> {
    /// A line of the panel, in `rect`, whose names end at `names_right`.
    pub(super) fn line(&mut self, ui: &Ui, line: &Line, rect: Rect, names_right: f32) {
        let names = Rect::from_min_max(rect.min, pos2(names_right.min(rect.right()), rect.bottom()));
        let keys = Rect::from_min_max(pos2(names.right(), rect.top()), rect.max);
        match line {
            Line::Group { group, label, tracks, is_open } => {
                ui.painter().rect_filled(rect, 0.0, ui.visuals().faint_bg_color);
                self.group(ui, names, *group, label, tracks, *is_open);
                if let Some(span) = self.keys {
                    self.shade(ui, keys);
                    self.sums(ui, keys, &span, label, tracks);
                }
            }
            Line::Track(at) => {
                let Some(shown) = self.lines.tracks.get(*at) else { return };
                let Some(track) = self.reading.session.scene().tracks.get(shown.at).filter(|it| it.id == shown.id)
                else {
                    return;
                };
                self.in_sight.push((*at, rect.center().y));
                self.track_name(ui, names, shown);
                if let Some(span) = self.keys {
                    self.shade(ui, keys);
                    self.track_keys(ui, keys, &span, shown, track);
                }
            }
        }
        let fine = ui.visuals().widgets.noninteractive.bg_stroke;
        ui.painter().hline(rect.x_range(), rect.bottom() - 0.5, Stroke::new(0.5, fine.color.gamma_multiply(0.7)));
    }

    fn shade(&self, ui: &Ui, keys: Rect) {
        super::ruler::shade(ui.painter(), keys, self.played, ui.visuals().extreme_bg_color);
    }

    fn group(
        &mut self,
        ui: &Ui,
        rect: Rect,
        group: Group,
        label: &str,
        tracks: &std::ops::Range<usize>,
        is_open: bool,
    ) {
        let id = ui.scope_id().with(("group", group));
        let caret = Rect::from_min_size(rect.min, vec2(LINE, LINE));
        let fold = ui.interact(caret, id.with("fold"), Sense::click());
        name_button(ui, &fold, &format!("{} {label}", if is_open { "Fold" } else { "Unfold" }));
        if fold.clicked() {
            self.folded = Some(group);
        }
        let name = Rect::from_min_max(caret.right_top(), rect.max);
        let response = ui.interact(name, id, Sense::click());
        name_button(ui, &response, &format!("Tracks of {label}"));
        if response.clicked() {
            let all = self.lines.tracks.get(tracks.clone()).unwrap_or_default();
            self.choose(ui, all.iter().map(|shown| shown.id).collect());
        }
        if response.double_clicked() {
            self.folded = Some(group);
        }
        let painter = ui.painter_at(rect);
        let strong = ui.visuals().strong_text_color();
        let middle = caret.center();
        let corners =
            if is_open { [(-4.0, -2.5), (4.0, -2.5), (0.0, 3.5)] } else { [(-2.5, -4.0), (3.5, 0.0), (-2.5, 4.0)] };
        let corners = corners.map(|(x, y)| middle + vec2(x, y)).to_vec();
        painter.add(egui::Shape::convex_polygon(corners, ui.visuals().text_color(), Stroke::NONE));
        let font = TextStyle::Body.resolve(ui.style());
        painter.text(name.left_center() + vec2(2.0, 0.0), Align2::LEFT_CENTER, label, font, strong);
    }

    fn choose(&mut self, ui: &Ui, tracks: Vec<TrackId>) {
        let modifiers = ui.input(|input| input.modifiers);
        let how = if modifiers.shift || modifiers.command { Choose::Toggle } else { Choose::Only };
        self.actions.push(Action::Timeline(TimelineChange::Tracks(tracks, how)));
    }

    fn track_name(&mut self, ui: &Ui, rect: Rect, shown: &Shown) {
        let is_chosen = self.reading.view.timeline.tracks.contains(&shown.id);
        let response = ui.interact(rect, ui.scope_id().with(("track", shown.id)), Sense::click());
        name_button(ui, &response, &shown.full_name());
        let painter = ui.painter_at(rect);
        if is_chosen {
            painter.rect_filled(rect, 0.0, ui.visuals().selection.bg_fill.gamma_multiply(0.75));
        } else if response.hovered() {
            painter.rect_filled(rect, 0.0, ui.visuals().widgets.hovered.weak_bg_fill.gamma_multiply(0.4));
        }
        let among_others = self.reading.view.timeline.tracks.len() > 1;
        if is_chosen && among_others && self.keys.is_none() && shown.target.is_some_and(|target| target.parts() == 1) {
            let strip = Rect::from_min_size(rect.min + vec2(8.0, 5.0), vec2(4.0, rect.height() - 10.0));
            painter.rect_filled(strip, 1.0, spot::tint_of(shown.id));
        }
        let color = if is_chosen { ui.visuals().strong_text_color() } else { ui.visuals().text_color() };
        let font = TextStyle::Body.resolve(ui.style());
        let (left, right) = (rect.left_center() + vec2(LINE, 0.0), rect.right_center() - vec2(5.0, 0.0));
        let value_left = self.value(ui, right, shown);
        let names = Rect::from_min_max(rect.min, pos2(value_left - 4.0, rect.bottom()));
        ui.painter_at(names).text(left, Align2::LEFT_CENTER, &shown.label, font, color);
        if response.clicked() {
            self.choose(ui, vec![shown.id]);
        }
        response.on_hover_text(shown.full_name());
    }

    /// The value at the clock's time, behind the name. Where it begins.
    fn value(&self, ui: &Ui, right: egui::Pos2, shown: &Shown) -> f32 {
        let (Some(target), Some(curve)) = (shown.target, self.curve(shown)) else { return right.x };
        let numbers = curve.all_at(self.reading.clock.time_s());
        if matches!(target.property.kind, Kind::Color(_)) {
            let swatch = Rect::from_center_size(right - vec2(8.0, 0.0), vec2(16.0, 10.0));
            let rim = Stroke::new(1.0, ui.visuals().weak_text_color());
            ui.painter().rect(swatch, 2.0, bands::color_of(numbers), rim, egui::StrokeKind::Inside);
            return swatch.left();
        }
        if target.parts() > 1 {
            return right.x;
        }
        let number = target.bring_within(numbers[0]);
        let font = FontId::proportional(theme::SMALL_TEXT);
        let text = format!("{}", (number * 1e3).round() / 1e3);
        ui.painter().text(right, Align2::RIGHT_CENTER, text, font, ui.visuals().weak_text_color()).left()
    }

    fn curve(&self, shown: &Shown) -> Option<Arc<Curve>> {
        curve_of(self.reading.session.scene().tracks.with_id(shown.id)?, &shown.target?, self.reading)
    }

    fn track_keys(&mut self, ui: &Ui, rect: Rect, span: &Span, shown: &Shown, track: &Track) {
        if self.reading.view.timeline.tracks.contains(&shown.id) {
            let fill = ui.visuals().selection.bg_fill.gamma_multiply(0.22);
            ui.painter().rect_filled(rect, 0.0, fill);
        }
        self.between(ui, rect, span, shown, track);
        let painter = ui.painter_at(rect.expand2(vec2(0.0, 2.0)));
        let is_color = shown.target.is_some_and(|target| matches!(target.property.kind, Kind::Color(_)));
        for (index, key) in in_sight(&track.keys, span) {
            let at = pos2(span.x_of(key.time_s), rect.center().y);
            let place = (track.id, index);
            let is_chosen = self.reading.view.timeline.chosen.contains(&place);
            let fill = match key.value {
                KeyValue::Three(numbers) if is_color => bands::color_of(numbers),
                _ if is_chosen => theme::CHOSEN,
                _ => theme::key(ui),
            };
            spot::paint(&painter, at, key, fill, spot::edge(ui, is_chosen));
            let name = || format!("key of {} at {}", shown.label, seconds(key.time_s));
            if spot::announce(ui, ui.scope_id().with(("key", place)), at, is_chosen, name) {
                self.actions.push(Action::Timeline(TimelineChange::Keys(vec![place], Choose::Only)));
            }
            self.spots.push(Spot { at, what: What::Key(place, None), time_s: key.time_s });
        }
    }

    /// What lies between the keys.
    fn between(&self, ui: &Ui, rect: Rect, span: &Span, shown: &Shown, track: &Track) {
        if let (Some(target), Some(curve)) = (shown.target, self.curve(shown)) {
            bands::show(ui, rect, span, &target, &curve, track);
        }
    }

    /// A group's line shows the keys of all its tracks.
    fn sums(&mut self, ui: &Ui, rect: Rect, span: &Span, label: &str, tracks: &std::ops::Range<usize>) {
        let scene = self.reading.session.scene();
        let chosen = &self.reading.view.timeline.chosen;
        let mut times: Vec<(f64, bool)> = Vec::new();
        for shown in self.lines.tracks.get(tracks.clone()).unwrap_or_default() {
            let Some(track) = scene.tracks.get(shown.at) else { continue };
            let keys = in_sight(&track.keys, span);
            times.extend(keys.map(|(index, key)| (key.time_s, chosen.contains(&(track.id, index)))));
        }
        times.sort_by(|a, b| a.0.total_cmp(&b.0));
        let merged_s = f64::from(MERGED) * span.s_per_point();
        times.dedup_by(|next, kept| {
            let same = next.0 - kept.0 <= merged_s;
            kept.1 |= same && next.1;
            same
        });
        let painter = ui.painter_at(rect);
        for (time_s, is_chosen) in times {
            let at = pos2(span.x_of(time_s), rect.center().y);
            let fill = if is_chosen { theme::CHOSEN } else { ui.visuals().weak_text_color() };
            let edge = spot::edge(ui, is_chosen);
            spot::shape(&painter, at, cloudwright_core::scene::Leaves::Linear, spot::RADIUS * 0.8, fill, edge);
            let id = ui.scope_id().with(("sum", tracks.start, time_s.to_bits()));
            let name = || format!("keys of {label} at {}", seconds(time_s));
            if spot::announce(ui, id, at, is_chosen, name) {
                let all = keys_at(self.lines, tracks, time_s, merged_s, self.reading);
                self.actions.push(Action::Timeline(TimelineChange::Keys(all, Choose::Only)));
            }
            self.spots.push(Spot { at, what: What::Sum(tracks.clone()), time_s });
        }
    }
}

/// A track's curve, whether or not the scene shows it now.
pub(super) fn curve_of(track: &Track, target: &Target, reading: &Reading<'_>) -> Option<Arc<Curve>> {
    let known = reading.session.derived().timeline().curve(target.owner, target.property.path);
    let fits = track.keys.iter().all(|key| key.value.parts().len() == target.parts()) && !track.keys.is_empty();
    known.cloned().or_else(|| fits.then(|| Arc::new(Curve::of(track, target))))
}

/// The keys of some of the found tracks that stand at a time, or so near that they are drawn as one with it.
pub(super) fn keys_at(
    lines: &Lines,
    tracks: &std::ops::Range<usize>,
    time_s: f64,
    merged_s: f64,
    reading: &Reading<'_>,
) -> Vec<(TrackId, usize)> {
    let scene = reading.session.scene();
    let shown = lines.tracks.get(tracks.clone()).unwrap_or_default().iter();
    let tracks = shown.filter_map(|shown| scene.tracks.get(shown.at));
    let keys =
        tracks.flat_map(|track| track.keys.iter().enumerate().map(|(index, key)| ((track.id, index), key.time_s)));
    keys.filter(|(_, at_s)| (at_s - time_s).abs() <= merged_s).map(|(place, _)| place).collect()
}

/// The keys in sight, with their indices.
pub(super) fn in_sight<'k>(keys: &'k [TrackKey], span: &Span) -> impl Iterator<Item = (usize, &'k TrackKey)> + use<'k> {
    let margin_s = 10.0 * span.s_per_point();
    let from = keys.partition_point(|key| key.time_s < span.times_s[0] - margin_s);
    let to = keys.partition_point(|key| key.time_s <= span.times_s[1] + margin_s);
    keys.iter().enumerate().take(to).skip(from)
}

/// Where a target's numbers are named: "x".
pub(super) fn part_name(target: &Target, part: usize) -> &'static str {
    target.property.parts.labels().get(part).copied().unwrap_or_default()
}
