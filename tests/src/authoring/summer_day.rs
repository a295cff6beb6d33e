//! A summer's day in a minute: a clear dawn, heaps that come up in the morning, tower after noon, drift, and part into
//! rags at dusk; and so again.
//!
//! The hour is keyed from six in the morning to six in the next. Every cloud forms at an hour of its own; where the base
//! stands, how the heads tower and how all dries at dusk are keys of the air.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use cloudwright_core::scene::{Beyond, Category, Leaves, ModelId, Region, Scene, Weather};
use glam::DVec3;

/// At second 0.
const DAWN_H: f64 = 6.0;
const DAY_S: f64 = 60.0;
/// The side of the sky in which clouds stay.
const FIELD_M: f64 = 17_000.0;

/// Hours and the seconds at which they are: the night, in which there is little to see, goes by quickly.
const HOURS: [(f64, f64); 4] = [(0.0, DAWN_H), (50.0, 22.0), (55.0, 28.0), (DAY_S, DAWN_H + 24.0)];

/// Seconds of the clock at which an hour is.
fn at(hour: f64) -> f64 {
    let after = HOURS.iter().position(|(_, each)| *each >= hour).unwrap_or(HOURS.len() - 1).max(1);
    let [(from_s, from), (to_s, to)] = [HOURS[after - 1], HOURS[after]];
    from_s + (to_s - from_s) * (hour - from) / (to - from)
}

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("A summer's day", 57);
    let models = models(&mut sketch);
    strew(&mut sketch, &models);
    sky(&mut sketch);
    air(&mut sketch);
    sketch.camera("main", DVec3::new(-200.0, 420.0, 3900.0), DVec3::new(300.0, 1650.0, -1500.0), 56.0);
    sketch.camera("sunset", DVec3::new(2600.0, 700.0, 2600.0), DVec3::new(-3800.0, 1500.0, 600.0), 55.0);
    sketch.camera("above", DVec3::new(-3000.0, 3600.0, 5200.0), DVec3::new(500.0, 1300.0, -1500.0), 50.0);
    sketch.scene
}

fn models(sketch: &mut Sketch) -> Vec<ModelId> {
    let kinds = [
        ("humilis", Category::CumulusHumilis, [340.0, 260.0], 250.0, 6, [85.0, 140.0], 0.45, 2),
        ("broad humilis", Category::CumulusHumilis, [580.0, 340.0], 290.0, 10, [85.0, 165.0], 0.42, 3),
        ("mediocris", Category::CumulusCongestus, [520.0, 420.0], 560.0, 9, [115.0, 215.0], 0.62, 2),
        ("congestus", Category::CumulusCongestus, [640.0, 500.0], 960.0, 11, [145.0, 255.0], 0.72, 2),
    ];
    let model = |(name, category, base, height, heaps, heap_radius, peak, wisps): (_, _, _, _, _, _, _, _)| {
        let crowns = if height > 400.0 { 2 } else { 1 };
        let kind = Cumulus { base, height, heaps, heap_radius, peak, wisps, crowns, ..Cumulus::default() };
        cumulus(sketch, name, category, &kind)
    };
    kinds.map(model).into()
}

/// Clouds all over the field, each with its hour.
fn strew(sketch: &mut Sketch, models: &[ModelId]) {
    for cloud in 0..62_u32 {
        // Two steps that fill a square evenly, and in no rows (Roberts's sequence by the plastic number).
        let share = |step: f64| (0.5 + f64::from(cloud + 1) * step).fract() - 0.5;
        let (east, south) = (share(0.754_877_666) * FIELD_M, share(0.569_840_291) * FIELD_M - 1500.0);
        let kind = match sketch.roll(0.0, 1.0) {
            roll if roll < 0.28 => 0,
            roll if roll < 0.56 => 1,
            roll if roll < 0.82 => 2,
            _ => 3,
        };
        let (scale, heading) = (sketch.roll(1.1, 1.75), sketch.roll(0.0, 360.0));
        let position = DVec3::new(east, 1300.0 + sketch.roll(-30.0, 30.0), south);
        let name = format!("heap {}", cloud + 1);
        sketch.place(models[kind], &name, position, heading, scale, Some(u64::from(cloud) + 1));
        let comes = sketch.roll(7.4, 11.0);
        let grows_h = sketch.roll(0.7, 1.2);
        let goes = sketch.roll(19.4, 21.2);
        let (core, edges) = (comes + grows_h, comes + 2.2 * grows_h);
        // The core comes first and goes last.
        sketch.key_cloud("formed/core", &[(comes, 0.0), (core, 1.0), (goes, 1.0), (goes + 1.2, 0.0)].map(by_hour));
        let edges_go = goes - 0.6;
        sketch.key_cloud("formed/edges", &[(core, 0.0), (edges, 1.0), (edges_go, 1.0), (goes, 0.0)].map(by_hour));
    }
}

fn by_hour((hour, value): (f64, f64)) -> (f64, f64) {
    ((at(hour) * 100.0).round() / 100.0, value)
}

fn sky(sketch: &mut Sketch) {
    sketch.scene.time_of_day_h = DAWN_H;
    sketch.scene.sky.turbidity = 2.4;
    sketch.key("time_of_day_h", Leaves::Linear, Beyond::Repeat, &HOURS);
    // Mist at dawn, and haze again towards the evening.
    let haze =
        [(6.0, 13_000.0), (10.0, 30_000.0), (15.0, 42_000.0), (20.5, 26_000.0), (28.0, 15_000.0), (30.0, 13_000.0)];
    sketch.key("sky/haze_length_m", Leaves::Smooth, Beyond::Repeat, &haze.map(by_hour));
    // An eye gets used to the dark.
    let exposure = [(6.0, 0.35), (7.0, 0.1), (9.0, 0.0), (19.0, 0.0), (21.5, 0.9), (28.0, 0.9), (30.0, 0.35)];
    sketch.key("sky/exposure_ev", Leaves::Smooth, Beyond::Repeat, &exposure.map(by_hour));
}

fn air(sketch: &mut Sketch) {
    sketch.scene.weather = Weather {
        wind_from_deg: 245.0,
        wind_speed_mps: 30.0,
        wind_shear: 0.8,
        turbulence: 0.35,
        temperature_c: 20.0,
        dew_point_c: 10.0,
        lean: 0.22,
        lag_s: 4.0,
        region: Some(Region {
            center_x_m: 0.0,
            center_z_m: -1500.0,
            width_m: FIELD_M,
            depth_m: FIELD_M,
            border_m: 2500.0,
        }),
        ..Weather::default()
    };
    let warmth = [(6.0, 14.6), (11.0, 20.0), (15.0, 23.0), (20.0, 19.0), (28.0, 15.0), (29.0, 14.5), (30.0, 14.6)];
    sketch.key("weather/temperature_c", Leaves::Smooth, Beyond::Repeat, &warmth.map(by_hour));
    let growth = [(6.0, 0.55), (8.0, 0.55), (12.0, 1.0), (15.5, 1.25), (19.0, 0.75), (21.0, 0.55), (30.0, 0.55)];
    sketch.key("weather/growth", Leaves::Smooth, Beyond::Repeat, &growth.map(by_hour));
    let humidity = [(6.0, 0.38), (9.0, 0.5), (12.0, 1.0), (17.5, 1.0), (21.3, 0.05), (30.0, 0.38)];
    sketch.key("weather/humidity", Leaves::Smooth, Beyond::Repeat, &humidity.map(by_hour));
}
