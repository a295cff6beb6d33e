//! Scenes to try: a sound one, and ways to break its text.

use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::{
    BoxId, Camera, CameraId, Category, Cloud, CloudBox, CloudId, CloudModel, ModelId, Scene,
};
use glam::DVec3;
use serde_json::json;

/// A model of two boxes, placed twice, with two cameras; small enough for quick pictures.
pub(crate) fn good_scene() -> Scene {
    let mut scene = Scene { name: "good".into(), ..Scene::default() };
    let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "heap", Category::CumulusHumilis);
    for x in [-200.0, 200.0] {
        model.boxes.push(CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::new(x, 0.0, 0.0)));
    }
    for (name, x) in [("west", -900.0), ("east", 900.0)] {
        let cloud = Cloud::new(CloudId::new(&mut scene.next_id), &model, DVec3::new(x, 900.0, 0.0));
        scene.clouds.push(Cloud { name: name.into(), ..cloud });
    }
    scene.models.push(model);
    let above = Camera {
        pitch_deg: -30.0,
        ..Camera::new(CameraId::new(&mut scene.next_id), "above", DVec3::new(0.0, 2500.0, 3000.0))
    };
    scene.cameras.push(above);
    scene
}

/// Its file.
pub(crate) fn good() -> String {
    text(&good_scene())
}

/// The file of any sound scene.
pub(crate) fn text(scene: &Scene) -> String {
    scene_file::write(scene).expect("a sound scene")
}

/// Its file, changed as a JSON value.
pub(crate) fn changed(change: impl FnOnce(&mut serde_json::Value)) -> Vec<u8> {
    let mut json: serde_json::Value = serde_json::from_str(&good()).expect("JSON");
    change(&mut json["scene"]);
    serde_json::to_vec_pretty(&json).expect("JSON")
}

/// Its file with a piece of text replaced; the piece must be there.
pub(crate) fn replaced(from: &str, to: &str) -> Vec<u8> {
    let text = good();
    assert!(text.contains(from), "no {from} in the scene");
    text.replacen(from, to, 1).into_bytes()
}

/// Flies an aircraft of that model along a path of one key, `west`.
pub(crate) fn aircraft(scene: &mut serde_json::Value, model: &str) {
    let key = json!({ "time_s": 0, "position": [0, 1000, 0], "heading_deg": 0, "pitch_deg": 0 });
    scene["paths"] = json!([{ "id": 900, "name": "west", "field_of_view_deg": 55, "keys": [key] }]);
    scene["aircraft"] = json!([{ "id": 901, "name": "leader", "model": model, "path": 900 }]);
    scene["next_id"] = json!(1000);
}
