//! The closed form of overdraw against counting.

use cloudwright_core::camera::NEAR_M;
use cloudwright_core::derived::Derived;
use cloudwright_core::facing::corners;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::overdraw;
use cloudwright_core::raster::{ScreenSprite, prepare};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::Moment;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

const SIZE: [u32; 2] = [150, 90];

/// Pixels whose centre lies in the sprite's quad.
fn count(sprite: &ScreenSprite) -> usize {
    let covers = |x: u32, y: u32| {
        let (x, y) = (x as f32 + 0.5 - sprite.anchor.x, y as f32 + 0.5 - sprite.anchor.y);
        let denominator = sprite.denominator.at(x, y);
        let inside = |t: f32| (0.0..=1.0).contains(&(t / denominator));
        denominator > 0.0
            && inside(sprite.u.at(x, y))
            && inside(sprite.v.at(x, y))
            && sprite.depth / denominator >= NEAR_M
    };
    (0..SIZE[1]).map(|y| (0..SIZE[0]).filter(|x| covers(*x, y)).count()).sum()
}

/// Fragments by area and by counting, and how far they may lie apart.
///
/// A convex figure of perimeter P has as many pixel centres as its area within P/√2 + π/2: their pixels lie within
/// 1/√2 of it, and cover all of it that lies deeper. Clipped to the picture, no perimeter exceeds the picture's.
fn measured(scene: &Scene, camera: &Camera) -> [f64; 3] {
    let derived = Derived::new(scene);
    let frame = Frame::new(
        scene,
        &derived,
        Atlas::built_in(),
        &Sight { moment: Moment::at_hour(12.0), ..Sight::still(camera, SIZE) },
    );
    let got = overdraw(&frame);
    assert!((got.mean_per_pixel * f64::from(SIZE[0] * SIZE[1]) - got.fragments).abs() < 1e-6 * got.fragments.max(1.0));
    let longest = 2.0 * f64::from(SIZE[0] + SIZE[1]);
    let bound = frame.list.sprites.iter().map(|drawn| {
        let sprite = &frame.clouds[drawn.cloud as usize].sprites[drawn.sprite as usize];
        let quad = corners(
            drawn.center,
            frame.list.pose(drawn, &frame.view).facing(sprite.rotation),
            sprite.width,
            sprite.height,
        );
        let on_screen: Option<Vec<_>> = quad.into_iter().map(|corner| frame.view.project(corner)).collect();
        let perimeter = on_screen.map_or(longest, |points| {
            let sides = (0..4).map(|i| f64::from(points[i].distance(points[(i + 1) % 4])));
            sides.sum::<f64>().min(longest)
        });
        perimeter * std::f64::consts::FRAC_1_SQRT_2 + std::f64::consts::FRAC_PI_2
    });
    [got.fragments, prepare(&frame).iter().map(count).sum::<usize>() as f64, bound.sum()]
}

/// As a status bar shows it: not "-0.0".
#[test]
fn nothing_in_view_is_nothing() {
    let [fragments, counted, _] = measured(&Scene::default(), &Scene::default().cameras[0]);
    assert_eq!((format!("{fragments:.1}"), counted), ("0.0".into(), 0.0));
}

#[test]
fn area_is_count() {
    let scene = heap(60);
    for (position, heading_deg, pitch_deg, roll_deg) in [
        (DVec3::new(0.0, 1000.0, 900.0), 0.0, 0.0, 0.0),
        (DVec3::new(10.0, 1010.0, 5.0), 30.0, 5.0, 0.0),
        (DVec3::new(20.0, 700.0, 10.0), 0.0, 90.0, 0.0),
        (DVec3::new(150.0, 1000.0, 500.0), 20.0, 5.0, 77.0),
        (DVec3::new(0.0, 1000.0, 900.0), 180.0, 0.0, 0.0),
    ] {
        let camera = Camera { heading_deg, pitch_deg, roll_deg, ..Camera::free(position) };
        let [area, count, bound] = measured(&scene, &camera);
        assert!((area - count).abs() <= bound, "{position}: area {area}, {count} counted, at most {bound} apart");
        // The roundings of many sprites cancel out.
        assert!((area - count).abs() <= 0.01 * count, "{position}: area {area}, {count} counted");
    }
}

#[test]
fn one_sprite_of_each_awkward_kind() {
    for (center, side) in [
        (DVec3::new(0.0, 0.0, -100.0), 20.0),
        (DVec3::new(0.02, 0.0, -0.12), 0.5),
        (DVec3::new(0.0, 0.0, 0.0), 10.0),
        (DVec3::new(0.05, 0.0, 0.0), 100.0),
        (DVec3::new(3.0, -1.0, -0.05), 40.0),
        (DVec3::new(-20_000.0, 0.0, -30_000.0), 50_000.0),
        (DVec3::new(0.0, 0.0, 50.0), 10.0),
        (DVec3::new(0.0, 0.0, -1.0), 0.001),
    ] {
        let [area, count, bound] = measured(&single_sprites(&[(center, side)]), &Camera::free(DVec3::ZERO));
        assert!((area - count).abs() <= bound.max(2.0), "{center}: area {area}, {count} counted, {bound} allowed");
    }
    let whole = measured(&single_sprites(&[(DVec3::NEG_Z * 5.0, 1000.0)]), &Camera::free(DVec3::ZERO));
    assert!((whole[0] - 150.0 * 90.0).abs() < 0.1, "{whole:?}");
}
