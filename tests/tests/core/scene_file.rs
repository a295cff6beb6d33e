//! The scene file's reader against whatever bytes there are: a scene, or problems with place and hint; never a panic.

use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Severity;
use cloudwright_core::scene::{
    Aircraft, AircraftId, Folder, FolderId, Formation, FormationChange, PathId, Prop, PropId,
};
use cloudwright_tests::small_scenes::heap;
use glam::DVec3;
use proptest::prelude::*;

fn good() -> String {
    scene_file::write(&heap(20)).expect("finite numbers")
}

fn check(bytes: &[u8]) -> Result<(), TestCaseError> {
    match scene_file::read(bytes) {
        Ok(scene) => {
            let written = scene_file::write(&scene).expect("a sound scene has only finite numbers");
            prop_assert_eq!(scene_file::read(written.as_bytes()), Ok(scene));
        }
        Err(problems) => {
            prop_assert!(!problems.is_empty());
            for problem in problems {
                prop_assert!(
                    !problem.place.is_empty() && !problem.message.is_empty() && !problem.hint.is_empty(),
                    "{problem}"
                );
                prop_assert_eq!(problem.severity, Severity::Error);
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        check(&bytes)?;
    }

    /// A sound file with a few bytes replaced by others that mean something in JSON.
    #[test]
    fn damaged_files(hits in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(b"{}[]\",:-.0e9tn \xff".to_vec())), 1..4)) {
        let mut bytes = good().into_bytes();
        for (at, byte) in hits {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        check(&bytes)?;
    }

    #[test]
    fn truncated_files(at in any::<prop::sample::Index>()) {
        let text = good();
        let cut = at.index(text.len() - 2);
        let problems = scene_file::read(&text.as_bytes()[..cut]).expect_err("half a file is no scene");
        prop_assert!(problems[0].place.contains("line"), "{}", problems[0]);
    }

    /// A number of a sound file replaced by one that is too large, too small, or of the wrong kind.
    #[test]
    fn wild_numbers(at in any::<prop::sample::Index>(), wild in prop::sample::select(vec!["1e999", "-1e300", "1e300", "-1", "null", "\"7\"", "1000000000", "0.5", "[]"])) {
        let text = good();
        let starts: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(i, _)| i).collect();
        let start = starts[at.index(starts.len())];
        let length = text[start..].find(|c: char| !(c.is_ascii_digit() || c == '.')).unwrap_or(1);
        check(format!("{}{wild}{}", &text[..start], &text[start + length..]).as_bytes())?;
    }
}

#[test]
fn folders_round_trip_and_must_be_there() {
    let mut scene = heap(20);
    let id = FolderId::new(&mut scene.next_id);
    scene.folders.push(Folder { hidden: true, ..Folder::new(id, "Anvils") });
    scene.clouds[0].folder = Some(id);
    let text = scene_file::write(&scene).expect("finite");
    assert!(!good().contains("folder"), "a scene without folders is as it was");
    assert!(text.contains("\"hidden\": true") && !text.contains("locked"));
    assert_eq!(scene_file::read(text.as_bytes()).as_ref(), Ok(&scene));
    let bare = text.replace("\"hidden\": true", "\"locked\": true");
    assert!(scene_file::read(bare.as_bytes()).is_ok_and(|scene| scene.folders[0].locked && !scene.folders[0].hidden));
    scene.folders.push(scene.folders[0].clone());
    scene.clouds[0].folder = Some(FolderId(99));
    let problems = scene_file::read(scene_file::write(&scene).expect("finite").as_bytes()).expect_err("two faults");
    for (place, message) in [("clouds[0].folder", "there is no folder 99"), ("folders[1].id", "taken already")] {
        assert!(
            problems.iter().any(|problem| problem.place == place && problem.message.contains(message)),
            "{problems:?}"
        );
    }
}

#[test]
fn round_trips_byte_for_byte() {
    let text = good();
    let scene = scene_file::read(text.as_bytes()).expect("sound");
    assert_eq!(scene_file::write(&scene).expect("finite"), text);
    assert_eq!(scene, heap(20));
}

#[test]
fn what_flights_leave_out_has_its_default() {
    let mut json: serde_json::Value = serde_json::from_str(&good()).expect("JSON");
    let scene = &mut json["scene"];
    scene["next_id"] = 100.into();
    scene["clouds"][0]["formation"] = serde_json::json!({ "change": "dissipating", "core_s": 5 });
    let key =
        |time_s| serde_json::json!({ "time_s": time_s, "position": [0, 500, 0], "heading_deg": 0, "pitch_deg": 0 });
    scene["paths"] =
        serde_json::json!([{ "id": 50, "name": "through", "field_of_view_deg": 50, "keys": [key(0), key(9)] }]);
    scene["aircraft"] = serde_json::json!([{ "id": 51, "name": "leader", "path": 50 }]);
    scene["props"] = serde_json::json!([{ "id": 52, "name": "prop", "model": "mast.glb", "position": [1, 2, 3] }]);
    let scene = scene_file::read(json.to_string().as_bytes()).expect("sound");
    let change = FormationChange::Dissipating;
    assert_eq!(scene.clouds[0].formation, Some(Formation { change, core_s: 5.0, ..Formation::default() }));
    assert_eq!(scene.paths[0].keys[1].roll_deg, 0.0);
    assert_eq!(scene.aircraft, vec![Aircraft::new(AircraftId(51), "leader", PathId(50))].into());
    assert_eq!(scene.props, vec![Prop::new(PropId(52), "mast.glb", DVec3::new(1.0, 2.0, 3.0))].into());
    assert_eq!(scene.sky.inside_density, 1.0);
    let text = scene_file::write(&scene).expect("finite");
    assert!(!text.contains("inside_density"), "the default is not written");
    assert_eq!(scene_file::read(text.as_bytes()), Ok(scene));
}
