//! What is drawn, and in which order.

use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::{DrawList, DrawSprite, FACES_EYE, Hidden, sort_back_to_front};
use cloudwright_core::facing::Pose;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::{fast, plain};
use cloudwright_core::rules::Blending;
use cloudwright_core::scene::Camera;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};
use proptest::prelude::*;
use std::collections::BTreeMap;

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

    /// Leaving out what the view does not see changes no bit of a pixel, and what is left stands as in any still.
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
        let listed: BTreeMap<u32, DrawSprite> = frame.list.sprites.iter().map(|drawn| (drawn.sprite, *drawn)).collect();
        let mut poses = frame.list.poses.clone();
        let mut all = Vec::new();
        for (sprite, index) in cloud.sprites.iter().zip(0..) {
            let center = offset + sprite.position;
            let still = Pose::still(center, sprite.radius(), &frame.view);
            all.push(match listed.get(&index) {
                Some(drawn) => {
                    check_pose(&frame.list.pose(drawn, &frame.view), &still)?;
                    *drawn
                }
                None => {
                    poses.push(still);
                    DrawSprite { cloud: 0, sprite: index, center, pose: poses.len() as u32 - 1 }
                }
            });
        }
        sort_back_to_front(&mut all);
        let whole = Frame { list: DrawList::of_sprites(all, poses), ..frame.clone() };
        let (seen, whole) = (fast::clouds(&frame, Blending::AS_PLAIN), fast::clouds(&whole, Blending::AS_PLAIN));
        prop_assert!(seen.pixels == whole.pixels);
    }
}

/// Near the eye a pose is mixed of two directions that without a history are one, and carries an up that does not turn.
///
/// In units of f32's epsilon: a mix is 1.5 off in each of three parts, its unit vector one more: 4. An up is carried by a
/// product and a unit vector, 4 more, and relaxes by three times the angle between: 20. The near plane's fade goes by a
/// distance that is 4 off from where it begins, and from 0 to 1 over as much again with a slope of 1.5: 12 more than of what fades by
/// the lock, 4.
fn check_pose(own: &Pose, still: &Pose) -> Result<(), TestCaseError> {
    let off = [own.towards.distance(still.towards), own.up.distance(still.up), (own.fade - still.fade).abs()];
    for (off, most) in off.into_iter().zip([4.0, 20.0, 16.0]) {
        prop_assert!(off <= most * f32::EPSILON, "{own:?} for {still:?}");
    }
    Ok(())
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
    for layer in [fast::clouds(&no_cloud, Blending::AS_PLAIN), plain::clouds(&no_cloud)] {
        assert!(layer.pixels.iter().all(|pixel| pixel.a == 0.0));
    }
}

/// Without haze, what is far has its own colour and light; without the ground, the sky goes on below the horizon.
#[test]
fn hidden_haze_and_ground_leave_the_background() {
    let mut scene = heap(25);
    scene.sky.haze_length_m = 2000.0;
    let derived = Derived::new(&scene);
    let mut camera = scene.cameras[0].clone();
    (camera.position, camera.pitch_deg) = (DVec3::Y * 1000.0, -20.0);
    let below = |hidden: Hidden| {
        let sight = Sight { hidden, ..Sight::still(&camera, [64, 36]) };
        let background = Frame::new(&scene, &derived, Atlas::built_in(), &sight).background;
        // Some 10 km away: five lengths of haze.
        let ray = Vec3::new(0.0, -0.1, -1.0);
        let [color, sky] = [background.color(ray, 1e-3), background.dome.horizon(ray)];
        (color.g / sky.g, background.ground.is_some())
    };
    let (hazed, has_ground) = below(Hidden::default());
    assert!(hazed > 0.95 && has_ground, "{hazed}");
    let (clear, has_ground) = below(Hidden { haze: true, ..Hidden::default() });
    assert!(clear < 0.7 && has_ground, "{clear}");
    let (sky, has_ground) = below(Hidden { ground: true, ..Hidden::default() });
    assert!(sky > 0.95 && !has_ground, "{sky}");
}
