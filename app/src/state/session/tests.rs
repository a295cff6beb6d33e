//! What is derived always comes to be the scene's, whatever happens while work is pending.

use super::*;
use cloudwright_core::document::ListEdit;
use cloudwright_core::random::draw;
use cloudwright_core::scene::{BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, ModelId};
use glam::DVec3;
use std::time::Duration;

/// More than is derived at once.
const MANY: u32 = 12_000;
const TOO_MANY: u32 = 2_000_000;

/// Two models of a box each, both placed once.
fn scene() -> Scene {
    let mut scene = Scene::default();
    for name in ["large", "small"] {
        let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), name, Category::CumulusHumilis);
        model.boxes.push(CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::ZERO));
        scene.clouds.push(Cloud::new(CloudId::new(&mut scene.next_id), &model, DVec3::Y * 1000.0));
        scene.models.push(model);
    }
    scene
}

fn session() -> Session {
    Session::new(scene(), None)
}

fn with_sprites(session: &Session, model: usize, sprite_count: u32) -> Edit {
    let model = &session.scene().models[model];
    Edit::Box(model.id, ListEdit::Replace(CloudBox { sprite_count, ..model.boxes[0].clone() }))
}

fn wait(session: &mut Session) {
    let context = egui::Context::default();
    for _ in 0..60_000 {
        session.keep_up(&context);
        if session.pending().is_none() {
            return;
        }
        std::thread::sleep(Duration::from_millis(1));
    }
    unreachable!("the work never ends");
}

fn assert_derived(session: &Session, when: &str) {
    assert!(session.derived().clouds() == Derived::new(session.scene()).clouds(), "{when}");
    assert!(!session.is_behind(), "{when}");
}

#[test]
fn much_is_derived_off_the_frame() {
    let mut session = session();
    let before = session.derived().clouds().to_vec();
    session.edit("Many", vec![with_sprites(&session, 0, MANY)]).expect("in range");
    let pending = session.pending().expect("that takes a while");
    assert_eq!((pending.what.as_str(), pending.can_cancel), ("Regenerating large", true));
    assert!(session.derived().clouds() == before, "the last good clouds are shown meanwhile");
    // Little things that come meanwhile wait with it.
    session.edit("Few", vec![with_sprites(&session, 1, 40)]).expect("in range");
    wait(&mut session);
    assert_derived(&session, "when it arrived");
    session.undo();
    session.undo();
    wait(&mut session);
    assert!(session.derived().clouds() == before);
    assert_eq!(session.steps, 0);
}

#[test]
fn little_is_derived_at_once() {
    let mut session = session();
    session.edit("Few", vec![with_sprites(&session, 1, 40)]).expect("in range");
    assert_eq!(session.pending(), None);
    assert_derived(&session, "at once");
}

#[test]
fn cancelling_takes_back_what_asked_for_the_work() {
    let mut session = session();
    session.edit("Few", vec![with_sprites(&session, 1, 40)]).expect("in range");
    let kept = session.scene().clone();
    session.edit("Many", vec![with_sprites(&session, 0, MANY)]).expect("in range");
    session.edit("Light", vec![Edit::TimeOfDay(9.0)]).expect("in range");
    session.cancel_pending();
    assert_eq!((session.scene(), session.pending()), (&kept, None));
    assert_derived(&session, "as before");
    // The way back to the work is redo; undo from it, and the way back is redo again.
    session.redo();
    wait(&mut session);
    assert_derived(&session, "redone");
    // A gesture is dropped.
    let many = session.scene().clone();
    session.drag("More", vec![with_sprites(&session, 0, MANY + 1000)]).expect("in range");
    session.cancel_pending();
    assert_eq!((session.scene(), session.document().is_open()), (&many, false));
    assert_derived(&session, "dropped");
    // With nothing pending there is nothing to cancel.
    session.cancel_pending();
    assert_eq!(session.scene(), &many);
}

#[test]
fn a_large_scene_opens_before_its_clouds() {
    let mut scene = scene();
    scene.models[0].boxes[0].sprite_count = 150_000;
    let mut session = Session::new(scene.clone(), None);
    assert!(session.pending().is_some_and(|pending| !pending.can_cancel));
    session.cancel_pending();
    assert_eq!(session.scene(), &scene);
    wait(&mut session);
    assert_derived(&session, "opened");
}

#[test]
fn nothing_is_lost_on_the_way_through_errors() {
    let mut session = session();
    session.drag("d", vec![with_sprites(&session, 0, TOO_MANY)]).expect("found");
    session.drag("d", vec![with_sprites(&session, 1, 7)]).expect("found");
    assert_eq!(session.derived().clouds()[1].candidate_count, 30, "clouds stay while there are errors");
    session.drag("d", vec![with_sprites(&session, 0, 31)]).expect("found");
    assert_derived(&session, "sound again");
    session.drag("d", vec![with_sprites(&session, 0, MANY)]).expect("found");
    session.drag("d", vec![with_sprites(&session, 0, TOO_MANY)]).expect("found");
    session.drag("d", vec![with_sprites(&session, 1, 8)]).expect("found");
    wait(&mut session);
    // What changed while there were errors, and clouds of before arrived, is not forgotten.
    session.drag("d", vec![with_sprites(&session, 0, 33)]).expect("found");
    assert_derived(&session, "sound once more");
    session.drag("d", vec![with_sprites(&session, 0, TOO_MANY)]).expect("found");
    session.commit().expect_err("there are too many");
    wait(&mut session);
    assert_derived(&session, "refused");
}

/// Gestures, large and small, good and bad, let go, dropped, undone and redone while work is pending.
#[test]
fn a_random_walk_ends_with_the_clouds_of_the_scene() {
    let context = egui::Context::default();
    for walk in 0..4 {
        let mut session = session();
        for step in 0..60 {
            let [what, which, size, _] = draw(walk, 5, step, 0);
            let which = which as usize % 2;
            match what % 12 {
                0 => drop(session.commit()),
                1 => session.cancel(),
                2 => drop(session.undo()),
                3 => drop(session.redo()),
                4 => session.cancel_pending(),
                5 => wait(&mut session),
                6 => session.drag("d", vec![with_sprites(&session, which, TOO_MANY)]).expect("found"),
                7 => session.drag("d", vec![Edit::TimeOfDay(f64::from(size % 24))]).expect("found"),
                8 | 9 => session.drag("d", vec![with_sprites(&session, 0, MANY + size % 3)]).expect("found"),
                _ => session.drag("d", vec![with_sprites(&session, which, size % 90)]).expect("found"),
            }
            session.keep_up(&context);
            if session.is_sound && session.pending().is_none() {
                assert_derived(&session, &format!("walk {walk}, step {step}"));
            }
        }
        let _ = session.commit();
        wait(&mut session);
        assert_derived(&session, &format!("walk {walk}"));
    }
}
