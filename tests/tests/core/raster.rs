//! The fast CPU renderer against the plain one, and against itself.

use cloudwright_core::color::Premultiplied;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Layer;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::raster::{fast, plain, prepare};
use cloudwright_core::rules::{Blending, NEVER_STOP};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

pub const SIZE: [u32; 2] = [215, 120];

pub fn with_frame<T>(scene: &Scene, camera: &Camera, size: [u32; 2], f: impl FnOnce(&Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    f(&Frame::new(scene, &derived, Atlas::built_in(), &Sight::still(camera, size)))
}

pub fn largest_difference(a: &Layer, b: &Layer) -> f32 {
    let channels = |p: &Premultiplied| [p.r, p.g, p.b, p.a];
    // f32::max passes over what is no number: that differs most of all.
    let apart = |x: f32, y: f32| if (x - y).is_nan() { f32::INFINITY } else { (x - y).abs() };
    let difference = |(a, b)| channels(a).into_iter().zip(channels(b)).map(|(x, y)| apart(x, y)).fold(0.0, f32::max);
    a.pixels.iter().zip(&b.pixels).map(difference).fold(0.0, f32::max)
}

/// Scenes and cameras where renderers tend to differ.
pub fn cases() -> Vec<(String, Scene, Camera)> {
    let mut cases: Vec<(String, Scene, Camera)> = Vec::new();
    for (name, make) in authoring::SCENES {
        let scene = make();
        cases.extend(
            scene.cameras.iter().map(|camera| (format!("{name} {}", camera.name), scene.clone(), camera.clone())),
        );
    }
    let scene = heap(40);
    for (name, position, heading_deg, pitch_deg, roll_deg) in [
        ("inside", DVec3::new(10.0, 1010.0, 5.0), 30.0, 5.0, 0.0),
        ("straight up", DVec3::new(20.0, 700.0, 10.0), 0.0, 90.0, 0.0),
        ("straight down", DVec3::new(20.0, 1600.0, 10.0), 45.0, -90.0, 0.0),
        ("rolled", DVec3::new(0.0, 1000.0, 700.0), 0.0, 0.0, 77.0),
        ("far away", DVec3::new(0.0, 1000.0, 200_000.0), 0.0, 0.0, 0.0),
        ("turned away", DVec3::new(0.0, 1000.0, 700.0), 180.0, 0.0, 0.0),
    ] {
        let camera = Camera { heading_deg, pitch_deg, roll_deg, ..Camera::free(position) };
        cases.push((name.into(), scene.clone(), camera));
    }
    let scene = single_sprites(&[
        (DVec3::new(0.02, 0.0, -0.12), 0.5),
        (DVec3::new(0.0, 0.0, 0.0), 10.0),
        (DVec3::new(3.0, -1.0, -0.05), 40.0),
        (DVec3::new(-20_000.0, 0.0, -30_000.0), 50_000.0),
        (DVec3::new(0.0, 0.5, -1.0), 0.01),
    ]);
    // Edge-on beside the eye: in the middle column of an odd width the ray runs along the sprite's plane.
    let beside = single_sprites(&[(DVec3::new(0.05, 0.0, 0.0), 100.0), (DVec3::new(0.0, 0.0, -200.0), 100.0)]);
    cases.push(("beside the eye".into(), beside, Camera { heading_deg: 0.0, ..Camera::free(DVec3::ZERO) }));
    let mut airy = scene.clone();
    airy.ground = None;
    cases.push((
        "down without ground".into(),
        airy,
        Camera { pitch_deg: -90.0, ..Camera::free(DVec3::new(0.0, 900.0, 0.0)) },
    ));
    cases.push(("near plane, eye in a sprite, 50 km, 1 cm".into(), scene.clone(), scene.cameras[0].clone()));
    cases
}

/// Largest difference of clouds drawn fast, without stopping, and plainly.
///
/// The fast one filters with weights of 15 bits: up to 2⁻¹⁵ for each of four texels, in alpha and colour, at two mip
/// levels. What n layers add up to is bounded by the sum of what each lets through, at most 1/α of the thinnest that
/// matter; with 8 layers' worth: 8 · 4 · 2⁻¹⁵ ≈ 10⁻³. Light up to 2 doubles it.
pub const FAST_IS_PLAIN: f32 = 2e-3;

/// Clouds over sky and ground, in bytes.
#[test]
fn whole_pictures_agree() {
    let scene = heap(40);
    with_frame(&scene, &scene.cameras[0], [1280, 720], |frame| {
        let off = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
        let (fast, plain) = (fast::picture_by(frame, Blending::AS_PLAIN), plain::picture(frame));
        let worst = fast.pixels.iter().zip(&plain.pixels).map(off).max();
        assert!(worst <= Some(2), "{worst:?}");
    });
}

#[test]
fn fast_is_plain() {
    for (name, scene, camera) in cases() {
        with_frame(&scene, &camera, SIZE, |frame| {
            let plain = plain::clouds(frame);
            let difference = largest_difference(&fast::clouds(frame, Blending::AS_PLAIN), &plain);
            assert!(difference <= FAST_IS_PLAIN, "{name}: {difference}");
            // Another order of the same products: some units in the last place of 2⁻²⁴, for each of the layers.
            let difference = largest_difference(&fast::clouds_one_by_one(frame, Blending::AS_PLAIN), &plain);
            assert!(difference <= 1e-5, "{name}, one by one: {difference}");
        });
    }
}

#[test]
fn backgrounds_agree() {
    for (name, mut scene, camera) in cases() {
        // Without clouds, in a size where the sky is interpolated between nodes.
        scene.clouds.clear();
        with_frame(&scene, &camera, [1280, 720], |frame| {
            let (fast, plain) = (fast::picture_by(frame, Blending::AS_PLAIN), plain::picture(frame));
            let off = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
            let worst = fast.pixels.iter().zip(&plain.pixels).map(off).max().unwrap_or(0);
            // The sky between nodes is within 0.5 %, under one step of 8 bits; rounding may add another.
            assert!(worst <= 2, "{name}: off by {worst}");
        });
    }
}

/// The early stop leaves 99.9 % of pixels within one step of 8 bits.
#[test]
fn stopping_early_does_not_show() {
    for (name, scene, camera) in cases() {
        with_frame(&scene, &camera, SIZE, |frame| {
            let whole = Blending { stop_below: NEVER_STOP, ..Blending::SHIPPED };
            let (stopped, whole) = (fast::picture(frame), fast::picture_by(frame, whole));
            let seen = stopped
                .pixels
                .iter()
                .zip(&whole.pixels)
                .filter(|(a, b)| (0..3).any(|c| a[c].abs_diff(b[c]) > 1))
                .count();
            assert!(seen * 1000 <= stopped.pixels.len(), "{name}: {seen} of {} pixels", stopped.pixels.len());
        });
    }
}

#[test]
fn same_bytes_on_any_number_of_threads() {
    let scene = authoring::SCENES[1].1();
    let draw = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| with_frame(&scene, &scene.cameras[0], SIZE, fast::picture))
    };
    let one = draw(1);
    for threads in [1, 2, 3, 7] {
        assert!(draw(threads) == one, "{threads} threads");
    }
}

/// Opacity does not depend on order; and a scene far from the origin looks as at the origin.
#[test]
fn a_scene_moved_a_thousand_kilometres_looks_the_same() {
    let scene = heap(40);
    let mut moved = scene.clone();
    let shift = DVec3::new(1e6, 0.0, -1e6);
    moved.clouds[0].position += shift;
    let mut camera = scene.cameras[0].clone();
    let near = with_frame(&scene, &camera, SIZE, fast::picture);
    camera.position += shift;
    let far = with_frame(&moved, &camera, SIZE, fast::picture);
    let off = near.pixels.iter().zip(&far.pixels).flat_map(|(a, b)| (0..3).map(|c| a[c].abs_diff(b[c]))).max();
    assert!(off <= Some(1), "{off:?}");
}

#[test]
fn any_size_of_picture() {
    let scene = heap(10);
    for size in [[1, 1], [1, 300], [300, 1], [33, 31], [1281, 41], [2000, 3]] {
        with_frame(&scene, &scene.cameras[0], size, |frame| {
            assert_eq!(fast::picture(frame).pixels.len(), (size[0] * size[1]) as usize);
            let difference = largest_difference(&fast::clouds(frame, Blending::AS_PLAIN), &plain::clouds(frame));
            assert!(difference <= FAST_IS_PLAIN, "{size:?}: {difference}");
        });
    }
}

/// A sprite is sampled where its plane lies, also one that is mostly beside the picture, whose centre may lie thousands
/// of pixels from it.
///
/// Linear functions are no larger in the picture than its longest ray R, times ½ + 2·distance/extent for a coordinate:
/// their three terms are then at most five times that, each off by three roundings of 2⁻²⁴ and their sums by two.
#[test]
fn sprites_are_hit_where_they_lie() {
    let scene = heap(25);
    let derived = Derived::new(&scene);
    let mut checked = 0;
    for index in 0..200 {
        let roll = |number: u32, from: f64, to: f64| from + (to - from) * unit(draw(7, 0, index, number)[0]);
        let camera = Camera {
            heading_deg: roll(0, 0.0, 360.0),
            pitch_deg: roll(1, -90.0, 90.0),
            field_of_view_deg: roll(2, 40.0, 150.0),
            ..Camera::free(DVec3::new(roll(3, -300.0, 300.0), roll(4, 900.0, 1200.0), roll(5, -300.0, 300.0)))
        };
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&camera, [90, 40]));
        let view = &frame.view;
        let longest = f64::from(view.ray(0.0, 0.0).length());
        for (drawn, on_screen) in frame.list.sprites.iter().zip(prepare(&frame)) {
            let posed = frame.posed(drawn);
            let facing = posed.facing;
            let normal = -facing.right.cross(facing.up).as_dvec3();
            let center = drawn.center.as_dvec3();
            for (x, y) in (0..9).flat_map(|x| (0..4).map(move |y| (5.5 + 10.0 * x as f32, 5.5 + 10.0 * y as f32))) {
                let Some(hit) = on_screen.hit(x, y) else { continue };
                let pixel = f64::from(view.pixel());
                let ray = view.forward.as_dvec3()
                    + view.right.as_dvec3() * ((f64::from(x) - 45.0) * pixel)
                    + view.up.as_dvec3() * ((20.0 - f64::from(y)) * pixel);
                let denominator = ray.dot(normal);
                let from_center = ray * (normal.dot(center) / denominator) - center;
                for (got, axis, extent) in
                    [(hit.u, facing.right, posed.sprite.width), (hit.v, -facing.up, posed.sprite.height)]
                {
                    let extent = f64::from(extent);
                    let wanted = 0.5 + from_center.dot(axis.as_dvec3()) / extent;
                    let terms = 5.0 * longest * (1.5 + 2.0 * center.length() / extent) / denominator;
                    let most = 5.0 * 0.5f64.powi(24) * (terms + 1.0);
                    let off = (f64::from(got) - wanted).abs();
                    assert!(off <= most, "{camera:?}, sprite {}: {off:e} off, {most:e} at most", drawn.sprite);
                    checked += 1;
                }
            }
            let begin = f64::from(on_screen.denominator.at_anchor.abs());
            assert!(begin <= 1.00001 * longest, "{begin} at the anchor {}, {longest} at most", on_screen.anchor);
        }
    }
    assert!(checked > 10_000, "{checked}");
}
