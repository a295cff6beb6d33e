//! Light that is baked: against marches through the same balls, for any sun, turn, thread count and edit.

use cloudwright_core::baked::{Baked, Ball, DIRECTIONS, DRAWN, Directions, FALLOFF, MANY, PROBES, Ray, optical_depth};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::facing::Pose;
use cloudwright_core::posed_sprite::PosedSprite;
use cloudwright_core::scene::{Scene, Sun};
use cloudwright_core::sprites::balls_of;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{CloudNow, Light};
use cloudwright_tests::small_scenes::{crowd, heap};
use glam::Vec3;

/// A heap that shades itself, with a halo.
fn lit_heap(count: u32) -> Scene {
    let mut scene = heap(count);
    let model = &mut scene.models[0];
    (model.self_shadow, model.halo) = (0.8, 0.7);
    scene
}

fn balls(scene: &Scene) -> Vec<Ball> {
    let (model, derived) = (&scene.models[0], Derived::new(scene));
    let populated = derived.populated(model.id, model.seed).expect("a cloud shows it");
    balls_of(&populated.sprites, &model.color_levels)
}

/// With all of its light.
fn derived(scene: &Scene) -> Derived {
    let derived = Derived::new(scene);
    derived.bake(&Watch::default());
    derived
}

/// Summed in short steps, in f64.
fn marched(balls: &[Ball], point: Vec3, direction: Vec3) -> f64 {
    let ray = Ray::towards(direction);
    let of_ball = |ball: &Ball| {
        let begins = (ball.center - point).dot(direction) - ball.reach();
        let steps = 400;
        let step = 2.0 * ball.reach() / steps as f32;
        let at = |i: i32| begins + (i as f32 + 0.5) * step;
        let ahead = (0..steps).map(at).filter(|along| *along > 0.0);
        ahead.map(|along| f64::from(ball.extinction(point + direction * along, ray) * step)).sum::<f64>()
    };
    balls.iter().map(of_ball).sum()
}

fn all_lights(scene: &Scene) -> Vec<[f32; 3]> {
    let derived = derived(scene);
    let light = Light::at(scene, scene.time_of_day_h);
    lights(&derived, &light)
}

/// The colour at a corner of each sprite, seen from the west.
fn lights(derived: &Derived, light: &Light) -> Vec<[f32; 3]> {
    let each = |placed| {
        let cloud = CloudNow::at_rest(placed);
        let lit = |index: usize| {
            let posed = PosedSprite::new(&cloud, index, Pose::facing_eye(Vec3::NEG_X, Vec3::Y), light);
            posed.light_at(posed.corners(Vec3::ZERO)[1]).color().rgb.to_array()
        };
        (0..placed.sprites.len()).map(lit).collect::<Vec<_>>()
    };
    derived.clouds().iter().flat_map(each).collect()
}

/// Optical depths by the closed form are those of the march: 2 % at the median, 8 % of 95 in a hundred. (The march's own
/// steps leave more at rims; a fault of the form would be far larger.)
#[test]
fn depths_are_those_of_a_march() {
    let balls = balls(&heap(60));
    let mut errors: Vec<f64> = Vec::new();
    for ball in balls.iter().step_by(5) {
        for direction in DIRECTIONS.all().into_iter().chain([Vec3::NEG_Y]) {
            let marched = marched(&balls, ball.center, direction);
            let got = f64::from(optical_depth(&balls, ball.center, direction));
            errors.push((got - marched).abs() / marched.max(0.1));
        }
    }
    errors.sort_by(f64::total_cmp);
    let at = |share: f64| errors[(errors.len() as f64 * share) as usize];
    assert!(errors.len() > 200 && at(0.5) < 0.02 && at(0.95) < 0.08, "{} {} {}", errors.len(), at(0.5), at(0.95));
}

/// What is kept is the mean of four points and the change along the axes, within half a step of its bytes.
#[test]
fn what_is_baked_is_what_a_march_leaves() {
    let balls = balls(&heap(60));
    let baked = Baked::new(&balls, DIRECTIONS, &Watch::default());
    let left = |point, direction| (-f64::from(FALLOFF) * marched(&balls, point, direction)).exp();
    for (sprite, ball) in balls.iter().enumerate().step_by(7) {
        for (number, direction) in DIRECTIONS.all().into_iter().enumerate().step_by(3) {
            let around = DIRECTIONS.around(direction);
            let got = baked.from(sprite, &around);
            let half = ball.half();
            let reach = half.x.hypot(half.y);
            let probes = PROBES.map(|probe| left(ball.center + probe * half * DRAWN, direction));
            let off = (f64::from(got.middle) - probes.iter().sum::<f64>() / 4.0).abs();
            assert!(off < 0.5 / 255.0 + 2e-3, "sprite {sprite}, way {number}: off by {off}");
            for axis in 0..3 {
                let slope: f64 = PROBES.iter().zip(probes).map(|(probe, left)| f64::from(probe[axis]) * left).sum();
                let change = 0.75 * slope * f64::from(reach / half[axis]);
                let off = (f64::from(got.change[axis]) - change).abs();
                assert!(off < 0.5 / 127.0 + 2e-3, "sprite {sprite}, way {number}, axis {axis}: off by {off}");
            }
        }
    }
}

#[test]
fn the_same_bytes_on_any_number_of_threads() {
    let balls = balls(&heap(80));
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| Baked::new(&balls, DIRECTIONS, &Watch::default()))
    };
    assert_eq!(on(1), on(3));
}

/// A direction between those baked has no step: for a turn of the sun by ε, a light that all directions together bound by
/// the slope of their triangles.
#[test]
fn the_sun_turns_without_a_step() {
    let mut scene = lit_heap(40);
    let derived = derived(&scene);
    let mut light_at = |heading_deg: f64, elevation_deg: f64| {
        scene.sun = Sun::ByHand { heading_deg, elevation_deg };
        // The tables would go dark below the horizon.
        Light { directional_max: cloudwright_core::color::Rgb::grey(1.0), ..Light::at(&scene, 12.0) }
    };
    let step_deg = 0.05_f64;
    // Two directions are at least 35° apart, shares run from one to the other, a step of the light left is 1 at most, and
    // what is let through rises with it by SCATTERED + 8 STRAIGHT = 2.85 of Cmax, 1.2 at most here; the halo by 4 of .8; the
    // group's own g by 1 a radian.
    let slope = step_deg.to_radians() * (2.0 / 35.0_f64.to_radians() * (2.85 * 1.2 + 3.2) + 2.0);
    for (from, turn) in [((10.0, 89.0), [0.3, -1.0]), ((44.0, 3.0), [1.0, -0.4]), ((180.0, 20.0), [1.0, 0.2])] {
        let mut before: Option<Vec<[f32; 3]>> = None;
        for step in 0..240 {
            let angle = f64::from(step) * step_deg;
            let now = lights(&derived, &light_at(from.0 + angle * turn[0], from.1 + angle * turn[1]));
            let moved = before.iter().flatten().zip(&now).map(|(a, b)| (a[1] - b[1]).abs()).fold(0.0, f32::max);
            assert!(f64::from(moved) < slope, "{from:?}, step {step}: {moved} of {slope}");
            before = Some(now);
        }
    }
}

/// A cloud that is turned with its sun is lit the same.
#[test]
fn light_turns_with_the_cloud() {
    let lit = |heading_deg: f64| {
        let mut scene = lit_heap(40);
        scene.models[0].self_shadow = 1.0;
        scene.clouds[0].heading_deg = heading_deg;
        scene.sun = Sun::ByHand { heading_deg: 70.0 + heading_deg, elevation_deg: 25.0 };
        let (derived, light) = (derived(&scene), Light::at(&scene, 12.0));
        let turn = glam::Quat::from_rotation_y(-(heading_deg.to_radians() as f32));
        let cloud = CloudNow::at_rest(&derived.clouds()[0]);
        let each = |index: usize| {
            let posed = PosedSprite::new(&cloud, index, Pose::facing_eye(turn * Vec3::NEG_X, Vec3::Y), &light);
            posed.light_at(posed.corners(Vec3::ZERO)[2]).directional.g
        };
        (0..cloud.placed.sprites.len()).map(each).collect::<Vec<f32>>()
    };
    let at_rest = lit(0.0);
    for heading in [37.0, 90.0, 200.0] {
        for (index, (a, b)) in at_rest.iter().zip(lit(heading)).enumerate() {
            assert!((a - b).abs() < 1e-4, "turned by {heading}°, sprite {index}: {a} and {b}");
        }
    }
}

/// With neither self-shadow nor halo, nothing is baked and every colour is the groups' alone, to the bit.
#[test]
fn without_a_share_all_is_as_by_groups_alone() {
    let plain = heap(40);
    let mut scene = lit_heap(40);
    assert_ne!(all_lights(&plain), all_lights(&scene));
    (scene.models[0].self_shadow, scene.models[0].halo) = (0.0, 0.0);
    assert_eq!(all_lights(&plain), all_lights(&scene));
    assert!(derived(&scene).clouds().iter().all(|cloud| cloud.baked().is_none()));
}

#[test]
fn any_sun_lights_a_cloud_of_any_few_sprites() {
    for count in [0, 1, 2] {
        let mut scene = lit_heap(count);
        for (heading_deg, elevation_deg) in [(0.0, 90.0), (0.0, -90.0), (250.0, -20.0), (90.0, 0.0)] {
            scene.sun = Sun::ByHand { heading_deg, elevation_deg };
            let lights = all_lights(&scene);
            assert!(
                lights.iter().flatten().all(|c| c.is_finite() && *c >= 0.0),
                "{count}, {elevation_deg}°: {lights:?}"
            );
        }
    }
}

/// The side towards the sun is brighter than the one behind, through the whole cloud and not by groups.
#[test]
fn a_cloud_is_darker_behind() {
    let mut scene = lit_heap(120);
    scene.models[0].self_shadow = 1.0;
    scene.sun = Sun::ByHand { heading_deg: 90.0, elevation_deg: 5.0 };
    let (derived, light) = (derived(&scene), Light::at(&scene, 12.0));
    let placed = &derived.clouds()[0];
    let lights = lights(&derived, &light);
    let mean = |wanted: &dyn Fn(f32) -> bool| {
        let those: Vec<f32> =
            (0..lights.len()).filter(|at| wanted(placed.sprites[*at].position.x)).map(|at| lights[at][1]).collect();
        those.iter().sum::<f32>() / those.len() as f32
    };
    let (lit, behind) = (mean(&|x| x > 60.0), mean(&|x| x < -60.0));
    assert!(lit > 1.4 * behind, "{lit} against {behind}");
}

/// Until the light of edited sprites is baked, the others keep theirs; what is baked is found by all copies.
#[test]
fn an_edit_keeps_light_until_the_new_is_baked() {
    let mut scene = lit_heap(60);
    let before = derived(&scene);
    scene.models[0].boxes[0].center.x -= 30.0;
    let placed = before.plan(&scene, &Change::everything()).place(&Watch::default()).expect("not cancelled");
    assert!(placed.is_unbaked() && !before.is_unbaked());
    let copy = placed.clone();
    let old = copy.clouds()[0].baked().expect("that of before").clone();
    assert_eq!(old.sprites(), copy.clouds()[0].sprites.all().len());

    let cancelled = Watch::default();
    cancelled.cancel();
    assert!(!placed.bake(&cancelled) && placed.is_unbaked(), "a bake that is given up leaves nothing");
    assert!(placed.bake(&Watch::default()));
    assert!(!copy.is_unbaked());
    assert_ne!(*copy.clouds()[0].baked().expect("new"), old);
    assert_eq!(copy.clouds()[0].baked(), derived(&scene).clouds()[0].baked());

    // Neither another place nor another colour bakes anything; another opacity of a level does.
    scene.clouds[0].position.x += 500.0;
    scene.models[0].color_levels[2].color.rgb.r = 0.9;
    let moved = placed.plan(&scene, &Change::everything()).place(&Watch::default()).expect("not cancelled");
    assert!(!moved.is_unbaked());
    scene.models[0].color_levels[2].color.a = 0.3;
    assert!(moved.plan(&scene, &Change::everything()).place(&Watch::default()).expect("not cancelled").is_unbaked());
}

#[test]
fn placements_share_what_is_baked() {
    let mut scene = crowd(24);
    scene.models.iter_mut().for_each(|model| model.self_shadow = 0.5);
    scene.clouds.iter_mut().for_each(|cloud| cloud.seed = None);
    let derived = derived(&scene);
    let mut words: Vec<*const u32> =
        derived.clouds().iter().map(|cloud| cloud.baked().expect("lit by it").words().as_ptr()).collect();
    words.sort_unstable();
    words.dedup();
    assert_eq!(words.len(), scene.models.len());
}

/// Many sprites are baked for fewer directions and by some that stand for all; the light is near that of all.
#[test]
fn very_many_sprites_are_baked_in_bounds() {
    let few = balls(&heap(200));
    let times = MANY / few.len() + 1;
    // The same heap, each of its sprites as so many thin ones.
    let thin = |ball: &Ball| Ball { depth: ball.depth / times as f32, ..*ball };
    let many: Vec<Ball> = few.iter().flat_map(|ball| std::iter::repeat_n(thin(ball), times)).collect();
    let five = Directions::parted(1);
    let (few, many) = (Baked::new(&few, five, &Watch::default()), Baked::new(&many, five, &Watch::default()));
    let up = five.around(Vec3::Y);
    let off = |sprite: usize| (few.from(sprite, &up).middle - many.from(sprite * times, &up).middle).abs();
    let mean = (0..few.sprites()).map(off).sum::<f32>() / few.sprites() as f32;
    assert!(mean < 0.08, "{mean}");
}
