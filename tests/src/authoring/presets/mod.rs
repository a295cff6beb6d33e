//! How the presets are made: one cloud of each kind, of few enough boxes that an artist finds their way in it.
//!
//! The scenes' clouds may take a thousand sprites; a preset stays within the four hundred that a cloud should have (W),
//! so it is laid out by hand, box by box, instead of by dice. Each scene has one model, placed once, and one camera,
//! `main`, that shows it as the picture to choose it by does.

mod heaps;
mod sheets;
mod wisps;

use super::{NamedScene, Sketch};
use cloudwright_core::scene::{CloudModel, Scene};
use glam::DVec3;

/// The name of each preset's file, without its ending, and how it is made.
pub const PRESETS: &[NamedScene] = &[
    ("cumulus_humilis", heaps::humilis),
    ("cumulus_congestus", heaps::congestus),
    ("solid_cumulus", heaps::solid),
    ("stratocumulus", sheets::stratocumulus),
    ("altocumulus", sheets::altocumulus),
    ("stratus", sheets::stratus),
    ("nimbostratus", sheets::nimbostratus),
    ("cumulonimbus", heaps::cumulonimbus),
    ("wisps", wisps::scene),
];

/// Where the eye stands and what it looks at, metres; the cloud's base lies at the origin.
struct Shot {
    eye: [f64; 3],
    target: [f64; 3],
    field_of_view_deg: f64,
}

/// The scene of one cloud, its base `altitude` metres high.
fn one_cloud(mut sketch: Sketch, model: CloudModel, altitude: f64, shot: &Shot) -> Scene {
    let base = DVec3::Y * altitude;
    let (id, name) = (model.id, model.name.clone());
    sketch.scene.models.push(model);
    sketch.place(id, &name, base, 0.0, 1.0, None);
    let [eye, target] = [shot.eye, shot.target].map(|at| base + DVec3::from(at));
    sketch.camera("main", eye, target, shot.field_of_view_deg);
    sketch.scene
}
