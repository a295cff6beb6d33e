//! The timeline: keys of all tracks over one ruler, as lines of keys or as curves.
//!
//! What is in sight is the panel's own memory; what is chosen is view state, since commands work on it. Keys that select,
//! copy or delete are about the timeline while the pointer is over it.

mod bands;
mod curves;
mod ends;
mod hand;
mod lines;
mod memory;
mod ruler;
mod sheet;
mod span;
mod spot;
mod toolbar;
mod values;

use crate::command::{context, give_keys_to_timeline};
use crate::state::{Action, Choose, Reading, TimelineChange};
use crate::theme;
use crate::visible;
use crate::widget::{context_menu, name_it};
use curves::Plot;
use egui::{Rangef, Rect, ScrollArea, Sense, Stroke, TextEdit, Ui, UiBuilder, Vec2, pos2, vec2};
use hand::Field;
use lines::{Line, Lines};
use memory::{Gesture, Memory};
use sheet::{LINE, Sheet};
use span::Span;
use spot::{What, under};

/// Of the names of tracks, points.
const NAMES: f32 = 176.0;
/// Of the wheel's way, points to e-fold what is in sight.
const ZOOM: f32 = 250.0;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    toolbar::show(ui, reading, actions);
    let memory = Memory::of(ui.ctx());
    let memory = &mut *memory.lock();
    let whole = ui.available_rect_before_wrap();
    if whole.height() < ruler::HEIGHT + LINE || whole.width() < 80.0 {
        return;
    }
    let place = Place::of(whole);
    search(ui, place.search, memory);
    let lines = memory.lines(reading);
    let span = in_sight(ui, &place, memory, &lines, reading);
    ruler::show(ui, place.ruler, &span, memory, reading, actions);
    if reading.session.scene().tracks.is_empty() {
        hint(ui, place.body, "Nothing is keyed yet. Click the diamond beside a value to key it at the clock's time.");
        return;
    }
    if lines.tracks.is_empty() {
        return hint(ui, place.body, &format!("No track matches “{}”", visible::one_line(memory.typed.trim())));
    }
    body(ui, &place, &span, &lines, memory, reading, actions);
}

/// Where things are.
struct Place {
    search: Rect,
    ruler: Rect,
    /// Names and keys.
    body: Rect,
    keys: Rect,
}

impl Place {
    fn of(whole: Rect) -> Self {
        let names = NAMES.min(whole.width() * 0.4);
        let (x, y) = (whole.left() + names, whole.top() + ruler::HEIGHT);
        Self {
            search: Rect::from_min_max(whole.min, pos2(x - 6.0, y - 4.0)),
            ruler: Rect::from_min_max(pos2(x, whole.top()), pos2(whole.right(), y)),
            body: Rect::from_min_max(pos2(whole.left(), y), whole.max),
            keys: Rect::from_min_max(pos2(x, y), whole.max),
        }
    }
}

fn hint(ui: &mut Ui, rect: Rect, text: &str) {
    let builder = UiBuilder::new().max_rect(rect.shrink(2.0 * theme::GAP));
    ui.scope_builder(builder, |ui| ui.weak(text));
}

fn search(ui: &mut Ui, rect: Rect, memory: &mut Memory) {
    let rect = Rect::from_center_size(rect.center(), vec2(rect.width(), ui.spacing().interact_size.y));
    let field = ui.put(rect, TextEdit::singleline(&mut memory.typed).hint_text("Find tracks"));
    name_it(ui, &field, "Find tracks");
    if field.changed() {
        memory.forget_lines();
    }
}

/// What of the time is in sight, after what wheel and middle button do, and what was asked to fit.
fn in_sight(ui: &Ui, place: &Place, memory: &mut Memory, lines: &Lines, reading: &Reading<'_>) -> Span {
    let clock_s = [0.0, reading.clock.length_s(reading.session.scene())];
    let x = Rangef::new(place.keys.left(), place.keys.right());
    if std::mem::replace(&mut memory.fitted, reading.view.timeline.fit) != reading.view.timeline.fit {
        memory.times_s = Some(Span::around(extent(lines, reading).unwrap_or(clock_s)));
        memory.values.fit();
    }
    let mut span = Span { x, times_s: memory.times_s.unwrap_or_else(|| Span::around(clock_s)) };
    let before = span.times_s;
    let area = place.keys.union(place.ruler);
    if ui.rect_contains_pointer(area) {
        let (at, mut wheel, zoom, drag) = ui.input_mut(|input| {
            let drag = if input.pointer.middle_down() { input.pointer.delta() } else { Vec2::ZERO };
            // What zooms does not scroll the lines.
            let wheel = std::mem::take(&mut input.smooth_scroll_delta);
            (input.pointer.latest_pos(), wheel, input.zoom_delta(), drag)
        });
        if reading.view.timeline.curves
            && let Some(at) = at.filter(|at| place.keys.contains(*at))
        {
            // With Ctrl or over its numbers, the wheel is about the values.
            let turned = if values::over_axis(at.x, &span) { std::mem::take(&mut wheel.y) } else { 0.0 };
            let factor = f64::from((-turned / ZOOM).exp() / zoom);
            let rect = plot_rect(place);
            let [about, up] = [rect.bottom() - at.y, -drag.y].map(|points| points / rect.height().max(1.0));
            memory.values.change(factor, f64::from(about), f64::from(up));
        } else if drag.y != 0.0 {
            memory.scrolled += drag.y;
        }
        if let Some(at) = at {
            span = span.zoomed(at.x, f64::from((-wheel.y / ZOOM).exp())).panned(wheel.x + drag.x);
        }
    }
    if span.times_s != before {
        memory.times_s = Some(span.times_s);
    }
    span
}

/// From the first to the last of the chosen keys, or of all of the tracks found.
fn extent(lines: &Lines, reading: &Reading<'_>) -> Option<[f64; 2]> {
    let timeline = &reading.view.timeline;
    let scene = reading.session.scene();
    let chosen = timeline.chosen.iter().filter_map(|(id, index)| scene.tracks.with_id(*id)?.keys.get(*index));
    let ends = |[first, last]: [f64; 2], time_s: f64| [first.min(time_s), last.max(time_s)];
    let none = [f64::INFINITY, f64::NEG_INFINITY];
    let mut times_s = if timeline.chosen.len() > 1 { chosen.map(|key| key.time_s).fold(none, ends) } else { none };
    if times_s[0] > times_s[1] {
        let tracks = lines.tracks.iter().filter_map(|shown| scene.tracks.with_id(shown.id));
        let keys = tracks.flat_map(|track| [track.keys.first(), track.keys.last()]).flatten();
        times_s = keys.map(|key| key.time_s).fold(none, ends);
    }
    (times_s[0] <= times_s[1]).then_some(times_s)
}

/// Where curves are.
fn plot_rect(place: &Place) -> Rect {
    place.keys.shrink2(vec2(0.0, 4.0))
}

/// Names, keys or curves, and what a hand does there.
fn body(
    ui: &mut Ui,
    place: &Place,
    span: &Span,
    lines: &Lines,
    memory: &mut Memory,
    reading: &Reading<'_>,
    actions: &mut Vec<Action>,
) {
    let area = ui.interact(place.keys, ui.scope_id().with("keys"), Sense::click_and_drag());
    name_it(ui, &area, "Keys over time");
    let shows_curves = reading.view.timeline.curves;
    let right = if shows_curves { place.keys.left() } else { place.body.right() };
    let builder = UiBuilder::new().max_rect(Rect::from_min_max(place.body.min, pos2(right, place.body.bottom())));
    let keys = (!shows_curves).then_some(*span);
    let played = ruler::played(span, reading);
    let mut sheet =
        Sheet { lines, keys, played, reading, actions, spots: Vec::new(), folded: None, in_sight: Vec::new() };
    ui.scope_builder(builder, |ui| scroll(ui, place, lines, memory, &mut sheet));
    let Sheet { mut spots, folded, in_sight, .. } = sheet;
    spots.retain(|spot| place.keys.expand(4.0).contains(spot.at));
    if let Some(group) = folded {
        if !memory.folded.remove(&group) {
            memory.folded.insert(group);
        }
        memory.forget_lines();
    }
    let plot = shows_curves.then(|| Plot::new(plot_rect(place), *span, lines, memory, reading));
    if let Some(plot) = &plot {
        ui.painter().rect_filled(place.keys, 0.0, ui.visuals().extreme_bg_color);
        ruler::shade(&ui.painter_at(place.keys), place.keys, played, ui.visuals().panel_fill);
        spots = plot.show(ui, reading, actions);
        if plot.is_empty() {
            hint(ui, place.keys, "Choose tracks by their names to see their curves.");
        }
    }
    over(ui, place, span, memory, reading);
    let is_over = ui.rect_contains_pointer(place.keys);
    let field = Field { rect: place.keys, span: *span, lines, spots: &spots, plot: plot.as_ref(), reading };
    field.work(ui, is_over, memory, actions);
    let clicked = area.interact_pointer_pos();
    if area.double_clicked() {
        actions.extend(clicked.and_then(|at| field.add(at, &in_sight, LINE * 0.5)));
    }
    if area.secondary_clicked()
        && let Some(What::Key(key, _)) = clicked.and_then(|at| under(&spots, at)).map(|spot| spot.what.clone())
        && !reading.view.timeline.chosen.contains(&key)
    {
        actions.push(Action::Timeline(TimelineChange::Keys(vec![key], Choose::Only)));
    }
    actions.extend(context_menu(&area, context::TIMELINE, reading.offered).map(Action::Command));
    if ui.rect_contains_pointer(place.body) {
        // Keys of the keyboard are about keys of tracks.
        give_keys_to_timeline(ui.ctx());
    }
}

/// The lines, those in sight.
fn scroll(ui: &mut Ui, place: &Place, lines: &Lines, memory: &mut Memory, sheet: &mut Sheet<'_, '_>) {
    ui.spacing_mut().item_spacing.y = 0.0;
    let timeline = &sheet.reading.view.timeline;
    let mut area = ScrollArea::vertical().id_salt("lines").auto_shrink(false);
    if std::mem::replace(&mut memory.revealed, timeline.reveal) != timeline.reveal {
        let is_chosen = |line: &Line| match line {
            Line::Track(at) => lines.tracks.get(*at).is_some_and(|shown| timeline.tracks.contains(&shown.id)),
            Line::Group { .. } => false,
        };
        let at = lines.lines.iter().position(is_chosen).unwrap_or(0);
        area = area.vertical_scroll_offset((at as f32 * LINE - 0.4 * place.body.height()).max(0.0));
    }
    area.show_rows(ui, LINE, lines.lines.len(), |ui, shown| {
        ui.scroll_with_delta(vec2(0.0, std::mem::take(&mut memory.scrolled)));
        for line in lines.lines.get(shown).unwrap_or_default() {
            let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), LINE), Sense::hover());
            sheet.line(ui, line, rect, place.keys.left());
        }
    });
}

/// What lies over the keys: in and out mark, the clock, a box that is drawn.
fn over(ui: &Ui, place: &Place, span: &Span, memory: &Memory, reading: &Reading<'_>) {
    let painter = ui.painter_at(place.keys);
    ruler::marks(&painter, place.keys, span, reading);
    painter.vline(span.x_of(reading.clock.time_s()), place.keys.y_range(), Stroke::new(1.5, theme::NOW));
    if let (Some(Gesture::Box(from)), Some(at)) = (&memory.gesture, ui.input(|input| input.pointer.latest_pos())) {
        let area = Rect::from_two_pos(*from, at).intersect(place.keys);
        painter.rect(area, 0.0, theme::MARQUEE_FILL, theme::MARQUEE, egui::StrokeKind::Inside);
    }
}
