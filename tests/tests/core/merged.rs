//! Merged sprites: each stands for its own and for all of them, where and as large as they are, and nothing pops where one
//! takes their place.

use cloudwright_core::derived::Derived;
use cloudwright_core::detail::Detail;
use cloudwright_core::draw;
use cloudwright_core::draw_list::{DrawList, FACES_EYE};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip, overdraw_map};
use cloudwright_core::random::{draw as random, unit};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{BoxId, Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::{Atlas, Candidate, Merging};
use cloudwright_core::watch::Watch;
use cloudwright_tests::small_scenes::heap;
use cloudwright_tests::{authoring, laid_out};
use glam::DVec3;
use std::collections::BTreeSet;

const SIZE: [u32; 2] = [160, 90];

/// Squares of one tile, strewn over a slab.
fn strewn(count: u32) -> Vec<Candidate> {
    let sprite = |index: u32| {
        let [x, y, z, side] = random(3, 7, index, 0).map(unit);
        Candidate {
            box_id: BoxId(1),
            index,
            position: DVec3::new(800.0 * x, 200.0 * y, 500.0 * z),
            width: 40.0 + 60.0 * side,
            height: 40.0 + 60.0 * side,
            rotation: 0.0,
            tile: if index % 11 == 3 { 3 } else { 5 },
            moved: false,
            group: None,
            lump: 0,
        }
    };
    (0..count).map(sprite).collect()
}

/// Every sprite is stood for once at each step down, by one that is no farther from it than it says.
#[test]
fn each_part_is_stood_for_once() {
    for count in [0, 1, 2, 5, 6, 12, 13, 500, 3000] {
        let sprites = strewn(count);
        let Merging { merged, order } = &Merging::new(&sprites);
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..count).collect::<Vec<_>>());
        assert_eq!(merged.is_empty(), count < 2);
        assert!(merged.first().is_none_or(|all| all.of == (0..count)));
        assert!(merged.len() <= sprites.len() * 2 / 3 + 1, "{} of {count}", merged.len());
        for whole in merged {
            let mut next = whole.of.start;
            for part in &merged[whole.parts.start as usize..whole.parts.end as usize] {
                assert_eq!(part.of.start, next);
                let of = &order[part.of.start as usize..part.of.end as usize];
                let flat = of.iter().filter(|at| sprites[**at as usize].tile == 3).count();
                assert!(flat == 0 || flat == of.len(), "a base keeps for itself");
                assert!(of.len() >= 2 || part.sprite == sprites[of[0] as usize], "one stands for itself");
                next = part.of.end;
            }
            assert!(next == whole.of.end || whole.parts.is_empty());
            let of = &order[whole.of.start as usize..whole.of.end as usize];
            assert!(of.contains(&whole.foremost));
            let off = of.iter().map(|at| sprites[*at as usize].position.distance(whole.sprite.position));
            let farthest = off.fold(0.0, f64::max);
            assert!((farthest - f64::from(whole.reach_m)).abs() < 1e-3);
            assert!(whole.spread_m <= whole.reach_m);
        }
    }
}

/// Two alike, a side apart: in the middle, as wide as both by second moments, no higher than one.
#[test]
fn two_become_one_as_wide_as_they_are() {
    let mut pair = strewn(2);
    for (sprite, x) in pair.iter_mut().zip([0.0, 60.0]) {
        (sprite.position, sprite.width, sprite.height) = (DVec3::new(x, 10.0, 0.0), 60.0, 60.0);
        sprite.tile = 5;
    }
    let merging = Merging::new(&pair);
    let [one] = &merging.merged[..] else { panic!("one of two") };
    assert!(one.sprite.position.distance(DVec3::new(30.0, 10.0, 0.0)) < 1e-9);
    assert!((one.spread_m - 30.0).abs() < 1e-4);
    // Across is the mean of two axes: half of 30² m² is added to what the sprites spread over, 30 m times the tile's share.
    let own = (30.0 * f64::from(Atlas::built_in().spread(5))).powi(2);
    let wanted = ((450.0 + own) / own).sqrt();
    assert!((one.sprite.width / one.sprite.height - wanted).abs() < 1e-6);
    // Where they lie on one another there is one as large, but for what covers more of it.
    pair[1].position = pair[0].position;
    let one = &Merging::new(&pair).merged[0];
    let area = one.sprite.width * one.sprite.height / (60.0 * 60.0);
    assert!((1.0..=1.3 + 1e-9).contains(&area), "{area}");
    assert_eq!(one.spread_m, 0.0);
}

fn frame<'a>(scene: &Scene, derived: &'a Derived, metres: f64, detail: Detail) -> Frame<'a> {
    let mut camera = scene.cameras[0].clone();
    let middle = derived.clouds()[0].origin;
    camera.position = middle + DVec3::new(0.0, 0.0, metres);
    (camera.heading_deg, camera.pitch_deg) = (0.0, 0.0);
    let rules = Rules { detail, ..Rules::SHIPPED };
    Frame::new(scene, derived, Atlas::built_in(), &Sight { rules, ..Sight::still(&camera, SIZE) })
}

/// Near, all sprites are drawn and nothing else; far, fewer and fewer, at last one; hidden boxes leave all as it was.
#[test]
fn the_farther_the_fewer() {
    let mut scene = heap(200);
    scene.sky.haze_length_m = 1e9;
    let derived = Derived::new(&scene);
    let all = derived.clouds()[0].sprites.len();
    let counts: Vec<usize> = [300.0, 1e4, 3e4, 1e5, 1e6]
        .map(|metres| frame(&scene, &derived, metres, Detail::AUTOMATIC).list.sprites.len())
        .into();
    assert!(counts.is_sorted_by(|near, far| near >= far), "{counts:?}");
    assert_eq!(counts.last(), Some(&1));
    let near = |detail| frame(&scene, &derived, 150.0, detail).list;
    assert!(near(Detail::AUTOMATIC) == near(Detail::FULL), "near, all is drawn");
    assert_eq!(frame(&scene, &derived, 1e5, Detail::FULL).list.sprites.len(), all);
    let mut hiding = Sight::still(&scene.cameras[0], SIZE);
    hiding.camera.position.z += 1e5;
    hiding.rules.detail = Detail::AUTOMATIC;
    hiding.hidden.boxes = BTreeSet::from([BoxId(u64::MAX)]);
    let list = Frame::new(&scene, &derived, Atlas::built_in(), &hiding).list;
    assert!(list.sprites.iter().all(|drawn| (drawn.sprite as usize) < all));
    // Haze hides what they are off by.
    let clear = frame(&scene, &derived, 2_000.0, Detail::AUTOMATIC).list.sprites.len();
    scene.sky.haze_length_m = 1_000.0;
    let hazy = frame(&scene, &derived, 2_000.0, Detail::AUTOMATIC).list.sprites.len();
    assert!(hazy < clear, "{hazy} of {clear}");
}

/// Tolerances that are none draw all sprites, and no tolerance stops short of a picture.
#[test]
fn any_tolerance_draws_something() {
    let scene = heap(60);
    let derived = Derived::new(&scene);
    for (flip, merges) in
        [(0.0, false), (-1.0, false), (f32::NAN, false), (1e-30, false), (1.0, true), (f32::INFINITY, true)]
    {
        let list = frame(&scene, &derived, 5_000.0, Detail::within(flip)).list;
        assert_eq!(list.sprites.len() < derived.clouds()[0].sprites.len(), merges, "{flip}");
        assert!(!list.sprites.is_empty());
    }
}

/// An eye that draws back by a thousandth at a time, at places from where all sprites are drawn to where one is: no pixel's
/// step is larger than what fades there makes it, beyond twice the largest step that all sprites make.
#[test]
fn nothing_pops_on_the_way() {
    const STEP: f64 = 1.001;
    let mut scene = heap(120);
    scene.sky.haze_length_m = 1e9;
    let derived = Derived::new(&scene);
    let drawn = |metres: f64, detail: Detail| {
        let mut frame = frame(&scene, &derived, metres, detail);
        let picture = draw::linear(&frame, &Watch::default()).expect("the CPU draws it");
        let sprites = std::mem::take(&mut frame.list.sprites);
        let faded = sprites.into_iter().filter(|drawn| drawn.pose != FACES_EYE).collect();
        frame.list = DrawList::of_sprites(faded, std::mem::take(&mut frame.list.poses));
        (picture.pixels.iter().map(|pixel| pixel.g).collect::<Vec<f32>>(), overdraw_map(&frame).values)
    };
    // A share goes from 0 to 1 over a fifth of the tolerance, a fade at most 1.343 times as fast, and what is off by a pixel
    // is so by a thousandth less after a step.
    let fade = 1.343 * (STEP as f32 - 1.0) / 0.2;
    let mut fading_steps = 0;
    for place in 0..24 {
        let from = 2_000.0 * 1.22_f64.powi(place);
        let at = |step: i32, detail| drawn(from * STEP.powi(step), detail);
        let mut before = [Detail::AUTOMATIC, Detail::FULL].map(|detail| at(0, detail));
        for step in 1..=8 {
            let now = [Detail::AUTOMATIC, Detail::FULL].map(|detail| at(step, detail));
            let [merged, all] = [0, 1].map(|way| (&before[way].0, &now[way].0));
            let steps = |(before, now): (&Vec<f32>, &Vec<f32>)| -> Vec<f32> {
                before.iter().zip(now).map(|(a, b)| (a - b).abs()).collect()
            };
            let own = 2.0 * steps(all).into_iter().fold(0.0, f32::max);
            let brightest = now[0].0.iter().copied().fold(0.0, f32::max);
            for (pixel, stepped) in steps(merged).into_iter().enumerate() {
                let faded = before[0].1[pixel].max(now[0].1[pixel]);
                fading_steps += u32::from(faded > 0.0);
                let bound = own + fade * faded * brightest;
                assert!(stepped <= bound, "{stepped} of {bound} at {from:.0} m, step {step}, pixel {pixel}");
            }
            before = now;
        }
    }
    assert!(fading_steps > 1000, "{fading_steps}");
}

/// A picture of merged sprites is within the tolerance of that of all, from each camera of the shipped scenes and over a deck
/// of 640 clouds, of which less than half of the sprites are drawn.
#[test]
fn pictures_are_within_the_tolerance() {
    let picture = |scene: &Scene, derived: &Derived, camera: &Camera, detail| {
        let rules = Rules { detail, ..Rules::SHIPPED };
        let sight = Sight { rules, ..Sight::still(camera, [480, 270]) };
        let frame = Frame::new(scene, derived, Atlas::built_in(), &sight);
        let picture: Picture = draw::picture(&frame, &Watch::default()).expect("the CPU draws it");
        (picture, frame.list.sprites.len())
    };
    let error = |scene: &Scene, derived: &Derived, camera: &Camera| {
        let [all, merged] = [Detail::FULL, Detail::AUTOMATIC].map(|detail| picture(scene, derived, camera, detail));
        (flip(&all.0, &merged.0, PIXELS_PER_DEGREE).expect("of one size").mean(), all.1, merged.1)
    };
    for (name, make) in authoring::SCENES {
        let scene = make();
        let derived = Derived::new(&scene);
        for camera in &scene.cameras {
            let (flip, ..) = error(&scene, &derived, camera);
            assert!(flip <= 0.01, "{name} from {}: {flip}", camera.name);
        }
    }
    let scene = laid_out::overcasts(4);
    let derived = Derived::new(&scene);
    let (flip, all, merged) = error(&scene, &derived, &scene.cameras[0]);
    assert!(flip <= 0.01 && merged * 2 < all, "{flip}, {merged} of {all}");
}

/// Faded ones name poses of their own, and the list is the same on any number of threads.
#[test]
fn lists_hold_together() {
    let scene = laid_out::overcasts(3);
    let derived = Derived::new(&scene);
    let list = || {
        let rules = Rules { detail: Detail::AUTOMATIC, ..Rules::SHIPPED };
        let sight = Sight { rules, ..Sight::still(&scene.cameras[0], SIZE) };
        Frame::new(&scene, &derived, Atlas::built_in(), &sight).list
    };
    let on =
        |threads: usize| rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool").install(list);
    let one = on(1);
    assert_eq!(one, on(3));
    let faded: Vec<u32> = one.sprites.iter().map(|drawn| drawn.pose).filter(|pose| *pose != FACES_EYE).collect();
    assert!(!faded.is_empty());
    assert_eq!(faded.iter().collect::<BTreeSet<_>>().len(), faded.len(), "each has its own");
    assert!(faded.iter().all(|pose| one.poses[*pose as usize].fade < 1.0));
}
