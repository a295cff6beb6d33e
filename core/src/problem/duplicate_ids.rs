//! An id belongs to one thing of its kind, and the counter is beyond them all: else edits would hit the wrong thing and
//! a new one would get an old id. Cameras' names are what the command line knows them by, so they differ too.

use super::Problem;
use crate::scene::Scene;
use std::collections::{BTreeMap, BTreeSet};

/// What JSON's readers hold exactly; a scene will not get that far by adding things.
const LAST_ID: u64 = 1 << 53;

pub(super) fn check(scene: &Scene, problems: &mut Vec<Problem>) {
    if scene.next_id.0 > LAST_ID {
        let message = format!("{} leaves no ids for new things", scene.next_id.0);
        problems.push(Problem::error("next_id", message, "set it to one more than the largest id in the scene"));
    }
    let mut check_kind = |ids: Vec<(u64, String)>| {
        let mut seen: BTreeMap<u64, String> = BTreeMap::new();
        for (id, place) in ids {
            if id >= scene.next_id.0 {
                let hint = format!("raise next_id above {id}");
                problems.push(Problem::error(
                    &place,
                    format!("id {id} is not below next_id, {}", scene.next_id.0),
                    hint,
                ));
            }
            if let Some(first) = seen.get(&id) {
                problems.push(Problem::error(
                    &place,
                    format!("id {id} is taken already, at {first}"),
                    "give it an id of its own",
                ));
            } else {
                seen.insert(id, place);
            }
        }
    };
    let models = || scene.models.iter().enumerate();
    check_kind(scene.cameras.iter().enumerate().map(|(i, c)| (c.id.0, format!("cameras[{i}].id"))).collect());
    check_kind(models().map(|(i, m)| (m.id.0, format!("models[{i}].id"))).collect());
    check_kind(scene.clouds.iter().enumerate().map(|(i, c)| (c.id.0, format!("clouds[{i}].id"))).collect());
    check_kind(
        models()
            .flat_map(|(i, m)| {
                m.boxes.iter().enumerate().map(move |(j, b)| (b.id.0, format!("models[{i}].boxes[{j}].id")))
            })
            .collect(),
    );
    check_kind(
        models()
            .flat_map(|(i, m)| {
                m.groups.iter().enumerate().map(move |(j, g)| (g.id.0, format!("models[{i}].groups[{j}].id")))
            })
            .collect(),
    );
    let mut names = BTreeSet::new();
    for (i, camera) in scene.cameras.iter().enumerate() {
        if !names.insert(&camera.name) {
            problems.push(Problem::error(
                format!("cameras[{i}].name"),
                format!("another camera is called “{}” too", camera.name),
                "give each camera a name of its own",
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn refuses() {
        let mut scene = sound_scene();
        scene.clouds.push(scene.clouds[0].clone());
        scene.cameras.push(scene.cameras[0].clone());
        let mut last = scene.clone();
        last.next_id.0 = u64::MAX;
        assert_found(&last, "next_id", "no ids");
        scene.next_id.0 = 2;
        assert_found(&scene, "clouds[1].id", "taken already, at clouds[0].id");
        assert_found(&scene, "models[0].id", "next_id");
        assert_found(&scene, "cameras[1].name", "called");
    }
}
