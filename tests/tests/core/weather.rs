//! A scene at a moment: what the clock and another hour make of it, and what of a cloud moves with it.

mod moving;

use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::{FACES_EYE, Run};
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::{fast, plain, prepare, truth};
use cloudwright_core::rules::Blending;
use cloudwright_core::scene::{Formation, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{Moment, SceneNow, WeatherRules};
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

const SIZE: [u32; 2] = [64, 36];

/// What the scene's first camera sees of it, after `change` has been made to the scene as it is now.
fn seen<T>(scene: &Scene, moment: Moment, change: fn(&mut SceneNow<'_>), f: impl FnOnce(&Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    let mut now = SceneNow::new(scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
    change(&mut now);
    f(&Frame::of(now, &derived, Atlas::built_in(), &Sight::still(&scene.cameras[0], SIZE)))
}

fn at_rest(_: &mut SceneNow<'_>) {}

/// Another hour is that of a scene which has it; the clock does not move the sun.
#[test]
fn an_hour_is_looked_at_in_place_of_the_scenes_own() {
    let scene = heap(20);
    let saved = Scene { time_of_day_h: 19.5, ..scene.clone() };
    let looked_at = seen(&scene, Moment::at_hour(19.5), at_rest, fast::picture);
    assert!(looked_at == seen(&saved, Moment::default(), at_rest, fast::picture));
    assert!(looked_at != seen(&scene, Moment::default(), at_rest, fast::picture));
    assert!(looked_at == seen(&saved, Moment::at(1000.0), at_rest, fast::picture), "nothing forms");
}

#[test]
fn clouds_form_by_the_clock() {
    let mut scene = heap(20);
    scene.clouds[0].formation = Some(Formation { core_s: 4.0, edges_s: 6.0, ..Formation::default() });
    let count = |clock_s| seen(&scene, Moment::at(clock_s), at_rest, |frame| frame.list.sprites.len());
    assert_eq!(count(0.0), 0, "it has not begun");
    assert!(count(3.0) > 0);
    let whole = seen(&heap(20), Moment::default(), at_rest, fast::picture);
    assert!(seen(&scene, Moment::at(3.0), at_rest, fast::picture) != whole);
    assert!(seen(&scene, Moment::at(10.0), at_rest, fast::picture) == whole);
}

/// A cloud that has been carried is drawn as one that is placed there: what faces, sorts, bounds and lights it goes along.
#[test]
fn a_carried_cloud_is_as_one_that_is_placed_there() {
    let scene = heap(30);
    // Whole metres are exact in f64, so only the last bit of an f32 may differ, and of a colour the last step.
    let by = DVec3::new(-40.0, 24.0, 620.0);
    let mut placed = scene.clone();
    placed.clouds.iter_mut().for_each(|cloud| cloud.position += by);
    let carry: fn(&mut SceneNow<'_>) =
        |now| now.clouds.iter_mut().for_each(|cloud| cloud.displacement = DVec3::new(-40.0, 24.0, 620.0));
    let [carried, there, rest] = [(&scene, carry), (&placed, at_rest as _), (&scene, at_rest as _)]
        .map(|(scene, change)| seen(scene, Moment::default(), change, fast::picture));
    let steps = carried.as_bytes().iter().zip(there.as_bytes()).map(|(a, b)| a.abs_diff(*b));
    assert!(steps.max() <= Some(1));
    assert!(carried != rest);
}

#[test]
fn heights_grow_from_the_bottom() {
    seen(
        &heap(30),
        Moment::default(),
        |now| now.clouds[0].growth = 2.0,
        |frame| {
            let cloud = &frame.now.clouds[0];
            let (bottom, rest) = (cloud.placed.bottom, seen(&heap(30), Moment::default(), at_rest, |f| f.view.eye));
            assert_eq!(frame.view.eye, rest);
            for (index, sprite) in cloud.placed.sprites.iter().enumerate() {
                let now = cloud.sprite_now(index).position;
                let height = 2.0 * (sprite.position.y - bottom);
                assert!((now.y - bottom - height).abs() <= 1e-4 * height, "{now} of {}", sprite.position);
                assert_eq!((now.x, now.z), (sprite.position.x, sprite.position.z));
            }
            // The sphere that the view asks for holds them all.
            for drawn in &frame.list.sprites {
                let sprite = cloud.sprite_now(drawn.sprite as usize);
                let from_center = sprite.position.distance(cloud.center_now());
                assert!(from_center + sprite.reach() <= cloud.reach_now() * 1.0001);
            }
        },
    );
}

/// At rest, to the last bit.
#[test]
fn what_is_at_rest_is_where_it_was_placed() {
    seen(&heap(30), Moment::at(7.5), at_rest, |frame| {
        let cloud = &frame.now.clouds[0];
        assert_eq!(cloud.origin(), cloud.placed.origin);
        for (index, sprite) in cloud.placed.sprites.iter().enumerate() {
            assert_eq!(
                cloud.sprite_now(index).position.to_array().map(f32::to_bits),
                sprite.position.to_array().map(f32::to_bits)
            );
        }
    });
}

/// The alpha in the middle of the picture, of one sprite that faces the eye far off.
fn alpha_in_the_middle(change: fn(&mut SceneNow<'_>), of_list: fn(&mut Frame<'_>)) -> [f32; 2] {
    let scene = single_sprites(&[(DVec3::new(0.0, 0.0, -500.0), 200.0)]);
    seen(&scene, Moment::default(), change, |frame| {
        let mut frame = frame.clone();
        of_list(&mut frame);
        let middle = (SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize;
        [fast::clouds(&frame, Blending::AS_PLAIN), plain::clouds(&frame)].map(|layer| layer.pixels[middle].a)
    })
}

#[test]
fn a_faded_cloud_is_that_much_clearer() {
    let whole = alpha_in_the_middle(at_rest, |_| ());
    let half = alpha_in_the_middle(|now| now.clouds[0].opacity = 0.5, |_| ());
    for (whole, half) in whole.into_iter().zip(half) {
        assert!(whole > 0.1 && (half - 0.5 * whole).abs() < 1e-3, "{half} of {whole}");
    }
    let gone = |now: &mut SceneNow<'_>| now.clouds[0].opacity = 0.0;
    assert!(seen(&heap(20), Moment::default(), gone, |frame| frame.list.sprites.is_empty()));
}

/// Each run fades by itself, and the truth takes the sprites as they are.
#[test]
fn runs_fade_each_by_itself() {
    let scene = heap(30);
    seen(&scene, Moment::default(), at_rest, |frame| {
        let runs = |from: usize, fades: [f32; 2]| {
            let mut frame = frame.clone();
            frame.list.runs = vec![Run::Sprites { from: 0, fade: fades[0] }, Run::Sprites { from, fade: fades[1] }];
            frame
        };
        let half = frame.list.sprites.len() / 2;
        let one = prepare(frame);
        assert!(prepare(&runs(half, [1.0, 1.0])) == one, "two whole runs are one");
        let faded = prepare(&runs(half, [0.25, 0.5]));
        assert_eq!(faded.len(), one.len());
        for (at, (faded, whole)) in faded.iter().zip(&one).enumerate() {
            let fade = if at < half { 0.25 } else { 0.5 };
            for (faded, whole) in faded.corners.iter().zip(&whole.corners) {
                assert_eq!(faded[..3], whole[..3], "its light stays");
                assert!((faded[3] - fade * whole[3]).abs() <= 1e-6, "{} of {}, {fade}", faded[3], whole[3]);
            }
        }
        // The near half alone is what is left when the far one has faded away.
        let mut near = frame.clone();
        near.list.sprites.drain(..half);
        let (gone, near) = (runs(half, [0.0, 1.0]), near);
        for draw in [plain::clouds, |frame: &Frame<'_>| fast::clouds(frame, Blending::AS_PLAIN)] {
            assert!(draw(&gone) == draw(&near));
        }
        let truth = |frame: &Frame<'_>| truth::linear_picture(frame, 1, &Watch::default());
        assert!(truth(&gone) == truth(frame), "the truth knows no stand-ins");
        assert!(frame.list.sprites.iter().any(|drawn| drawn.pose == FACES_EYE));
    });
}
