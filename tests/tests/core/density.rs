//! Clouds as grids of extinction: as opaque along chords as the sprites are.

use cloudwright_core::density::chord::{self, Chord};
use cloudwright_core::density::{Density, DensityError, Fineness, Vapour};
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{CloudNow, Light, WeatherRules};
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::{DVec3, Vec3};

/// What `of` says of so many clouds of a scene, as one body.
fn with<R>(scene: &Scene, clouds: std::ops::Range<usize>, of: impl FnOnce(&Vapour<'_>) -> R) -> R {
    let derived = Derived::new(scene);
    let all = derived.clouds_at(0.0, WeatherRules::default());
    let clouds: Vec<&CloudNow<'_>> = all[clouds].iter().collect();
    let light = Light::at(scene, scene.time_of_day_h);
    of(&Vapour { clouds: &clouds, atlas: Atlas::built_in(), light: &light })
}

fn density(scene: &Scene, fineness: Fineness) -> Result<Density, DensityError> {
    with(scene, 0..1, |vapour| vapour.density(fineness, &Watch::default()))
}

fn shipped(name: &str) -> Scene {
    scene_file::read(&std::fs::read(cloudwright_tests::scene_path(name)).expect("it ships")).expect("sound")
}

/// A twentieth of the light, for half of the chords: what a path tracer's own noise hides. The mean says that it is not
/// the outline's clear places alone.
#[test]
fn chords_are_as_opaque_as_the_sprites() {
    for name in ["single_cumulus", "cumulonimbus_dusk", "fair_weather", "overcast", "altocumulus", "morning_stratus"] {
        let Density { factor, error, .. } = density(&shipped(name), Fineness::Longest(96)).expect("a grid");
        assert!(error.median <= 0.05 && error.mean <= 0.12, "{name}: {error:?}");
        assert!((0.7..1.3).contains(&factor), "{name}: what sprites let through is known, not fitted: {factor}");
    }
}

/// Opacity of a sprite that is alone is its tile's; and chords are even over its sphere's outline, in all directions.
#[test]
fn chords_are_even_over_the_outline() {
    let chords: Vec<Chord> =
        with(&single_sprites(&[(DVec3::ZERO, 200.0)]), 0..1, |vapour| chord::through(vapour, &Watch::default()));
    assert_eq!(chords.len(), chord::CHORDS);
    let mut mean = Vec3::ZERO;
    let mut within_half = 0;
    for Chord { through, direction, opacity } in &chords {
        assert!((0.0..=1.0).contains(opacity) && (direction.length() - 1.0).abs() < 1e-5);
        mean += *direction;
        let away = through.cross(*direction).length();
        within_half += usize::from(away < 0.5 * 0.5 * 200.0 * std::f32::consts::SQRT_2);
    }
    assert!((mean / chords.len() as f32).length() < 0.06, "{mean}");
    // A quarter of a disc is within half its radius: 250 of 1,000, within three of their deviations.
    assert!((209..291).contains(&within_half), "{within_half}");
}

/// What balls hold does not hang on the voxels, be they larger than the balls.
#[test]
fn coarse_voxels_hold_what_fine_ones_do() {
    let whole = |voxel_m: f32| {
        let Density { grid, factor, .. } = density(&heap(12), Fineness::VoxelM(voxel_m)).expect("a grid");
        let sum: f64 = grid.extinction.iter().map(|value| f64::from(*value / factor)).sum();
        sum * f64::from(voxel_m).powi(3)
    };
    let fine = whole(6.0);
    for voxel_m in [10.0, 25.0, 80.0, 700.0] {
        let coarse = whole(voxel_m);
        assert!((coarse / fine - 1.0).abs() < 1e-3, "{voxel_m} m: {coarse} for {fine}");
    }
}

#[test]
fn a_grid_stands_where_its_cloud_does() {
    let place = DVec3::new(2.0e6, 1500.0, -3.0e6);
    let scene = single_sprites(&[(place, 400.0)]);
    let Density { grid, .. } = density(&scene, Fineness::Longest(64)).expect("a grid");
    let middle = grid.corner + grid.size.as_dvec3() * f64::from(grid.voxel_m) * 0.5;
    // A cloud's origin is held in whole f32.
    assert!(middle.distance(place) < f64::from(grid.voxel_m), "{middle}");
    assert_eq!(grid.size.max_element(), 64);
    // It is dense within its quad, and no longer at the quad's corners.
    let at = |away_m: f32| grid.at(grid.size.as_vec3() * grid.voxel_m * 0.5 + Vec3::X * away_m);
    let densest = (0..20).map(|step| at(10.0 * step as f32)).fold(0.0, f32::max);
    assert!(densest > 1e-3 && at(260.0) < 0.01 * densest, "{densest} {}", at(260.0));
}

/// Clouds that are one body hold what they hold one by one.
#[test]
fn clouds_together_hold_what_each_does() {
    let scene = shipped("fair_weather");
    let whole = |clouds: std::ops::Range<usize>| {
        let made = with(&scene, clouds, |vapour| vapour.density(Fineness::VoxelM(40.0), &Watch::default()));
        let Density { grid, factor, .. } = made.expect("a grid");
        grid.extinction.iter().map(|value| f64::from(*value / factor)).sum::<f64>()
    };
    let (alone, together) = (whole(0..1) + whole(1..2), whole(0..2));
    assert!((together / alone - 1.0).abs() < 1e-3, "{together} for {alone}");
}

#[test]
fn any_number_of_threads_makes_the_same_grid() {
    let made = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| density(&heap(40), Fineness::Longest(48)).expect("a grid"))
    };
    let one = made(1);
    for threads in [2, 5] {
        assert!(one == made(threads), "{threads} threads");
    }
}

#[test]
fn what_can_be_no_grid_says_so() {
    assert_eq!(density(&heap(0), Fineness::Longest(8)).expect_err("no sprites"), DensityError::Nothing);
    let error = density(&heap(5), Fineness::VoxelM(0.01)).expect_err("too fine");
    assert!(matches!(error, DensityError::TooFine(voxels) if voxels > 1 << 27), "{error}");
    for side in [0.0, -1.0, f32::NAN] {
        assert!(density(&heap(5), Fineness::VoxelM(side)).is_err(), "{side}");
    }
    let watch = Watch::default();
    watch.cancel();
    let stopped = with(&heap(5), 0..1, |vapour| vapour.density(Fineness::Longest(32), &watch));
    assert_eq!(stopped, Err(DensityError::Cancelled));
}

/// 256 voxels along the longest side within 3 s: `cargo test --test core density -- --ignored`, alone.
#[test]
#[ignore = "a figure of the machine, alone on it"]
fn a_large_grid_takes_no_three_seconds() {
    for name in ["single_cumulus", "cumulonimbus_dusk"] {
        let scene = shipped(name);
        let start = std::time::Instant::now();
        let Density { grid, .. } = density(&scene, Fineness::Longest(256)).expect("a grid");
        let seconds = start.elapsed().as_secs_f64();
        assert!(seconds < 3.0, "{name}: {} voxels in {seconds:.1} s", grid.size);
    }
}
