//! An evening in the lee of mountains that are not seen: lens clouds stand still in the wave while the wind goes through
//! them, and below, torn heaps race past, their edges streaming in gusts.

use super::cumulus::{Cumulus, cumulus};
use super::{Sketch, by_plugin};
use cloudwright_core::scene::{Beyond, Category, Leaves, ModelId, Region, Scene, Weather};
use glam::DVec3;

/// The side of the sky in which the low clouds stay.
const FIELD_M: f64 = 11_000.0;
/// A gust comes again so often.
const GUSTS_S: f64 = 40.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("In the lee", 67);
    lenses(&mut sketch);
    racing(&mut sketch);
    let scene = &mut sketch.scene;
    scene.time_of_day_h = 19.3;
    scene.sky.turbidity = 2.2;
    scene.sky.haze_length_m = 48_000.0;
    air(&mut sketch);
    sketch.camera("main", DVec3::new(600.0, 500.0, 3300.0), DVec3::new(-400.0, 1750.0, -1500.0), 56.0);
    sketch.camera("sunward", DVec3::new(3000.0, 700.0, 1500.0), DVec3::new(-3500.0, 1900.0, -900.0), 58.0);
    sketch.camera("above", DVec3::new(-2600.0, 2500.0, 3800.0), DVec3::new(300.0, 1500.0, -1200.0), 52.0);
    sketch.scene
}

/// Smooth stacks of plates, as the plugin makes them; the wind does not carry them.
fn lenses(sketch: &mut Sketch) {
    let id = by_plugin::model(sketch, &["lens", "boxes"], "", "lens(dice, \"lens\", 1.0)");
    for (i, (east, up, south, scale)) in
        [(-1500.0, 2500.0, -3600.0, 1.25), (2700.0, 2750.0, -5600.0, 1.5), (-5200.0, 2650.0, -6600.0, 1.4)]
            .into_iter()
            .enumerate()
    {
        sketch.place(id, &format!("lens {}", i + 1), DVec3::new(east, up, south), 0.0, scale, Some(i as u64 + 1));
        if let Some(cloud) = sketch.scene.clouds.last_mut() {
            (cloud.wind_share, cloud.base_share) = (0.0, 0.0);
        }
        // The wave comes and goes a little with the gusts.
        let phase = 5.0 + 6.0 * i as f64;
        sketch.key(
            &format!("cloud/{}/growth", sketch.scene.clouds.last().expect("a lens").id),
            Leaves::Smooth,
            Beyond::Repeat,
            &[(phase, 0.85), (phase + 0.5 * GUSTS_S, 1.15), (phase + GUSTS_S, 0.85)],
        );
    }
}

/// Torn heaps and scraps under the wave.
fn racing(sketch: &mut Sketch) {
    let kinds = [
        ("torn heap", Category::CumulusCongestus, [480.0, 300.0], 420.0, 8, [100.0, 185.0], 0.55, 5),
        ("low heap", Category::CumulusHumilis, [420.0, 240.0], 230.0, 7, [80.0, 140.0], 0.45, 5),
        ("scrap", Category::CumulusHumilis, [230.0, 140.0], 130.0, 4, [55.0, 90.0], 0.35, 4),
    ];
    let model = |(name, category, base, height, heaps, heap_radius, peak, wisps): (_, _, _, _, _, _, _, _)| {
        // The gusts tear them as they go.
        let kind = Cumulus { base, height, heaps, heap_radius, peak, wisps, crowns: 1, lean: 0.4, decay: 0.45 };
        cumulus(sketch, name, category, &kind)
    };
    let models: Vec<ModelId> = kinds.map(model).into();
    for i in 0..34_u32 {
        let share = |step: f64| (0.5 + f64::from(i + 1) * step).fract() - 0.5;
        let (east, south) = (share(0.754_877_666) * FIELD_M, share(0.569_840_291) * FIELD_M - 1800.0);
        let position = DVec3::new(east, 1150.0 + sketch.roll(-60.0, 60.0), south);
        let scale = sketch.roll(0.9, 1.4);
        let kind = [0, 2, 1, 2, 0, 1][(i % 6) as usize];
        let heading = sketch.roll(-25.0, 25.0) + if sketch.roll(0.0, 1.0) < 0.5 { 0.0 } else { 180.0 };
        sketch.place(
            models[kind],
            &format!("{} {}", kinds[kind].0, i + 1),
            position,
            heading,
            scale,
            Some(u64::from(i) + 1),
        );
    }
}

fn air(sketch: &mut Sketch) {
    sketch.scene.weather = Weather {
        wind_from_deg: 280.0,
        wind_speed_mps: 40.0,
        wind_shear: 1.6,
        turbulence: 0.6,
        humidity: 0.8,
        lag_s: 5.0,
        lean: 0.8,
        turn_deg_per_km: 30.0,
        region: Some(Region {
            center_x_m: 0.0,
            center_z_m: -1800.0,
            width_m: FIELD_M,
            depth_m: FIELD_M,
            border_m: 1800.0,
        }),
        ..Weather::default()
    };
    let mut key = |property: &str, keys: &[(f64, f64)]| sketch.key(property, Leaves::Smooth, Beyond::Repeat, keys);
    let gusts = [(0.0, 34.0), (7.0, 46.0), (14.0, 36.0), (24.0, 52.0), (32.0, 38.0), (GUSTS_S, 34.0)];
    key("weather/wind_speed_mps", &gusts);
    key("weather/humidity", &[(0.0, 0.8), (12.0, 0.6), (26.0, 0.9), (GUSTS_S, 0.8)]);
}
