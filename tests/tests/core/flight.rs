//! Flying through clouds: what ships stays within derived bounds where other ways fail, and a frame is the same however
//! it is come by.

use cloudwright_core::color::Rgba;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::facing::FacingRule;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::method::{METHODS, Method, shipped, truth};
use cloudwright_core::raster::{fast, plain};
use cloudwright_core::rules::Blending;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraPath, Formation, FormationChange, PathKey, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::variants::{Listing, SteppedFade};
use cloudwright_core::view_history::{Playback, ViewHistory};
use cloudwright_core::weather::{Formed, Moment};
use cloudwright_tests::small_scenes::heap;
use cloudwright_tests::suite::heap_flights::through;
use cloudwright_tests::suite::{Figure, Stage};
use glam::DVec3;
use std::sync::Arc;

/// In a cloud of one colour the order costs nothing, and what is left beyond the truth's own changes is what locking and
/// fading do. Straight through, every other way is more than twice as far off.
#[test]
fn pixels_follow_the_truth() {
    let mut stage = Stage { size: [48, 27], ..through(400.0) };
    (0..).zip(&mut stage.looks).for_each(|(step, look)| look.drawn = step % 3 == 0);
    for model in &mut stage.scene.models {
        model.color_levels.iter_mut().for_each(|level| level.color = Rgba::new(1.0, 1.0, 1.0, 0.9));
        for cloud_box in &mut model.boxes {
            (cloud_box.light.c_min, cloud_box.light.c_med, cloud_box.light.c_max) = (0.3, 0.3, 0.3);
        }
    }
    // As many samples as the others take: how finely a pixel is sampled is another matter.
    let truths = stage.draw(&Rules { samples_side: 1, ..truth().rules }).expect("on the CPU");
    let excess = |method: &Method| {
        let pictures = stage.draw(&method.rules).expect("on the CPU");
        Figure::Excess.of(&stage, &method.rules, &pictures, &truths).expect("pictures of one size")
    };
    let shipped_excess = excess(shipped());
    // The truth fades alike. What is left is its filter: a quarter of a mip level more or less blur, of a tile whose
    // neighbouring levels differ by up to 0.4 of opacity where it frays, in either frame.
    assert!(shipped_excess < 2.0 * 0.25 * 0.4, "{shipped_excess}");
    for method in METHODS.iter().filter(|method| method.rules.facing != FacingRule::BOUNDED) {
        let other = excess(method);
        assert!(2.0 * shipped_excess < other, "{}: {other}, shipped {shipped_excess}", method.name);
    }
}

/// Into a heap and out again, with a turn of the head.
fn path(by: DVec3) -> CameraPath {
    let key = |time_s: f64, z: f64, heading_deg: f64| PathKey {
        time_s,
        position: DVec3::new(-80.0, 1010.0, z) + by,
        heading_deg,
        pitch_deg: 3.0,
        roll_deg: 0.0,
    };
    CameraPath::free(vec![key(0.0, 300.0, 0.0), key(3.0, 20.0, 20.0), key(6.0, -250.0, -10.0)])
}

fn frame_of<'a>(
    scene: &Scene,
    derived: &'a Derived,
    (camera, clock_s): (&Camera, f64),
    history: &Arc<ViewHistory>,
) -> Frame<'a> {
    let (moment, history) = (Moment::at(clock_s), Arc::clone(history));
    Frame::new(scene, derived, Atlas::built_in(), &Sight { moment, history, ..Sight::still(camera, [64, 36]) })
}

fn picture(scene: &Scene, derived: &Derived, playback: &mut Playback, t_s: f64) -> Picture {
    let (camera, history) = playback.seek(derived, t_s);
    fast::picture(&frame_of(scene, derived, (&camera, t_s), history))
}

#[test]
fn a_frame_is_the_same_alone_or_in_sequence() {
    let mut scene = heap(30);
    scene.clouds[0].formation = Some(Formation { core_s: 4.0, edges_s: 6.0, ..Formation::default() });
    let derived = Derived::new(&scene);
    for sorting in [Sorting::EachFrame, Sorting::Crossfade] {
        let new = || Playback::new(&path(DVec3::ZERO), Rules { sorting, ..Rules::SHIPPED });
        let mut in_sequence = new();
        let mut locked = 0;
        let whole: Vec<Picture> =
            (0..=150).map(|i| picture(&scene, &derived, &mut in_sequence, f64::from(i) / 30.0)).collect();
        let mut alone = new();
        for i in (100..=120).rev() {
            let t_s = i as f64 / 30.0;
            assert!(picture(&scene, &derived, &mut alone, t_s) == whole[i], "frame {i}, {sorting:?}");
            locked += alone.seek(&derived, t_s).1.facing.sprite_count();
        }
        assert!(locked > 0, "the flight goes through sprites");
    }
}

/// Going back starts from a state that was kept; what it finds is what a flight from the start finds.
#[test]
fn going_back_is_as_going_there() {
    let derived = Derived::new(&heap(30));
    let mut slow = path(DVec3::ZERO);
    slow.keys.iter_mut().for_each(|key| key.time_s *= 5.0);
    for sorting in [Sorting::EachFrame, Sorting::Crossfade] {
        let new = || Playback::new(&slow, Rules { sorting, ..Rules::SHIPPED });
        let mut scrubbed = new();
        for t_s in [29.0, 12.0, 20.0, 3.0, 9.99, 10.0, 30.0, 0.0, 10.02] {
            let there = scrubbed.seek(&derived, t_s).1.clone();
            assert!(there == *new().seek(&derived, t_s).1, "{t_s} s, {sorting:?}");
        }
    }
}

/// By whole periods of the ground, 1,000 km to the east and south.
#[test]
fn far_from_the_origin_it_is_the_same_flight() {
    let by = DVec3::new(1.0e6, 0.0, 1.0e6);
    let near = heap(30);
    let mut far = near.clone();
    far.clouds[0].position += by;
    let [derived, derived_far] = [&near, &far].map(Derived::new);
    let [mut playback, mut playback_far] = [DVec3::ZERO, by].map(|by| Playback::new(&path(by), Rules::SHIPPED));
    for i in 0..=12 {
        let t_s = f64::from(i) * 0.5;
        let a = picture(&near, &derived, &mut playback, t_s);
        let b = picture(&far, &derived_far, &mut playback_far, t_s);
        let off = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).map(|c| a[c].abs_diff(b[c])).max().unwrap_or(0);
        assert!(a.pixels.iter().zip(&b.pixels).map(off).max() <= Some(1), "at {t_s} s");
    }
}

/// With locked sprites, a veil, and one order fading into another, the fast renderer is still the plain one (raster.rs
/// has the tolerance).
#[test]
fn inside_a_cloud_fast_is_plain() {
    let scene = heap(40);
    let derived = Derived::new(&scene);
    let mut playback = Playback::new(&path(DVec3::ZERO), Rules { sorting: Sorting::Crossfade, ..Rules::SHIPPED });
    let (mut veiled, mut faded) = (0, 0);
    for i in 0..24 {
        let t_s = f64::from(i) * 0.25;
        let (camera, history) = playback.seek(&derived, t_s);
        let frame = frame_of(&scene, &derived, (&camera, t_s), history);
        veiled += usize::from(frame.veil.a > 0.05);
        faded += usize::from(frame.fading.is_some());
        let (fast, plain) = (fast::clouds(&frame, Blending::AS_PLAIN), plain::clouds(&frame));
        for (a, b) in fast.pixels.iter().zip(&plain.pixels) {
            let apart = [a.r - b.r, a.g - b.g, a.b - b.b, a.a - b.a].map(f32::abs).into_iter().fold(0.0, f32::max);
            assert!(apart <= 2e-3, "{t_s} s: {a:?} for {b:?}");
        }
    }
    assert!(veiled > 2 && faded > 2, "{veiled} frames with a veil, {faded} that fade");
}

/// Whatever the frame rate, through a stall of 30 s and backwards, the closed form gives the same; the listings don't.
#[test]
fn forming_does_not_depend_on_steps() {
    let formation = Formation { core_s: 3.0, edges_s: 4.0, start_s: 1.0, ..Formation::default() };
    for change in [FormationChange::Forming, FormationChange::Dissipating] {
        let formation = Formation { change, ..formation };
        let at = |clock_s: f64| Formed::at(Some(&formation), clock_s);
        for steps_a_second in [10, 60, 240] {
            let mut forwards = Vec::new();
            let mut clock_s = 0.0;
            for _ in 0..8 * steps_a_second {
                forwards.push((clock_s, at(clock_s)));
                clock_s += 1.0 / f64::from(steps_a_second);
            }
            let stalled = at(clock_s + 30.0);
            for (clock_s, formed) in forwards.into_iter().rev() {
                assert!((at(clock_s).opacity(0.3) - formed.opacity(0.3)).abs() < 1e-6);
            }
            let end = if change == FormationChange::Forming { 1.0 } else { 0.0 };
            assert_eq!(stalled.opacity(0.9), end);
        }
    }
    let listing = |listing, steps_a_second: u32, seconds: f32, radii: f32| {
        let mut fade = SteppedFade::new(listing);
        let delta_s = 1.0 / steps_a_second as f32;
        (0..(seconds * steps_a_second as f32) as u32).for_each(|_| fade.step(delta_s, 2.95));
        fade.opacity(radii)
    };
    let centre_and_edge = |which| [0.0, 1.0].map(|radii| listing(which, 60, 1.5, radii));
    assert!(matches!(centre_and_edge(Listing::AsPrinted), [Some(a), Some(b)] if a < b), "its edge comes first");
    assert_eq!(listing(Listing::AsPrinted, 60, 4.0, 0.5), None, "it is left unset");
    assert!(matches!(centre_and_edge(Listing::Mended), [Some(a), Some(b)] if a > b));
    let reached = [10, 60, 240].map(|rate| listing(Listing::Mended, rate, 4.0, 0.5).unwrap_or(0.0));
    assert!(reached[0] > 1.01 && (reached[0] - reached[2]).abs() > 1e-2, "it overshoots by its step: {reached:?}");
}

/// What two opposite half-chords from inside a cloud hide is what the whole chord hides from outside. Without the veil
/// much of it is missing; with it, it is there again, within what a ball of uniform depth stands for: sprites before and behind
/// the eye give all of theirs, those beside it, a good third, some 0.4 of it.
#[test]
fn the_veil_brings_back_what_is_missing_inside() {
    let mut scene = heap(40);
    for model in &mut scene.models {
        // Thin, so that depths can be told from opacities.
        model.color_levels.iter_mut().for_each(|level| level.color.a = 0.15);
    }
    let depth_towards = |scene: &Scene, position: DVec3, heading_deg: f64| -> f64 {
        let derived = Derived::new(scene);
        let camera = Camera { heading_deg, field_of_view_deg: 4.0, ..Camera::free(position) };
        let layer = plain::clouds(&frame_of(scene, &derived, (&camera, 0.0), &Arc::default()));
        let alpha = layer.pixels.iter().map(|pixel| f64::from(pixel.a)).sum::<f64>() / layer.pixels.len() as f64;
        -(1.0 - alpha).ln()
    };
    let mut clear = scene.clone();
    clear.sky.inside_density = 0.0;
    let (mut outside, mut veiled, mut bare) = (0.0, 0.0, 0.0);
    for (i, heading_deg) in (0..12).map(|i| (i, 30.0 * f64::from(i))) {
        let inside = DVec3::new(-60.0 + 10.0 * f64::from(i), 1000.0 + 4.0 * f64::from(i), 5.0);
        let turned = heading_deg.to_radians();
        let back = DVec3::new(-turned.sin(), 0.0, turned.cos()) * 900.0;
        outside += depth_towards(&scene, inside + back, heading_deg);
        for way in [heading_deg, heading_deg + 180.0] {
            veiled += depth_towards(&scene, inside, way);
            bare += depth_towards(&clear, inside, way);
        }
    }
    assert!(bare < 0.8 * outside, "without a veil {bare} of {outside}");
    assert!((0.7..=1.25).contains(&(veiled / outside)), "with one {veiled} of {outside}, {bare} without");
}
