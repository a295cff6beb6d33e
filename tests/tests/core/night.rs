//! The night: what the sky holds, from where its light comes, and that nothing of it pops or reaches into the day.

use cloudwright_core::color::Rgb;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::{fast, plain};
use cloudwright_core::rules::Blending;
use cloudwright_core::scene::{Camera, Date, Scene, Sun};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::{Light, Moment};
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};

/// A scene without clouds, under a moon that is nearly full.
fn moonlit() -> Scene {
    let mut scene = heap(10);
    scene.clouds.clear();
    (scene.sun, scene.site.date) = (Sun::ByPlace, Date { year: 2004, month: 7, day: 1 });
    scene
}

fn with_frame<T>(scene: &Scene, camera: &Camera, (size, hour): ([u32; 2], f64), f: impl FnOnce(&Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    let moment = Moment { clock_s: 0.0, time_h: Some(hour) };
    f(&Frame::new(scene, &derived, Atlas::built_in(), &Sight { moment, ..Sight::still(camera, size) }))
}

fn towards(direction: Vec3, field_of_view_deg: f64) -> Camera {
    let heading_deg = f64::from(direction.x.atan2(-direction.z).to_degrees());
    let pitch_deg = f64::from(direction.y.asin().to_degrees());
    Camera { heading_deg, pitch_deg, field_of_view_deg, ..Camera::free(DVec3::new(0.0, 800.0, 0.0)) }
}

fn to_moon(scene: &Scene, hour: f64) -> Vec3 {
    Light::at(scene, hour).night.expect("it is night").moon_direction
}

#[test]
fn the_fast_sky_is_the_plain_one() {
    let scene = moonlit();
    let moon = to_moon(&scene, 1.0);
    for (name, camera, size) in [
        ("moon", towards(moon, 45.0), [960, 540]),
        ("moon, near", towards(moon, 2.0), [320, 200]),
        ("horizon", towards(Vec3::new(0.6, 0.05, -0.8), 60.0), [960, 540]),
        ("zenith", towards(Vec3::Y, 70.0), [960, 540]),
        ("rolled", Camera { roll_deg: 70.0, ..towards(Vec3::new(-0.5, 0.3, 0.8), 30.0) }, [641, 359]),
        ("so coarse that stars fade", towards(moon, 60.0), [90, 60]),
    ] {
        with_frame(&scene, &camera, (size, 1.0), |frame| {
            let (fast, plain) = (fast::picture_by(frame, Blending::AS_PLAIN), plain::picture(frame));
            let off = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
            let worst = fast.pixels.iter().zip(&plain.pixels).map(off).max().unwrap_or(0);
            // As by day: under one step of 8 bits, and rounding may add another.
            assert!(worst <= 2, "{name}: off by {worst}");
        });
    }
}

/// While the sun is up there is no night in anything that is drawn from; then it comes in small steps, light included.
#[test]
fn it_comes_without_a_pop() {
    let mut scene = moonlit();
    // They wander past any direction.
    scene.sky.stars = 0.0;
    let camera = towards(Vec3::new(0.3, 0.4, -0.8).normalize(), 50.0);
    let looks = [Vec3::new(0.1, 0.9, 0.2), Vec3::new(-0.8, 0.05, -0.6), Vec3::new(0.5, 0.3, 0.6)].map(Vec3::normalize);
    let mut before: Option<Vec<Rgb>> = None;
    for step in 0..900 {
        let hour = 20.5 + f64::from(step) / 200.0;
        let now = with_frame(&scene, &camera, ([8, 8], hour), |frame| {
            let light = frame.now.light;
            assert_eq!(light.night.is_none(), light.sun_direction.y >= 0.0);
            assert_eq!(frame.background.dome.night.is_none(), light.night.is_none());
            assert!(light.night.is_some() || light.direction == light.sun_direction);
            // A face's light changes with amount and direction.
            let faces =
                [Vec3::X, Vec3::Y, Vec3::Z, Vec3::NEG_X].map(|n| light.directional_max * n.dot(light.direction));
            looks.iter().map(|look| frame.background.color(*look, 1e-3)).chain(faces).collect::<Vec<Rgb>>()
        });
        // Eighteen seconds. The default table's directional light falls by 1.35 an hour to just after sunset, and the sun
        // sinks; then the sky is the fastest, by a sixtieth for the twentieth of a degree that the sun sinks.
        let by_table = hour < 21.35;
        for (a, b) in before.iter().flatten().zip(&now) {
            let apart = (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs());
            let most = if by_table { 0.012 } else { 0.0004 + a.r.abs().max(a.b.abs()) / 60.0 };
            assert!(apart <= most, "{hour}: {a:?}, then {b:?}");
        }
        before = Some(now);
    }
}

#[test]
fn stars_and_moon_go_by_their_strength() {
    let mut scene = moonlit();
    let sky = |scene: &Scene, direction: Vec3| {
        with_frame(scene, &towards(direction, 6.0), ([240, 240], 1.0), |frame| {
            let lit = plain::linear_picture(frame).pixels.iter().map(|color| color.g).fold(0.0, f32::max);
            (lit, frame.now.light.directional_max.g)
        })
    };
    let (moon, away) = (to_moon(&scene, 1.0), Vec3::new(0.2, 0.8, -0.5).normalize());
    let ((lit, light), (starry, _)) = (sky(&scene, moon), sky(&scene, away));
    assert!(lit > 0.45 && light > 0.04, "a moon of {lit} that lights by {light}");
    assert!(starry > 0.1, "{starry}");
    scene.sky.stars = 0.0;
    assert!(sky(&scene, away).0 < 0.03, "no stars");
    scene.sky.moon = 0.0;
    let (dark, light) = sky(&scene, moon);
    assert!(dark < 0.03 && light == 0.0, "no moon: {dark} {light}");
}

/// Whatever the hour, a cloud's side towards the moon is the brighter one.
#[test]
fn clouds_are_lit_from_where_the_moon_is() {
    let scene = moonlit();
    for hour in [23.5, 0.5, 1.0, 2.0] {
        let light = Light::at(&scene, hour);
        assert_eq!(light.direction, to_moon(&scene, hour));
        assert!(light.direction.y > 0.0 && light.directional_max.g > 0.01, "{hour}: {light:?}");
    }
    let mut by_hand = scene;
    by_hand.sun = Sun::ByHand { heading_deg: 30.0, elevation_deg: -40.0 };
    let light = Light::at(&by_hand, 1.0);
    assert_eq!(light.direction, -light.sun_direction, "a full moon opposite");
}
