//! A curve among a plugin's parameters: points that are joined by straight lines, from left to right.
//!
//! A point is dragged, or moved by the arrow keys while it has the focus, in finer steps with Shift. A double click adds
//! one, and so does Insert, to the right of the point that has the focus; a right click takes one out, and so does Delete.
//! The numbers of the point that was touched last stand beneath.

use crate::theme;
use crate::widget::{self, ENDLESS, span_field};
use cloudwright_scripts::parameter::Span;
use cloudwright_scripts::{Parameter, ParameterValue};
use egui::accesskit::{Action, ActionData, Role};
use egui::{Align2, CursorIcon, EventFilter, FontId, Key, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, pos2, vec2};

type Point = [f64; 2];

/// Of an arrow key, as a share of what is shown.
const STEP: f64 = 0.05;
/// Shift makes it so much finer.
const FINE: f64 = 0.2;
/// Between two points' x, as a share of what is shown.
const APART: f64 = 1e-3;
/// Around its middle, where a point is taken, points.
const REACH: f32 = 16.0;

/// What was done with a point.
enum Done {
    Move(Point),
    /// Another one to its right.
    Add,
    Remove,
}

/// Shows it. The points, if they were changed.
pub(super) fn show(ui: &mut Ui, parameter: &Parameter, span: &Span, points: &[Point]) -> Option<Vec<Point>> {
    let size = vec2(theme::PARAMETER_WIDTH, theme::CURVE_HEIGHT);
    let (whole, ground) = ui.allocate_exact_size(size, Sense::click());
    let plot = Plot::new(whole, parameter, span, points);
    plot.paint(ui, span, points);
    let chosen_id = ground.id.with("chosen");
    let mut chosen: Option<usize> = ui.data(|data| data.get_temp(chosen_id));
    let mut done = None;
    for (index, point) in points.iter().enumerate() {
        let id = ground.id.with(("point", index));
        let dot = ui.interact(Rect::from_center_size(plot.at(*point), vec2(REACH, REACH)), id, Sense::click_and_drag());
        describe(ui, &dot, &format!("{} point {}", parameter.label, index + 1), *point, span);
        if dot.clicked() || dot.drag_started() {
            dot.request_focus();
        }
        if dot.has_focus() {
            chosen = Some(index);
        }
        plot.dot(ui, &dot, *point);
        done = asked(ui, &dot, *point, &plot).map(|what| (index, what)).or(done);
        dot.on_hover_cursor(CursorIcon::Grab).on_hover_text(format!("{:.4}: {:.4} {}", point[0], point[1], span.unit));
    }
    let at = ground.double_clicked().then(|| ground.interact_pointer_pos()).flatten();
    let mut changed = None;
    if let Some(new) = at.map(|at| plot.point(at)) {
        changed = with(points, new);
    }
    if let Some((index, what)) = done {
        changed = match what {
            Done::Move(to) => Some(moved(points, index, to, &plot, span)),
            Done::Add => right_of(points, index, &plot).and_then(|new| with(points, new)),
            Done::Remove => without(points, index),
        };
    }
    let chosen = chosen.filter(|index| *index < points.len());
    ui.data_mut(|data| data.insert_temp(chosen_id, chosen.unwrap_or_default()));
    let typed = numbers(ui, parameter, span, points, chosen.unwrap_or_default(), &plot);
    ground.on_hover_text(format!("{}\nDouble click: another point. Right click: takes it out.", parameter.help).trim());
    changed.or(typed).filter(|changed| changed != points)
}

/// The numbers of one point, to be typed.
fn numbers(
    ui: &mut Ui,
    parameter: &Parameter,
    span: &Span,
    points: &[Point],
    index: usize,
    plot: &Plot,
) -> Option<Vec<Point>> {
    let mut point = *points.get(index)?;
    let [min, max] = span.hard;
    let x = widget::Span { unit: "", min: -ENDLESS, max: ENDLESS, doc: "", whole: false, step: Some(plot.step()[0]) };
    let y = widget::Span { unit: &span.unit, min, max, doc: &parameter.help, whole: false, step: span.step };
    let changed = ui.horizontal(|ui| {
        let moved = span_field(ui, &format!("{} x", parameter.label), &x, &mut point[0]);
        span_field(ui, &format!("{} y", parameter.label), &y, &mut point[1]) || moved
    });
    changed.inner.then(|| moved(points, index, point, plot, span))
}

/// With another point; unless there is one at its x.
fn with(points: &[Point], new: Point) -> Option<Vec<Point>> {
    let mut points = points.to_vec();
    let at = points.partition_point(|point| point[0] < new[0]);
    if points.get(at).is_some_and(|point| point[0] == new[0]) {
        return None;
    }
    points.insert(at, new);
    Some(points)
}

/// One is left.
fn without(points: &[Point], index: usize) -> Option<Vec<Point>> {
    let mut points = points.to_vec();
    (points.len() > 1).then(|| points.remove(index))?;
    Some(points)
}

/// On the line halfway to the next point; right of the last one, to the end of what is shown.
fn right_of(points: &[Point], index: usize, plot: &Plot) -> Option<Point> {
    let here = *points.get(index)?;
    let next = points.get(index + 1).copied().unwrap_or([plot.x[1], here[1]]);
    let apart = next[0] - here[0];
    (apart > 0.0).then(|| [0, 1].map(|axis| 0.5 * (here[axis] + next[axis])))
}

/// With a point elsewhere, between its neighbours.
fn moved(points: &[Point], index: usize, [x, y]: Point, plot: &Plot, span: &Span) -> Vec<Point> {
    let mut points = points.to_vec();
    let apart = APART * (plot.x[1] - plot.x[0]);
    let low = index.checked_sub(1).map_or(-ENDLESS, |before| points[before][0] + apart);
    let high = points.get(index + 1).map_or(ENDLESS, |after| after[0] - apart);
    // Between neighbours that stand closer, it stays.
    let x = if low <= high { x.clamp(low, high) } else { points[index][0] };
    points[index] = [x, y.clamp(span.hard[0], span.hard[1])];
    points
}

/// What pointer, keys or a screen reader want of a point.
fn asked(ui: &Ui, dot: &Response, point: Point, plot: &Plot) -> Option<Done> {
    if dot.secondary_clicked() {
        return Some(Done::Remove);
    }
    if dot.dragged() {
        return dot.interact_pointer_pos().map(|at| Done::Move(plot.point(at)));
    }
    let focused = dot.has_focus();
    if focused {
        let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
        ui.memory_mut(|memory| memory.set_focus_lock_filter(dot.id, arrows));
    }
    let [step_x, step_y] = plot.step();
    ui.input(|input| {
        for request in input.accesskit_action_requests(dot.id, Action::SetValue) {
            if let Some(ActionData::NumericValue(value)) = request.data
                && value.is_finite()
            {
                return Some(Done::Move([point[0], value]));
            }
        }
        let pressed = |key| focused && input.key_pressed(key);
        if pressed(Key::Delete) || pressed(Key::Backspace) {
            return Some(Done::Remove);
        }
        if pressed(Key::Insert) {
            return Some(Done::Add);
        }
        let asked = |action| input.num_accesskit_action_requests(dot.id, action) as f64;
        let count = |key| f64::from(u8::from(pressed(key)));
        let up = asked(Action::Increment) - asked(Action::Decrement) + count(Key::ArrowUp) - count(Key::ArrowDown);
        let right = count(Key::ArrowRight) - count(Key::ArrowLeft);
        let by = if input.modifiers.shift { FINE } else { 1.0 };
        let to = [in_short(point[0] + right * by * step_x, step_x), in_short(point[1] + up * by * step_y, step_y)];
        (up != 0.0 || right != 0.0).then_some(Done::Move(to))
    })
}

fn describe(ui: &Ui, dot: &Response, name: &str, [x, y]: Point, span: &Span) {
    ui.ctx().accesskit_node_builder(dot.id, |node| {
        node.set_role(Role::Slider);
        node.set_label(name);
        node.set_description(format!("at {x}"));
        node.set_numeric_value(y);
        node.set_min_numeric_value(span.hard[0]);
        node.set_max_numeric_value(span.hard[1]);
        for action in [Action::SetValue, Action::Increment, Action::Decrement, Action::Focus] {
            node.add_action(action);
        }
    });
}

/// Without digits finer than a hundredth of a step.
fn in_short(value: f64, step: f64) -> f64 {
    let parts = 10_f64.powf(2.0 - step.log10().floor());
    (value * parts).round() / parts
}

/// What is shown of the plane, and where.
struct Plot {
    rect: Rect,
    whole: Rect,
    x: [f64; 2],
    y: [f64; 2],
}

impl Plot {
    /// As far as the curve reaches, and did at first; in height as far as a slider would.
    fn new(whole: Rect, parameter: &Parameter, span: &Span, points: &[Point]) -> Self {
        let first: &[Point] = if let ParameterValue::Curve(first) = &parameter.initial { first } else { &[] };
        let extent = |axis: usize| {
            let all = points.iter().chain(first).map(|point| point[axis]);
            all.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
        };
        let [low, high] = extent(1);
        let is_bounded = span.soft[1] - span.soft[0] < ENDLESS;
        let y = if is_bounded { [low.min(span.soft[0]), high.max(span.soft[1])] } else { [low, high] };
        let rect = Rect::from_min_max(whole.min + vec2(4.0, 4.0), whole.max - vec2(4.0, 16.0));
        Self { rect, whole, x: wide(extent(0)), y: wide(y) }
    }

    fn at(&self, [x, y]: Point) -> Pos2 {
        let share = |value: f64, [low, high]: [f64; 2]| ((value - low) / (high - low)) as f32;
        pos2(
            self.rect.left() + share(x, self.x) * self.rect.width(),
            self.rect.bottom() - share(y, self.y) * self.rect.height(),
        )
    }

    /// Under the pointer, within what is shown.
    fn point(&self, at: Pos2) -> Point {
        let along = f64::from((at.x - self.rect.left()) / self.rect.width()).clamp(0.0, 1.0);
        let up = f64::from((self.rect.bottom() - at.y) / self.rect.height()).clamp(0.0, 1.0);
        let [step_x, step_y] = self.step();
        let value =
            |share: f64, [low, high]: [f64; 2], step: f64| in_short(low + share * (high - low), step).clamp(low, high);
        [value(along, self.x, step_x), value(up, self.y, step_y)]
    }

    /// Of an arrow key.
    fn step(&self) -> [f64; 2] {
        [self.x, self.y].map(|[low, high]| STEP * (high - low))
    }

    fn paint(&self, ui: &Ui, span: &Span, points: &[Point]) {
        let (painter, visuals) = (ui.painter(), ui.visuals());
        painter.rect_filled(self.rect, 3.0, visuals.extreme_bg_color);
        painter.rect_stroke(self.rect, 3.0, visuals.widgets.noninteractive.bg_stroke, egui::StrokeKind::Inside);
        let (font, weak) = (FontId::proportional(theme::SMALL_TEXT), visuals.weak_text_color());
        let text = |at: Pos2, align: Align2, value: f64, range: [f64; 2], unit: &str| {
            let value = in_short(value, STEP * (range[1] - range[0]));
            painter.text(at, align, format!("{value} {unit}").trim_end(), font.clone(), weak);
        };
        let inside = self.rect.shrink(3.0);
        text(inside.left_top(), Align2::LEFT_TOP, self.y[1], self.y, &span.unit);
        text(inside.left_bottom(), Align2::LEFT_BOTTOM, self.y[0], self.y, &span.unit);
        text(self.whole.left_bottom() + vec2(4.0, 0.0), Align2::LEFT_BOTTOM, self.x[0], self.x, "");
        text(self.whole.right_bottom() - vec2(4.0, 0.0), Align2::RIGHT_BOTTOM, self.x[1], self.x, "");
        let mut line: Vec<Pos2> = points.iter().map(|point| self.at(*point)).collect();
        // Beyond its ends it goes on as it is there.
        if let (Some(first), Some(last)) = (line.first().copied(), line.last().copied()) {
            line.insert(0, pos2(self.rect.left(), first.y));
            line.push(pos2(self.rect.right(), last.y));
        }
        painter.add(Shape::line(line, Stroke::new(1.6, theme::key(ui))));
    }

    fn dot(&self, ui: &Ui, dot: &Response, point: Point) {
        let radius = if dot.hovered() || dot.dragged() { 6.0 } else { 4.5 };
        let (fill, rim) = if dot.has_focus() {
            (theme::CHOSEN, Stroke::new(1.5, ui.visuals().strong_text_color()))
        } else {
            (theme::key(ui), Stroke::new(1.0, ui.visuals().extreme_bg_color))
        };
        ui.painter().circle(self.at(point), radius, fill, rim);
    }
}

/// A range of some width.
fn wide([low, high]: [f64; 2]) -> [f64; 2] {
    match high - low {
        _ if !(low.is_finite() && high.is_finite()) => [0.0, 1.0],
        width if width > 0.0 => [low, high],
        _ => [low - 0.5, high + 0.5],
    }
}
