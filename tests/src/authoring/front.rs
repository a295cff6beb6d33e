//! A front passes in a minute and a half: high veils thicken, a grey deck comes up from the west and darkens, the wind
//! veers in a gust, and behind it the sky is washed clean and heaps come up.
//!
//! Veil, deck and heaps form and go as the front reaches them; what they look like under one another, the haze and the
//! light, are keys of the models and of the sky.

use super::Sketch;
use super::cumulus::{Cumulus, cumulus};
use super::look::levels;
use super::sketch::Strew;
use cloudwright_core::scene::{Beyond, Category, KeyValue, Leaves, ModelId, Scene, Track, TrackId, TrackKey, Weather};
use glam::DVec3;

const END_S: f64 = 90.0;
/// When the deck's edge stands overhead, and when its rear does.
const ARRIVES_S: f64 = 26.0;
const LEAVES_S: f64 = 60.0;
/// How fast both go eastwards, metres for each second of the clock.
const SPEED_MPS: f64 = 750.0;

pub(super) fn scene() -> Scene {
    let mut sketch = Sketch::new("A front passes", 91);
    veils(&mut sketch);
    let deck = deck(&mut sketch);
    heaps(&mut sketch);
    darken(&mut sketch, &deck);
    sky(&mut sketch);
    wind(&mut sketch);
    sketch.camera("main", DVec3::new(1800.0, 350.0, 3600.0), DVec3::new(-1500.0, 1650.0, -1800.0), 58.0);
    sketch.camera("east", DVec3::new(-2500.0, 500.0, 2500.0), DVec3::new(3500.0, 1600.0, 300.0), 58.0);
    sketch.camera("above", DVec3::new(2500.0, 3300.0, 5200.0), DVec3::new(-800.0, 1500.0, -800.0), 52.0);
    sketch.scene
}

/// When what passes over the middle at `overhead_s` passes over `east` metres.
fn passes_s(overhead_s: f64, east: f64) -> f64 {
    ((overhead_s + east / SPEED_MPS) * 100.0).round() / 100.0
}

/// Thin sheets of large, nearly clear tiles, six kilometres up: the nearest to cirrostratus that sprites come.
fn veils(sketch: &mut Sketch) {
    let levels = levels([
        (0.0, 0.52, 0.55, 0.61, 0.10),
        (0.3, 0.55, 0.58, 0.63, 0.17),
        (0.5, 0.58, 0.60, 0.65, 0.20),
        (0.7, 0.60, 0.62, 0.66, 0.17),
        (1.0, 0.62, 0.64, 0.67, 0.10),
    ]);
    let mut model = sketch.model("veil", Category::Wisps, 1.0 / 6.0, levels);
    for band in 0..6 {
        let (south, east) = ((f64::from(band) - 2.5) * 620.0, sketch.roll(-500.0, 500.0));
        sketch.strew(
            &mut model,
            &format!("band {}", band + 1),
            Strew {
                center: DVec3::new(east, sketch.roll(-20.0, 20.0), south),
                size: DVec3::new(5200.0, 60.0, 480.0),
                count: 24,
                sprite: [700.0, 1500.0],
                squash: 0.45,
                category: Category::Wisps,
                light: [0.1, 0.3, 0.75],
                pull: 0.0,
                turn_deg: sketch.roll(-7.0, 7.0).round(),
                ..Strew::default()
            },
        );
    }
    let id = model.id;
    sketch.scene.models.push(model);
    for (i, [east, south]) in [
        [-7000.0, -4500.0],
        [-2000.0, -3000.0],
        [3500.0, -5200.0],
        [-4500.0, 800.0],
        [1500.0, 1500.0],
        [6500.0, -600.0],
    ]
    .into_iter()
    .enumerate()
    {
        let position = DVec3::new(east, 6000.0 + sketch.roll(-150.0, 150.0), south);
        let heading = sketch.roll(-12.0, 12.0);
        sketch.place(id, &format!("veil {}", i + 1), position, heading, 1.0, Some(i as u64 + 1));
        let comes = passes_s(ARRIVES_S - 20.0, east * 0.6).max(1.0);
        sketch.key_cloud("opacity", &[(comes, 0.0), (comes + 12.0, 1.0), (66.0, 1.0), (76.0, 0.0)]);
    }
}

/// Cells of a deck, in two kinds, over twelve kilometres.
fn deck(sketch: &mut Sketch) -> Vec<ModelId> {
    let models: Vec<ModelId> = (0..3)
        .map(|i| {
            let levels = levels([
                (0.0, 0.33, 0.37, 0.44, 0.80),
                (0.2, 0.37, 0.41, 0.48, 0.95),
                (0.45, 0.46, 0.50, 0.56, 1.0),
                (0.7, 0.55, 0.58, 0.62, 1.0),
                (1.0, 0.62, 0.64, 0.67, 0.9),
            ]);
            let mut model = sketch.model(&format!("deck {}", i + 1), Category::Nimbostratus, 1.0 / 6.5, levels);
            let layers = [
                ("base", 70.0, 60.0, 60, [420.0, 760.0], 0.5, Category::Nimbostratus, [0.0, 0.10, 0.36], [4, 1, 3]),
                ("folds", 20.0, 40.0, 34, [260.0, 480.0], 0.5, Category::Stratus, [0.0, 0.06, 0.30], [4, 1, 3]),
                ("body", 230.0, 160.0, 56, [360.0, 640.0], 0.7, Category::Stratocumulus, [0.0, 0.22, 0.9], [4, 1, 3]),
                ("heads", 360.0, 110.0, 34, [300.0, 560.0], 0.8, Category::CumulusHumilis, [0.0, 0.26, 1.0], [3, 1, 3]),
            ];
            for (name, up, thick, count, sprite, squash, category, light, lumps) in layers {
                let center = DVec3::new(sketch.roll(-90.0, 90.0), up, sketch.roll(-90.0, 90.0));
                let size = DVec3::new(1750.0, thick, 1350.0);
                let strew = Strew { center, size, count, sprite, squash, category, light, lumps, ..Strew::default() };
                sketch.strew(&mut model, name, Strew { pull: 0.2, ..strew });
            }
            let id = model.id;
            sketch.scene.models.push(model);
            id
        })
        .collect();
    for cell in 0..63_u32 {
        let (column, row) = (cell % 9, cell / 9);
        let east = (f64::from(column) - 4.0) * 1650.0 + sketch.roll(-180.0, 180.0) + f64::from(row % 2) * 500.0;
        let south = (f64::from(row) - 4.3) * 1500.0 + sketch.roll(-180.0, 180.0);
        let position = DVec3::new(east, 1450.0 + sketch.roll(-45.0, 45.0), south);
        let heading = sketch.roll(-14.0, 14.0) + if sketch.roll(0.0, 1.0) < 0.5 { 0.0 } else { 180.0 };
        let model = models[(cell as usize * 2 + row as usize) % models.len()];
        let scale = sketch.roll(0.95, 1.15);
        sketch.place(
            model,
            &format!("deck {}.{}", row + 1, column + 1),
            position,
            heading,
            scale,
            Some(u64::from(cell)),
        );
        let comes = passes_s(ARRIVES_S, east) + sketch.roll(-2.5, 2.5);
        let goes = passes_s(LEAVES_S, east) + sketch.roll(-2.0, 2.0);
        let keys = |up: [f64; 2], down: [f64; 2]| {
            [(up[0], 0.0), (up[1], 1.0), (down[0], 1.0), (down[1], 0.0)].map(|(time_s, value)| (round(time_s), value))
        };
        sketch.key_cloud("formed/core", &keys([comes, comes + 5.0], [goes, goes + 4.0]));
        sketch.key_cloud("formed/edges", &keys([comes + 2.5, comes + 8.0], [goes - 2.5, goes + 2.0]));
    }
    models
}

fn round(seconds: f64) -> f64 {
    (seconds * 100.0).round() / 100.0
}

/// The showers' heaps behind the front.
fn heaps(sketch: &mut Sketch) {
    let kinds = [
        Cumulus { base: [520.0, 400.0], height: 560.0, heaps: 9, heap_radius: [115.0, 210.0], peak: 0.6, wisps: 2 },
        Cumulus { base: [640.0, 480.0], height: 1000.0, heaps: 11, heap_radius: [140.0, 250.0], peak: 0.72, wisps: 2 },
    ];
    let models: Vec<ModelId> = kinds
        .iter()
        .zip(["heap", "tower"])
        .map(|(kind, name)| {
            let model = cumulus(sketch, name, Category::CumulusCongestus, kind);
            let id = model.id;
            sketch.scene.models.push(model);
            id
        })
        .collect();
    for i in 0..16_u32 {
        let share = |step: f64| (0.5 + f64::from(i + 1) * step).fract() - 0.5;
        let (east, south) = (share(0.754_877_666) * 13_000.0, share(0.569_840_291) * 11_000.0 - 2800.0);
        let position = DVec3::new(east, 1250.0 + sketch.roll(-30.0, 30.0), south);
        let (heading, scale) = (sketch.roll(0.0, 360.0), sketch.roll(1.0, 1.5));
        let model = models[usize::from(i % 3 == 0)];
        sketch.place(model, &format!("shower {}", i + 1), position, heading, scale, Some(u64::from(i) + 1));
        let comes = round(passes_s(LEAVES_S + 9.0, east).max(62.0) + sketch.roll(-1.0, 3.0));
        sketch.key_cloud("formed/core", &[(comes, 0.0), (round(comes + 5.0), 1.0)]);
        sketch.key_cloud("formed/edges", &[(round(comes + 2.5), 0.0), (round(comes + 8.0), 1.0)]);
        sketch.key_cloud("growth", &[(comes, 0.6), (END_S, 1.15)]);
    }
}

/// The deck's undersides under a full sky of it.
fn darken(sketch: &mut Sketch, deck: &[ModelId]) {
    let times = [ARRIVES_S - 4.0, ARRIVES_S + 10.0, LEAVES_S - 6.0, LEAVES_S + 6.0];
    for model in deck {
        for (level, bright, dark) in
            [(0, [0.33, 0.37, 0.44], [0.19, 0.225, 0.285]), (1, [0.37, 0.41, 0.48], [0.23, 0.265, 0.325])]
        {
            let colors = [bright, dark, dark, bright];
            let key = |(time_s, color)| TrackKey::new(time_s, KeyValue::Three(color));
            let keys = times.into_iter().zip(colors).map(key).collect();
            let id = TrackId::new(&mut sketch.scene.next_id);
            sketch.scene.tracks.push(Track::new(id, format!("model/{model}/color_levels/{level}/color"), keys));
        }
    }
}

fn sky(sketch: &mut Sketch) {
    sketch.scene.time_of_day_h = 10.0;
    let mut key = |property: &str, keys: &[(f64, f64)]| sketch.key(property, Leaves::Smooth, Beyond::Hold, keys);
    key("time_of_day_h", &[(0.0, 10.0), (END_S, 18.6)]);
    let under = [ARRIVES_S - 6.0, ARRIVES_S + 10.0, LEAVES_S - 4.0, LEAVES_S + 10.0];
    let through = |values: [f64; 4]| under.into_iter().zip(values).collect::<Vec<_>>();
    key("sky/haze_length_m", &through([30_000.0, 11_000.0, 10_000.0, 48_000.0]));
    key("sky/turbidity", &through([2.6, 6.0, 6.0, 2.0]));
    key("sky/gain", &through([1.0, 0.72, 0.72, 1.0]));
    key("sky/directional_tuning/scale", &through([1.0, 0.38, 0.38, 1.0]));
    key("sky/ambient_tuning/scale", &through([1.0, 0.9, 0.9, 1.0]));
}

fn wind(sketch: &mut Sketch) {
    sketch.scene.weather = Weather {
        wind_shear: 1.0,
        lean: 0.35,
        lag_s: 3.0,
        wind_from_deg: 200.0,
        wind_speed_mps: 12.0,
        ..Weather::default()
    };
    let mut key = |property: &str, keys: &[(f64, f64)]| sketch.key(property, Leaves::Smooth, Beyond::Hold, keys);
    key("weather/wind_from_deg", &[(0.0, 190.0), (LEAVES_S - 8.0, 225.0), (LEAVES_S + 4.0, 300.0), (END_S, 310.0)]);
    key("weather/wind_speed_mps", &[(0.0, 12.0), (LEAVES_S - 8.0, 18.0), (LEAVES_S, 34.0), (LEAVES_S + 12.0, 20.0)]);
    key("weather/turbulence", &[(0.0, 0.15), (LEAVES_S - 10.0, 0.3), (LEAVES_S, 1.0), (LEAVES_S + 14.0, 0.4)]);
}
