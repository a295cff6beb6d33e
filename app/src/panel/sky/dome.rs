//! The sky from above, its middle overhead and its rim the horizon: the sun's way over the day, and the sun, which can
//! be dragged if it is set by hand. Outside the rim it stands below the horizon.

use super::sun_path::SunPath;
use crate::theme;
use crate::widget::name_it;
use cloudwright_core::math::clock;
use cloudwright_core::scene::{Site, Sun};
use cloudwright_core::weather::sun_direction;
use egui::{Align2, Color32, FontId, Pos2, Sense, Shape, Stroke, Ui, Vec2, vec2};
use glam::Vec3;

/// Points.
const SIDE: f32 = 100.0;
/// Of the horizon.
const RADIUS: f32 = 36.0;
/// Outside the horizon: where the nadir is.
const BELOW: f32 = 8.0;

/// The sun where it was dragged to.
pub(super) fn show(ui: &mut Ui, sun: Sun, place: &Site, hour: f64, path: &SunPath) -> Option<Sun> {
    let by_hand = sun != Sun::ByPlace;
    let sense = if by_hand { Sense::drag() } else { Sense::hover() };
    let (rect, response) = ui.allocate_exact_size(Vec2::splat(SIDE), sense);
    name_it(ui, &response, "Sun on the sky");
    let middle = rect.center();
    let painter = ui.painter_at(rect);
    let line = ui.visuals().widgets.noninteractive.bg_stroke;
    painter.circle(middle, RADIUS, theme::SILHOUETTE_SKY, Stroke::new(1.0, line.color));
    for elevation_deg in [30.0_f32, 60.0] {
        painter.circle_stroke(middle, RADIUS * (1.0 - elevation_deg / 90.0), Stroke::new(1.0, theme::LEVEL_GUIDE));
    }
    for (text, side) in [("N", Vec2::UP), ("E", Vec2::RIGHT), ("S", Vec2::DOWN), ("W", Vec2::LEFT)] {
        let at = middle + side * (RADIUS + BELOW);
        painter.text(at, Align2::CENTER_CENTER, text, FontId::proportional(10.5), ui.visuals().weak_text_color());
    }
    if !by_hand {
        let points: Vec<Pos2> = path.directions.iter().map(|direction| middle + place_of(*direction)).collect();
        for (pair, directions) in points.windows(2).zip(path.directions.windows(2)) {
            if directions[0].y > 0.0 && directions[1].y > 0.0 {
                painter.line_segment([pair[0], pair[1]], Stroke::new(1.5, theme::SUN_PATH));
            }
        }
    }
    let direction = sun_direction(sun, place, hour);
    let at = middle + place_of(direction);
    let fill = if direction.y > 0.0 { theme::SUN } else { theme::SUN_BELOW };
    painter.add(Shape::circle_filled(at, 5.5, fill));
    painter.circle_stroke(at, 5.5, Stroke::new(1.0, Color32::BLACK.gamma_multiply(0.5)));
    let dragged = response.interact_pointer_pos().filter(|_| response.dragged());
    let elevation = direction.y.clamp(-1.0, 1.0).asin().to_degrees();
    let hint = if by_hand { "Drag the sun." } else { "Tick “Sun by hand” to drag the sun." };
    response.on_hover_text(format!("{}, {elevation:.1}° above the horizon. {hint}", clock(hour)));
    dragged.map(|pointer| sun_at(pointer - middle))
}

/// From the middle of the sky, points.
fn place_of(direction: Vec3) -> Vec2 {
    let elevation = direction.y.clamp(-1.0, 1.0).asin() / std::f32::consts::FRAC_PI_2;
    let level = vec2(direction.x, direction.z);
    let length = level.length();
    // Straight up or down there is no heading.
    let side = if length > 1e-6 { level / length } else { Vec2::DOWN };
    let distance = if elevation >= 0.0 { RADIUS * (1.0 - elevation) } else { RADIUS - BELOW * elevation };
    side * distance
}

/// The inverse of [`place_of`], to a tenth of a degree.
fn sun_at(place: Vec2) -> Sun {
    let distance = place.length();
    let share = if distance <= RADIUS { 1.0 - distance / RADIUS } else { -((distance - RADIUS) / BELOW).min(1.0) };
    let tenth = |deg: f32| f64::from((deg * 10.0).round()) / 10.0;
    let heading_deg = tenth(place.x.atan2(-place.y).to_degrees()).rem_euclid(360.0);
    Sun::ByHand { heading_deg, elevation_deg: tenth(share * 90.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_sun_lies_where_it_was_dragged_to() {
        for (x, y) in [(0.0, -20.0), (25.0, 10.0), (-30.0, -5.0), (0.0, 0.0), (40.0, 0.0), (-200.0, 300.0)] {
            let place = vec2(x, y);
            let sun = sun_at(place);
            let again = place_of(sun_direction(sun, &Site::default(), 0.0));
            // Straight down there is no heading.
            let want = if place.length() > RADIUS + BELOW { vec2(0.0, RADIUS + BELOW) } else { place };
            assert!((again - want).length() < 0.2, "{place:?} came to {again:?}");
        }
    }
}
