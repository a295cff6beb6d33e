//! The path tracer against closed forms: nothing, single scattering, a white furnace, Beer's law; and on any threads.

use cloudwright_core::camera::View;
use cloudwright_core::density::DensityGrid;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::scene::Camera;
use cloudwright_core::traced::{FORWARD, Medium, Surroundings, Traced, trace};
use cloudwright_core::watch::Watch;
use glam::{DVec3, UVec3, Vec3};
use std::f64::consts::PI;

/// Looks north and level from there.
fn view(position: DVec3, field_of_view_deg: f64, side: u32) -> View {
    View::new(&Camera { field_of_view_deg, ..Camera::free(position) }, side, side)
}

fn traced(grid: &DensityGrid, view: &View, around: &Surroundings, samples: u32) -> Traced {
    trace(&Medium::new(grid), view, around, samples, &Watch::default())
}

/// A lumpy ball, some optical depths thick, in a box of 16³ voxels of 10 m about (0, 0, −300).
fn lumpy_ball(thick: f32) -> DensityGrid {
    let mut grid = DensityGrid::clear(UVec3::splat(16), 10.0, DVec3::new(-80.0, -80.0, -380.0));
    for index in 0..16_u32.pow(3) {
        let place = Vec3::new((index % 16) as f32, (index / 16 % 16) as f32, (index / 256) as f32) - 7.5;
        if place.length() < 7.0 {
            grid.extinction[index as usize] = thick / 140.0 * 2.0 * unit(draw(9, 0, index, 0)[0]) as f32;
        }
    }
    grid
}

fn mean(values: &[f32]) -> f64 {
    values.iter().map(|value| f64::from(*value)).sum::<f64>() / values.len() as f64
}

#[test]
fn what_is_clear_shows_nothing() {
    let grid = DensityGrid::clear(UVec3::splat(4), 10.0, DVec3::new(-20.0, -20.0, -100.0));
    let around = Surroundings { above: 1.0, below: 1.0, suns: vec![Vec3::Y] };
    let Traced { alpha, sky, suns, .. } = traced(&grid, &view(DVec3::ZERO, 40.0, 8), &around, 4);
    assert!(alpha.iter().chain(&sky).chain(&suns[0]).all(|value| *value == 0.0));
}

/// What hides is e^(−τ), whatever is sampled: a wall of even extinction, seen straight on.
#[test]
fn opacity_is_that_of_the_depth() {
    for depth in [0.1_f32, 1.0, 5.0] {
        let mut grid = DensityGrid::clear(UVec3::new(8, 8, 4), 10.0, DVec3::new(-40.0, -40.0, -1040.0));
        grid.extinction.fill(depth / 40.0);
        let around = Surroundings { above: 0.0, below: 0.0, suns: Vec::new() };
        let Traced { alpha, .. } = traced(&grid, &view(DVec3::ZERO, 2.0, 4), &around, 2);
        for got in alpha {
            // Lines through the corners are longer by less than a thousandth.
            assert!((got - (1.0 - (-depth).exp())).abs() < 2e-3, "{depth}: {got}");
        }
    }
}

/// A cloud that absorbs nothing, amid light that is the same from everywhere, is as bright as that: where it shows at all
/// it can't be seen. This holds path by path, so there is no noise to allow for.
#[test]
fn a_white_furnace_is_white() {
    for thick in [1.0, 30.0] {
        let around = Surroundings { above: 1.0, below: 1.0, suns: Vec::new() };
        let Traced { alpha, sky, .. } = traced(&lumpy_ball(thick), &view(DVec3::ZERO, 40.0, 12), &around, 16);
        assert!(alpha.iter().any(|alpha| *alpha > 0.3 && *alpha <= 1.0));
        for (sky, alpha) in sky.iter().zip(&alpha) {
            assert!((sky - alpha).abs() < 1e-5, "{sky} of {alpha}");
        }
    }
}

/// Light from above and below alone sum to the light of both; the ball's upper half takes more of the upper.
#[test]
fn the_sky_is_above_and_the_ground_below() {
    let grid = lumpy_ball(30.0);
    let of = |above, below| {
        let around = Surroundings { above, below, suns: Vec::new() };
        traced(&grid, &view(DVec3::ZERO, 30.0, 12), &around, 32)
    };
    let [upper, lower, both] = [of(1.0, 0.0), of(0.0, 0.5), of(1.0, 0.5)];
    for at in 0..both.sky.len() {
        assert!((upper.sky[at] + lower.sky[at] - both.sky[at]).abs() < 1e-5);
    }
    let (top, bottom) = upper.sky.split_at(upper.sky.len() / 2);
    assert!(mean(top) > 1.5 * mean(bottom), "{} above, {} below", mean(top), mean(bottom));
}

/// A level layer of little depth, seen from below, sends what scatters once: with μ and μ₀ the cosines of eye and sun from
/// the vertical, E p(θ) μ₀ / (μ₀ ± μ) times what both ways leave (Chandrasekhar, *Radiative Transfer*, § 17). What scatters
/// twice adds less than a share τ/μ + τ/μ₀ of that.
#[test]
fn a_thin_layer_shows_what_scatters_once() {
    const DEPTH: f64 = 0.02;
    // So wide that its ends are out of reach.
    let mut grid = DensityGrid::clear(UVec3::new(400, 1, 400), 50.0, DVec3::new(-10_000.0, 1000.0, -10_000.0));
    grid.extinction.fill((DEPTH / 50.0) as f32);
    let camera = Camera { pitch_deg: 60.0, field_of_view_deg: 1.0, ..Camera::free(DVec3::ZERO) };
    let view = View::new(&camera, 4, 4);
    for (sun, reflects) in [
        (Vec3::new(0.0, 0.6, -0.8), false),
        (Vec3::new(0.6, 0.8, 0.0), false),
        (Vec3::new(0.0, -0.8, 0.6), true),
        (Vec3::new(0.48, -0.6, -0.64), true),
    ] {
        let around = Surroundings { above: 0.0, below: 0.0, suns: vec![sun] };
        let got = mean(&traced(&grid, &view, &around, 512).suns[0]);
        let (eye, light) = (f64::from(view.forward.y), f64::from(sun.y.abs()));
        let cos = f64::from(view.forward.dot(sun));
        let spread = 1.0 + FORWARD * FORWARD - 2.0 * FORWARD * cos;
        let phase = (1.0 - FORWARD * FORWARD) / (4.0 * PI * spread * spread.sqrt());
        let left = if reflects {
            light / (light + eye) * (1.0 - (-DEPTH * (1.0 / eye + 1.0 / light)).exp())
        } else {
            light / (light - eye) * ((-DEPTH / light).exp() - (-DEPTH / eye).exp())
        };
        let once = PI * phase * left;
        let twice = once * DEPTH * (1.0 / eye + 1.0 / light);
        // Many angles forward of the sun's may turn light better in two steps than in one.
        assert!(got > 0.98 * once && got < 1.02 * once + 3.0 * twice, "sun {sun}: {got}, once {once}");
    }
}

#[test]
fn the_same_on_any_threads_and_stopped_when_cancelled() {
    let (grid, view) = (lumpy_ball(10.0), view(DVec3::ZERO, 40.0, 8));
    let around = Surroundings { above: 1.0, below: 0.2, suns: vec![Vec3::Y, Vec3::X] };
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| traced(&grid, &view, &around, 8))
    };
    let [one, many] = [1, 5].map(on);
    assert_eq!(one, many);
    let watch = Watch::default();
    watch.cancel();
    let Traced { alpha, .. } = trace(&Medium::new(&grid), &view, &around, 8, &watch);
    assert!(alpha.iter().all(|alpha| *alpha == 0.0));
}
