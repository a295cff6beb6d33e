//! The GPU's part of the command line. What it draws is tested in the render package; here it is enough that it draws
//! where there is an adapter, and says what to do where there is none.

use crate::Place;
use crate::scenes::changed;
use serde_json::json;

#[test]
fn a_picture_or_a_way_out() {
    let place = Place::new();
    for words in ["", " --samples 4"] {
        let ran = place.run(&format!("render good.cloudscene -o out.png --size 64x36 --renderer gpu{words}"));
        let required = std::env::var("CLOUDWRIGHT_REQUIRE_GPU").is_ok_and(|value| value == "1");
        assert!(ran.code == 0 || !required, "an adapter is required: {}", ran.stderr);
        if ran.code == 0 {
            assert!(ran.stderr.contains("GPU: "), "{}", ran.stderr);
            assert!(place.read("out.png").starts_with(b"\x89PNG"));
        } else {
            assert_eq!(ran.code, 3, "{}", ran.stderr);
            assert!(ran.stderr.contains("--renderer cpu"), "{}", ran.stderr);
            assert_eq!(place.files(), ["good.cloudscene"]);
        }
    }
}

/// An aircraft of the scene's own is drawn where its path has brought it, and a prop that stands there looks the same, by
/// the CPU and by a GPU.
#[test]
fn models_at_their_places() {
    let place = Place::new();
    place.put("own.glb", include_bytes!("../../../assets/models/aircraft.glb"));
    let key = |time_s: f64, x: f64| json!({ "time_s": time_s, "position": [x, 2486.0, 2975.0], "heading_deg": 90, "pitch_deg": 0 });
    place.put(
        "good.cloudscene",
        &changed(|scene| {
            scene["paths"] = json!([{ "id": 900, "name": "past", "field_of_view_deg": 55,
                "keys": [key(0.0, -60.0), key(4.0, 60.0)] }]);
            scene["aircraft"] = json!([{ "id": 901, "name": "own", "model": "own.glb", "path": 900, "ahead_s": 0 }]);
            scene["next_id"] = json!(1000);
        }),
    );
    let picture = |words: &str| {
        let ran = place.run(&format!("render good.cloudscene -o out.png --camera above --size 64x36 {words}"));
        (ran.code == 0).then(|| place.read("out.png"))
    };
    let mut flown = Vec::new();
    for renderer in ["cpu", "gpu"] {
        let at = |time: &str| picture(&format!("--renderer {renderer} {time}"));
        let (Some(before), Some(here)) = (at("--at 0"), at("--at 2")) else {
            let required = std::env::var("CLOUDWRIGHT_REQUIRE_GPU").is_ok_and(|value| value == "1");
            assert!(renderer == "gpu" && !required, "{renderer}: no picture");
            continue;
        };
        assert!(before != here, "{renderer}: at 0 s it is beside the picture, at 2 s before the camera");
        flown.push((renderer, here));
    }
    let stands = |scene: &mut serde_json::Value| {
        scene["props"] = json!([{ "id": 902, "name": "mast", "model": "own.glb", "position": [0, 2486, 2975],
            "heading_deg": 90 }]);
        scene["next_id"] = json!(1000);
    };
    place.put("good.cloudscene", &changed(stands));
    for (renderer, here) in flown {
        let stood = picture(&format!("--renderer {renderer} --at 2")).expect("as before");
        assert!(stood == here, "{renderer}: it stands where the other flew past");
    }
}

/// Drivers are hidden from the program, so this holds on a machine with a GPU too.
#[cfg(target_os = "linux")]
#[test]
fn without_an_adapter_it_says_what_to_do() {
    let place = Place::new();
    let hidden =
        ["VK_DRIVER_FILES", "VK_ICD_FILENAMES", "__EGL_VENDOR_LIBRARY_FILENAMES"].map(|name| (name, "/dev/null"));
    let run = |renderer: &str| {
        place.run_with(&hidden, &format!("render good.cloudscene -o out.png --size 64x36 --renderer {renderer}"))
    };
    let ran = run("gpu");
    assert_eq!(ran.code, 3, "{}", ran.stderr);
    assert!(ran.stderr.contains("--renderer cpu"), "{}", ran.stderr);
    assert_eq!(place.files(), ["good.cloudscene"]);
    let ran = run("auto");
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    assert!(ran.stderr.contains("renderer: CPU"), "{}", ran.stderr);
}
