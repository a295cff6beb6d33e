//! What is sent, remembered and computed again follows the part of a cloud that changed: its name, its look, its place or
//! its shape. An eye that has flown into one of four heaps remembers the same through every change of the others, and
//! through all of its own that leave its sprites as they are.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::detail::{Detail, Subset};
use cloudwright_core::document::Document;
use cloudwright_core::draw_list::{Choice, DrawList, Hidden, Ranks, Sorting};
use cloudwright_core::facing::{Pose, Poses};
use cloudwright_core::measure::bytes_of_change;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::{Camera, CameraPath, CloudId, PathKey};
use cloudwright_core::sprites::{Atlas, PlacedCloud};
use cloudwright_core::view_history::{Playback, ViewHistory};
use cloudwright_core::weather::CloudNow;
use cloudwright_tests::part_edits::{PART_EDITS, PartEdit, heaps};
use glam::DVec3;
use std::sync::Arc;

/// The heap that the eye flies into.
const FLOWN: usize = 1;

/// Before and after an edit.
struct Edited {
    before: Derived,
    after: Derived,
}

fn edited(part: &PartEdit) -> Edited {
    let mut document = Document::new(heaps());
    let before = Derived::new(document.scene());
    let edits = (part.edits)(document.scene());
    let change = document.edit(part.name, edits).expect("in range");
    let mut after = before.clone();
    after.update(document.scene(), &change);
    assert!(after.clouds() == Derived::new(document.scene()).clouds(), "{}: as if all were computed anew", part.name);
    Edited { before, after }
}

fn part(name: &str) -> PartEdit {
    *PART_EDITS.iter().find(|part| part.name == name).expect("an edit of that name")
}

/// Into the heap, a metre a step.
fn way(step: u32) -> Camera {
    Camera::free(DVec3::new(60.0, 1010.0, 160.0 - f64::from(step)))
}

/// As shipped: sprites near the eye are remembered, none of the order is.
const SHIPPED: &Rules = &Rules::SHIPPED;
const CROSSFADE: &Rules = &Rules { sorting: Sorting::Crossfade, ..Rules::SHIPPED };

fn now(derived: &Derived) -> Vec<CloudNow<'_>> {
    derived.clouds_at(0.0, SHIPPED.of_weather())
}

fn flown(derived: &Derived, rules: &Rules) -> ViewHistory {
    let mut history = ViewHistory::default();
    (0..140).for_each(|step| history.step(rules, derived, 0.0, &View::new(&way(step), 64, 36)));
    history
}

fn by_id(derived: &Derived, id: CloudId) -> (usize, &PlacedCloud) {
    derived.clouds().iter().enumerate().find(|(_, cloud)| cloud.id == id).expect("it is there")
}

/// Of the flown heap's sprites, at the end of the way.
fn poses(derived: &Derived, history: &ViewHistory, id: CloudId) -> Vec<Option<Pose>> {
    let view = View::new(&way(140), 64, 36);
    let poses = Poses::new(&SHIPPED.facing, &now(derived), derived.shapes(), &view, &history.facing);
    let (index, cloud) = by_id(derived, id);
    (0..cloud.sprites.len() as u32).map(|sprite| poses.of_sprite(index, sprite).copied()).collect()
}

#[test]
fn work_and_bytes_follow_the_part() {
    let whole = |cloud: &PlacedCloud| 32 * (cloud.sprites.all().len() + cloud.groups.len()) as u64 + 128;
    // Models populated, clouds placed, clouds dressed.
    type Bytes = fn(&[PlacedCloud], &dyn Fn(&PlacedCloud) -> u64) -> u64;
    let cases: [(&str, [u64; 3], Bytes); 9] = [
        ("name", [0, 0, 1], |_, _| 0),
        ("colours", [0, 0, 2], |_, _| 2 * 128),
        ("light", [0, 0, 2], |after, _| 32 * (after[1].groups.len() + after[3].groups.len()) as u64),
        ("place", [0, 0, 1], |_, _| 0),
        ("altitude", [0, 0, 1], |_, _| 0),
        ("heading", [0, 1, 0], |after, whole| whole(&after[2])),
        // Behind a heap with fewer sprites each stands elsewhere in the table; groups and the cloud itself do not.
        ("shape", [1, 1, 0], |after, whole| whole(&after[2]) + 32 * after[3].sprites.all().len() as u64),
        ("one more", [0, 1, 0], |after, whole| whole(&after[4])),
        // The one behind it comes in its place, where what is the same of both clouds is there already.
        ("one less", [0, 0, 0], |after, whole| whole(&after[2])),
    ];
    for (name, work, bytes) in cases {
        let Edited { before, after } = edited(&part(name));
        let (had, has) = (before.work_done(), after.work_done());
        let done = [
            has.models_populated - had.models_populated,
            has.clouds_placed - had.clouds_placed,
            has.clouds_dressed - had.clouds_dressed,
        ];
        assert_eq!(done, work, "{name}");
        assert_eq!(bytes_of_change(before.clouds(), after.clouds()), bytes(after.clouds(), &whole), "{name}");
        assert_ne!(before.version(), after.version(), "{name}: another state");
        let stays = ["name", "colours", "light"].contains(&name);
        assert_eq!(before.shapes() == after.shapes(), stays, "{name}");
    }
}

#[test]
fn an_eye_remembers_what_was_not_reshaped() {
    for part in PART_EDITS {
        let Edited { before, after } = edited(&part);
        let mut uninterrupted = flown(&before, SHIPPED);
        let mut interrupted = uninterrupted.clone();
        assert!(interrupted.facing.sprite_count() > 3, "it is near sprites");
        let end = View::new(&way(140), 64, 36);
        uninterrupted.step(SHIPPED, &before, 0.0, &end);
        // First as the picture between two steps sees it.
        let id = before.clouds()[FLOWN].id;
        let want = poses(&before, &uninterrupted, id);
        assert!(want.iter().flatten().count() > 3);
        interrupted.step(SHIPPED, &after, 0.0, &end);
        assert_eq!(interrupted.facing.sprite_count(), uninterrupted.facing.sprite_count(), "{}", part.name);
        assert!(poses(&after, &interrupted, id) == want, "{}: they snap", part.name);
        // What is forgotten would show.
        let mut forgetful = ViewHistory::default();
        forgetful.step(SHIPPED, &after, 0.0, &end);
        assert!(poses(&after, &forgetful, id) != want, "{}", part.name);
    }
}

#[test]
fn a_reshaped_cloud_is_seen_for_the_first_time() {
    let scene = heaps();
    let before = Derived::new(&scene);
    let mut other = scene;
    other.models[1].boxes[0].sprite_count = 30;
    let after = Derived::new(&other);
    let mut history = flown(&before, SHIPPED);
    let mut anew = ViewHistory::default();
    let end = View::new(&way(140), 64, 36);
    history.step(SHIPPED, &after, 0.0, &end);
    anew.step(SHIPPED, &after, 0.0, &end);
    let id = before.clouds()[FLOWN].id;
    assert!(poses(&after, &history, id) == poses(&after, &anew, id));
}

/// The flown heap's sprites, farthest first.
fn order(derived: &Derived, ranks: Option<&Ranks>, id: CloudId) -> Vec<u32> {
    let view = View::new(&Camera { position: DVec3::new(0.0, 1000.0, 3000.0), ..way(0) }, 64, 36);
    let (poses, hidden) = (&Poses::default(), &Hidden::default());
    let clouds = &now(derived);
    let subset = &Subset::new(Detail::FULL, clouds, Atlas::built_in());
    let list = DrawList::new(&Choice { clouds, poses, subset, hidden, haze_length_m: f32::INFINITY }, &view, ranks);
    let index = by_id(derived, id).0 as u32;
    list.sprites.iter().filter(|drawn| drawn.cloud == index).map(|drawn| drawn.sprite).collect()
}

#[test]
fn an_order_holds_through_all_but_new_shapes() {
    for part in PART_EDITS {
        let Edited { before, after } = edited(&part);
        let mut history = flown(&before, CROSSFADE);
        let id = before.clouds()[FLOWN].id;
        let had = order(&before, history.order.orders().0, id);
        let end = View::new(&way(140), 64, 36);
        let sorted = Ranks::from_afar(&now(&after), &end);
        let anew = order(&after, Some(&sorted), id);
        assert!(had.len() > 20 && had != anew, "the order that is kept is an old one");
        history.step(CROSSFADE, &after, 0.0, &end);
        let is_new = ["heading", "shape", "one more"].contains(&part.name);
        let want = if is_new { anew } else { had };
        assert!(order(&after, history.order.orders().0, id) == want, "{}", part.name);
        // And goes on in the new state.
        (141..400).for_each(|step| history.step(CROSSFADE, &after, 0.0, &View::new(&way(step), 64, 36)));
    }
}

#[test]
fn a_flight_is_gone_anew_only_where_shapes_or_places_changed() {
    let key = |time_s: f64, z: f64| PathKey {
        time_s,
        position: DVec3::new(60.0, 1010.0, z),
        heading_deg: 0.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let path = CameraPath::free(vec![key(0.0, 160.0), key(2.0, 20.0)]);
    for part in PART_EDITS {
        let Edited { before, after } = edited(&part);
        let mut playback = Playback::new(&path, Rules::SHIPPED);
        playback.seek(&before, 2.0);
        let gone = playback.steps_taken();
        assert_eq!(gone, 121);
        let (_, history) = playback.seek(&after, 2.0);
        let history = Arc::clone(history);
        let stays = ["name", "colours", "light"].contains(&part.name);
        assert_eq!(playback.steps_taken() - gone, if stays { 0 } else { 121 }, "{}", part.name);
        let mut alone = Playback::new(&path, Rules::SHIPPED);
        assert!(*alone.seek(&after, 2.0).1 == history, "{}: as if it were gone in this state", part.name);
    }
}
