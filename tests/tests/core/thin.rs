//! Thinning keeps its word: measured again from the scene that comes out, and by the cameras' whole pictures.

use cloudwright_core::derived::Derived;
use cloudwright_core::document::Document;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip};
use cloudwright_core::raster::fast;
use cloudwright_core::scene::{Cloud, CloudId, KeyValue, Scene, Track, TrackId, TrackKey};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::thin::{ThinError, Thinned, thin};
use cloudwright_core::watch::Watch;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;
use std::time::{Duration, Instant};

fn thinned(scene: &Scene, tolerance: f64) -> Result<Thinned, ThinError> {
    thin(scene, Atlas::built_in(), tolerance, &Watch::default())
}

fn after(scene: &Scene, thinned: &Thinned) -> Scene {
    let mut document = Document::new(scene.clone());
    document.edit("Thin", thinned.edits.clone()).expect("edits of boxes that are there");
    document.scene().clone()
}

/// From the scene's camera, in the size that thinning judges by.
fn seen(scene: &Scene) -> (Picture, u64) {
    let derived = Derived::new(scene);
    let sprites = derived.clouds().iter().map(|cloud| cloud.sprites.len() as u64).sum();
    let camera = &scene.cameras[0];
    let frame = Frame::new(scene, &derived, Atlas::built_in(), &Sight::still(camera, [240, 135]));
    (fast::picture(&frame), sprites)
}

#[test]
fn what_comes_out_is_within_the_tolerance() {
    let scene = heap(120);
    let (whole, before) = seen(&scene);
    let mut fewest = u64::MAX;
    for tolerance in [0.002, 0.01, 0.05] {
        let thinned = thinned(&scene, tolerance).expect("a heap hides most of its sprites");
        let (thin, sprites) = seen(&after(&scene, &thinned));
        assert_eq!((thinned.before, thinned.after), (before, sprites));
        assert_eq!(thinned.views, 1 + 8, "a camera, and around one cloud");
        let error = flip(&whole, &thin, PIXELS_PER_DEGREE).expect("one size").mean();
        assert!(error <= thinned.error && thinned.error <= tolerance, "{error}, {thinned:?}");
        assert!(thinned.after < fewest, "a larger tolerance drops more: {thinned:?}");
        fewest = thinned.after;
    }
    assert!(fewest < before / 2, "{fewest} of {before} are left at 0.05");
}

/// Which goes first is what adds
/// least: a sprite that others hide from all sides.
#[test]
fn hidden_sprites_go_first() {
    let corner = |i: u32| DVec3::new(f64::from(i & 1), f64::from(i >> 1 & 1), f64::from(i >> 2)) * 20.0 - 10.0;
    let mut sprites: Vec<_> = (0..8).map(|i| (DVec3::NEG_Z * 500.0 + corner(i), 120.0)).collect();
    sprites.push((DVec3::NEG_Z * 500.0, 5.0));
    let scene = single_sprites(&sprites);
    let thinned = thinned(&scene, 1e-4).expect("the small one in the middle shows nowhere");
    assert_eq!((thinned.before, thinned.after), (9, 8));
    let scene = after(&scene, &thinned);
    let gone: Vec<_> = scene.models[0].boxes.iter().filter(|each| !each.sprite_edits.is_empty()).collect();
    assert_eq!((gone.len(), gone[0].width[0]), (1, 5.0));
}

/// A cloud that does not show at second 0, or in the air as it is, is thinned as one that does.
#[test]
fn what_the_clock_hides_is_not_thrown_away() {
    let scene = heap(60);
    let want = thinned(&scene, 0.01).expect("a heap hides some of its sprites");
    let mut hidden = scene;
    let property = format!("cloud/{}/opacity", hidden.clouds[0].id);
    let keys = vec![TrackKey::new(0.0, KeyValue::One(0.0)), TrackKey::new(9.0, KeyValue::One(1.0))];
    hidden.tracks.push(Track::new(TrackId::new(&mut hidden.next_id), property, keys));
    hidden.weather.humidity = 0.0;
    hidden.clouds[0].growth = 2.0;
    let got = thinned(&hidden, 0.01).expect("the same");
    assert_eq!((got.after, &got.edits), (want.after, &want.edits));
}

#[test]
fn says_why_it_refuses() {
    let scene = heap(40);
    for tolerance in [0.0, -1.0, 1.1, f64::NAN] {
        assert!(matches!(thinned(&scene, tolerance), Err(ThinError::Tolerance(_))), "{tolerance}");
    }
    let mut empty = scene.clone();
    empty.clouds.clear();
    assert_eq!(thinned(&empty, 0.01), Err(ThinError::NoSprites));
    assert!(matches!(thinned(&scene, 1e-9), Err(ThinError::CannotHold { .. })));
    let watch = Watch::default();
    watch.cancel();
    assert_eq!(thin(&scene, Atlas::built_in(), 0.01, &watch), Err(ThinError::Cancelled));
}

#[test]
fn same_sprites_go_on_any_number_of_threads() {
    let scene = heap(60);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| thinned(&scene, 0.01))
    };
    assert_eq!(on(1), on(3));
}

/// A kilometre of clouds: no more are looked at from around than memory and patience allow, and Stop is heard at once.
#[test]
fn a_crowd_of_clouds_is_looked_at_by_some_and_can_be_stopped() {
    let mut scene = heap(10);
    let cloud = scene.clouds[0].clone();
    for i in 0..2000 {
        let id = CloudId::new(&mut scene.next_id);
        let position = cloud.position + DVec3::new(f64::from(i % 50), 0.0, f64::from(i / 50)) * 500.0;
        scene.clouds.push(Cloud { id, position, ..cloud.clone() });
    }
    let watch = Watch::default();
    std::thread::scope(|scope| {
        let thinning = scope.spawn(|| thin(&scene, Atlas::built_in(), 0.01, &watch));
        while watch.share() == 0.0 {
            std::thread::sleep(Duration::from_millis(10));
        }
        let begun = Instant::now();
        watch.cancel();
        assert_eq!(thinning.join().expect("no panic"), Err(ThinError::Cancelled));
        // A view takes milliseconds.
        assert!(begun.elapsed() < Duration::from_secs(5), "{:?}", begun.elapsed());
    });
}
