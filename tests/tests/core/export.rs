//! What leaves for other tools says what is drawn.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::{sprites_csv, sprites_json};
use cloudwright_core::frame::Frame;
use cloudwright_core::posed_sprite::Still;
use cloudwright_core::scene::{CullRadius, Formation};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{CloudNow, Light, WeatherRules};
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};
use serde_json::Value;

fn as_json(clouds: &[CloudNow<'_>], shaded: Option<Still<'_>>) -> Value {
    let mut text = Vec::new();
    sprites_json::write(&mut text, clouds, shaded, &Watch::default()).expect("memory takes all");
    serde_json::from_slice(&text).expect("JSON")
}

fn as_table(clouds: &[CloudNow<'_>], shaded: Option<Still<'_>>) -> String {
    let mut text = Vec::new();
    sprites_csv::write(&mut text, clouds, shaded, &Watch::default()).expect("memory takes all");
    String::from_utf8(text).expect("text")
}

fn at_rest(derived: &Derived) -> Vec<CloudNow<'_>> {
    derived.clouds_at(0.0, WeatherRules::default())
}

fn point(value: &Value) -> DVec3 {
    DVec3::from_array(std::array::from_fn(|i| value[i].as_f64().expect("a number")))
}

fn shaded_heap() -> (Value, DVec3) {
    let scene = heap(20);
    let derived = Derived::new(&scene);
    let view = View::new(&scene.cameras[0], 1280, 720);
    let light = Light::at(&scene, 17.5);
    let still = Still { view: &view, light: &light };
    (as_json(&at_rest(&derived), Some(still)), scene.cameras[0].position)
}

/// The shading formulas once more, in f64 and from the exported figures alone.
#[test]
fn corners_follow_from_the_exported_figures() {
    let (file, eye) = shaded_heap();
    assert_eq!((&file["format"], &file["version"]), (&Value::from("cloudwright-sprites"), &Value::from(1)));
    assert_eq!(file["light"]["time"], "17:30");
    let sun = point(&file["light"]["sun_direction"]);
    let cloud = &file["clouds"][0];
    let (bottom, top) = (cloud["bottom"].as_f64().expect("bottom"), cloud["top"].as_f64().expect("top"));
    let levels: Vec<(f64, DVec3)> = cloud["color_levels"]
        .as_array()
        .expect("levels")
        .iter()
        .map(|l| (l["height"].as_f64().expect("height"), point(&l["rgba"])))
        .collect();
    assert_eq!(levels.len(), 5);
    for sprite in cloud["sprites"].as_array().expect("sprites") {
        let group =
            cloud["groups"].as_array().expect("groups").iter().find(|g| g["id"] == sprite["group"]).expect("its group");
        let corners = sprite["corners"].as_array().expect("corners");
        for corner in corners {
            let position = point(&corner["position"]);
            let height = ((position.y - bottom) / (top - bottom)).clamp(0.0, 1.0);
            assert!((corner["height"].as_f64().expect("height") - height).abs() < 1e-4);
            let above = levels.iter().position(|l| l.0 > height).unwrap_or(4);
            let (from, to) = (levels[above - 1], levels[above]);
            let level = from.1.lerp(to.1, (height - from.0) / (to.0 - from.0));
            let ambient = level * point(&file["light"]["ambient_max"]);
            assert!(point(&corner["ambient"]).distance(ambient) < 1e-4);
            let c = |name: &str| group[name].as_f64().expect("a number");
            let d = (position - point(&group["center"])).normalize().dot(sun);
            let share = if d < 0.0 {
                c("c_med") + d * (c("c_med") - c("c_min"))
            } else {
                c("c_med") + d * (c("c_max") - c("c_med"))
            };
            let directional = point(&file["light"]["directional_max"]) * share;
            assert!(point(&corner["directional"]).distance(directional) < 1e-4);
            assert!(point(&corner["color"]).distance(ambient + directional) < 2e-4);
        }
        // Top left to top right is the width, across the line of sight.
        let [a, b, c, d] = std::array::from_fn(|i| point(&corners[i]["position"]));
        let to_eye = (eye - point(&sprite["position"])).normalize();
        assert!(((b - a).length() - sprite["width"].as_f64().expect("width")).abs() < 1e-2);
        assert!(((d - a).length() - sprite["height"].as_f64().expect("height")).abs() < 1e-2);
        assert!((b - a).normalize().dot(to_eye).abs() < 1e-4 && (c - b).normalize().dot(to_eye).abs() < 1e-4);
        // Turned back by its rotation, the first corner is the one at the top left.
        let rotation = sprite["rotation_deg"].as_f64().expect("degrees").to_radians();
        let right = DVec3::Y.cross(to_eye).normalize();
        let along = (b - a).normalize();
        let up = to_eye.cross(right);
        let seen = along.dot(up).atan2(along.dot(right));
        let off = (seen - rotation).rem_euclid(std::f64::consts::TAU);
        assert!(off.min(std::f64::consts::TAU - off) < 1e-3, "counter-clockwise as seen: {seen} for {rotation}");
    }
}

#[test]
fn without_light_there_are_no_corners() {
    let scene = heap(5);
    let derived = Derived::new(&scene);
    let file = as_json(&at_rest(&derived), None);
    assert!(file.get("light").is_none() && file["clouds"][0]["sprites"][0].get("corners").is_none());
}

#[test]
fn a_table_has_a_line_a_sprite() {
    let mut scene = heap(20);
    scene.clouds[0].name = "odd, \"name\"".into();
    let derived = Derived::new(&scene);
    let text = as_table(&at_rest(&derived), None);
    assert_eq!(text.lines().count(), 1 + derived.clouds()[0].sprites.len());
    assert!(text.lines().nth(1).expect("a sprite").contains("\"odd, \"\"name\"\"\""));
    let view = View::new(&scene.cameras[0], 100, 100);
    let light = Light::at(&scene, 12.0);
    let shaded = as_table(&at_rest(&derived), Some(Still { view: &view, light: &light }));
    assert_eq!(shaded.lines().next().map(|head| head.split(',').count()), Some(13 + 16));
}

/// A cloud that forms from 10 s to 20 s is clear before, and whole after.
#[test]
fn corners_are_as_far_as_the_cloud_has_formed() {
    let mut scene = heap(20);
    scene.clouds[0].formation =
        Some(Formation { start_s: 10.0, core_s: 5.0, edges_s: 5.0, threshold: 1.0, ..Formation::default() });
    let derived = Derived::new(&scene);
    let (view, light) = (View::new(&scene.cameras[0], 100, 100), Light::at(&scene, 12.0));
    let largest_alpha = |clock_s: f64| {
        let shaded = Some(Still { view: &view, light: &light });
        let text = as_table(&derived.clouds_at(clock_s, WeatherRules::default()), shaded);
        let alphas = text.lines().skip(1).filter_map(|line| line.rsplit(',').next()?.parse::<f32>().ok());
        alphas.fold(0.0, f32::max)
    };
    assert_eq!(largest_alpha(10.0), 0.0);
    assert!(largest_alpha(14.0) > 0.0 && largest_alpha(14.0) < largest_alpha(20.0), "{}", largest_alpha(14.0));
    assert_eq!(largest_alpha(20.0), largest_alpha(1e6));
}

/// What leaves is what is drawn: pose and light of each sprite in a picture, and in the export for the same eye.
#[test]
fn a_picture_and_an_export_show_one_sprite() {
    let scene = heap(200);
    let derived = Derived::new(&scene);
    // Into the heap, so that some of its sprites are near enough to have a pose of their own and to fade.
    let mut camera = scene.cameras[0].clone();
    camera.position = scene.clouds[0].position;
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&camera, [640, 360]));
    let still = Still { view: &frame.view, light: &frame.now.light };
    let mut faded = 0;
    for drawn in &frame.list.sprites {
        let cloud = &frame.now.clouds[drawn.cloud as usize];
        let (drawn, left) = (frame.posed(drawn), still.posed(cloud, drawn.sprite as usize));
        // Near the eye the two measure the way to it by different sums: some units in the last place of 100 m and of 1.
        for (a, b) in drawn.corners(Vec3::ZERO).into_iter().zip(left.corners(Vec3::ZERO)) {
            assert!(a.distance(b) < 1e-3, "{a} {b}");
            let (drawn, left) = (drawn.light_at(b), left.light_at(b));
            assert_eq!((drawn.ambient.rgb, drawn.directional), (left.ambient.rgb, left.directional));
            assert!((drawn.ambient.a - left.ambient.a).abs() < 1e-5, "{drawn:?} {left:?}");
        }
        faded += usize::from(left.pose.fade < 1.0);
    }
    assert!(faded > 0 && faded < frame.list.sprites.len(), "{faded} of {}", frame.list.sprites.len());
}

/// A disk that is full after 100 kB, by when the writer has looked at few of the sprites: the rest is never in memory.
#[test]
fn text_leaves_as_it_is_made() {
    let mut scene = heap(3000);
    scene.models[0].cull_radius = CullRadius::Metres(0.0);
    let derived = Derived::new(&scene);
    let (view, light) = (View::new(&scene.cameras[0], 100, 100), Light::at(&scene, 12.0));
    let (full, watch) = (&mut [0; 100_000][..], Watch::default());
    let still = Still { view: &view, light: &light };
    let error = sprites_json::write(&mut { full }, &at_rest(&derived), Some(still), &watch).expect_err("too small");
    assert_eq!(error.kind(), std::io::ErrorKind::WriteZero);
    assert!(watch.share() < 0.5, "{} of 6000 sprites were made into text", watch.share());
}

/// A watch that is cancelled ends the text early; whoever cancels throws it away.
#[test]
fn an_export_stops_when_it_is_not_wanted_any_more() {
    let derived = Derived::new(&heap(20));
    let watch = Watch::default();
    watch.cancel();
    let mut text = Vec::new();
    sprites_csv::write(&mut text, &at_rest(&derived), None, &watch).expect("memory takes all");
    assert_eq!(text.iter().filter(|byte| **byte == b'\n').count(), 1, "no more than the line of heads");
}
