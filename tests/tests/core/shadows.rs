//! Shadows of clouds: against sums over all sprites' balls, for any number of threads, hidden clouds and low suns.

use cloudwright_core::baked::{Ball, FALLOFF, Ray};
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::scene::{Aircraft, AircraftId, CameraPath, PathId, PathKey, Scene, Sun};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::{Atlas, PlacedCloud, balls_of};
use cloudwright_core::weather::{CloudNow, Moment, SceneNow, ShadowMap, WeatherRules, shadows};
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::{crowd, heap};
use glam::{DVec3, Vec3};
use std::sync::Arc;

fn lit_from(mut scene: Scene, heading_deg: f64, elevation_deg: f64) -> Scene {
    scene.sun = Sun::ByHand { heading_deg, elevation_deg };
    scene
}

fn now<'a>(scene: &Scene, derived: &'a Derived) -> SceneNow<'a> {
    SceneNow::new(scene, (derived.clouds(), derived.timeline()), Moment::default(), WeatherRules::default())
}

/// Sprites of a cloud that is not turned as balls about its origin.
fn balls(scene: &Scene, derived: &Derived, placed: &PlacedCloud) -> Vec<Ball> {
    let model = scene.model(placed.cloud.model).expect("it is there");
    let populated = derived.populated(model.id, placed.seed).expect("a cloud shows it");
    balls_of(&populated.sprites, &model.color_levels)
}

/// What all sprites of some clouds leave of the light at a point of the world, ball by ball.
fn left_by_all(of_clouds: &[(DVec3, Vec<Ball>)], point: DVec3, direction: Vec3) -> f32 {
    let of_cloud = |(origin, balls): &(DVec3, Vec<Ball>)| {
        let point = (point - *origin).as_vec3();
        balls.iter().map(|ball| ball.depth_beyond(point, Ray::towards(direction))).sum::<f32>()
    };
    (-FALLOFF * of_clouds.iter().map(of_cloud).sum::<f32>()).exp()
}

/// On the ground, by the map, against all balls. Between texels the map is linear: it errs by no more than a quarter of what
/// each spot's slope changes by, which is at most three halves of its depth over its half, both ways; and the sun's width
/// takes from a spot's depth what it adds to its area.
#[test]
fn the_ground_has_the_shadow_of_every_sprite() {
    for (heading_deg, elevation_deg) in [(180.0, 89.9), (135.0, 50.0), (260.0, 20.0)] {
        let scene = lit_from(heap(60), heading_deg, elevation_deg);
        let derived = Derived::new(&scene);
        let now = now(&scene, &derived);
        let shadows = now.shadows.expect("there are some");
        let map = now.shadow_map().expect("there is a ground");
        let of_clouds: Vec<_> = now.clouds.iter().map(|c| (c.origin(), balls(&scene, &derived, c.placed))).collect();
        let spots: Vec<_> = shadows::spots(&now.clouds[0], &shadows, &map.plane).collect();
        let below = {
            let cloud = &now.clouds[0];
            let middle = cloud.origin() + cloud.center_now().as_dvec3();
            middle - shadows.direction.as_dvec3() * (middle.y / f64::from(shadows.direction.y))
        };
        let (mut errors, mut dark) = (Vec::new(), 0);
        for i in 0..900 {
            let point = below + DVec3::new(f64::from(i % 30 - 15), 0.0, f64::from(i / 30 - 15)) * 37.0;
            let place = map.plane.place(point);
            let (got, want) = (map.left(place), left_by_all(&of_clouds, point, shadows.direction));
            let bound: f32 = spots
                .iter()
                .filter(|spot| (0..2).all(|i| (place[i] - spot.center[i]).abs() < spot.half[i] + 1.0))
                .map(|spot| FALLOFF * 0.75 * spot.depth * (1.0 / spot.half[0] + 1.0 / spot.half[1]))
                .sum();
            assert!((got - want).abs() < bound + 0.02, "{elevation_deg}°, {i}: {got}, all balls {want}, may {bound}");
            errors.push((got - want).abs());
            dark += usize::from(want < 0.7);
        }
        let mean = errors.iter().sum::<f32>() / errors.len() as f32;
        assert!(mean < 0.003 && dark > 50, "{elevation_deg}°: mean error {mean}, {dark} dark");
    }
}

/// A cloud above another, by few balls on a grid, against all balls at each sprite: as near as few balls are (baked/gathered.rs),
/// and as a grid of four nodes to a ball.
#[test]
fn clouds_shade_one_another_about_as_all_their_sprites_do() {
    let mut scene = lit_from(heap(60), 180.0, 60.0);
    let mut above = scene.clouds[0].clone();
    above.id = cloudwright_core::scene::CloudId::new(&mut scene.next_id);
    above.position += DVec3::new(40.0, 900.0, 520.0);
    scene.clouds.push(above);
    let derived = Derived::new(&scene);
    let now = now(&scene, &derived);
    let direction = now.light.direction;
    assert!(now.clouds[1].shade.is_none(), "nothing stands over the upper one");
    let upper = vec![(now.clouds[1].origin(), balls(&scene, &derived, now.clouds[1].placed))];
    let lower = &now.clouds[0];
    let mut errors: Vec<f32> = Vec::new();
    let mut least = 1.0_f32;
    for sprite in lower.placed.sprites.iter() {
        let want = left_by_all(&upper, lower.origin() + sprite.position.as_dvec3(), direction);
        errors.push((lower.shade_at(sprite.position) - want).abs());
        least = least.min(want);
    }
    errors.sort_by(f32::total_cmp);
    let at = |share: usize| errors[errors.len() * share / 100];
    assert!(least < 0.6, "some are in the shade: {least}");
    assert!(at(50) < 0.07 && at(95) < 0.2, "{} {}", at(50), at(95));
}

#[test]
fn the_same_map_on_any_number_of_threads() {
    let scene = lit_from(crowd(40), 200.0, 35.0);
    let derived = Derived::new(&scene);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        pool.install(|| now(&scene, &derived).shadow_map())
    };
    let one = on(1);
    assert!(one.is_some());
    assert_eq!(one, on(3));
}

/// A view that turns draws no map anew; another hour, another second of clouds that form, and hidden clouds each do, and
/// what is kept is what would be drawn.
#[test]
fn a_map_is_kept_while_nothing_moves() {
    let (_, make) = authoring::SCENES.iter().find(|(name, _)| *name == "forming").expect("it is there");
    let scene = make();
    let derived = Derived::new(&scene);
    let still = Sight::still(&scene.cameras[0], [64, 48]);
    let map = |sight: &Sight| {
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), sight);
        let kept = frame
            .shadows
            .map
            .of((frame.clouds_version, frame.now.shadows_state()), || frame.now.shadow_map().map(Arc::new));
        assert_eq!(kept.as_deref(), frame.now.shadow_map().as_ref());
        kept.expect("there are shadows")
    };
    let at = |clock_s: f64, time_h: f64| Sight { moment: Moment { clock_s, time_h: Some(time_h) }, ..still.clone() };
    let turned = |sight: &Sight| {
        let mut sight = sight.clone();
        sight.camera.heading_deg += 40.0;
        sight
    };
    let mut hiding = at(6.0, 11.0);
    hiding.hidden.clouds.insert(scene.clouds[0].id);
    let mut last = None;
    for sight in [at(40.0, 10.0), at(6.0, 10.0), at(6.0, 11.0), hiding] {
        let first = map(&sight);
        assert!(Arc::ptr_eq(&first, &map(&turned(&sight))));
        assert!(last.is_none_or(|last| !Arc::ptr_eq(&last, &first)));
        last = Some(first);
    }
}

/// How bright the ground is right below the heap, and far beside it, from an eye between the two.
fn ground(scene: &Scene, hide: bool) -> [f32; 2] {
    let derived = Derived::new(scene);
    let mut sight = Sight::still(&scene.cameras[0], [64, 48]);
    if hide {
        sight.hidden.clouds = scene.clouds.iter().map(|cloud| cloud.id).collect();
    }
    let frame = Frame::new(scene, &derived, Atlas::built_in(), &sight);
    let behind = frame.behind();
    let clear = cloudwright_core::sky::Background { haze_length_m: 1e12, ..behind };
    [Vec3::new(0.0, -1000.0, -900.0), Vec3::new(6000.0, -1000.0, 0.0)].map(|ray| {
        let Some(ground) = &clear.ground else { return 0.0 };
        let (mut shadowed, bright) = (ground.clone(), ground.bright);
        // Woods and fields alike, so that shadows alone differ.
        shadowed.dark = bright;
        cloudwright_core::sky::Background { ground: Some(shadowed), ..clear.clone() }.color(ray, 0.001).g / bright.g
    })
}

#[test]
fn what_is_hidden_turned_off_or_under_a_low_light_casts_none() {
    let overhead = lit_from(heap(60), 180.0, 89.0);
    let [below, beside] = ground(&overhead, false);
    assert!(below < 0.75 && (beside - 1.0).abs() < 1e-5, "{below} {beside}");
    assert!((ground(&overhead, true)[0] - 1.0).abs() < 1e-5, "hidden");
    let mut off = overhead.clone();
    off.sky.cloud_shadows = 0.0;
    assert!((ground(&off, false)[0] - 1.0).abs() < 1e-5, "turned off");
    let mut half = overhead.clone();
    half.sky.cloud_shadows = 0.5;
    assert!((ground(&half, false)[0] - 0.5 * (1.0 + below)).abs() < 1e-3, "half of it");
    for elevation_deg in [0.0, -0.5, -30.0, -90.0] {
        let scene = lit_from(heap(30), 90.0, elevation_deg);
        let derived = Derived::new(&scene);
        let now = now(&scene, &derived);
        let lit = now.clouds.iter().all(|cloud| cloud.shade.is_none());
        assert!(lit && now.light.direction.is_finite(), "{elevation_deg}°");
        assert!(now.shadow_map().is_none_or(|map| map.left([3.0, 3.0]).is_finite()), "{elevation_deg}°");
    }
    let mut none = overhead;
    none.clouds.clear();
    assert!(ground(&none, false).iter().all(|light| (light - 1.0).abs() < 1e-5), "no clouds");
}

#[test]
fn what_flies_and_stands_is_in_the_shade() {
    let mut scene = lit_from(heap(60), 180.0, 89.0);
    for x in [0.0, 4000.0] {
        let path_id = PathId::new(&mut scene.next_id);
        let position = DVec3::new(x, 300.0, 0.0);
        let key = PathKey { time_s: 0.0, position, heading_deg: 0.0, pitch_deg: 0.0, roll_deg: 0.0 };
        scene.paths.push(CameraPath::new(path_id, "path", vec![key]));
        let id = AircraftId::new(&mut scene.next_id);
        scene.aircraft.push(Aircraft::new(id, "aircraft", path_id));
    }
    let derived = Derived::new(&scene);
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&scene.cameras[0], [64, 48]));
    let lit: Vec<f32> = frame.models.iter().map(|model| model.sunlit).collect();
    assert_eq!(lit.len(), 2);
    assert!(lit[0] < 0.75 && lit[1] == 1.0, "{lit:?}");
}

/// While a sun goes down, light at points of the ground changes by no more than its shadow's edge moves, and by what the map
/// may err when its texels are others.
#[test]
fn shadows_go_with_the_sun() {
    let scene = heap(60);
    let derived = Derived::new(&scene);
    let mut before: Option<Vec<f32>> = None;
    for step in 0..360 {
        let elevation_deg = 60.0 - 0.05 * f64::from(step);
        let scene = lit_from(scene.clone(), 180.0, elevation_deg);
        let now = now(&scene, &derived);
        let map = now.shadow_map().expect("there are shadows");
        let at = |i: i32| {
            map.left(map.plane.place(DVec3::new(
                f64::from(i % 10) * 60.0 - 270.0,
                0.0,
                f64::from(i / 10) * 60.0 - 1400.0,
            )))
        };
        let lights: Vec<f32> = (0..100).map(at).collect();
        if let Some(before) = &before {
            let step = lights.iter().zip(before).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
            // 0.05° moves the shadow of what is 1,100 m up by 1.4 to 2.1 m; the steepest edges there fall by 1 in 60 m.
            assert!(step < 2.1 / 60.0 + 0.02, "{elevation_deg}°: {step}");
        }
        before = Some(lights);
    }
}

#[test]
fn a_map_of_one_sprite_and_of_clouds_that_are_nowhere() {
    let one = cloudwright_tests::small_scenes::single_sprites(&[(DVec3::new(0.0, 500.0, 0.0), 100.0)]);
    let scene = Scene { ground: Some(Default::default()), ..lit_from(one, 90.0, 45.0) };
    let derived = Derived::new(&scene);
    let map: ShadowMap = now(&scene, &derived).shadow_map().expect("there is one");
    let below = map.left(map.plane.place(DVec3::new(-500.0, 0.0, 0.0)));
    assert!(below < 0.97, "{below}");
    assert_eq!(map.left([-1e9, 1e9]), 1.0);
    assert!(map.left([f32::NAN, 0.0]).is_finite());
    let cloud = CloudNow::at_rest(&derived.clouds()[0]);
    assert!(cloud.casts() && !CloudNow { is_hidden: true, ..cloud }.casts());
}
