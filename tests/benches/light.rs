//! Light that is baked: `cargo bench -p cloudwright-tests --bench light`.
//!
//! Targets on an idle machine of two cores: `overcast` baked in 2 s, one edited box of the largest shipped model in 60 ms, a
//! picture with self-shadow within 1.03 times one without. The table says what the number of directions costs and errs: the
//! default is the last of which a sprite's words stay within 64 bytes.

#![allow(clippy::print_stdout)] // A bench's answer is its table.

use cloudwright_core::baked::{Baked, Ball, DIRECTIONS, DRAWN, Directions, FALLOFF, optical_depth};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::frame::Frame;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::raster::fast;
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::{Atlas, balls_of};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{Moment, SceneNow, WeatherRules};
use cloudwright_tests::authoring;
use glam::Vec3;
use std::hint::black_box;
use std::time::{Duration, Instant};

fn scene(name: &str) -> Scene {
    let (_, make) = authoring::SCENES.iter().find(|(each, _)| *each == name).expect("it ships");
    make()
}

fn took<T>(work: impl FnOnce() -> T) -> Duration {
    let start = Instant::now();
    black_box(work());
    start.elapsed()
}

fn main() {
    bakes();
    directions();
    frames();
    shadows();
}

fn placed(scene: &Scene) -> Derived {
    Derived::default().plan(scene, &Change::everything()).place(&Watch::default()).expect("not cancelled")
}

fn bakes() {
    for name in ["single_cumulus", "cumulonimbus_dusk", "overcast"] {
        let derived = placed(&scene(name));
        let sprites: usize = derived.clouds().iter().map(|cloud| cloud.sprites.len()).sum();
        println!("{name}: {sprites} sprites placed, baked in {:.0?}", took(|| derived.bake(&Watch::default())));
    }
    let mut edited = scene("cumulonimbus_dusk");
    let before = placed(&edited);
    before.bake(&Watch::default());
    edited.models[0].boxes[0].center.x += 20.0;
    let after = before.plan(&edited, &Change::everything()).place(&Watch::default()).expect("not cancelled");
    println!("one box of the cumulonimbus: {:.0?}", took(|| after.bake(&Watch::default())));
}

/// Light at corners that face an eye at random, lit from random suns, against the balls summed for each corner.
fn directions() {
    let scene = scene("single_cumulus");
    let (model, derived) = (&scene.models[0], Derived::new(&scene));
    let populated = derived.populated(model.id, model.seed).expect("a cloud shows it");
    let balls = balls_of(&populated.sprites, &model.color_levels);
    let shown = |left: f32| 0.85 * left + 0.25 * left.powi(8);
    println!(
        "directions: of a sphere, baked; bytes a sprite; error of the light let through, mean and 95 of 100; time"
    );
    for parts in [1, 2, 3, 4, 6] {
        let directions = Directions::parted(parts);
        let start = Instant::now();
        let baked = Baked::new(&balls, directions, &Watch::default());
        let time = start.elapsed();
        let mut errors: Vec<f32> = Vec::new();
        for (number, ball) in balls.iter().enumerate() {
            for look in 0..12 {
                let (sun, corner) = (towards(number as u32, look, 0.0), corner(ball, number as u32, look));
                let left = (-FALLOFF * optical_depth(&balls, ball.center + corner * DRAWN, sun)).exp();
                let reach = ball.half().x.hypot(ball.half().y);
                let got = baked.from(number, &directions.around(sun)).at(corner / reach);
                errors.push((shown(got) - shown(left)).abs());
            }
        }
        errors.sort_by(f32::total_cmp);
        let (mean, high) = (errors.iter().sum::<f32>() / errors.len() as f32, errors[errors.len() * 95 / 100]);
        let default = if directions == DIRECTIONS { " (ships)" } else { "" };
        println!(
            "  {:3} {:3}; {:3}; {mean:.4} {high:.4}; {time:.0?}{default}",
            4 * parts * parts + 2,
            directions.count(),
            4 * (directions.count() + 1),
        );
    }
}

fn towards(sprite: u32, look: u32, lowest: f64) -> Vec3 {
    let [up, turn, ..] = draw(5, u64::from(sprite), look, 0).map(unit);
    let (y, turn) = (lowest + (1.0 - lowest) * up, turn * std::f64::consts::TAU);
    let level = (1.0 - y * y).sqrt();
    Vec3::new((level * turn.cos()) as f32, y as f32, (level * turn.sin()) as f32)
}

/// A corner of a square that is as large as the ball, turned before an eye somewhere.
fn corner(ball: &Ball, sprite: u32, look: u32) -> Vec3 {
    let (right, above) = towards(sprite, look + 100, -1.0).any_orthonormal_pair();
    (right * ball.half().x + above * ball.half().y) * if look.is_multiple_of(2) { 1.0 } else { -1.0 }
}

fn frames() {
    let atlas = Atlas::built_in();
    for name in ["single_cumulus", "overcast"] {
        let lit = scene(name);
        let mut plain = lit.clone();
        plain.models.iter_mut().for_each(|model| (model.self_shadow, model.halo) = (0.0, 0.0));
        let scenes = [plain, lit].map(|scene| (Derived::new(&scene), scene));
        let mut times = [Vec::new(), Vec::new()];
        for _ in 0..15 {
            for ((derived, scene), times) in scenes.iter().zip(&mut times) {
                let sight = Sight::still(&scene.cameras[0], [1280, 720]);
                times.push(took(|| fast::picture(&Frame::new(scene, derived, atlas, &sight))));
            }
        }
        let [without, with] = times.map(|mut times| {
            times.sort_unstable();
            times[times.len() / 2]
        });
        let ratio = with.as_secs_f64() / without.as_secs_f64();
        println!("{name}, 1280 x 720: {without:.1?} by groups, {with:.1?} with self-shadow, {ratio:.3} times");
    }
}

/// What shadows cost a frame that moves: between clouds, and on the ground by the CPU's map; and a whole picture with them,
/// in times of one without.
fn shadows() {
    for name in ["fair_weather", "cumulonimbus_dusk", "overcast", "summer_day"] {
        let mut scene = scene(name);
        let derived = Derived::new(&scene);
        let moment = Moment { clock_s: 0.0, time_h: Some(16.0) };
        let mut least = |share: f64| {
            scene.sky.cloud_shadows = share;
            let of = || SceneNow::new(&scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
            let moments = (0..15).map(|_| took(of)).min().unwrap_or_default();
            let now = of();
            let maps = (0..15).map(|_| took(|| now.shadow_map())).min().unwrap_or_default();
            let sight = Sight { moment, ..Sight::still(&scene.cameras[0], [960, 540]) };
            let frame = || fast::picture(&Frame::new(&scene, &derived, Atlas::built_in(), &sight));
            [moments, maps, (0..5).map(|_| took(frame)).min().unwrap_or_default()]
        };
        let ([without, _, plain], [with, map, shadowed]) = (least(0.0), least(1.0));
        println!(
            "{name}: shadows between clouds {:.2?}, the ground's map {map:.2?}; a picture {:.2} times",
            with.saturating_sub(without),
            shadowed.as_secs_f64() / plain.as_secs_f64()
        );
    }
}
