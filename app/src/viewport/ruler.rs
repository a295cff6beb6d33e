//! What tells sizes in an orthographic view, where nothing comes nearer: altitudes along its left edge if it looks level,
//! else a bar of a round length.

use super::overlay;
use super::plane::round_step;
use super::screen::Screen;
use crate::theme;
use crate::units::{Unit, Units};
use egui::{Painter, Pos2, pos2, vec2};
use glam::DVec3;

/// Between two altitudes, and along the bar, points at least.
const STEP: f64 = 56.0;
/// Of a tick, points.
const TICK: f32 = 7.0;
/// What stands above and below, points.
const ABOVE: f32 = 44.0;
const BELOW: f32 = 52.0;

/// Paints it, true for what lies as far away as what is looked at.
pub(super) fn paint(painter: &Painter, screen: &Screen, looked_at: DVec3, units: Units) {
    let unit = units.altitude();
    let a_point_m = screen.metres_per_point(looked_at);
    if !a_point_m.is_finite() || a_point_m <= 0.0 {
        return;
    }
    let step = round_step(unit.from_si(a_point_m * STEP), 0.0);
    if screen.view.forward.y.abs() > 0.01 {
        bar(painter, screen, (unit.to_si(step) / a_point_m) as f32, &unit.text(unit.to_si(step)));
    } else if let Some(at) = screen.find(looked_at) {
        altitudes(painter, screen, |y| looked_at.y + f64::from(at.y - y) * a_point_m, unit, step);
    }
}

/// Ticks where the altitude is a multiple of `step`.
fn altitudes(painter: &Painter, screen: &Screen, metres_at: impl Fn(f32) -> f64, unit: Unit, step: f64) {
    let (top, bottom) = (screen.rect.top() + ABOVE, screen.rect.bottom() - BELOW);
    let [highest, lowest] = [top, bottom].map(|y| unit.from_si(metres_at(y)) / step);
    let mut multiple = lowest.ceil();
    while multiple <= highest {
        let share = ((multiple - lowest) / (highest - lowest)) as f32;
        let left = pos2(screen.rect.left(), egui::lerp(bottom..=top, share));
        line(painter, [left, left + vec2(TICK, 0.0)]);
        overlay::label(painter, left + vec2(TICK + 8.0, -8.0), &unit.text(unit.to_si(multiple * step)));
        multiple += 1.0;
    }
}

fn bar(painter: &Painter, screen: &Screen, points: f32, text: &str) {
    let left = screen.rect.left_bottom() + vec2(theme::VIEWPORT_MARGIN, -BELOW);
    let right = left + vec2(points, 0.0);
    line(painter, [left, right]);
    for end in [left, right] {
        line(painter, [end, end - vec2(0.0, TICK)]);
    }
    overlay::label(painter, left + vec2(8.0, -26.0), text);
}

fn line(painter: &Painter, ends: [Pos2; 2]) {
    for stroke in [theme::casing(theme::GRID), theme::GRID] {
        painter.line_segment(ends, stroke);
    }
}
