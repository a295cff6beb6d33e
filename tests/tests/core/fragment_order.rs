//! Fragments in their own order: the fast renderer against each pixel's fragments, all of them sorted.

use crate::raster::{FAST_IS_PLAIN, cases, largest_difference, with_frame};
use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Layer;
use cloudwright_core::raster::{fast, plain, prepare};
use cloudwright_core::rules::{Blending, FragmentOrder, NEVER_STOP};
use cloudwright_core::scene::Camera;
use cloudwright_tests::small_scenes::single_sprites;
use glam::DVec3;

/// Small: each pixel's fragments are all sorted.
const SIZE: [u32; 2] = [108, 60];

const TO_THE_LAST: Blending = Blending { stop_below: NEVER_STOP, order: FragmentOrder::OfTheirOwn };

/// All fragments of each pixel's centre by their depth, equally deep ones as the list has them.
fn sorted(frame: &Frame<'_>) -> Layer {
    let sprites = prepare(frame);
    let (width, height) = (frame.view.width, frame.view.height);
    let pixel = |i: u32| {
        let (x, y) = ((i % width) as f32 + 0.5, (i / width) as f32 + 0.5);
        let hits = sprites.iter().rev().filter_map(|sprite| sprite.fragment(frame.atlas, x, y, |_| sprite.mip));
        let mut fragments: Vec<(Premultiplied, f32)> = hits.collect();
        fragments.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        let mut pixel = frame.veil;
        fragments.iter().for_each(|(fragment, _)| plain::put_behind(&mut pixel, *fragment));
        pixel
    };
    Layer { width, height, pixels: (0..width * height).map(pixel).collect() }
}

/// Four sprites from all sides and from within: a queue of four puts any four in order, so every pixel is right.
#[test]
fn as_many_as_a_queue_holds_are_in_order() {
    let places = [[0.0, 0.0, 0.0], [24.0, 5.0, -8.0], [-20.0, 13.0, 9.0], [8.0, -18.0, 14.0]];
    let mut scene = single_sprites(&places.map(|place| (DVec3::from(place), 100.0)));
    // Stripes of black and white, so that the order shows.
    for (level, light) in scene.models[0].color_levels.iter_mut().zip([0.0, 1.0, 0.0, 1.0, 0.0]) {
        level.color.rgb = Rgb::grey(light);
    }
    let mut by_sprites_at_worst = 0.0_f32;
    for turn in 0..12 {
        let heading_deg = f64::from(turn) * 30.0;
        let away = DVec3::new(-heading_deg.to_radians().sin(), 0.0, heading_deg.to_radians().cos());
        for distance_m in [2000.0, 300.0, 90.0, 20.0] {
            let camera = Camera { heading_deg, ..Camera::free(away * distance_m) };
            with_frame(&scene, &camera, SIZE, |frame| {
                let sorted = sorted(frame);
                for (how, drawn) in [
                    ("eight at once", fast::clouds(frame, TO_THE_LAST)),
                    ("one by one", fast::clouds_one_by_one(frame, TO_THE_LAST)),
                ] {
                    let difference = largest_difference(&drawn, &sorted);
                    assert!(difference <= FAST_IS_PLAIN, "{heading_deg}°, {distance_m} m, {how}: {difference}");
                }
                by_sprites_at_worst = by_sprites_at_worst.max(largest_difference(&plain::clouds(frame), &sorted));
            });
        }
    }
    assert!(by_sprites_at_worst > 10.0 * FAST_IS_PLAIN, "nothing crosses: {by_sprites_at_worst}");
}

/// Where more cross than a queue holds, some stay out of place: colours come nearer to the sorted ones all the same, and
/// opacity, which depends on no order, is the plain renderer's.
#[test]
fn many_come_nearer_to_it() {
    for (name, scene, camera) in cases().into_iter().step_by(2) {
        with_frame(&scene, &camera, SIZE, |frame| {
            let (sorted, plain) = (sorted(frame), plain::clouds(frame));
            for (how, drawn) in [
                ("eight at once", fast::clouds(frame, TO_THE_LAST)),
                ("one by one", fast::clouds_one_by_one(frame, TO_THE_LAST)),
            ] {
                let [ours, by_sprites] = [&drawn, &plain].map(|layer| mean_difference(layer, &sorted));
                assert!(ours <= by_sprites + f64::from(FAST_IS_PLAIN), "{name}, {how}: {ours} {by_sprites}");
                let opacity =
                    drawn.pixels.iter().zip(&plain.pixels).map(|(a, b)| (a.a - b.a).abs()).fold(0.0, f32::max);
                assert!(opacity <= FAST_IS_PLAIN, "{name}, {how}: opacity {opacity}");
            }
        });
    }
}

/// Mean over pixels of red's difference.
fn mean_difference(a: &Layer, b: &Layer) -> f64 {
    let apart = a.pixels.iter().zip(&b.pixels).map(|(a, b)| f64::from((a.r - b.r).abs()));
    apart.sum::<f64>() / a.pixels.len() as f64
}
