//! How the presets are made: one cloud of each kind, of few enough boxes that an artist finds their way in it.
//!
//! The scenes' clouds may take a thousand sprites; a preset stays within the four hundred that a cloud should have (W),
//! so it is laid out by hand, box by box, instead of by dice: heaps.rhai and sheets.rhai, from what the plugins consist
//! of. Each scene has one model, placed once, and one camera, `main`, that shows it as the picture to choose it by does.

use super::{NamedScene, Sketch, by_plugin};
use cloudwright_core::scene::Scene;
use glam::DVec3;

/// The name of each preset's file, without its ending, and how it is made.
pub const PRESETS: &[NamedScene] = &[
    ("cumulus_humilis", || {
        let shot = Shot { eye: [-260.0, -10.0, 1200.0], target: [0.0, 105.0, 0.0], field_of_view_deg: 28.0 };
        Preset { name: "Cumulus humilis", maker: "humilis", seed: 31, base_m: 900.0, hour: 15.5, shot }.scene()
    }),
    ("cumulus_congestus", || {
        let shot = Shot { eye: [-800.0, 40.0, 3100.0], target: [0.0, 650.0, 0.0], field_of_view_deg: 30.0 };
        Preset { name: "Cumulus congestus", maker: "congestus", seed: 47, base_m: 900.0, hour: 16.5, shot }.scene()
    }),
    ("solid_cumulus", || {
        let shot = Shot { eye: [-500.0, 60.0, 1800.0], target: [0.0, 255.0, 0.0], field_of_view_deg: 30.0 };
        Preset { name: "Solid cumulus", maker: "solid", seed: 59, base_m: 900.0, hour: 16.5, shot }.scene()
    }),
    ("stratocumulus", || {
        let shot = Shot { eye: [-700.0, -520.0, 2600.0], target: [0.0, 60.0, 0.0], field_of_view_deg: 41.0 };
        Preset { name: "Stratocumulus", maker: "rolls", seed: 43, base_m: 1100.0, hour: 16.5, shot }.scene()
    }),
    ("altocumulus", || {
        let shot = Shot { eye: [-300.0, -1500.0, 2300.0], target: [0.0, 0.0, 210.0], field_of_view_deg: 44.0 };
        Preset { name: "Altocumulus", maker: "flakes", seed: 83, base_m: 3400.0, hour: 18.5, shot }.scene()
    }),
    ("stratus", || {
        let shot = Shot { eye: [-300.0, -270.0, 2300.0], target: [0.0, 20.0, 0.0], field_of_view_deg: 40.0 };
        let preset = Preset { name: "Stratus", maker: "grey", seed: 5, base_m: 380.0, hour: 9.0, shot };
        preset.in_air(3.5, 12_000.0)
    }),
    ("nimbostratus", || {
        let shot = Shot { eye: [-300.0, -420.0, 2700.0], target: [0.0, -10.0, 0.0], field_of_view_deg: 40.0 };
        let preset = Preset { name: "Nimbostratus", maker: "rainy", seed: 19, base_m: 750.0, hour: 11.0, shot };
        preset.in_air(6.0, 9_000.0)
    }),
    ("cumulonimbus", || {
        let shot = Shot { eye: [-4200.0, -500.0, 17_500.0], target: [1700.0, 3400.0, 0.0], field_of_view_deg: 33.0 };
        let preset =
            Preset { name: "Cumulonimbus", maker: "thunder_cloud", seed: 67, base_m: 1000.0, hour: 18.8, shot };
        preset.in_air(Scene::default().sky.turbidity, 70_000.0)
    }),
    ("wisps", || {
        let shot = Shot { eye: [-150.0, -150.0, 1350.0], target: [0.0, 125.0, 0.0], field_of_view_deg: 28.0 };
        Preset { name: "Wisps", maker: "torn", seed: 71, base_m: 800.0, hour: 16.0, shot }.scene()
    }),
];

/// What makes the clouds.
const MAKERS: &str = concat!(include_str!("heaps.rhai"), include_str!("sheets.rhai"));

/// Where the eye stands and what it looks at, metres; the cloud's base lies at the origin.
struct Shot {
    eye: [f64; 3],
    target: [f64; 3],
    field_of_view_deg: f64,
}

/// One of them.
struct Preset {
    /// Of the scene.
    name: &'static str,
    /// The function of the scripts that makes the model.
    maker: &'static str,
    seed: u64,
    base_m: f64,
    /// Time of day.
    hour: f64,
    shot: Shot,
}

impl Preset {
    /// One cloud under the default sky.
    fn scene(&self) -> Scene {
        let mut sketch = Sketch::new(self.name, self.seed);
        let id = by_plugin::model(&mut sketch, &["cumulus", "boxes"], MAKERS, &format!("{}(dice)", self.maker));
        let (base, name) = (DVec3::Y * self.base_m, sketch.scene.models[0].name.clone());
        sketch.place(id, &name, base, 0.0, 1.0, None);
        let [eye, target] = [self.shot.eye, self.shot.target].map(|at| base + DVec3::from(at));
        sketch.camera("main", eye, target, self.shot.field_of_view_deg);
        sketch.scene.time_of_day_h = self.hour;
        sketch.scene
    }

    /// The same in air of that turbidity, and of that haze, metres.
    fn in_air(&self, turbidity: f64, haze_length_m: f64) -> Scene {
        let mut scene = self.scene();
        (scene.sky.turbidity, scene.sky.haze_length_m) = (turbidity, haze_length_m);
        scene
    }
}
