//! Sheets go on to the horizon: pieces of large flat tiles in a ring around what is seen close by.

use super::{Sketch, by_plugin};
use cloudwright_core::scene::ModelId;
use glam::{DVec2, DVec3};

/// What a far piece of a sheet consists of (scripts/plugins/parts/far.rhai), metres.
pub struct Far<'a> {
    /// Of the model, whose name is `far` and a number.
    pub category: &'a str,
    /// Its colour levels, as the script writes them.
    pub levels: &'a str,
    /// Length along its rolls, and width.
    pub size: [f64; 2],
    /// How many rolls lie side by side, and of how many sprites each.
    pub rolls: [u32; 2],
    /// Sprites of the floor between the rolls; 0 for none.
    pub floor: u32,
    /// Smallest and largest side of the sprites.
    pub sprite: [f64; 2],
    /// The sprites' height over their width.
    pub squash: f64,
    /// How high over the base the rolls' middles lie, and by how much they vary.
    pub up: [f64; 2],
    /// Category of the rolls' tiles.
    pub tiles: &'a str,
}

/// Where the pieces lie: between a square about the middle and a circle around it, metres.
pub struct Ring {
    /// Middle, at the altitude of the base.
    pub middle: DVec3,
    /// Half the side of the square that stays free.
    pub inner_m: f64,
    /// Radius of the circle.
    pub outer_m: f64,
    /// Heading of the rolls, degrees.
    pub heading_deg: f64,
    /// Share of the places that are gaps, here and there.
    pub gaps: f64,
}

/// Lays three kinds of pieces over the ring, more and more torn towards its outer edge.
pub fn lay(sketch: &mut Sketch, far: &Far<'_>, ring: &Ring) {
    let Far { category, levels, size, rolls: [rolls, count], floor, sprite, squash, up: [up, thick], tiles } = far;
    let first = sketch.scene.models.len();
    let models: [ModelId; 3] = std::array::from_fn(|i| {
        let call = format!(
            "far_piece(dice, \"far {}\", \"{category}\", {levels}, #{{ size: {size:?}, rolls: {rolls}, count: {count}, \
             floor: {floor}, sprite: {sprite:?}, squash: {squash:?}, up: {up:?}, thick: {thick:?}, tiles: \"{tiles}\" }})",
            first + i + 1
        );
        by_plugin::model(sketch, &["far", "boxes"], "", &call)
    });
    let along = DVec2::from_angle(ring.heading_deg.to_radians());
    let [columns, rows] = size.map(|side| (ring.outer_m / (0.86 * side)).ceil() as i32);
    let mut number = 0;
    for row in -rows..=rows {
        let slide = sketch.roll(-0.5, 0.5);
        for column in -columns..=columns {
            let shake = DVec2::new(sketch.roll(-0.06, 0.06), sketch.roll(-0.1, 0.1));
            let cell = DVec2::new(f64::from(column) + slide, f64::from(row)) + shake;
            // Headings turn clockwise, from north; x is east and y is south here.
            let at = along.rotate(cell * DVec2::from_array(*size) * 0.86);
            let gap = 0.5 + 0.25 * ((at.x / 2900.0).sin() + (at.y / 2300.0 + at.x / 5100.0).cos());
            let (turn, chance) = (sketch.roll(-6.0, 6.0), sketch.roll(-0.15, 0.15));
            let out = at.length() / ring.outer_m;
            let free = at.abs().max_element() < ring.inner_m + 0.3 * size[1];
            if free || out > 1.0 || gap + chance < ring.gaps + 0.55 * out.powi(6) {
                continue;
            }
            number += 1;
            let position = ring.middle + DVec3::new(at.x, sketch.roll(-20.0, 20.0), at.y);
            let heading = ring.heading_deg + turn + if number % 2 == 0 { 180.0 } else { 0.0 };
            let (model, name) = (models[number % 3], format!("far {}.{number}", first + 1));
            sketch.place(model, &name, position, heading.rem_euclid(360.0), 1.0, Some(number as u64));
        }
    }
}
