//! The selected cloud from the side that the viewport sees, as soft shapes in the colours of its levels.
//!
//! Heights are true to the gradient beside it; widths are pressed together where the cloud is too wide for the panel.

use crate::state::Reading;
use crate::theme;
use crate::widget::color32;
use cloudwright_core::color::Rgba;
use cloudwright_core::scene::ColorLevels;
use cloudwright_core::shading::level_color;
use cloudwright_core::sprites::{PlacedCloud, Sprite};
use egui::{Align2, Color32, FontId, Mesh, Pos2, Rect, Ui, pos2, vec2};
use glam::Vec3;

/// Of a cloud with more, evenly chosen ones stand for all.
const MAX_SPRITES: usize = 500;
/// Corners of a soft shape.
const CORNERS: usize = 12;
/// Of a sprite's opacity: its tile is soft too.
const MIDDLE_SHARE: f32 = 0.62;
/// Where a shape begins to fade, and how much of it is left there.
const RING: (f32, f32) = (0.68, 0.7);
/// Steps of the ramp of colours.
const RAMP: usize = 128;
/// Left free at the sides, points.
const MARGIN: f32 = 6.0;

/// Fills `rect`, whose lower and upper rims are the cloud's bottom and top.
pub(super) fn paint(ui: &Ui, rect: Rect, reading: &Reading<'_>, levels: &ColorLevels) {
    let painter = ui.painter_at(rect);
    painter.rect_filled(rect, 0.0, theme::SILHOUETTE_SKY);
    let placed = reading.view.selection.cloud(reading.session.scene());
    let Some(cloud) = placed.and_then(|cloud| reading.session.placed(cloud.id)) else {
        return note(&painter, rect.center(), Align2::CENTER_CENTER, "not placed");
    };
    let (sin, cos) = reading.view_heading_deg.to_radians().sin_cos();
    let right = Vec3::new(cos as f32, 0.0, sin as f32);
    let forward = Vec3::new(sin as f32, 0.0, -cos as f32);
    let mut sprites: Vec<&Sprite> =
        cloud.sprites.iter().step_by(cloud.sprites.len().div_ceil(MAX_SPRITES).max(1)).collect();
    sprites.sort_by(|a, b| b.position.dot(forward).total_cmp(&a.position.dot(forward)));
    if let Some(map) = Map::new(rect, cloud, &sprites, right) {
        let mut mesh = Mesh::default();
        let ramp = Ramp::new(levels);
        for sprite in sprites {
            soft_shape(&mut mesh, &map, &ramp, [sprite.position.dot(right), sprite.position.y], radii(sprite));
        }
        painter.add(mesh);
    }
    let altitude = |y: f32| format!("{:.0} m", cloud.origin.y + f64::from(y));
    note(&painter, rect.right_top() + vec2(-4.0, 3.0), Align2::RIGHT_TOP, &altitude(cloud.top));
    note(&painter, rect.right_bottom() + vec2(-4.0, -3.0), Align2::RIGHT_BOTTOM, &altitude(cloud.bottom));
}

fn note(painter: &egui::Painter, at: Pos2, align: Align2, text: &str) {
    painter.text(at, align, text, FontId::proportional(10.5), theme::SILHOUETTE_TEXT);
}

/// From metres across and up to the screen.
struct Map {
    rect: Rect,
    middle: f32,
    bottom: f32,
    across: f32,
    up: f32,
}

impl Map {
    /// None for a cloud without extent.
    fn new(rect: Rect, cloud: &PlacedCloud, sprites: &[&Sprite], right: Vec3) -> Option<Self> {
        let ends = sprites.iter().map(|sprite| {
            let (at, [wide, _]) = (sprite.position.dot(right), radii(sprite));
            (at - wide, at + wide)
        });
        let (left, right) = ends.reduce(|(l, r), (low, high)| (l.min(low), r.max(high)))?;
        let up = rect.height() / (cloud.top - cloud.bottom);
        let across = up.min((rect.width() - 2.0 * MARGIN).max(1.0) / (right - left));
        let map = Self { rect, middle: (left + right) * 0.5, bottom: cloud.bottom, across, up };
        (up.is_finite() && across.is_finite()).then_some(map)
    }

    fn at(&self, x: f32, y: f32) -> Pos2 {
        let across = self.rect.center().x + (x - self.middle) * self.across;
        pos2(across, self.rect.bottom() - (y - self.bottom) * self.up)
    }

    /// 0 at the bottom, 1 at the top.
    fn height(&self, y: f32) -> f32 {
        (y - self.bottom) * self.up / self.rect.height()
    }
}

/// The levels' colours by height, for a shape's middle and for its ring.
struct Ramp([[Color32; 2]; RAMP]);

impl Ramp {
    fn new(levels: &ColorLevels) -> Self {
        Self(std::array::from_fn(|i| {
            let color = level_color(levels, i as f32 / (RAMP - 1) as f32);
            [1.0, RING.1].map(|share| color32(Rgba { a: color.a * MIDDLE_SHARE * share, ..color }))
        }))
    }

    fn at(&self, height: f32) -> [Color32; 2] {
        self.0[((height.clamp(0.0, 1.0) * (RAMP - 1) as f32) as usize).min(RAMP - 1)]
    }
}

/// Across and up, of the ellipse that a sprite's tile fills, metres.
fn radii(sprite: &Sprite) -> [f32; 2] {
    let (sin, cos) = sprite.rotation.sin_cos();
    let (width, height) = (sprite.width * 0.5, sprite.height * 0.5);
    [(width * cos).hypot(height * sin), (width * sin).hypot(height * cos)]
}

/// Each corner has the colour of its own height, as the corners of sprites do.
fn soft_shape(mesh: &mut Mesh, map: &Map, ramp: &Ramp, [x, y]: [f32; 2], [wide, high]: [f32; 2]) {
    let first = mesh.vertices.len() as u32;
    mesh.colored_vertex(map.at(x, y), ramp.at(map.height(y))[0]);
    for i in 0..CORNERS {
        let (sin, cos) = (i as f32 / CORNERS as f32 * std::f32::consts::TAU).sin_cos();
        let (inner_x, inner_y) = (x + cos * wide * RING.0, y + sin * high * RING.0);
        mesh.colored_vertex(map.at(inner_x, inner_y), ramp.at(map.height(inner_y))[1]);
        mesh.colored_vertex(map.at(x + cos * wide, y + sin * high), Color32::TRANSPARENT);
    }
    for i in 0..CORNERS as u32 {
        let (this, next) = (first + 1 + 2 * i, first + 1 + 2 * ((i + 1) % CORNERS as u32));
        mesh.add_triangle(first, this, next);
        mesh.add_triangle(this, this + 1, next);
        mesh.add_triangle(next, this + 1, next + 1);
    }
}
