//! Light fitted to a path tracer's: it comes nearer, what is kept is kept, and it knows when there is nothing to do.

use cloudwright_core::document::Document;
use cloudwright_core::fit_light::{Choice, FitError, FittedLight, Free, fit_light, usual_hours};
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_tests::small_scenes::heap;

fn fitted(scene: &Scene, choice: &Choice) -> Result<FittedLight, FitError> {
    fit_light(scene, Atlas::built_in(), choice, &Watch::default())
}

/// Few samples and two suns: quick, and as good for a test.
fn quick(free: Free) -> Choice {
    Choice { free, hours: vec![9.0, 17.0], samples: 64, ..Choice::default() }
}

fn after(scene: &Scene, fitted: &FittedLight) -> Scene {
    let mut document = Document::new(scene.clone());
    document.edit("Fit light", fitted.edits.clone()).expect("edits of models that are there");
    document.scene().clone()
}

/// A heap whose light an artist has not seen to yet: dark where it stands in the sun, and dark in the sky's light too.
fn badly_lit() -> Scene {
    let mut scene = heap(60);
    for cloud_box in scene.models[0].boxes.iter_mut() {
        (cloud_box.light.c_min, cloud_box.light.c_med, cloud_box.light.c_max) = (0.9, 0.5, 0.1);
    }
    scene.models[0].color_levels.iter_mut().for_each(|level| level.color.rgb = level.color.rgb * 0.2);
    scene
}

#[test]
fn light_comes_nearer_and_a_second_time_finds_it_there() {
    let scene = badly_lit();
    let choice = quick(Free::ALL);
    let first = fitted(&scene, &choice).expect("there is a cloud by day");
    let [model] = &first.models[..] else { panic!("one model, not {}", first.models.len()) };
    assert!(model.after.error < 0.75 * model.before.error, "{model:?}");
    assert!(model.after.correlation > model.before.correlation + 0.3, "{model:?}");
    let again = fitted(&after(&scene, &first), &choice).expect("still there");
    let [again] = &again.models[..] else { panic!("one model") };
    // The same pictures, so all that is left to find is what thousandths and inertia took, and by how much the fitted light is
    // dimmer than what it was fitted to.
    assert!((again.before.error / model.after.error - 1.0).abs() < 0.1, "{again:?} after {model:?}");
    assert!(again.after.error > 0.95 * again.before.error, "{again:?}");
}

#[test]
fn what_is_kept_stays() {
    let scene = badly_lit();
    let none = Free { levels: false, shares: false, self_shadow: false };
    let was = &scene.models[0];
    for free in [Free { levels: true, ..none }, Free { shares: true, ..none }, Free { self_shadow: true, ..none }] {
        let fitted = fitted(&scene, &quick(free)).expect("there is a cloud by day");
        let [likeness] = &fitted.models[..] else { panic!("one model") };
        assert!(likeness.after.error < likeness.before.error, "each alone brings it nearer: {free:?}, {likeness:?}");
        let scene = after(&scene, &fitted);
        let is = &scene.models[0];
        assert_eq!(is.color_levels != was.color_levels, free.levels, "{free:?}");
        assert_eq!(is.self_shadow != was.self_shadow, free.self_shadow, "{free:?}");
        let shares = is.boxes.iter().zip(was.boxes.iter()).all(|(is, was)| is.light != was.light);
        assert_eq!(shares, free.shares, "{free:?}");
        for (is, was) in is.color_levels.iter().zip(&was.color_levels) {
            assert_eq!((is.height, is.color.a), (was.height, was.color.a), "heights and opacities are the artist's");
        }
        assert_eq!(is.halo, was.halo);
    }
}

#[test]
fn the_same_on_any_threads() {
    let scene = badly_lit();
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| fitted(&scene, &Choice { hours: vec![9.0], samples: 2, ..quick(Free::ALL) }))
    };
    let [one, many] = [1, 5].map(on);
    assert_eq!(one, many);
}

#[test]
fn refuses_what_makes_no_sense() {
    let scene = heap(20);
    let refused = |scene: &Scene, choice: &Choice| fitted(scene, choice).expect_err("it makes no sense");
    let kept = Free { levels: false, shares: false, self_shadow: false };
    assert_eq!(refused(&scene, &quick(kept)), FitError::NothingFree);
    assert_eq!(refused(&scene, &Choice { hours: vec![9.0, 1.0], ..quick(Free::ALL) }), FitError::SunIsDown(1.0));
    let mut bare = scene.clone();
    bare.clouds.clear();
    assert_eq!(refused(&bare, &quick(Free::ALL)), FitError::NoClouds);
    let mut empty = scene.clone();
    empty.models[0].boxes.clear();
    assert_eq!(refused(&empty, &quick(Free::ALL)), FitError::NoClouds);
    let watch = Watch::default();
    watch.cancel();
    assert_eq!(fit_light(&scene, Atlas::built_in(), &quick(Free::ALL), &watch), Err(FitError::Cancelled));
    let mut polar = scene;
    (polar.site.latitude_deg, polar.site.date.month) = (80.0, 12);
    assert_eq!(usual_hours(&polar), [0.0; 0]);
    assert_eq!(refused(&polar, &Choice::default()), FitError::NeverUp);
}

/// One sprite has no depth to shade itself by, and its light can be fitted all the same.
#[test]
fn a_cloud_of_one_sprite() {
    let mut scene = heap(1);
    scene.models[0].boxes = scene.models[0].boxes.iter().take(1).cloned().collect();
    let fitted = fitted(&scene, &quick(Free::ALL)).expect("it shows");
    assert!(fitted.models[0].after.error <= fitted.models[0].before.error);
    after(&scene, &fitted);
}
