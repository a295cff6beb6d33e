//! What is drawn, and in which order.

use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::{DrawList, DrawSprite, FACES_EYE, Hidden, sort_back_to_front};
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::{fast, plain};
use cloudwright_core::rules::NEVER_STOP;
use cloudwright_core::scene::Camera;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};
use proptest::prelude::*;

fn any_number() -> impl Strategy<Value = f32> {
    prop_oneof![Just(0.0), Just(-0.0), Just(f32::NAN), Just(f32::INFINITY), Just(1e-40), -1e3..1e3_f32, any::<f32>()]
}

proptest! {
    /// Farthest first, equally far ones in their old order, nothing lost: whatever the numbers.
    #[test]
    fn sorted_is_a_total_order(centers in prop::collection::vec((any_number(), any_number(), any_number()), 0..200)) {
        let before: Vec<DrawSprite> =
            centers.into_iter().zip(0..).map(|(center, i)| DrawSprite { cloud: i / 7, sprite: i % 7, center: Vec3::from(center), pose: FACES_EYE }).collect();
        let mut after = before.clone();
        sort_back_to_front(&mut after);
        let place = |s: &DrawSprite| (s.cloud, s.sprite);
        let mut places: Vec<_> = after.iter().map(place).collect();
        for pair in after.windows(2) {
            let (far, near) = (pair[0].center.length_squared(), pair[1].center.length_squared());
            if far.is_nan() || near.is_nan() {
                continue;
            }
            prop_assert!(far >= near, "{far} before {near}");
            prop_assert!(far > near || place(&pair[0]) < place(&pair[1]));
        }
        places.sort_unstable();
        prop_assert_eq!(places, before.iter().map(place).collect::<Vec<_>>());
    }

    /// Leaving out what the view does not see changes no pixel.
    #[test]
    fn culling_by_the_view_does_not_show(
        x in -300.0..300.0_f64, y in 700.0..1300.0_f64, z in -300.0..900.0_f64,
        heading_deg in 0.0..360.0_f64, pitch_deg in -90.0..90.0_f64, roll_deg in 0.0..360.0_f64, field_of_view_deg in 5.0..150.0_f64,
    ) {
        let scene = heap(25);
        let derived = Derived::new(&scene);
        let camera = Camera { heading_deg, pitch_deg, roll_deg, field_of_view_deg, ..Camera::free(DVec3::new(x, y, z)) };
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&camera, [90, 40]));
        let cloud = &derived.clouds()[0];
        let offset = (cloud.origin - frame.view.eye).as_vec3();
        let poses = cloud.sprites.iter().map(|s| Pose::still(offset + s.position, s.radius(), &frame.view)).collect();
        let mut all: Vec<DrawSprite> =
            cloud.sprites.iter().zip(0..).map(|(s, sprite)| DrawSprite { cloud: 0, sprite, center: offset + s.position, pose: sprite }).collect();
        sort_back_to_front(&mut all);
        prop_assert!(frame.list.sprites.len() <= all.len());
        let whole = Frame { list: DrawList::of_sprites(all, poses), ..frame.clone() };
        // A pose is put together in one way for sprites near the eye and in another for all: some units in the last place.
        // What they come to in a pixel has no bound derived yet; 2.3e-4 has been met, at x 111.61165199333294,
        // y 1016.1514692335077, z 35.49920793497468, heading 41.726986329992414, pitch 69.48790959857388, roll 0 and a
        // field of view of 143.42987841697277. A quarter of a step of eight bits shows nowhere.
        let (seen, whole) = (fast::clouds(&frame, NEVER_STOP), fast::clouds(&whole, NEVER_STOP));
        for (a, b) in seen.pixels.iter().zip(&whole.pixels) {
            prop_assert!((a.r - b.r).abs().max((a.a - b.a).abs()) < 1.0 / 1020.0, "{a:?} for {b:?}");
        }
    }
}

/// What is hidden leaves the list, what stays looks as it did, and every renderer of the CPU draws from the list alone.
#[test]
fn what_is_hidden_is_not_drawn() {
    let scene = heap(25);
    let derived = Derived::new(&scene);
    let camera = &scene.cameras[0];
    let frame = |hidden: &Hidden| {
        let sight = Sight { hidden: hidden.clone(), ..Sight::still(camera, [90, 40]) };
        Frame::new(&scene, &derived, Atlas::built_in(), &sight)
    };
    let all = frame(&Hidden::default());

    let box_id = scene.models[0].boxes[1].id;
    let one_box = frame(&Hidden { boxes: [box_id].into(), ..Hidden::default() });
    let shown = |s: &DrawSprite| derived.clouds()[0].sprites[s.sprite as usize].box_id != box_id;
    let rest: Vec<DrawSprite> = all.list.sprites.iter().copied().filter(shown).collect();
    assert!(!rest.is_empty() && rest.len() < all.list.sprites.len());
    assert_eq!(one_box.list.sprites, rest);

    let no_cloud = frame(&Hidden { clouds: [scene.clouds[0].id].into(), ..Hidden::default() });
    assert!(no_cloud.list.sprites.is_empty());
    for layer in [fast::clouds(&no_cloud, NEVER_STOP), plain::clouds(&no_cloud)] {
        assert!(layer.pixels.iter().all(|pixel| pixel.a == 0.0));
    }
}

#[test]
fn diagnose() {
    let scene = heap(25);
    let derived = Derived::new(&scene);
    let camera = Camera { heading_deg: 41.726986329992414, pitch_deg: 69.48790959857388, roll_deg: 0.0, field_of_view_deg: 143.42987841697277, ..Camera::free(DVec3::new(111.61165199333294, 1016.1514692335077, 35.49920793497468)) };
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&camera, [90, 40]));
    let cloud = &derived.clouds()[0];
    let offset = (cloud.origin - frame.view.eye).as_vec3();
    eprintln!("{} of {}; poses {}", frame.list.sprites.len(), cloud.sprites.len(), frame.list.poses.len());
    for d in &frame.list.sprites {
        let s = &cloud.sprites[d.sprite as usize];
        let a = frame.list.pose(d, &frame.view);
        let b = Pose::still(offset + s.position, s.radius(), &frame.view);
        if a != b || d.center != offset + s.position {
            eprintln!("{} own {} dist {} r {}: towards {} up {} fade {} / {} center {}", d.sprite, d.pose != FACES_EYE, d.center.length(), s.radius(), (a.towards - b.towards).length(), (a.up - b.up).length(), a.fade, b.fade, (d.center - offset - s.position).length());
        }
    }
    // One at a time.
    for d in &frame.list.sprites {
        let s = &cloud.sprites[d.sprite as usize];
        let b = Pose::still(offset + s.position, s.radius(), &frame.view);
        let one = |pose| Frame { list: DrawList::of_sprites(vec![DrawSprite { pose: 0, ..*d }], vec![pose]), ..frame.clone() };
        let (x, y) = (fast::clouds(&one(frame.list.pose(d, &frame.view)), NEVER_STOP), fast::clouds(&one(b), NEVER_STOP));
        let most = x.pixels.iter().zip(&y.pixels).map(|(a, b)| (a.r - b.r).abs().max((a.a - b.a).abs())).fold(0.0, f32::max);
        if most > 1e-5 { eprintln!("{}: {most:e}", d.sprite); }
    }
    let listed: std::collections::BTreeSet<u32> = frame.list.sprites.iter().map(|d| d.sprite).collect();
    for (s, i) in cloud.sprites.iter().zip(0..) {
        if listed.contains(&i) { continue; }
        let center = offset + s.position;
        let b = Pose::still(center, s.radius(), &frame.view);
        let one = Frame { list: DrawList::of_sprites(vec![DrawSprite { cloud: 0, sprite: i, center, pose: 0 }], vec![b]), ..frame.clone() };
        let most = fast::clouds(&one, NEVER_STOP).pixels.iter().map(|a| a.r.abs().max(a.a.abs())).fold(0.0, f32::max);
        if most > 0.0 { eprintln!("culled {i}: {most:e} {center}"); }
    }
}
