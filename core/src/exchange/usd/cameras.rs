//! Cameras, and flights as cameras that move.

use super::{FINE_STEPS, code, display_name, placed, scope};
use crate::exchange::motion::{Flight, Motion, turn_of};
use crate::flight::PathCurve;
use crate::formats::usda::{Names, Number, Text};
use crate::scene::Scene;
use glam::{DQuat, DVec3};

/// Width and height of the film, tenths of a metre, as stages measure it: that of 36 mm, at 16:9.
const FILM: [f64; 2] = [0.36, 0.2025];

pub(super) fn write(text: &mut Text, scene: &Scene, motion: &Motion<'_>) {
    scope(text, "Cameras", |text, names| {
        for camera in &scene.cameras {
            let still = (camera.position, turn_of(camera), camera.field_of_view_deg);
            write_one(text, names, &camera.name, still, motion.camera(camera));
        }
        for path in &scene.paths {
            let start = PathCurve::new(path).at(0.0);
            let still = (start.position, start.turn(), path.field_of_view_deg);
            write_one(text, names, &path.name, still, Flight::of(path));
        }
    });
}

fn write_one(
    text: &mut Text,
    names: &mut Names,
    name: &str,
    (place, turn, field_of_view_deg): (DVec3, DQuat, f64),
    flight: Option<Flight>,
) {
    let flight = flight.unwrap_or_default();
    text.prim(&format!("def Camera \"{}\"", names.free(name)), &[display_name(name)], |text| {
        text.set("float2 clippingRange", "(1, 400000)");
        text.set("float focalLength", focal_length(field_of_view_deg));
        if !flight.fields_of_view_deg.is_empty() {
            let samples = flight.fields_of_view_deg.iter().map(|(time, deg)| (code(*time), focal_length(*deg)));
            text.samples("float focalLength", samples);
        }
        text.set("float horizontalAperture", FILM[0]);
        text.set("token projection", "\"perspective\"");
        text.set("float verticalAperture", FILM[1]);
        placed(text, (place, &flight.places), Some((turn, &flight.turns)));
    });
}

/// With which the film sees so much from top to bottom, tenths of a metre.
fn focal_length(field_of_view_deg: f64) -> Number {
    Number(0.5 * FILM[1] / libm::tan(0.5 * field_of_view_deg.to_radians()), FINE_STEPS)
}
