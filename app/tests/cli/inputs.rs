//! What is read is never written over, by whatever name the output leads to it.

use crate::Place;
use crate::scenes::{aircraft, changed};
use serde_json::{Value, json};

const ATLAS: &[u8] = include_bytes!("../../../assets/atlas/clouds.png");
const MODEL: &[u8] = include_bytes!("../../../assets/models/aircraft.glb");

/// A scene with an atlas and a model of its own, all of which must stay as they are; names of an atlas's kind, so that
/// only what they are speaks against them.
struct Guarded {
    place: Place,
    scene: Vec<u8>,
}

impl Guarded {
    fn new(atlas: &str, model: &str) -> Self {
        let place = Place::new();
        let scene = changed(|scene| with_own_files(scene, atlas, model));
        std::fs::create_dir(place.path("out")).expect("writable");
        std::fs::create_dir(place.path("out_frames")).expect("writable");
        for (name, bytes) in [("own.cloudscene", &scene[..]), (atlas, ATLAS), (model, MODEL)] {
            place.put(name, bytes);
        }
        Self { place, scene }
    }

    fn refuses(&self, words: &str, wanted: &[&str], atlas: &str, model: &str) {
        self.place.refuses(words, 2, wanted);
        for (name, bytes) in [("own.cloudscene", &self.scene[..]), (atlas, ATLAS), (model, MODEL)] {
            assert!(self.place.read(name) == bytes, "cloudwright {words}: {name} has changed");
        }
    }
}

fn with_own_files(scene: &mut Value, atlas: &str, model: &str) {
    aircraft(scene, model);
    let end = json!({ "time_s": 0.1, "position": [0, 1000, 9], "heading_deg": 0, "pitch_deg": 0 });
    scene["paths"][0]["keys"].as_array_mut().expect("keys").push(end);
    scene["atlas"] = json!(atlas);
}

#[test]
fn no_output_is_an_input() {
    let (atlas, model) = ("own.png", "leader.json");
    let guarded = Guarded::new(atlas, model);
    let path = |name: &str| guarded.place.path(name);
    std::fs::hard_link(path(atlas), path("hard.png")).expect("allowed");
    std::fs::hard_link(path("own.cloudscene"), path("hard.csv")).expect("allowed");
    std::fs::hard_link(path(model), path("out/chart.json")).expect("allowed");
    std::fs::hard_link(path(model), path("hard.mp4")).expect("allowed");
    #[cfg(unix)]
    std::os::unix::fs::symlink(atlas, path("soft.png")).expect("allowed");
    let is_atlas = &["the scene's atlas, own.png", "another name"][..];
    let is_model = &["the scene's model, leader.json", "another name"][..];
    let is_scene = &["the scene itself", "another name"][..];
    for (words, wanted) in [
        ("render own.cloudscene -o own.png", is_atlas),
        ("render own.cloudscene -o ./own.png", is_atlas),
        ("render own.cloudscene -o out/../own.png", is_atlas),
        ("render own.cloudscene -o hard.png", is_atlas),
        #[cfg(unix)]
        ("render own.cloudscene -o soft.png", is_atlas),
        ("export own.cloudscene -o leader.json", is_model),
        ("export own.cloudscene -o hard.csv", is_scene),
        ("chart own.cloudscene -o out", is_model),
        ("thin own.cloudscene -o ./own.cloudscene --force", is_scene),
        ("fly own.cloudscene --path west -o hard.mp4", is_model),
    ] {
        guarded.refuses(words, wanted, atlas, model);
    }
}

#[test]
fn no_frame_and_no_video_is_an_input() {
    for (atlas, link, words) in [
        ("west_00002.png", None, "-o ."),
        ("own.png", Some("out/west_00003.png"), "-o out"),
        ("own.png", Some("out_frames/west_00000.png"), "-o out.mp4"),
        ("own.png", Some("out_frames/unfinished.mp4"), "-o out.mp4"),
    ] {
        let guarded = Guarded::new(atlas, "leader.glb");
        if let Some(link) = link {
            std::fs::hard_link(guarded.place.path(atlas), guarded.place.path(link)).expect("allowed");
        }
        // As large as the atlas, so that it would be taken for a frame that is there already.
        let fly = "fly own.cloudscene --path west --renderer cpu --size 512x512";
        guarded.refuses(&format!("{fly} {words}"), &["the scene's atlas", atlas], atlas, "leader.glb");
    }
    let guarded = Guarded::new("west_00002.png", "leader.glb");
    let ran = guarded.place.run("fly own.cloudscene --path west --renderer cpu --size 64x36 -o . --frames 0..2");
    assert_eq!(ran.code, 0, "other frames are none of it: {}", ran.stderr);
    assert!(guarded.place.read("west_00002.png") == ATLAS);
}
