//! The share of the sun's light over the angle to the sun, as a curve with a dot at each of its three numbers.
//!
//! From the side that is turned away (180°, left) to the side that faces the sun (0°, right). The curve is the one that
//! shades the cloud, so it is straight in the angle's cosine, and round here. A dot is dragged up and down, or moved by
//! the arrow keys while it has the focus, in finer steps with Shift.

use crate::theme;
use cloudwright_core::property::{C_MAX, C_MED, C_MIN, HasLight, Number, Row};
use cloudwright_core::shading::directional_share;
use egui::accesskit::{Action, ActionData, Role};
use egui::{
    Align2, Color32, CursorIcon, EventFilter, FontId, Key, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, pos2, vec2,
};
use glam::Vec3;

/// Which of the three numbers, away from the sun first.
pub(super) type At = usize;

/// Of the three numbers, in the order of the curve.
const NUMBERS: [Number; 3] = [C_MIN, C_MED, C_MAX];
/// Shares that the plot always shows.
const SHOWN: [f64; 2] = [-0.1, 1.2];
/// Of a press of an arrow key.
const STEP: f64 = 0.05;

/// Cmin, Cmed, Cmax.
pub(super) struct Shares([f64; 3]);

impl Shares {
    /// As `shown` says of each of the three.
    pub(super) fn of(shown: impl Fn(At) -> f64) -> Self {
        Self(std::array::from_fn(shown))
    }

    /// The light on the side that is turned `angle` from the sun, radians.
    fn at(&self, angle: f32) -> f64 {
        let outward = Vec3::new(angle.cos(), angle.sin(), 0.0);
        f64::from(directional_share(outward, self.0.map(|share| share as f32), Vec3::X))
    }
}

/// The row of one of the three numbers.
pub(super) fn row<T: HasLight>(at: At) -> Option<&'static Row<T>> {
    T::LIGHT.iter().find(|row| row.property.label == NUMBERS[at].label)
}

/// Shows it. The number that was changed, with its new value.
pub(super) fn show(ui: &mut Ui, shares: &Shares, tint: Color32) -> Option<(At, f64)> {
    let size = vec2(ui.available_width(), theme::CURVE_HEIGHT);
    let (whole, _) = ui.allocate_exact_size(size, Sense::hover());
    let plot = Plot {
        rect: Rect::from_min_max(whole.min + vec2(30.0, 6.0), whole.max - vec2(10.0, 20.0)),
        low: shares.0.iter().copied().fold(SHOWN[0], f64::min),
        high: shares.0.iter().copied().fold(SHOWN[1], f64::max),
    };
    if !ui.is_rect_visible(whole) || plot.rect.width() < 20.0 {
        return None;
    }
    plot.grid(ui, whole);
    plot.curve(ui, shares, tint);
    // All dots are shown, whichever is moved.
    (0..3).fold(None, |moved, at| plot.dot(ui, at, shares.0[at], tint).map(|share| (at, share)).or(moved))
}

struct Plot {
    rect: Rect,
    low: f64,
    high: f64,
}

impl Plot {
    /// `along` is 0 away from the sun, 1 towards it.
    fn place(&self, along: f32, share: f64) -> Pos2 {
        let up = (share - self.low) / (self.high - self.low);
        pos2(self.rect.left() + along * self.rect.width(), self.rect.bottom() - up as f32 * self.rect.height())
    }

    fn share_per_point(&self) -> f64 {
        (self.high - self.low) / f64::from(self.rect.height())
    }

    fn grid(&self, ui: &Ui, whole: Rect) {
        let (painter, visuals) = (ui.painter(), ui.visuals());
        painter.rect_filled(self.rect, 3.0, visuals.extreme_bg_color);
        let weak = visuals.weak_text_color();
        let font = FontId::proportional(theme::SMALL_TEXT);
        let fine = Stroke::new(1.0, visuals.widgets.noninteractive.bg_stroke.color);
        let strong = Stroke::new(1.0, visuals.weak_text_color());
        let step = if self.high - self.low > 3.0 { 1.0 } else { 0.5 };
        let lines = (self.low / step).ceil() as i32..=(self.high / step).floor() as i32;
        for share in lines.map(|line| f64::from(line) * step) {
            let y = self.place(0.0, share).y;
            painter.hline(self.rect.x_range(), y, if share == 0.0 { strong } else { fine });
            let text = if step < 1.0 { format!("{share:.1}") } else { format!("{share:.0}") };
            painter.text(pos2(self.rect.left() - 5.0, y), Align2::RIGHT_CENTER, text, font.clone(), weak);
        }
        for (along, text, align) in [
            (0.0, "180° away", Align2::LEFT_BOTTOM),
            (0.25, "", Align2::CENTER_BOTTOM),
            (0.5, "90°", Align2::CENTER_BOTTOM),
            (0.75, "", Align2::CENTER_BOTTOM),
            (1.0, "0° towards the sun", Align2::RIGHT_BOTTOM),
        ] {
            let x = self.place(along, 0.0).x;
            painter.vline(x, self.rect.y_range(), fine);
            painter.text(pos2(x, whole.bottom()), align, text, font.clone(), weak);
        }
    }

    fn curve(&self, ui: &Ui, shares: &Shares, tint: Color32) {
        const PIECES: u16 = 48;
        let points: Vec<Pos2> = (0..=PIECES)
            .map(|i| {
                let along = f32::from(i) / f32::from(PIECES);
                self.place(along, shares.at((1.0 - along) * std::f32::consts::PI))
            })
            .collect();
        ui.painter().add(Shape::line(points, Stroke::new(2.0, tint)));
    }

    /// The new share, if it was moved.
    fn dot(&self, ui: &Ui, at: At, share: f64, tint: Color32) -> Option<f64> {
        let number = &NUMBERS[at];
        let middle = self.place(at as f32 * 0.5, share);
        let id = ui.scope_id().with(("dot", at));
        let response = ui.interact(Rect::from_center_size(middle, vec2(18.0, 18.0)), id, Sense::drag());
        let moved = moved(ui, &response, share, self.share_per_point());
        let moved = moved.map(|share| share.clamp(number.min, number.max)).filter(|new| *new != share);
        describe(ui, &response, number, share);
        let stands_out = response.has_focus() || response.hovered() || response.dragged();
        let radius = if stands_out { 7.0 } else { 5.5 };
        let ring = if response.has_focus() { ui.visuals().selection.stroke.color } else { ui.visuals().text_color() };
        ui.painter().circle(middle, radius, tint, Stroke::new(1.5, ring));
        if response.dragged() {
            ui.ctx().set_cursor_icon(CursorIcon::ResizeVertical);
        }
        response
            .on_hover_cursor(CursorIcon::ResizeVertical)
            .on_hover_text(format!("{}: {share:.2}\n{} Drag, or arrow keys.", number.label, number.doc));
        moved
    }
}

/// Where pointer, keys or a screen reader put it.
fn moved(ui: &Ui, dot: &Response, share: f64, share_per_point: f64) -> Option<f64> {
    if dot.drag_started() {
        dot.request_focus();
    }
    if dot.dragged() {
        let up = -f64::from(dot.drag_delta().y);
        return Some(share + up * share_per_point);
    }
    let arrows = EventFilter { vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(dot.id, arrows));
    // Asked here: within the input it would wait for itself.
    let focused = dot.has_focus();
    ui.input(|input| {
        for request in input.accesskit_action_requests(dot.id, Action::SetValue) {
            if let Some(ActionData::NumericValue(value)) = request.data
                && value.is_finite()
            {
                return Some(value);
            }
        }
        let asked = |action| input.num_accesskit_action_requests(dot.id, action) as f64;
        let pressed = |key| if focused && input.key_pressed(key) { 1.0 } else { 0.0 };
        let up = asked(Action::Increment) - asked(Action::Decrement) + pressed(Key::ArrowUp) - pressed(Key::ArrowDown);
        let step = if input.modifiers.shift { STEP * 0.2 } else { STEP };
        (up != 0.0).then(|| ((share + up * step) * 1e4).round() / 1e4)
    })
}

fn describe(ui: &Ui, dot: &Response, number: &Number, share: f64) {
    ui.ctx().accesskit_node_builder(dot.id, |node| {
        node.set_role(Role::Slider);
        node.set_label(number.label);
        node.set_numeric_value(share);
        node.set_min_numeric_value(number.min);
        node.set_max_numeric_value(number.max);
        node.set_numeric_value_step(STEP);
        for action in [Action::SetValue, Action::Increment, Action::Decrement, Action::Focus] {
            node.add_action(action);
        }
    });
}
