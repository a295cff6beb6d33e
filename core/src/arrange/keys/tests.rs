use super::*;
use crate::arrange::Arrangement;
use crate::arrange::duplicate::{self, Copy};
use crate::arrange::test_scenes::{applied, two_clouds};
use crate::property::Target;
use crate::scene::{CloudId, Handles, KeyValue, Leaves, Scene};
use crate::weather::Curve;
use glam::DVec3;

fn target(text: &str) -> Target {
    text.parse().expect("a property")
}

fn after(scene: &Scene, rekeyed: &Rekeyed) -> Scene {
    applied(scene, &Arrangement { edits: rekeyed.edits.clone(), made: Vec::new() })
}

/// Exposure with keys at those times, each of its own number's value.
fn exposure(times: &[f64]) -> Scene {
    let mut scene = two_clouds();
    for (i, time_s) in times.iter().enumerate() {
        scene = after(&scene, &keyed(&scene, &[(target("sky/exposure_ev"), KeyValue::One(i as f64))], *time_s));
    }
    scene
}

fn keys_of(scene: &Scene) -> Vec<(f64, f64)> {
    scene.tracks[0].keys.iter().map(|key| (key.time_s, key.value.parts()[0])).collect()
}

fn chosen(scene: &Scene, indices: &[usize]) -> BTreeSet<KeyPlace> {
    indices.iter().map(|index| (scene.tracks[0].id, *index)).collect()
}

#[test]
fn a_key_is_set_replaced_and_taken_out() {
    let scene = exposure(&[4.0, 1.0, 2.5]);
    assert_eq!(keys_of(&scene), [(1.0, 1.0), (2.5, 2.0), (4.0, 0.0)]);
    let exposure_ev = target("sky/exposure_ev");
    let rekeyed = keyed(&scene, &[(exposure_ev, KeyValue::One(99.0))], 2.500_000_1);
    let replaced = after(&scene, &rekeyed);
    assert_eq!(keys_of(&replaced)[1], (2.5, 20.0), "within the range");
    assert_eq!(rekeyed.chosen, chosen(&scene, &[1]));
    let two = [(exposure_ev, KeyValue::One(0.5)), (target("sky/gain"), KeyValue::One(2.0))];
    assert_eq!(after(&scene, &keyed(&scene, &two, 9.0)).tracks.len(), 2);
    assert_eq!(keyed(&scene, &[(exposure_ev, KeyValue::Three([0.0; 3]))], 9.0), Rekeyed::default());

    let one_less = after(&scene, &removed(&scene, &[exposure_ev], 1.0));
    assert_eq!(keys_of(&one_less), [(2.5, 2.0), (4.0, 0.0)]);
    assert!(removed(&scene, &[exposure_ev], 1.5).edits.is_empty());
    assert!(after(&scene, &cleared(&scene, &[exposure_ev])).tracks.is_empty());
    let next = |from, onwards| next_key_s(&scene.tracks, from, onwards);
    assert_eq!(
        [next(1.0, true), next(4.0, true), next(4.0, false), next(0.5, false)],
        [Some(2.5), None, Some(2.5), None]
    );
}

#[test]
fn moved_keys_pass_others_and_take_their_place() {
    let scene = exposure(&[0.0, 1.0, 2.0, 3.0]);
    let first = chosen(&scene, &[0]);
    let rekeyed = moved(&scene.tracks, &first, 2.5);
    assert_eq!(keys_of(&after(&scene, &rekeyed)), [(1.0, 1.0), (2.0, 2.0), (2.5, 0.0), (3.0, 3.0)]);
    assert_eq!(rekeyed.chosen, chosen(&scene, &[2]));
    let onto = moved(&scene.tracks, &first, 2.0);
    assert_eq!(keys_of(&after(&scene, &onto)), [(1.0, 1.0), (2.0, 0.0), (3.0, 3.0)], "the moved one stays");
    assert_eq!(onto.chosen, chosen(&scene, &[1]));
    for bad in [f64::NAN, f64::INFINITY] {
        let keys = keys_of(&after(&scene, &moved(&scene.tracks, &chosen(&scene, &[3]), bad)));
        assert!(keys.iter().all(|(time_s, _)| time_s.abs() <= MOST_S), "{keys:?}");
    }
    let all = chosen(&scene, &[0, 1, 2, 3]);
    let wide = after(&scene, &scaled(&scene.tracks, &all, 1.0, 2.0));
    assert_eq!(keys_of(&wide).map_times(), [-1.0, 1.0, 3.0, 5.0]);
    assert!(scaled(&scene.tracks, &all, 1.0, f64::NAN).edits.is_empty());
    assert!(after(&scene, &deleted(&scene.tracks, &all)).tracks.is_empty(), "no track without keys");
}

#[test]
fn a_ripple_takes_along_what_comes_later() {
    let mut scene = exposure(&[0.0, 1.0, 2.0, 3.0]);
    for (time_s, gain) in [(0.5, 1.0), (1.5, 2.0), (9.0, 3.0)] {
        scene = after(&scene, &keyed(&scene, &[(target("sky/gain"), KeyValue::One(gain))], time_s));
    }
    let gains = |scene: &Scene| scene.tracks[1].keys.iter().map(|key| key.time_s).collect::<Vec<_>>();
    let ripple = |scene: &Scene, chosen: &BTreeSet<KeyPlace>, by_s| rippled(&scene.tracks, chosen, by_s, |_, _| {});
    let second = chosen(&scene, &[1]);
    let rekeyed = ripple(&scene, &second, 2.5);
    let later = after(&scene, &rekeyed);
    assert_eq!(keys_of(&later).map_times(), [0.0, 3.5, 4.5, 5.5]);
    assert_eq!(gains(&later), [0.5, 1.5, 9.0], "no key of it is chosen");
    assert_eq!(rekeyed.chosen, second);
    // In all tracks from the first chosen key on, whichever it is of.
    let both: BTreeSet<_> = second.iter().copied().chain([(scene.tracks[1].id, 2)]).collect();
    let later = after(&scene, &ripple(&scene, &both, 1.0));
    assert_eq!((keys_of(&later).map_times(), gains(&later)), (vec![0.0, 2.0, 3.0, 4.0], vec![0.5, 2.5, 10.0]));
    assert_eq!(with_later(&scene.tracks, &both).len(), 5);
    // Backwards as far as there is time, in the track that has least.
    let earlier = after(&scene, &ripple(&scene, &both, -5.0));
    assert_eq!(keys_of(&earlier).map_times(), [0.0, 0.001, 1.001, 2.001]);
    assert_eq!(gains(&earlier), [0.5, 0.501, 8.001]);
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let keys = keys_of(&after(&scene, &ripple(&scene, &second, bad))).map_times();
        assert!(keys.len() == 4 && keys.iter().all(|time_s| time_s.abs() <= MOST_S), "{bad}: {keys:?}");
    }
    assert_eq!(ripple(&scene, &BTreeSet::new(), 1.0), Rekeyed::default());
    let changed = rippled(&scene.tracks, &second, 1.0, |_, key| key.value = KeyValue::One(-4.0));
    assert_eq!(keys_of(&after(&scene, &changed)), [(0.0, 0.0), (2.0, -4.0), (3.0, 2.0), (4.0, 3.0)]);
}

trait Times {
    fn map_times(&self) -> Vec<f64>;
}

impl Times for Vec<(f64, f64)> {
    fn map_times(&self) -> Vec<f64> {
        self.iter().map(|(time_s, _)| *time_s).collect()
    }
}

#[test]
fn a_mirrored_curve_is_the_curve_backwards() {
    let mut scene = exposure(&[0.0, 1.0, 3.0, 4.0]);
    let keys = &mut scene.tracks[0].keys;
    (keys[0].leaves, keys[1].leaves) = (Leaves::Linear, Leaves::Smooth);
    keys[2].handles = Some(Handles { arrives: KeyValue::One(3.0), leaves: KeyValue::One(-2.0) });
    let turned = after(&scene, &mirrored(&scene.tracks, &chosen(&scene, &[0, 1, 2, 3]), 2.0));
    let [before, after] = [&scene, &turned].map(|scene| Curve::new(&scene.tracks[0], false));
    for i in 0..=80 {
        let time_s = f64::from(i) * 0.05;
        let [a, b] = [before.at(time_s, 0), after.at(4.0 - time_s, 0)];
        assert!((a - b).abs() < 1e-9, "{time_s} s: {a} and {b}");
    }
}

#[test]
fn handles_begin_where_the_curve_is() {
    let scene = exposure(&[0.0, 1.0, 3.0, 4.0]);
    let all = chosen(&scene, &[0, 1, 2, 3]);
    let free = after(&scene, &eased(&scene.tracks, &all, Ease::Free));
    let flat = after(&scene, &eased(&scene.tracks, &all, Ease::Flat));
    let [smooth, free, flat] = [&scene, &free, &flat].map(|scene| Curve::new(&scene.tracks[0], false));
    for i in 0..=80 {
        let time_s = f64::from(i) * 0.05;
        assert!((smooth.at(time_s, 0) - free.at(time_s, 0)).abs() < 1e-9, "{time_s} s");
    }
    assert!(smooth.at(1.01, 0) - 1.0 > 1e-3 && flat.at(1.01, 0) - 1.0 < 1e-3);
    let step = after(&scene, &eased(&scene.tracks, &chosen(&scene, &[1]), Ease::Plain(Leaves::Step)));
    assert_eq!(Curve::new(&step.tracks[0], false).at(2.9, 0), 1.0);
}

#[test]
fn a_clip_goes_to_its_own_tracks_or_to_others() {
    let mut scene = exposure(&[0.0, 1.0]);
    scene = after(&scene, &keyed(&scene, &[(target("sky/gain"), KeyValue::One(9.0))], 0.0));
    let clip = copied(&scene, &chosen(&scene, &[1]));
    assert!(copied(&scene, &BTreeSet::new()).is_empty());
    let own = pasted(&scene, &clip, 5.0, &BTreeSet::new());
    assert_eq!(keys_of(&after(&scene, &own)), [(0.0, 0.0), (1.0, 1.0), (5.0, 1.0)]);
    assert_eq!(own.chosen, chosen(&scene, &[2]));
    let gain = scene.tracks[1].id;
    let other = after(&scene, &pasted(&scene, &clip, 5.0, &[gain].into()));
    assert_eq!((other.tracks[0].keys.len(), other.tracks[1].keys.len()), (2, 2));
    let bare = after(&scene, &cleared(&scene, &[target("sky/exposure_ev")]));
    let made = after(&bare, &pasted(&bare, &clip, 5.0, &BTreeSet::new()));
    assert_eq!((made.tracks.len(), made.tracks[1].keys[0].time_s), (2, 5.0), "the track is made again");
    let double = after(&scene, &duplicated(&scene.tracks, &chosen(&scene, &[0, 1]), 2.0));
    assert_eq!(keys_of(&double).map_times(), [0.0, 1.0, 2.0, 3.0]);
}

#[test]
fn copies_of_clouds_move_as_their_originals_do() {
    let mut scene = two_clouds();
    let (cloud, model, group) = (scene.clouds[1].id, scene.models[1].id, scene.models[1].groups[0].id);
    let values = [
        (target(&format!("cloud/{cloud}/position")), KeyValue::Three([1.0, 2.0, 3.0])),
        (target(&format!("model/{model}/group/{group}/light/c_max")), KeyValue::One(0.5)),
        (target(&format!("model/{model}/color_levels/3/height")), KeyValue::One(0.5)),
    ];
    scene = after(&scene, &keyed(&scene, &values, 2.0));
    let offset = DVec3::X * 100.0;
    let linked = applied(&scene, &duplicate::clouds(&scene, &[cloud, CloudId(999)], offset, Copy::Linked));
    assert_eq!(linked.tracks.len(), 4, "the model is the same");
    let new = &linked.tracks[3];
    assert_eq!(new.property, format!("cloud/{}/position", linked.clouds[2].id));
    assert_eq!(new.keys[0].value, KeyValue::Three([101.0, 2.0, 3.0]));
    let own = applied(&scene, &duplicate::clouds(&scene, &[cloud], offset, Copy::Own));
    assert_eq!(own.tracks.len(), 6);
    assert!(own.tracks.iter().all(|track| target(&track.property).owner.is_in(&own)));
}
