//! Faults that a user can mend: where, what, and what to do. One check a file.
//!
//! A check walks the scene, or what a change touched of it (`scope`), and reports; it never changes anything. Errors make
//! a scene unusable (a file with one is not opened, a transaction that brings one is taken back); notes are worth a look
//! and refused by nobody.

mod camera_paths;
mod coarse_light;
mod crowded_group;
mod daily_tables;
mod duplicate_ids;
mod levels_out_of_order;
mod missing_references;
mod no_cameras;
mod not_a_rotation;
mod numbers_out_of_range;
mod reversed_ranges;
mod scope;
mod too_many_sprites;
mod tracks;
mod unused_groups;

pub use too_many_sprites::MAX_SPRITES_TRIED;
pub use tracks::MAX_KEYS;

use crate::change::Change;
use crate::property::{Described, Owner};
use crate::scene::{CloudBox, Scene};
use scope::Scope;
use std::fmt;

/// How bad a problem is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Worth a look.
    Note,
    /// The scene can't be used.
    Error,
}

/// A fault with its place and a way out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Problem {
    /// How bad.
    pub severity: Severity,
    /// Path in the document, such as `models[2].boxes[0].size`; or line and column of a file.
    pub place: String,
    /// What is wrong, with the value found.
    pub message: String,
    /// What to do about it.
    pub hint: String,
}

impl Problem {
    /// A fault that makes the scene unusable.
    pub fn error(place: impl Into<String>, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { severity: Severity::Error, place: place.into(), message: message.into(), hint: hint.into() }
    }

    /// Something worth a look.
    pub fn note(place: impl Into<String>, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { severity: Severity::Note, ..Self::error(place, message, hint) }
    }
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { place, message, hint, .. } = self;
        write!(f, "{place}: {message} ({hint})")
    }
}

/// All checks, in the order of their reports.
const CHECKS: &[fn(Scope<'_>, &mut Vec<Problem>)] = &[
    numbers_out_of_range::check,
    not_a_rotation::check,
    reversed_ranges::check,
    daily_tables::check,
    levels_out_of_order::check,
    duplicate_ids::check,
    missing_references::check,
    camera_paths::check,
    tracks::check,
    too_many_sprites::check,
    unused_groups::check,
    no_cameras::check,
];

/// Every problem of `scene` that can be seen without its sprites, errors and notes.
pub fn check(scene: &Scene) -> Vec<Problem> {
    check_touched(scene, &Change::everything())
}

/// Those problems of `scene` that lie in what `change` touched. If it had no errors before the change, these are all
/// its errors; notes on the rest are left out.
pub fn check_touched(scene: &Scene, change: &Change) -> Vec<Problem> {
    let mut problems = Vec::new();
    for check in CHECKS {
        check(Scope { scene, change }, &mut problems);
    }
    problems
}

/// Whether `scene`, which had no errors before `change`, has none after it.
pub fn stays_sound(scene: &Scene, change: &Change) -> bool {
    check_touched(scene, change).iter().all(|problem| problem.severity != Severity::Error)
}

/// What is wrong with `thing` by itself, which is not in a scene yet: numbers out of range, its parts' included. It is
/// to be `owner`, and `place` stands for it in what is said.
pub fn check_new<T: Described>(owner: Owner, place: &str, thing: &T) -> Vec<Problem> {
    let mut problems = Vec::new();
    numbers_out_of_range::check_new(owner, place, thing, &mut problems);
    problems
}

/// What is wrong with the turn or the ranges of `new` by itself, which is in no model yet.
pub fn check_new_box(place: &str, new: &CloudBox) -> Vec<Problem> {
    let mut problems = Vec::new();
    not_a_rotation::check_box(format_args!("{place}"), new, &mut problems);
    reversed_ranges::check_box(format_args!("{place}"), new, &mut problems);
    problems
}

/// The first two hundred, and how many more there are: a file can hold millions of faults.
pub fn shortened(mut problems: Vec<Problem>) -> Vec<Problem> {
    const MOST: usize = 200;
    if problems.len() > MOST {
        let more = problems.len() - MOST;
        problems.truncate(MOST);
        problems.push(Problem::error("…", format!("and {more} more"), "mend these first"));
    }
    problems
}

/// Every problem of `scene`, those of its sprites included: for a scene without errors.
pub fn check_with_sprites(scene: &Scene, clouds: &[crate::sprites::PlacedCloud]) -> Vec<Problem> {
    let mut problems = check(scene);
    crowded_group::check(scene, clouds, &mut problems);
    coarse_light::check(scene, clouds, &mut problems);
    problems
}

/// A minimally broken scene must be refused by exactly the check that owns the fault.
#[cfg(test)]
fn assert_found(scene: &Scene, place: &str, words: &str) {
    let problems = check(scene);
    assert!(
        problems.iter().any(|p| p.place == place && p.message.contains(words)),
        "no problem at {place} with “{words}” among {problems:#?}"
    );
}

/// A scene with one model of one box, placed once: without problems.
#[cfg(test)]
pub(crate) fn sound_scene() -> Scene {
    use crate::scene::{BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, ModelId};
    let mut scene = Scene::default();
    let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "heap", Category::CumulusHumilis);
    model.boxes.push(CloudBox::new(BoxId::new(&mut scene.next_id), glam::DVec3::ZERO));
    let cloud = Cloud::new(CloudId::new(&mut scene.next_id), &model, glam::DVec3::new(0.0, 1000.0, 0.0));
    scene.models.push(model);
    scene.clouds.push(cloud);
    assert_eq!(check(&scene), []);
    scene
}

/// The same with a path of two keys and an aircraft on it.
#[cfg(test)]
pub(crate) fn scene_with_flight() -> Scene {
    use crate::scene::{Aircraft, AircraftId, CameraPath, PathId, PathKey};
    use glam::DVec3;
    let mut scene = sound_scene();
    let key = |time_s, z| PathKey {
        time_s,
        position: DVec3::new(0.0, 1000.0, z),
        heading_deg: 0.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let path = CameraPath::new(PathId::new(&mut scene.next_id), "through", vec![key(0.0, 900.0), key(20.0, -900.0)]);
    let aircraft = Aircraft::new(AircraftId::new(&mut scene.next_id), "leader", path.id);
    scene.paths.push(path);
    scene.aircraft.push(aircraft);
    assert_eq!(check(&scene), []);
    scene
}
