//! Much more sky: `cargo bench -p cloudwright-tests --bench scale`.
//!
//! The deck of `overcast` once, 4 × 4 and 10 × 10 times, seen along its path `down` at 1280 × 720, with all sprites and by
//! automatic detail. Targets on an idle machine of two cores: ten times ten in twice the time of one, both by automatic
//! detail, and in a sixtieth of the time that all sprites take.

#![allow(clippy::print_stdout)] // A bench's answer is its table.

use cloudwright_core::derived::Derived;
use cloudwright_core::detail::Detail;
use cloudwright_core::draw;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_tests::laid_out;
use std::time::Instant;

const SIZE: [u32; 2] = [1280, 720];
/// Places along the path.
const PLACES: usize = 9;

fn main() {
    let asked: Vec<f32> = std::env::args().filter_map(|argument| argument.parse().ok()).collect();
    let tolerances = if asked.is_empty() { vec![Detail::AUTOMATIC.tolerance_px] } else { asked };
    println!(
        "tolerance, px; sprites; list, ms; frame, ms: median and worst; times faster; FLIP to all sprites: mean, worst"
    );
    for side in [1, 4, 10] {
        let scene = laid_out::overcasts(side);
        let start = Instant::now();
        let derived = Derived::new(&scene);
        derived.bake(&Watch::default());
        println!("{side} × {side}: {} clouds, placed and baked in {:.1?}", derived.clouds().len(), start.elapsed());
        let all = flown(&scene, &derived, 0.0);
        print(&all, &all, 0.0);
        for tolerance_px in &tolerances {
            print(&flown(&scene, &derived, *tolerance_px), &all, *tolerance_px);
        }
    }
}

/// What a flight was like.
struct Flown {
    /// In all frames.
    sprites: usize,
    lists_ms: Vec<f64>,
    frames_ms: Vec<f64>,
    pictures: Vec<Picture>,
}

fn flown(scene: &Scene, derived: &Derived, tolerance_px: f32) -> Flown {
    let rules = Rules { detail: Detail { tolerance_px, ..Detail::FULL }, ..Rules::SHIPPED };
    let curve = PathCurve::new(&scene.paths[0]);
    let mut flown = Flown { sprites: 0, lists_ms: Vec::new(), frames_ms: Vec::new(), pictures: Vec::new() };
    for place in 0..PLACES {
        let camera = curve.camera_at(curve.duration_s() * place as f64 / (PLACES - 1) as f64);
        let sight = Sight { rules, ..Sight::still(&camera, SIZE) };
        // What is kept from frame to frame is there from the second on.
        for is_second in [false, true] {
            let start = Instant::now();
            let frame = Frame::new(scene, derived, Atlas::built_in(), &sight);
            let list_ms = start.elapsed().as_secs_f64() * 1e3;
            let picture = draw::picture(&frame, &Watch::default()).expect("the CPU draws it");
            if is_second {
                flown.lists_ms.push(list_ms);
                flown.frames_ms.push(start.elapsed().as_secs_f64() * 1e3);
                flown.sprites += frame.list.sprites.len();
                flown.pictures.push(picture);
            }
        }
    }
    flown
}

fn print(flown: &Flown, all: &Flown, tolerance_px: f32) {
    let error = |(all, picture)| flip(all, picture, PIXELS_PER_DEGREE).expect("of one size").mean();
    let errors: Vec<f64> = all.pictures.iter().zip(&flown.pictures).map(error).collect();
    println!(
        "  {tolerance_px:4}; {:7}; {:5.1}; {:5.1} {:5.1}; {:5.2}; {:.4} {:.4}",
        flown.sprites / PLACES,
        median(&flown.lists_ms),
        median(&flown.frames_ms),
        worst(&flown.frames_ms),
        median(&all.frames_ms) / median(&flown.frames_ms),
        errors.iter().sum::<f64>() / errors.len() as f64,
        worst(&errors),
    );
}

fn worst(values: &[f64]) -> f64 {
    values.iter().copied().fold(0.0, f64::max)
}

fn median(values: &[f64]) -> f64 {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    sorted[sorted.len() / 2]
}
