//! The tracks of things that go, are copied, or are no longer to move.

use super::Rekeyed;
use crate::document::Edit;
use crate::property::{Owner, Target};
use crate::scene::{Scene, Thing, Track};
use std::collections::BTreeSet;

/// The tracks of what is doomed, and of what is part of it.
pub(in crate::arrange) fn doomed(scene: &Scene, things: &BTreeSet<Thing>) -> Vec<Thing> {
    let is_doomed = |track: &&Track| {
        let target = track.property.parse::<Target>();
        target.is_ok_and(|target| holders(target.owner).into_iter().flatten().any(|thing| things.contains(&thing)))
    };
    scene.tracks.iter().filter(is_doomed).map(|track| Thing::Track(track.id)).collect()
}

/// Without the tracks of `things`, and of what is part of them.
pub fn cleared_of(scene: &Scene, things: &[Thing]) -> Rekeyed {
    let tracks = doomed(scene, &things.iter().copied().collect());
    Rekeyed { edits: tracks.into_iter().filter_map(Edit::removing).collect(), chosen: BTreeSet::new() }
}

/// What an owner is, and what it is part of, of the things that can be chosen.
fn holders(owner: Owner) -> [Option<Thing>; 2] {
    match owner {
        Owner::Thing(thing @ (Thing::Box(model, _) | Thing::Group(model, _) | Thing::Sprite(model, ..))) => {
            [Some(thing), Some(Thing::Model(model))]
        }
        Owner::Thing(thing) => [Some(thing), None],
        Owner::Level(model, _) => [Some(Thing::Model(model)), None],
        Owner::Key(path, _) => [Some(Thing::Path(path)), None],
        _ => [None, None],
    }
}

/// For each track whose owner has copies, its properties at those, with the track: `copies` tells the copies of an owner.
pub(in crate::arrange) fn of_copies(scene: &Scene, copies: impl Fn(Owner) -> Vec<Owner>) -> Vec<(Target, &Track)> {
    let targets = scene.tracks.iter().filter_map(|track| Some((track.property.parse::<Target>().ok()?, track)));
    let copied = targets.flat_map(|(target, track)| {
        let new = copies(target.owner).into_iter();
        new.map(move |owner| (Target { owner, ..target }, track)).collect::<Vec<_>>()
    });
    copied.collect()
}
