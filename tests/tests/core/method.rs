//! The table of methods: every row has a name of its own, draws, and is what it says.

use cloudwright_core::derived::Derived;
use cloudwright_core::detail::{Detail, Subset};
use cloudwright_core::document::{Document, Edit, ListEdit};
use cloudwright_core::draw::{self, Drawn};
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::{Counts, linear_error};
use cloudwright_core::method::{Family, METHODS, Method, named, shipped, truth};
use cloudwright_core::raster::develop;
use cloudwright_core::rules::{Movement, Rasterizer, Rules};
use cloudwright_core::scene::{Camera, Cloud, Formation, FormationChange, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::variants::{STEPPED_AS_PRINTED, STEPPED_MENDED};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{Formed, FormingRule, Moment, Stepped, WeatherRules};
use cloudwright_tests::small_scenes::{crowd, heap};
use std::collections::BTreeSet;

const SIZE: [u32; 2] = [48, 27];

/// The still of a heap by a method, with its frame.
fn with_frame<T>(method: &Method, scene: &Scene, camera: &Camera, f: impl FnOnce(&Frame<'_>) -> T) -> T {
    let sight = Sight { moment: Moment::at(1.0), rules: method.rules, ..Sight::still(camera, SIZE) };
    f(&Frame::new(scene, &Derived::new(scene), Atlas::built_in(), &sight))
}

fn drawn(method: &Method) -> Option<Drawn> {
    let scene = heap(40);
    with_frame(method, &scene, &scene.cameras[0], |frame| draw::drawn(frame, &Watch::default()))
}

#[test]
fn names_are_unique_and_say_what_they_are() {
    let names: BTreeSet<&str> = METHODS.iter().map(|method| method.name).collect();
    assert_eq!(names.len(), METHODS.len());
    for method in METHODS {
        let plain = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-';
        assert!(method.name.chars().all(plain), "{}: no comma or space may split it", method.name);
        assert!(method.about.ends_with('.'), "{}: a sentence", method.name);
        assert_eq!(named(method.name), Some(method));
    }
    assert_eq!(named("wishful"), None);
    assert_eq!((shipped().family, shipped().rules), (Family::Shipped, Rules::SHIPPED));
    assert_eq!((truth().family, truth().rules.rasterizer), (Family::Truth, Rasterizer::Truth));
    for family in [Family::Truth, Family::Shipped] {
        assert_eq!(METHODS.iter().filter(|method| method.family == family).count(), 1, "{family:?}");
    }
}

/// No two rows are one method, nor do two say the same of themselves.
#[test]
fn rows_differ() {
    for (i, a) in METHODS.iter().enumerate() {
        for b in &METHODS[..i] {
            assert_ne!(a.rules, b.rules, "{} and {}", a.name, b.name);
            assert_ne!(a.rules.in_words(), b.rules.in_words(), "{} and {}", a.name, b.name);
        }
    }
}

#[test]
fn every_row_draws() {
    let scene = heap(40);
    for method in METHODS {
        let on_gpu = method.rules.rasterizer == Rasterizer::Gpu;
        let Some(Drawn { linear, clouds }) = drawn(method) else {
            assert!(on_gpu, "{}: only a GPU is not here", method.name);
            continue;
        };
        assert!(!on_gpu);
        assert_eq!([linear.width, linear.height], SIZE, "{}", method.name);
        assert!(linear.pixels.iter().all(|pixel| pixel.to_array().iter().all(|x| x.is_finite())), "{}", method.name);
        assert!(clouds.is_none_or(|clouds| [clouds.width, clouds.height] == SIZE), "{}", method.name);
        // What is shown is what is measured, but for the fast way's roundings: a step of 8 bits.
        let (shown, exposure) = with_frame(method, &scene, &scene.cameras[0], |frame| {
            (draw::picture(frame, &Watch::default()), frame.now.exposure)
        });
        let (shown, measured) = (shown.expect("on the CPU"), develop(&linear, exposure));
        let steps = shown.as_bytes().iter().zip(measured.as_bytes()).map(|(a, b)| a.abs_diff(*b));
        assert!(steps.max() <= Some(1), "{}", method.name);
    }
}

/// What is worth a look stays near the truth: in a still, all of the rows that keep every sprite. Those that fail in stills
/// are farther off than what is shipped.
#[test]
fn errors_are_as_the_families_say() {
    // Dim enough that eight bits cut no light: what they err is rounding then.
    let mut scene = heap(40);
    scene.sky.directional_tuning.scale = 0.7;
    let linear = |name: &str| {
        let drawn = with_frame(named(name).expect("in the table"), &scene, &scene.cameras[0], |frame| {
            draw::drawn(frame, &Watch::default())
        });
        drawn.expect("on the CPU").linear
    };
    let truth = linear("truth");
    let rmse = |name: &str| linear_error(&linear(name), &truth).expect("of one size").rmse;
    let fast = rmse("fast");
    for name in ["plain", "no-stop", "crossfade"] {
        // The fast way is the plain one within 2·10⁻³ (ARCHITECTURE.md, 8).
        assert!((rmse(name) - fast).abs() < 2e-3, "{name}");
    }
    assert!(rmse("four-samples") < fast, "more samples are nearer to sixteen");
    // Which way sprites turn is seen when the eye moves: the suite judges it.
    for name in ["eight-bits", "three-quarters"] {
        assert!(rmse(name) > fast, "{name}: {}, shipped {fast}", rmse(name));
    }
    // A stop is judged against no stop.
    let stopped = |name: &str| linear_error(&linear(name), &linear("no-stop")).expect("of one size").rmse;
    assert!(stopped("fast") < stopped("early-stop"), "{} {}", stopped("fast"), stopped("early-stop"));
    assert!(rmse("three-quarters") < rmse("half") && rmse("half") < rmse("quarter"));
}

#[test]
fn kept_sprites_are_the_largest() {
    let (scene, atlas) = (heap(41), Atlas::built_in());
    let all = Derived::new(&scene);
    let cloud = &all.clouds()[0];
    let cover = |sprite: &cloudwright_core::sprites::Sprite| {
        sprite.width * sprite.height * atlas.mean_opacity(sprite.tile.into())
    };
    for (share, count) in
        [(0.0, 0), (0.5, cloud.sprites.len().div_ceil(2)), (1.0, cloud.sprites.len()), (7.0, cloud.sprites.len())]
    {
        let chosen =
            Subset::new(Detail { kept: share, ..Detail::FULL }, &all.clouds_at(0.0, WeatherRules::default()), atlas);
        let (kept, dropped): (Vec<_>, Vec<_>) =
            cloud.sprites.iter().zip(0..).partition(|(sprite, at)| chosen.has(0, sprite, *at));
        assert_eq!((kept.len(), chosen.is_all()), (count, share >= 1.0), "{share}");
        let least = kept.iter().map(|(sprite, _)| cover(sprite)).fold(f32::INFINITY, f32::min);
        assert!(dropped.iter().all(|(sprite, _)| cover(sprite) <= least), "{share}");
    }
}

/// Frames look up which sprites are kept: that is chosen once of each cloud's sprites, and again only of those that are
/// placed anew.
#[test]
fn sprites_are_chosen_once_for_all_frames() {
    let mut document = Document::new(crowd(3));
    let mut derived = Derived::new(document.scene());
    let draw = |scene: &Scene, derived: &Derived, name: &str, clock_s: f64| {
        let camera = &mut scene.cameras[0].clone();
        camera.position.x += clock_s;
        let rules = named(name).expect("in the table").rules;
        let sight = Sight { moment: Moment::at(clock_s), rules, ..Sight::still(camera, SIZE) };
        Frame::new(scene, derived, Atlas::built_in(), &sight).list.sprites.len()
    };
    let chosen =
        |derived: &Derived| -> Vec<u64> { derived.clouds().iter().map(|cloud| cloud.sprites.choices_made()).collect() };
    let [all, half] = ["fast", "half"].map(|name| draw(document.scene(), &derived, name, 0.0));
    assert!(half < all && half > 0, "{half} of {all}");
    for (name, want) in [("fast", 1), ("half", 1), ("quarter", 2), ("half", 2), ("quarter", 2)] {
        for clock_s in [0.0, 1.0] {
            draw(document.scene(), &derived, name, clock_s);
            assert_eq!(chosen(&derived), [want; 3], "{name} at {clock_s} s");
        }
    }
    let cloud = document.scene().clouds[1].clone();
    for (edit, want) in [
        (Cloud { position: cloud.position + glam::DVec3::X, name: "moved".into(), ..cloud.clone() }, [2, 2, 2]),
        (Cloud { scale: 2.0, ..cloud }, [2, 1, 2]),
    ] {
        let change = document.apply(Edit::Cloud(ListEdit::Replace(edit))).expect("it is there");
        derived.update(document.scene(), &change);
        draw(document.scene(), &derived, "half", 2.0);
        assert_eq!(chosen(&derived), want);
    }
    let other = Atlas::from_sheet(&[]);
    let clouds = derived.clouds_at(0.0, WeatherRules::default());
    Subset::new(Detail { kept: 0.5, ..Detail::FULL }, &clouds, &other);
    assert_eq!(chosen(&derived), [3, 2, 3], "other tiles cover otherwise");
}

/// The truth draws 16 rays a pixel.
#[test]
fn the_truth_counts_its_samples() {
    let scene = heap(40);
    let count = |method: &Method| with_frame(method, &scene, &scene.cameras[0], draw::counts);
    let (one, sixteen): (Counts, Counts) = (count(shipped()), count(truth()));
    assert_eq!((sixteen.fragments, sixteen.sprites), (16 * one.fragments, one.sprites));
    assert_eq!(count(named("four-samples").expect("in the table")).sprites, one.sprites);
}

/// The article's listings where they differ from the closed form: at a frame rate that meets the end late, they overshoot;
/// as printed, a whole cloud is unset, and the core fades first.
#[test]
fn stepped_forming_is_the_listings() {
    let formation =
        Formation { change: FormationChange::Forming, start_s: 1.0, core_s: 1.0, edges_s: 1.0, threshold: 0.5 };
    let at = |listing: Stepped, frames_a_second, clock_s| {
        FormingRule::Stepped(Stepped { frames_a_second, ..listing }).formed(Some(&formation), clock_s)
    };
    let check = |formed: Formed, [core, edge]: [f32; 2]| {
        let got = [formed.opacity(0.0), formed.opacity(1.0)];
        assert!(got.iter().zip([core, edge]).all(|(got, want)| (got - want).abs() < 1e-5), "{got:?}: {core}, {edge}");
    };
    // The core takes a second, the edges one from half of it on: 1.5 s together.
    check(at(STEPPED_MENDED, 60, 0.5), [0.0, 0.0]);
    check(at(STEPPED_MENDED, 60, 1.75), [0.5, 0.0]);
    check(at(STEPPED_AS_PRINTED, 60, 1.75), [0.0, 0.5]);
    check(at(STEPPED_MENDED, 60, 9.0), [1.0, 1.0]);
    check(at(STEPPED_AS_PRINTED, 60, 9.0), [0.0, 0.0]);
    assert!(!at(STEPPED_AS_PRINTED, 60, 9.0).shows(), "left unset");
    assert!(at(STEPPED_AS_PRINTED, 60, 1.2).shows(), "its edges");
    // A frame a second: two steps of two thirds.
    assert!(at(STEPPED_MENDED, 1, 3.0).core > 1.3);
    let slow = at(STEPPED_MENDED, 1, 2.9);
    check(slow, [2.0 / 3.0, 0.0]);
    assert_eq!(FormingRule::ClosedForm.formed(Some(&formation), 1.75), Formed::at(Some(&formation), 1.75));
    assert_eq!(at(STEPPED_MENDED, 0, 1e9), at(STEPPED_MENDED, 1, 1e9), "no rate is the least one");
}

#[test]
fn what_has_no_effect_is_told() {
    let without = |name: &str, moves| named(name).expect("in the table").rules.without_effect(moves).is_some();
    let still = Movement::default();
    let [flies, forms, blows] =
        [Movement { flies: true, ..still }, Movement { forms: true, ..still }, Movement { blows: true, ..still }];
    for (name, moves, want) in [
        ("fast", still, false),
        ("crossfade", forms, true),
        ("crossfade", flies, false),
        ("no-lock", still, true),
        ("no-lock", flies, false),
        ("view-plane", still, false),
        ("stepped-mended", flies, true),
        ("stepped-mended", forms, false),
        ("stepped-wind", forms, true),
        ("stepped-wind", blows, false),
    ] {
        assert_eq!(without(name, moves), want, "{name} {moves:?}");
    }
}
