//! The upright gradient with its five handles, and beside it, at the same heights, the cloud.

use super::{paint_gradient, silhouette};
use crate::state::{Reading, color_levels};
use crate::theme;
use crate::widget::{Handle, LEVEL_STEP, color32};
use cloudwright_core::color::Rgba;
use cloudwright_core::property::LEVEL_HEIGHT;
use cloudwright_core::scene::{ColorLevel, ColorLevels};
use egui::{CursorIcon, Pos2, Rect, Response, Sense, Shape, Stroke, Ui, pos2, vec2};

/// Of the scale, points: it takes what room there is.
const HEIGHT: std::ops::RangeInclusive<f32> = 110.0..=260.0;
/// Points.
const BAR_WIDTH: f32 = 34.0;
/// Between bar and cloud: where the handles hang.
const GUTTER: f32 = 26.0;
/// Of a handle, points.
const TAG: egui::Vec2 = vec2(20.0, 13.0);
/// From a handle's tip to where it is full, points.
const TIP: f32 = 6.0;

/// Handles change `levels`, and the one that is touched is `chosen`.
pub(super) fn show(ui: &mut Ui, room: f32, reading: &Reading<'_>, levels: &mut ColorLevels, chosen: &mut usize) {
    let size = vec2(ui.available_width(), room.clamp(*HEIGHT.start(), *HEIGHT.end()));
    let (whole, _) = ui.allocate_exact_size(size, Sense::hover());
    let rect = whole.shrink2(vec2(0.0, TAG.y * 0.5));
    let bar = Rect::from_min_size(rect.min, vec2(BAR_WIDTH, rect.height()));
    let cloud = Rect::from_min_max(pos2(bar.right() + GUTTER, rect.top()), rect.max);
    paint_gradient(ui.painter(), bar, levels);
    let frame = ui.visuals().widgets.noninteractive.bg_stroke;
    ui.painter().rect_stroke(bar, 0.0, frame, egui::StrokeKind::Outside);
    silhouette::paint(ui, cloud, reading, levels);

    let places = places(levels, bar, cloud);
    let before = *levels;
    let tags: Vec<(usize, Response)> = (0..before.len())
        .map(|index| {
            let place = places[index];
            let handled = Handle {
                id: ui.scope_id().with(("level", index)),
                rect: Rect::from_min_size(place - vec2(0.0, TAG.y * 0.5), TAG),
                name: &format!("Level {}", index + 1),
                number: &LEVEL_HEIGHT,
                value: before[index].height,
                step: LEVEL_STEP,
            }
            .show(ui, |start, way| start - f64::from(way.y / bar.height()));
            if let Some(height) = handled.wanted {
                *levels = color_levels::moved(before, index, height);
            }
            if handled.response.clicked() || handled.response.gained_focus() || handled.wanted.is_some() {
                *chosen = index;
            }
            (index, handled.response.on_hover_cursor(CursorIcon::ResizeVertical))
        })
        .collect();
    // The chosen one on top.
    for (index, tag) in tags.iter().filter(|(i, _)| i != chosen).chain(tags.iter().filter(|(i, _)| i == chosen)) {
        guide(ui, cloud, places[*index].y, index == chosen);
        paint_tag(ui, bar.right(), places[*index], &before[*index], index == chosen, tag);
    }
    for (index, tag) in tags {
        let ColorLevel { height, color } = before[index];
        let percent = color.a * 100.0;
        tag.on_hover_text(format!("Level {}: height {height:.3}, opacity {percent:.0} %", index + 1));
    }
}

/// The middle of each tag's left side. Tags at nearly one height stand beside each other, so that each can be taken.
fn places(levels: &ColorLevels, bar: Rect, cloud: Rect) -> [Pos2; 5] {
    let mut places = [bar.right_top(); 5];
    for i in 0..levels.len() {
        let y = egui::lerp(bar.bottom()..=bar.top(), levels[i].height.clamp(0.0, 1.0) as f32);
        let beside = i > 0 && (places[i - 1].y - y).abs() < TAG.y;
        let x = if beside { places[i - 1].x + TAG.x + 1.0 } else { bar.right() + 4.0 };
        places[i] = pos2(x.min(cloud.right() - TAG.x), y);
    }
    places
}

fn guide(ui: &Ui, cloud: Rect, y: f32, chosen: bool) {
    let stroke = if chosen { Stroke::new(1.0, theme::CHOSEN) } else { Stroke::new(1.0, theme::LEVEL_GUIDE) };
    ui.painter().hline(cloud.x_range(), y, stroke);
}

/// A tag that points at the bar, in the level's colour.
fn paint_tag(ui: &Ui, bar_right: f32, place: Pos2, level: &ColorLevel, chosen: bool, tag: &Response) {
    let visuals = ui.visuals();
    let edge = if chosen {
        Stroke::new(2.0, theme::CHOSEN)
    } else if tag.hovered() {
        visuals.widgets.hovered.fg_stroke
    } else {
        Stroke::new(1.0, theme::tag_edge(ui))
    };
    let (half, shoulder) = (TAG.y * 0.5, place.x + TIP);
    if place.x - bar_right > TAG.x {
        ui.painter().hline(bar_right..=place.x, place.y, Stroke::new(1.0, edge.color));
    }
    let points = vec![
        pos2(place.x, place.y),
        pos2(shoulder, place.y - half),
        pos2(place.x + TAG.x, place.y - half),
        pos2(place.x + TAG.x, place.y + half),
        pos2(shoulder, place.y + half),
    ];
    let fill = color32(Rgba { a: 1.0, ..level.color });
    ui.painter().add(Shape::convex_polygon(points, fill, edge));
    if tag.has_focus() {
        let ring = Rect::from_min_size(place - vec2(0.0, half), TAG).expand(2.5);
        ui.painter().rect_stroke(ring, 3.0, visuals.selection.stroke, egui::StrokeKind::Outside);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tags_at_one_height_stand_beside_each_other() {
        let levels = [0.0, 0.0, 0.5, 1.0, 1.0].map(|height| ColorLevel { height, color: Rgba::default() });
        let bar = Rect::from_min_size(pos2(0.0, 0.0), vec2(30.0, 100.0));
        let cloud = Rect::from_min_size(pos2(60.0, 0.0), vec2(200.0, 100.0));
        let places = places(&levels, bar, cloud);
        assert_eq!((places[0].y, places[2].y, places[4].y), (100.0, 50.0, 0.0));
        assert!(places[1].x >= places[0].x + TAG.x && places[4].x >= places[3].x + TAG.x);
        assert_eq!(places[2].x, places[0].x);
    }
}
