//! Shipped plugins and small ones of each kind: the same twice, undone cleanly, all or nothing.

use crate::{scene, turn};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::{Document, Edit};
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::formats::scene_file;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::coverage;
use cloudwright_core::problem;
use cloudwright_core::scene::{CloudId, Scene, Thing};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_scripts::shipped::{SHIPPED, named};
use cloudwright_scripts::{Fault, Outcome, Patience, Plugin, PluginKind, ScriptError};
use cloudwright_tests::root;
use glam::DVec3;
use std::fs;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// A plugin whose `run` has that body.
pub fn plugin(body: &str) -> Plugin {
    let head = r#"const PLUGIN = #{ name: "Test", kind: "edit", sentence: "For tests." };"#;
    Plugin::read(&format!("{head}\nfn run(p) {{\n{body}\n}}")).expect("a plugin")
}

pub fn run(plugin: &Plugin, scene: &Scene) -> Result<Outcome, ScriptError> {
    plugin.run(scene, &plugin.values(), &Patience::usual())
}

/// What `body` makes of the usual scene.
pub fn after(body: &str) -> Scene {
    let plugin = plugin(body);
    let mut document = Document::new(scene());
    run(&plugin, document.scene()).expect("it runs").apply(&plugin, &mut document).expect("it fits");
    document.scene().clone()
}

/// Such as no hand would wait: other tests may use the machine as well.
fn patient() -> Patience {
    Patience { until: Some(Instant::now() + Duration::from_secs(60)), ..Patience::usual() }
}

/// Runs it twice, has it leave no faults, and takes it back.
fn check_shipped(name: &str, before: &Scene) {
    let shipped = named(name).unwrap_or_else(|| panic!("no {name}"));
    let plugin = Plugin::read(shipped.source).unwrap_or_else(|error| panic!("{name}: {error}"));
    let run = |scene: &Scene| plugin.run(scene, &plugin.values(), &patient());
    let mut document = Document::new(before.clone());
    let first = match run(document.scene()) {
        Ok(first) => first,
        // What follows a path says so where there is none.
        Err(error) if error.message.contains("no camera path") && before.paths.is_empty() => return,
        Err(error) => panic!("{name}: {error}"),
    };
    assert_eq!(Ok(&first), run(document.scene()).as_ref(), "{name}");
    if plugin.description.kind == PluginKind::Exporter {
        assert!(first.edits.is_empty() && first.text.is_some(), "{name}");
        return;
    }
    // An edit of no clouds does nothing.
    let nothing = before.clouds.is_empty() && plugin.description.kind == PluginKind::Edit;
    assert!(first.edits.is_empty() == nothing && first.text.is_none(), "{name}");
    first.apply(&plugin, &mut document).expect("it fits");
    assert_eq!(problem::check(document.scene()), [], "{name}");
    let bytes = scene_file::write(document.scene()).expect("a scene");
    assert_eq!(scene_file::read(bytes.as_bytes()).as_ref(), Ok(document.scene()), "{name}");
    if !nothing {
        assert_eq!(document.undo_name(), Some(plugin.description.name.as_str()));
        document.undo();
    }
    let bytes = |scene: &Scene| scene_file::write(scene).expect("a scene");
    assert!(bytes(document.scene()) == bytes(before), "{name}: undone, it is another scene");
    assert!(document.undo_name().is_none(), "{name}: more than one undo point");
}

#[test]
fn shipped_ones_make_the_same_twice_and_are_undone_cleanly() {
    let _turn = turn();
    let fair_weather = fs::read(root().join("assets/scenes/fair_weather.cloudscene")).expect("a shipped scene");
    let fair_weather = scene_file::read(&fair_weather).expect("a scene");
    for shipped in SHIPPED {
        for before in [&Scene::default(), &scene(), &fair_weather] {
            check_shipped(shipped.name, before);
        }
    }
}

/// From under the middle, no lower than to the nearer edge of the field, whatever else is in the scene.
fn measured_oktas(name: &str, before: &Scene, set: &[(&str, &str)], half_m: f64, base_m: f64) -> f64 {
    let plugin = Plugin::read(named(name).expect("a plugin").source).expect("a plugin");
    let mut values = plugin.values();
    for (name, value) in set {
        values.set(&plugin.description.parameters, name, value).expect("a value");
    }
    let mut document = Document::new(before.clone());
    let outcome = plugin.run(before, &values, &patient()).unwrap_or_else(|error| panic!("{name}: {error}"));
    outcome.apply(&plugin, &mut document).expect("it fits");
    let scene = document.scene();
    let derived = Derived::new(scene);
    let hidden = Hidden { clouds: before.clouds.iter().map(|cloud| cloud.id).collect(), ..Hidden::default() };
    // Finer than the script looks.
    let seen = coverage(DVec3::Y * 2.0, (base_m / half_m).atan().to_degrees(), 128, |camera, size| {
        let sight = Sight { hidden: hidden.clone(), ..Sight::still(camera, size) };
        Frame::new(scene, &derived, Atlas::built_in(), &sight)
    });
    8.0 * seen.covered
}

#[test]
fn a_cumulus_field_covers_what_was_asked_for() {
    let _turn = turn();
    for (oktas, seed) in (0..=8).zip([1, 2, 3].into_iter().cycle()) {
        let set = [("oktas", &*oktas.to_string()), ("seed", &*seed.to_string())];
        let got = measured_oktas("cumulus_field", &Scene::default(), &set, 8_000.0, 1_100.0);
        assert!((got - f64::from(oktas)).abs() <= 0.5, "{got} oktas for {oktas}, seed {seed}");
    }
}

#[test]
fn layers_cover_what_was_asked_for_over_others() {
    let _turn = turn();
    let below = scene();
    let broad: &[(&str, &str)] = &[];
    let fine: &[(&str, &str)] = &[("grain", "fine"), ("width_m", "5000"), ("depth_m", "5000")];
    for (name, more, oktas, half_m, base_m) in [
        ("stratocumulus_deck", broad, "8", 8_000.0, 1_000.0),
        ("stratocumulus_deck", broad, "4.5", 8_000.0, 1_000.0),
        ("stratocumulus_deck", broad, "1.5", 8_000.0, 1_000.0),
        ("stratocumulus_deck", fine, "8", 2_500.0, 1_000.0),
        ("stratocumulus_deck", fine, "4", 2_500.0, 1_000.0),
        ("altocumulus_sheet", broad, "2", 12_000.0, 3_800.0),
        ("altocumulus_sheet", broad, "6", 12_000.0, 3_800.0),
        ("stratus_sheet", broad, "1.5", 3_500.0, 330.0),
        ("stratus_sheet", broad, "4.5", 3_500.0, 330.0),
        ("stratus_sheet", broad, "8", 3_500.0, 330.0),
    ] {
        let set = [more, &[("oktas", oktas)]].concat();
        let got = measured_oktas(name, &below, &set, half_m, base_m);
        let wanted: f64 = oktas.parse().expect("a number");
        assert!((got - wanted).abs() <= 0.5, "{name} {more:?}: {got} oktas for {wanted}");
    }
}

/// What makes a layer is told of it by the same names.
#[test]
fn layers_share_the_names_of_their_parameters() {
    const SHARED: [&str; 7] = ["oktas", "base_m", "thickness_m", "width_m", "depth_m", "center_x_m", "center_z_m"];
    let mut layers = Vec::new();
    for shipped in SHIPPED {
        let plugin = Plugin::read(shipped.source).expect(shipped.name);
        let names: Vec<&str> = plugin.description.parameters.iter().map(|parameter| parameter.name.as_str()).collect();
        if names.first() == Some(&"oktas") {
            assert_eq!(names[..SHARED.len()], SHARED, "{}", shipped.name);
            assert_eq!(names.last(), Some(&"seed"), "{}", shipped.name);
            layers.push(shipped.name);
        }
    }
    let wanted = ["altocumulus_sheet", "cumulonimbus", "cumulus_field", "stratocumulus_deck", "stratus_sheet"];
    assert_eq!(layers, wanted);
}

#[test]
fn a_fine_deck_is_a_small_one() {
    let plugin = Plugin::read(named("stratocumulus_deck").expect("a plugin").source).expect("a plugin");
    let mut values = plugin.values();
    values.set(&plugin.description.parameters, "grain", "fine").expect("a choice");
    let error = plugin.run(&scene(), &values, &patient()).expect_err("of 16 km");
    assert!(error.to_string().contains("36 square kilometres at most"), "{error}");
}

#[test]
fn every_value_is_what_was_chosen() {
    let plugin = Plugin::read(named("diurnal_cumulus").expect("a plugin").source).expect("a plugin");
    let mut values = plugin.values();
    values.set(&plugin.description.parameters, "length_s", "60").expect("a length");
    values.set(&plugin.description.parameters, "looped", "yes").expect("a flag");
    let outcome = plugin.run(&scene(), &values, &Patience::usual()).expect("it runs");
    let mut document = Document::new(scene());
    outcome.apply(&plugin, &mut document).expect("it fits");
    assert_eq!(document.scene().tracks.len(), 4);
    for track in &document.scene().tracks {
        assert_eq!(track.keys.last().map(|key| key.time_s), Some(60.0));
        assert_eq!(track.after, cloudwright_core::scene::Beyond::Repeat);
    }
    for (name, text, wanted) in [
        ("length_s", "5", "is not a number from 10 to 86400 s"),
        ("length_s", "NaN", "is not a number"),
        ("lenght_s", "60", "did you mean `length_s`?"),
        ("looped", "perhaps", "true or false"),
    ] {
        let error = values.set(&plugin.description.parameters, name, text).expect_err(text);
        assert!(error.to_string().contains(wanted) && error.fault == Fault::Value, "{error}");
    }
}

#[test]
fn a_failure_after_half_its_edits_leaves_nothing() {
    let plugin =
        plugin("set(\"time_of_day_h\", 3.0);\nadd_camera(#{ name: \"half\" });\nset(\"time_of_day_h\", 99.0);");
    let error = run(&plugin, &scene()).expect_err("out of range");
    assert_eq!(error.place.map(|place| (place.line, place.column)), Some((5, 1)), "{error}");
}

#[test]
fn what_is_added_is_within_its_ranges_or_told_at_its_line() {
    for (made, wanted) in [
        ("add_camera(#{ field_of_view_deg: 500 })", "camera.field_of_view_deg: 500 is out of range (use "),
        ("add_model(#{ boxes: [#{ }, #{ size: [1, -2, 3] }] })", "model.boxes[1].size.y: -2 is out of range"),
        ("add_model(#{ boxes: [#{ width: [9, 5] }] })", "model.boxes[0].width: the range runs backwards, from 9 to 5"),
        ("add_box(models()[0], #{ orientation: [0, 0, 0, 2] })", "box.orientation: [0, 0, 0, 2] is no rotation"),
        ("add_cloud(#{ model: models()[0], opacity: 2 })", "cloud.opacity: 2 is out of range"),
    ] {
        let error = run(&plugin(&format!("let a = 1;\n{made};")), &scene()).expect_err(made);
        assert_eq!((error.fault, error.place.map(|place| place.line)), (Fault::Script, Some(4)), "{error}");
        assert!(error.to_string().contains(wanted), "{error}");
    }
}

#[test]
fn nothing_asked_for_is_no_undo_point() {
    let plugin = plugin("set(\"time_of_day_h\", get(\"time_of_day_h\"));");
    let mut document = Document::new(scene());
    run(&plugin, document.scene()).expect("it runs").apply(&plugin, &mut document).expect("it fits");
    assert!(document.undo_name().is_none());
}

#[test]
fn scripts_see_what_they_did() {
    let scene = after(
        "let cloud = clouds()[0];
         let at = `cloud/${cloud}/position`;
         set(at, add(get(at), [100, 0, 0]));
         set(at + \"/y\", 2500);
         let model = add_model(#{ name: \"made\", boxes: [#{ center: [0, 1, 2] }] });
         let one = add_box(model, #{ sprite_count: 7.0, size: [10, 20, 30] });
         if boxes(model).len() != 2 { throw \"two boxes\" }
         set(`model/${model}/box/${one}/width`, [5, 9]);
         set(`model/${model}/seed`, 42);
         let placed = add_cloud(#{ model: model, position: [1, 2, 3] });
         remove(`cloud/${cloud}`);
         if has(`cloud/${cloud}`) || !has(`cloud/${placed}`) { throw \"the one for the other\" }",
    );
    assert_eq!(scene.clouds.len(), 1);
    let model = scene.model(scene.clouds[0].model).expect("its model");
    assert_eq!((model.name.as_str(), model.seed, scene.clouds[0].name.as_str()), ("made", 42, "made"));
    assert_eq!((model.boxes[1].sprite_count, model.boxes[1].width), (7, [5.0, 9.0]));
}

#[test]
fn keys_go_into_the_track_that_is_there() {
    let body = "key(\"sky/exposure_ev\", 2, 1.0);
         key(\"sky/exposure_ev\", 0, 0.0, #{ leaves: \"step\" });
         key(\"sky/exposure_ev\", 2, 0.5);
         track(\"sky/exposure_ev\", #{ before: \"swing\" });
         key(\"sky/directional_tuning/tint\", 1, [1, 0.9, 0.8]);";
    let first = after(body);
    let exposure = first.tracks.iter().find(|track| track.property == "sky/exposure_ev").expect("a track");
    assert_eq!(exposure.keys.iter().map(|key| key.time_s).collect::<Vec<_>>(), [0.0, 2.0]);
    let again = plugin("key(\"sky/exposure_ev\", 5, 0.0); clear_keys(\"sky/directional_tuning/tint\");");
    let mut document = Document::new(first);
    run(&again, document.scene()).expect("it runs").apply(&again, &mut document).expect("it fits");
    assert_eq!(document.scene().tracks.len(), 1);
    assert_eq!(document.scene().tracks[0].keys.len(), 3);
}

#[test]
fn keys_are_read_as_they_were_set() {
    let scene = after(
        "let exposure = \"sky/exposure_ev\";
         if keys(exposure).len() != 0 { throw \"none yet\" }
         key(exposure, 2, 1);
         key(exposure, 0, 0.5, #{ leaves: \"step\" });
         key(\"sky/directional_tuning/tint\", 1, [1, 0.9, 0.8]);
         let read = keys(exposure);
         if read[0].time_s != 0.0 || read[0].leaves != \"step\" || read[1].value != 1.0 { throw `${read}` }
         if keys(\"sky/directional_tuning/tint\")[0].value[1] != 0.9 { throw \"a vector\" }
         for each in read { key(exposure, each.time_s + 10, each.value * 2, #{ leaves: each.leaves }); }",
    );
    let track = scene.tracks.iter().find(|track| track.property == "sky/exposure_ev").expect("a track");
    let keys: Vec<_> = track.keys.iter().map(|key| (key.time_s, key.value.parts()[0])).collect();
    assert_eq!(keys, [(0.0, 0.5), (2.0, 1.0), (10.0, 1.0), (12.0, 2.0)]);
    let again = plugin("if keys(\"sky/exposure_ev\").len() != 4 { throw \"four\" }");
    run(&again, &scene).expect("it reads the scene's");
}

#[test]
fn many_things_are_arranged_as_by_hand() {
    let before = scene();
    let first = before.clouds[0].clone();
    let scene = after(
        "let one = clouds()[0];
         key(`cloud/${one}/opacity`, 1, 0.5);
         let copies = duplicate([one], [500, 0, 0]);
         let own = duplicate_own(copies, [500, 0, 0]);
         if clouds() != [one, copies[0], own[0]] { throw `${clouds()}` }
         if keys(`cloud/${own[0]}/opacity`).len() != 1 { throw \"tracks go along\" }
         let model = get(`cloud/${own[0]}/model`);
         let more = duplicate_boxes(model, [boxes(model)[0]], [0, 300, 0]);
         if !boxes(model).contains(more[0]) { throw \"a box\" }
         if mirror(own, \"x\") != own { throw \"mirrored\" }
         if make_own([one]) != [one] || !selection().is_empty() { throw \"own\" }
         mirror_boxes(model, more, \"z\");",
    );
    let [one, linked, own] = [0, 1, 2].map(|i| scene.clouds[i].clone());
    assert_eq!((linked.position.x - first.position.x, own.position.x - first.position.x), (500.0, 1000.0));
    assert_eq!(linked.model, first.model);
    assert!(one.model != first.model && own.model != first.model && own.model != one.model);
    assert_eq!(scene.tracks.len(), before.tracks.len() + 3);
}

#[test]
fn what_is_selected_is_given_by_who_asks() {
    let plugin = plugin("for each in selection() { set(each + \"/opacity\", 0.25); }");
    let mut document = Document::new(scene());
    let selected = [Thing::Cloud(document.scene().clouds[0].id), Thing::Cloud(CloudId(999_999))];
    let outcome = plugin.run_on(document.scene(), &selected, &plugin.values(), &Patience::usual()).expect("it runs");
    outcome.apply(&plugin, &mut document).expect("it fits");
    assert!((document.scene().clouds[0].opacity - 0.25).abs() < 1e-9);
}

#[test]
fn exporters_return_a_text() {
    let exporter = |body: &str| {
        let head = r#"const PLUGIN = #{ name: "Test", kind: "exporter", sentence: "For tests." };"#;
        Plugin::read(&format!("{head}\nfn run(p) {{ {body} }}")).expect("a plugin")
    };
    let text = |body: &str| run(&exporter(body), &scene()).map(|outcome| outcome.text.expect("a text"));
    assert_eq!(text("`${clouds().len()} cloud\n`"), Ok("1 cloud\n".into()));
    let table = text("sprite_table(#{ columns: [\"index\", \"x\"] })").expect("a table");
    let scaled = text("[\"# twice\\n\", sprite_table(#{ columns: [\"-x\"], scale: 2 })]").expect("two pieces");
    assert!(scaled.starts_with("# twice\n"));
    // Each is rounded to 0.00005 of its unit.
    for (one, two) in table.lines().zip(scaled.lines().skip(1)) {
        let (x, negative): (f64, f64) =
            (one.split(' ').nth(1).expect("x").parse().expect("x"), two.parse().expect("-2x"));
        assert!((2.0 * x + negative).abs() < 2e-4, "{one}, {two}");
    }
    assert_eq!(table.lines().count() + 1, scaled.lines().count());
}

#[test]
fn who_cancels_is_heard() {
    let plugin = plugin("loop { }");
    let patience = Patience { until: None, ..Patience::usual() };
    patience.cancelled.store(true, Ordering::Relaxed);
    let error = plugin.run(&scene(), &plugin.values(), &patience).expect_err("cancelled");
    assert_eq!(error.fault, Fault::Cancelled, "{error}");
}

/// The issue's bound is 50 ms in a release; here it is one that a debug build on a busy machine keeps.
#[test]
fn two_hundred_boxes_and_two_thousand_keys_are_quick() {
    let plugin = plugin(
        "let list = [];
         for place in grid(20, 10, 500) { list.push(#{ center: place }); }
         let model = add_model(#{ boxes: list });
         let cloud = add_cloud(#{ model: model });
         for i in 0..2000 { key(`cloud/${cloud}/opacity`, i, 0.5 + 0.5 * sin(i * 0.1)); }",
    );
    let _turn = turn();
    let start = Instant::now();
    let outcome = run(&plugin, &scene()).expect("it runs");
    assert!(start.elapsed() < Duration::from_secs(1), "{:?}", start.elapsed());
    assert!(matches!(outcome.edits.last(), Some(Edit::Track(_))), "{}", outcome.edits.len());
}
