//! A path runs forward in time from its first key, and the model of an aircraft or a prop lies beside the scene.
//!
//! Two places at one time can't both be flown through, and keys in disorder are mostly a slip of the pen. A path of one
//! key stands still: mentioned, since it may be in the making. A scene from elsewhere has no business with files in
//! other folders; that its model's file is there and sound is seen when it is opened.

use super::Problem;
use super::scope::Scope;
use crate::flight::SHORTEST_LEG_S;
use crate::scene::{Aircraft, CameraPath, Prop};

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    for (i, path) in scope.all::<CameraPath>() {
        check_path(i, path, problems);
    }
    let mut check_name = |place: String, name: &str, hint: &str| {
        if !is_file_name(name) {
            problems.push(Problem::error(place, format!("“{name}” doesn't lie beside the scene file"), hint));
        }
    };
    for (i, aircraft) in scope.all::<Aircraft>() {
        if let Some(name) = &aircraft.model {
            let hint = "copy it there, and give its name alone; take `model` out for the built-in aircraft";
            check_name(format!("aircraft[{i}].model"), name, hint);
        }
    }
    for (i, prop) in scope.all::<Prop>() {
        check_name(format!("props[{i}].model"), &prop.model, "copy it there, and give its name alone");
    }
}

fn check_path(i: usize, path: &CameraPath, problems: &mut Vec<Problem>) {
    match path.keys.len() {
        0 => problems.push(Problem::error(
            format!("paths[{i}].keys"),
            "the path has no keys",
            "give it one for each place on the way, two at least, or delete it",
        )),
        1 => problems.push(Problem::note(
            format!("paths[{i}].keys"),
            "the path has one key, so it stands still",
            "add a key with a later time",
        )),
        _ => {}
    }
    for (j, pair) in path.keys.windows(2).enumerate() {
        let (before, time) = (pair[0].time_s, pair[1].time_s);
        // What is no number at all is told by its range.
        if time < before + SHORTEST_LEG_S {
            problems.push(Problem::error(
                format!("paths[{i}].keys[{}].time_s", j + 1),
                format!("{time} s doesn't come after the key before it, at {before} s"),
                format!("give each key a later time than the one before it, by {SHORTEST_LEG_S} s or more"),
            ));
        }
    }
}

/// Whether it is a file's name alone, on any system.
fn is_file_name(name: &str) -> bool {
    !name.is_empty() && name != "." && name != ".." && !name.contains(['/', '\\', ':'])
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, check, scene_with_flight};

    #[test]
    fn refuses_keys_out_of_order() {
        let mut scene = scene_with_flight();
        let first = scene.paths[0].keys[0];
        for (time_s, is_sound) in [(first.time_s, false), (first.time_s + 0.0005, false), (first.time_s + 0.001, true)]
        {
            scene.paths[0].keys[1].time_s = time_s;
            assert_eq!(check(&scene).is_empty(), is_sound, "{time_s}");
        }
        scene.paths[0].keys[0].time_s = 9.0;
        assert_found(&scene, "paths[0].keys[1].time_s", "at 9 s");
        scene.paths[0].keys.truncate(1);
        assert_found(&scene, "paths[0].keys", "stands still");
        scene.paths[0].keys.clear();
        assert_found(&scene, "paths[0].keys", "no keys");
    }

    #[test]
    fn refuses_models_from_elsewhere() {
        let mut scene = scene_with_flight();
        for bad in ["", "..", "../jet.glb", "/etc/passwd", "models/jet.glb", "..\\jet.glb", "C:jet.glb"] {
            scene.aircraft[0].model = Some(bad.into());
            assert_found(&scene, "aircraft[0].model", "beside");
        }
        scene.aircraft[0].model = Some("jet 2.glb".into());
        assert_eq!(check(&scene), []);
    }
}
