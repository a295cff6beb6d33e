//! An id belongs to one thing of its kind, and the counter is beyond them all: else edits would hit the wrong thing and
//! a new one would get an old id. Cameras' and paths' names are what the command line knows them by, so they differ too.

use super::Problem;
use super::scope::Scope;
use crate::scene::{CloudModel, ForKind, Listed, Scene, for_each_kind};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// What JSON's readers hold exactly; a scene will not get that far by adding things.
const LAST_ID: u64 = 1 << 53;

pub(super) fn check(Scope { scene, change }: Scope<'_>, problems: &mut Vec<Problem>) {
    if scene.next_id.0 > LAST_ID {
        let message = format!("{} leaves no ids for new things", scene.next_id.0);
        problems.push(Problem::error("next_id", message, "set it to one more than the largest id in the scene"));
    }
    let mut ids = Ids { scene, problems };
    // What is in no list but the scene's keeps its id as long as it is there.
    if change.touches_lists() {
        for_each_kind(&mut ids);
    }
    if change.touches_lists() || change.touches_models() {
        let boxes = |model: &CloudModel| model.boxes.iter().map(|each| each.id.0).collect();
        ids.check(&mut parts(scene, boxes), &|[i, j]| format!("models[{i}].boxes[{j}].id"));
        let groups = |model: &CloudModel| model.groups.iter().map(|group| group.id.0).collect();
        ids.check(&mut parts(scene, groups), &|[i, j]| format!("models[{i}].groups[{j}].id"));
    }
    check_names("camera", "cameras", scene.cameras.iter().map(|camera| camera.name.as_str()), problems);
    check_names("path", "paths", scene.paths.iter().map(|path| path.name.as_str()), problems);
}

struct Ids<'a> {
    scene: &'a Scene,
    problems: &'a mut Vec<Problem>,
}

impl Ids<'_> {
    /// Places are put into words only where something is wrong: a drag asks at every step.
    fn check(&mut self, ids: &mut dyn Iterator<Item = (u64, [usize; 2])>, place: &dyn Fn([usize; 2]) -> String) {
        let next_id = self.scene.next_id.0;
        let mut seen: FxHashMap<u64, [usize; 2]> = FxHashMap::default();
        for (id, at) in ids {
            if id >= next_id {
                let message = format!("id {id} is not below next_id, {next_id}");
                self.problems.push(Problem::error(place(at), message, format!("raise next_id above {id}")));
            }
            if let Some(first) = seen.get(&id) {
                let message = format!("id {id} is taken already, at {}", place(*first));
                self.problems.push(Problem::error(place(at), message, "give it an id of its own"));
            } else {
                seen.insert(id, at);
            }
        }
    }
}

impl ForKind for Ids<'_> {
    fn kind<T: Listed>(&mut self) {
        let mut ids = T::list(self.scene).iter().enumerate().map(|(i, value)| (value.id().into(), [i, 0]));
        self.check(&mut ids, &|[i, _]| format!("{}[{i}].id", T::LIST));
    }
}

/// Ids of parts of all models, with the positions of model and part.
fn parts(scene: &Scene, ids: impl Fn(&CloudModel) -> Vec<u64>) -> impl Iterator<Item = (u64, [usize; 2])> {
    scene
        .models
        .iter()
        .enumerate()
        .flat_map(move |(i, model)| ids(model).into_iter().enumerate().map(move |(j, id)| (id, [i, j])))
}

fn check_names<'a>(kind: &str, list: &str, names: impl Iterator<Item = &'a str>, problems: &mut Vec<Problem>) {
    let mut taken = BTreeSet::new();
    for (i, name) in names.enumerate() {
        if !taken.insert(name) {
            problems.push(Problem::error(
                format!("{list}[{i}].name"),
                format!("another {kind} is called “{name}” too"),
                format!("give each {kind} a name of its own"),
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, scene_with_flight};

    #[test]
    fn refuses() {
        let mut scene = scene_with_flight();
        scene.clouds.push(scene.clouds[0].clone());
        scene.cameras.push(scene.cameras[0].clone());
        scene.paths.push(scene.paths[0].clone());
        scene.aircraft.push(scene.aircraft[0].clone());
        let mut last = scene.clone();
        last.next_id.0 = u64::MAX;
        assert_found(&last, "next_id", "no ids");
        scene.next_id.0 = 2;
        assert_found(&scene, "clouds[1].id", "taken already, at clouds[0].id");
        assert_found(&scene, "models[0].id", "next_id");
        assert_found(&scene, "cameras[1].name", "called");
        assert_found(&scene, "paths[1].id", "taken already, at paths[0].id");
        assert_found(&scene, "paths[1].name", "another path");
        assert_found(&scene, "aircraft[1].id", "taken already, at aircraft[0].id");
    }
}
