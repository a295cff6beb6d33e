//! What wrong order costs, against swapping neighbours one by one, and against a closed form.

use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::{WrongOrder, wrong_order};
use cloudwright_core::raster::{ScreenSprite, prepare, truth};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

type Fragment = (f32, [u32; 2], Premultiplied);

/// A ray's fragments, nearest first by the list's order.
fn listed(frame: &Frame<'_>, sprites: &[ScreenSprite], x: u32, y: u32) -> Vec<Fragment> {
    let fragment = |(sprite, drawn): (&ScreenSprite, &cloudwright_core::draw_list::DrawSprite)| {
        let (x, y) = (x as f32 + 0.5, y as f32 + 0.5);
        let (fragment, depth) = sprite.fragment(frame.atlas, x, y, |depth| sprite.mip_at(depth, 1.0))?;
        Some((depth, [drawn.cloud, drawn.sprite], fragment))
    };
    sprites.iter().zip(&frame.list.sprites).rev().filter_map(fragment).collect()
}

/// The pixel that fragments blend to, nearest first.
fn blended(fragments: &[Fragment]) -> [f64; 3] {
    let mut color = [0.0; 3];
    for (_, _, Premultiplied { r, g, b, a }) in fragments.iter().rev() {
        let through = 1.0 - f64::from(*a);
        color = std::array::from_fn(|c| f64::from([*r, *g, *b][c]) + through * color[c]);
    }
    color
}

fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

fn nearer(a: &Fragment, b: &Fragment) -> bool {
    a.0.total_cmp(&b.0).then(b.1.cmp(&a.1)).is_lt()
}

/// Wrong pairs' and all pairs' weights: the pixel is blended anew before and after each swap of neighbours.
///
/// From the farthest in the list on, each fragment sinks through all that the list has behind it, which are sorted
/// already; where it stops belonging farther down, the pairs are no longer wrong.
fn by_swapping(listed: &[Fragment]) -> [f64; 2] {
    let [mut wrong, mut all] = [0.0; 2];
    let mut pixel = listed.to_vec();
    for first in (0..listed.len()).rev() {
        let mut sinking = pixel.clone();
        for at in first..listed.len() - 1 {
            let before = blended(&sinking);
            sinking.swap(at, at + 1);
            let cost = apart(before, blended(&sinking));
            all += cost;
            if nearer(&sinking[at], &sinking[at + 1]) {
                wrong += cost;
                pixel = sinking.clone();
            }
        }
    }
    [wrong, all]
}

fn with_frame<T>(scene: &Scene, camera: &Camera, size: [u32; 2], f: impl FnOnce(Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    f(Frame::new(scene, &derived, Atlas::built_in(), &Sight::still(camera, size)))
}

/// Each pixel's cost within f32's roundings (a unit of 2⁻²⁴ a factor, for some hundred pairs of weights that sum to less
/// than 1) and what is not followed: twice 10⁻⁵ of the brightest colour, about 2.
fn check(name: &str, frame: &Frame<'_>) -> WrongOrder {
    const WITHIN: f64 = 5e-5;
    let got = wrong_order(frame);
    let sprites = prepare(frame);
    let [mut wrong_sum, mut all_sum] = [0.0; 2];
    for (i, cost) in (0..).zip(&got.cost.values) {
        let listed = listed(frame, &sprites, i % frame.view.width, i / frame.view.width);
        let [wrong, all] = by_swapping(&listed);
        assert!((f64::from(*cost) - wrong).abs() < WITHIN, "{name}, pixel {i}: {cost}, by swapping {wrong}");
        let mut by_depth = listed.clone();
        by_depth.sort_by(|a, b| if nearer(a, b) { std::cmp::Ordering::Less } else { std::cmp::Ordering::Greater });
        let error = apart(blended(&listed), blended(&by_depth));
        assert!(error < f64::from(*cost) + WITHIN, "{name}, pixel {i}: changed by {error}, said to cost {cost}");
        (wrong_sum, all_sum) = (wrong_sum + wrong, all_sum + all);
    }
    let share = if all_sum > 0.0 { wrong_sum / all_sum } else { 0.0 };
    assert!((got.share - share).abs() < 1e-3, "{name}: {}, by swapping {share}", got.share);
    got
}

#[test]
fn costs_what_swaps_cost() {
    let scene = heap(40);
    let inside = Camera { heading_deg: 30.0, ..Camera::free(DVec3::new(10.0, 1010.0, 5.0)) };
    with_frame(&scene, &inside, [20, 14], |frame| drop(check("inside", &frame)));
    let shares: Vec<f64> = [false, true]
        .into_iter()
        .map(|reversed| {
            with_frame(&scene, &scene.cameras[0], [32, 20], |mut frame| {
                if reversed {
                    frame.list.sprites.reverse();
                }
                check(if reversed { "reversed" } else { "sorted" }, &frame).share
            })
        })
        .collect();
    // Sorted by distance, a few pairs are wrong; the other way round, all but those few.
    assert!(shares[0] > 0.0 && shares[0] < 0.2 && shares[1] > 0.8, "{shares:?}");
}

/// Two quads that cross in the picture's middle, one white and one black, both of opacity α: the list has one before
/// the other, which is wrong on one side. There a swap costs α² times the difference of their colours.
#[test]
fn two_crossing_sprites() {
    let alpha: u8 = 153;
    let inside = |t: usize| (32..96).contains(&(t % 128));
    let texel = |i: usize| [255, 255, 255, if inside(i % 512) && inside(i / 512) { alpha } else { 0 }];
    let atlas = Atlas::from_sheet(&(0..512 * 512).map(texel).collect::<Vec<_>>());
    let at = |x: f64| (DVec3::new(x, 0.0, -60.0), 80.0);
    let mut scene = single_sprites(&[at(-8.0), at(8.0)]);
    scene.models[0].color_levels.iter_mut().for_each(|level| {
        (level.color.rgb, level.color.a) = (Rgb::BLACK, 1.0);
    });
    for (cloud_box, c) in scene.models[0].boxes.iter_mut().zip([0.0, 1.0]) {
        (cloud_box.light.c_min, cloud_box.light.c_med, cloud_box.light.c_max) = (c, c, c);
    }
    let derived = Derived::new(&scene);
    // An even width: no pixel's ray meets both quads at one depth.
    let frame = Frame::new(&scene, &derived, &atlas, &Sight::still(&scene.cameras[0], [100, 100]));
    let got = check("crossing", &frame);
    // By symmetry half of the pixels are wrong, and all weigh the same.
    assert!((got.share - 0.5).abs() < 1e-3, "{}", got.share);
    let colors: Vec<Rgb> =
        prepare(&frame).iter().map(|s| Rgb::new(s.corners[0][0], s.corners[0][1], s.corners[0][2])).collect();
    let differences = [colors[0].r - colors[1].r, colors[0].g - colors[1].g, colors[0].b - colors[1].b];
    let difference = differences.into_iter().map(f32::abs).fold(0.0, f32::max);
    let wanted = (f32::from(alpha) / 255.0).powi(2) * difference;
    let row = &got.cost.values[50 * 100..51 * 100];
    let (left, right) = (row[45], row[54]);
    assert!(left.min(right) == 0.0 && (left.max(right) - wanted).abs() < 1e-3, "{left} and {right}, not {wanted}");
}

/// Where nothing overlaps, or all has one colour, nothing is lost.
#[test]
fn nothing_to_lose() {
    let apart = single_sprites(&[(DVec3::new(-30.0, 0.0, -100.0), 20.0), (DVec3::new(30.0, 0.0, -90.0), 20.0)]);
    let mut dark = heap(12);
    dark.sky.haze_length_m = 1e9;
    dark.sky.ambient.keys.iter_mut().for_each(|key| key.value.rgb = Rgb::BLACK);
    dark.sky.directional.keys.iter_mut().for_each(|key| key.value = Rgb::BLACK);
    for (name, scene) in [("apart", apart), ("dark", dark)] {
        let got = with_frame(&scene, &scene.cameras[0], [40, 30], |frame| wrong_order(&frame));
        assert!(got.cost.largest() < 1e-4, "{name}: {got:?}");
    }
}

#[test]
fn same_bytes_on_any_number_of_threads() {
    let scene = heap(30);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| with_frame(&scene, &scene.cameras[0], [90, 70], |frame| wrong_order(&frame)))
    };
    let one = on(1);
    assert!(one.cost.largest() > 0.0);
    assert!([2, 3, 7].into_iter().all(|threads| on(threads) == one));
}

/// The truth with one sample a pixel and the list's own order differ by no more than the order is said to cost.
#[test]
fn bounds_the_error_against_the_truth() {
    let scene = heap(60);
    with_frame(&scene, &scene.cameras[0], [80, 60], |frame| {
        let got = wrong_order(&frame);
        assert!(got.cost.largest() > 0.01, "the scene has something to get wrong");
        let sprites = prepare(&frame);
        let truth = truth::linear_picture(&frame, 1, &Watch::default());
        for (i, cost) in (0..).zip(&got.cost.values) {
            let (x, y) = (i % 80, i / 80);
            let fragments = listed(&frame, &sprites, x, y);
            let a = fragments.iter().fold(1.0, |through, (_, _, fragment)| through * (1.0 - fragment.a));
            let ray = frame.view.ray(x as f32 + 0.5, y as f32 + 0.5);
            let behind = frame.background.color(ray, frame.view.pixel()) * a;
            let listed = blended(&fragments);
            let sorted = truth.pixels[i as usize].to_array();
            let error = apart(listed, std::array::from_fn(|c| f64::from(sorted[c] - behind.to_array()[c])));
            assert!(error < f64::from(*cost) + 5e-5, "pixel {i}: {error}, said to cost {cost}");
        }
    });
}
