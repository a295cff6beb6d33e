//! Pictures in layers: their sum is the picture, each is what it says, depth and motion are what they should be.

use cloudwright_core::color::{Rgb, srgb_from_linear};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::draw_list::{DrawList, Sorting};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{LayeredPixel, Layers, LinearPicture};
use cloudwright_core::model_in_view::Meshes;
use cloudwright_core::raster::fast;
use cloudwright_core::raster::layers::{Later, layers};
use cloudwright_core::rules::{Blending, Rules};
use cloudwright_core::scene::{Camera, Prop, PropId, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::tone::tone_curve;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

const SIZE: [u32; 2] = [214, 120];

/// The layers of what `now` sees, with the motion until what `next` sees, and the frame.
fn with_layers<T>(scene: &Scene, [now, next]: [&Sight; 2], check: impl FnOnce(&Frame<'_>, Layers) -> T) -> T {
    let derived = Derived::new(scene);
    let frame = Frame::new(scene, &derived, Atlas::built_in(), now);
    let layers = draw::layers(&frame, &Later::new(scene, &derived, next)).expect("drawn fast");
    check(&frame, layers)
}

/// The largest difference of two pictures on a display, in steps of 8 bits before they are rounded.
fn steps_apart(a: &LinearPicture, b: &LinearPicture, exposure: f32) -> f32 {
    let shown = |color: &Rgb| (*color * exposure).to_array().map(|c| 255.0 * srgb_from_linear(tone_curve(c)));
    let apart = |(a, b): (&Rgb, &Rgb)| {
        let steps = |(a, b): (f32, f32)| if (a - b).is_nan() { f32::INFINITY } else { (a - b).abs() };
        shown(a).into_iter().zip(shown(b)).map(steps).fold(0.0, f32::max)
    };
    assert_eq!(a.pixels.len(), b.pixels.len());
    a.pixels.iter().zip(&b.pixels).map(apart).fold(0.0, f32::max)
}

/// Every shipped scene at its own hour, at noon, at dusk and at night, and from within a cloud.
fn looks() -> Vec<(String, Scene, Sight)> {
    let mut looks = Vec::new();
    for (name, make) in authoring::SCENES {
        let scene = make();
        for time_h in [None, Some(12.0), Some(20.0), Some(23.5)] {
            let sight = Sight { moment: Moment { clock_s: 3.0, time_h }, ..Sight::still(&scene.cameras[0], SIZE) };
            looks.push((format!("{name} at {time_h:?}"), scene.clone(), sight));
        }
    }
    let mut scene = heap(40);
    let mut with_prop = Sight::still(&scene.cameras[0], SIZE);
    with_prop.meshes.insert("own.glb".into(), (*Meshes::built_in()).clone());
    let mut propped = scene.clone();
    propped.props.push(Prop { scale: 20.0, ..Prop::new(PropId(900), "own.glb", DVec3::new(0.0, 1000.0, 80.0)) });
    looks.push(("a model in the cloud".into(), propped, with_prop));
    let camera = within(&scene);
    for (name, haze_length_m) in [("inside", 20_000.0), ("inside, in thick haze", 400.0)] {
        (scene.sky.haze_length_m, scene.sky.inside_density) = (haze_length_m, 1.0);
        looks.push((name.into(), scene.clone(), Sight::still(&camera, SIZE)));
    }
    looks
}

/// An eye in the middle of a sprite, which it does not see, but for the veil.
fn within(scene: &Scene) -> Camera {
    let derived = Derived::new(scene);
    let cloud = &derived.clouds()[0];
    let middle = cloud.sprites[cloud.sprites.len() / 2].position.as_dvec3();
    let place = scene.clouds[0].position + middle + DVec3::splat(0.1);
    Camera { heading_deg: 30.0, ..Camera::free(place) }
}

#[test]
fn layers_sum_to_the_picture() {
    let (mut hazed, mut veiled, mut grounded, mut flown) = (0, 0, 0, 0);
    for (name, scene, sight) in looks() {
        with_layers(&scene, [&sight, &sight], |frame, layers| {
            let picture = draw::linear(frame, &Watch::default()).expect("drawn fast");
            let apart = steps_apart(&layers.composed(), &picture, frame.now.exposure);
            assert!(apart <= 0.5, "{name}: {apart} steps of 8 bits apart");
            hazed += usize::from(layers.pixels.iter().any(|pixel| pixel.haze.b > 0.05));
            veiled += usize::from(frame.veil.a > 0.01);
            grounded += usize::from(layers.pixels.iter().any(|pixel| pixel.ground_share == 1.0));
            flown += usize::from(layers.pixels.iter().any(|pixel| pixel.models_share == 1.0));
            let seen = |p: &LayeredPixel| [p.sky, p.ground, p.models].iter().filter(|c| **c != Rgb::BLACK).count();
            assert!(layers.pixels.iter().all(|pixel| seen(pixel) <= 1), "{name}: sky, ground or a model");
        });
    }
    let counts = [hazed, veiled, grounded, flown];
    assert!(hazed > 4 && veiled == 2 && grounded > 4 && flown == 1, "{counts:?}: all kinds are among them");
}

/// Also where each pixel is a mean, and where another order fades out.
#[test]
fn means_and_faded_orders_sum_to_the_picture() {
    let scene = heap(40);
    let rules = Rules { samples_side: 3, ..Rules::SHIPPED };
    let sight = Sight { rules, ..Sight::still(&scene.cameras[0], [64, 36]) };
    with_layers(&scene, [&sight, &sight], |frame, layers| {
        let picture = draw::linear(frame, &Watch::default()).expect("drawn fast");
        assert_eq!([layers.width, layers.height], [64, 36]);
        assert!(steps_apart(&layers.composed(), &picture, frame.now.exposure) <= 0.5);
    });
    let rules = Rules::SHIPPED.sorted(Sorting::Crossfade);
    let (derived, sight) = (Derived::new(&scene), Sight { rules, ..Sight::still(&scene.cameras[0], SIZE) });
    let mut frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
    let reversed = frame.list.sprites.iter().rev().copied().collect();
    frame.fading = Some((DrawList::of_sprites(reversed, frame.list.poses.clone()), 0.3));
    let layers = draw::layers(&frame, &Later::new(&scene, &derived, &sight)).expect("drawn fast");
    let linear = |frame: &Frame<'_>| draw::linear(frame, &Watch::default()).expect("drawn fast");
    let picture = linear(&frame);
    assert!(steps_apart(&layers.composed(), &picture, frame.now.exposure) <= 0.5);
    let alone = linear(&Frame { fading: None, ..frame });
    assert!(steps_apart(&alone, &picture, 1.0) > 1.0, "the other order shows");
}

/// Without the sun's light, clouds show what the other layers have.
#[test]
fn each_light_is_what_it_says() {
    let scene = heap(40);
    let inside = within(&scene);
    for (camera, is_inside) in [(&scene.cameras[0], false), (&inside, true)] {
        let (derived, sight) = (Derived::new(&scene), Sight::still(camera, SIZE));
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
        let later = Later::new(&scene, &derived, &sight);
        let lit = layers(&frame, &later, Blending::AS_PLAIN);
        let mut sunless = frame.clone();
        sunless.now.light.directional_max = Rgb::BLACK;
        sunless.veil.r -= frame.veil_directional.r;
        sunless.veil.g -= frame.veil_directional.g;
        sunless.veil.b -= frame.veil_directional.b;
        let wanted = fast::clouds(&sunless, Blending::AS_PLAIN);
        for (got, wanted) in lit.pixels.iter().zip(&wanted.pixels) {
            let (got, wanted) = (got.ambient + got.haze, Rgb::new(wanted.r, wanted.g, wanted.b));
            let apart = got.to_array().into_iter().zip(wanted.to_array()).map(|(a, b)| (a - b).abs());
            // The same sums in another order.
            assert!(apart.fold(0.0, f32::max) < 1e-4, "{got:?}, not {wanted:?}");
        }
        let sun = lit.pixels.iter().map(|pixel| pixel.directional.r).fold(0.0, f32::max);
        assert!(sun > 0.1, "the sun shines on them: {sun}");
        assert_eq!(frame.veil_directional.r > 0.0, is_inside);
        assert!(frame.veil.r >= frame.veil_directional.r);
    }
}

fn at(layers: &Layers, x: u32, y: u32) -> LayeredPixel {
    layers.pixels[(y * layers.width + x) as usize]
}

#[test]
fn depth_is_the_distance_of_what_shows() {
    // Before one another, and one by itself to the right.
    let near = [(DVec3::new(0.0, 0.0, -100.0), 20.0), (DVec3::new(0.0, 0.0, -300.0), 90.0)];
    let alone = (DVec3::new(140.0, 0.0, -400.0), 80.0);
    let scene = single_sprites(&[near[0], near[1], alone]);
    let sight = Sight::still(&scene.cameras[0], [301, 201]);
    with_layers(&scene, [&sight, &sight], |frame, layers| {
        let before = frame.view.project(alone.0.as_vec3()).expect("before the eye");
        let only = at(&layers, before.x as u32, before.y as u32);
        let distance = alone.0.length() as f32;
        assert!(only.alpha > 0.5 && (only.depth_m() - distance).abs() < 0.01, "{only:?}, not {distance} m");
        let (both, first) = (at(&layers, 150, 100), at(&layers, 150, 100).depth_m());
        assert!(both.alpha > 0.5 && (100.0..200.0).contains(&first), "{first} m: the nearer hides most");
        assert_eq!(at(&layers, 0, 0).depth_m(), 0.0, "no cloud, no depth");
    });
}

#[test]
fn motion_is_that_of_the_clouds_on_the_picture() {
    let scene = single_sprites(&[(DVec3::new(3.0, 2.0, -100.0), 40.0)]);
    let now = Sight::still(&scene.cameras[0], [301, 201]);
    let mut next = now.clone();
    // The eye goes to the left and down, so clouds go to the right and up, by 100 m's parallax.
    next.camera.position += DVec3::new(-1.0, -0.5, 0.0);
    with_layers(&scene, [&now, &next], |frame, layers| {
        let pixel = 1.0 / (100.0 * frame.view.pixel());
        let [across, up] = at(&layers, 150, 100).motion_px();
        assert!((across - pixel).abs() < 0.01 && (up - 0.5 * pixel).abs() < 0.01, "{across} {up}, not {pixel}");
        assert_eq!(at(&layers, 0, 0).motion_px(), [0.0, 0.0]);
    });
    let mut next = now.clone();
    next.camera.heading_deg += 1.0;
    with_layers(&scene, [&now, &next], |frame, layers| {
        let [across, _] = at(&layers, 150, 100).motion_px();
        let wanted = -1.0_f32.to_radians() / frame.view.pixel();
        assert!((across - wanted).abs() < 0.02 * wanted.abs(), "{across}, not {wanted}");
    });
    // A still eye in a wind.
    let scene = authoring::SCENES.iter().find(|(name, _)| *name == "summer_day").expect("it ships").1();
    let sights = [40.0, 40.0 + 1.0 / 24.0]
        .map(|clock_s| Sight { moment: Moment::at(clock_s), ..Sight::still(&scene.cameras[0], SIZE) });
    with_layers(&scene, [&sights[0], &sights[1]], |_, layers| {
        let moves = layers.pixels.iter().filter(|pixel| pixel.motion_sum != [0.0; 2]).count();
        assert!(moves > 100, "{moves} pixels move");
    });
    with_layers(&scene, [&sights[0], &sights[0]], |_, layers| {
        let most = layers.pixels.iter().flat_map(LayeredPixel::motion_px).map(f32::abs).fold(0.0, f32::max);
        // To project and back, in 32 bits.
        assert!(most < 0.02, "nothing moves in no time: {most}");
    });
}

/// What does not keep layers says so.
#[test]
fn only_the_fast_renderer_keeps_layers() {
    let scene = heap(5);
    let derived = Derived::new(&scene);
    let sight = Sight { rules: cloudwright_core::method::truth().rules, ..Sight::still(&scene.cameras[0], [8, 8]) };
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
    assert!(draw::layers(&frame, &Later::new(&scene, &derived, &sight)).is_none());
}
