//! What is checked in is what the makers make: a stale asset says how to renew it.

use cloudwright::cli::schemas;
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::preset::{LevelPreset, Preset};
use cloudwright_core::problem::{check, check_with_sprites};
use cloudwright_tests::{atlas, authoring, root, scene_path, with_shortcuts};
use std::fs;

#[test]
fn schemas_are_fresh() {
    let of_answers = schemas::all().expect("types make schemas").into_iter();
    let of_answers = of_answers.map(|(name, made)| (format!("assets/schemas/{name}.schema.json"), made));
    let of_scenes = scene_file::json_schema().expect("types make a schema");
    for (file, made) in of_answers.chain([("assets/scene.schema.json".into(), of_scenes)]) {
        let checked_in = fs::read_to_string(root().join(&file)).expect(&file);
        assert!(checked_in == made, "{file} is stale: run `cargo run -p cloudwright-tests --bin renew -- schema`");
    }
}

#[test]
fn readme_has_the_command_tables_shortcuts() {
    let readme = fs::read_to_string(root().join("README.md")).expect("the readme");
    let made = with_shortcuts(&readme).expect("the marks are there");
    assert!(readme == made, "stale: run `cargo run -p cloudwright-tests --bin renew -- shortcuts`");
    assert!(readme.contains("| Ctrl+Shift+P |"), "the palette has its keys");
}

#[test]
fn scenes_are_fresh_and_without_problems() {
    for (name, make) in authoring::SCENES {
        let bytes = fs::read(scene_path(name)).expect("a shipped scene");
        let made = scene_file::write(&make()).expect("finite numbers");
        assert!(
            bytes == made.as_bytes(),
            "{name} is stale: run `cargo run -p cloudwright-tests --bin renew -- scenes`"
        );
        let scene = scene_file::read(&bytes).expect("a sound scene");
        assert!(scene_file::write(&scene).expect("finite numbers").as_bytes() == bytes, "{name}: not byte for byte");
        assert_eq!(check_with_sprites(&scene, Derived::new(&scene).clouds()), [], "{name}");
        assert!(scene.cameras.len() >= 2, "{name} has two cameras or more");
        assert!(scene.camera_named("main").is_some(), "{name} has a camera “main”");
    }
}

#[test]
fn presets_are_fresh_and_sound() {
    let made: Vec<&str> = authoring::PRESETS.iter().map(|(name, _)| *name).collect();
    let offered: Vec<&str> = Preset::ALL.iter().map(|preset| preset.name).collect();
    assert_eq!(offered, made, "each preset that is made is offered, in that order");
    for (name, make) in authoring::PRESETS {
        let made = make();
        let preset = Preset::by_name(name).expect("offered");
        let scene = preset.scene();
        assert!(scene == made, "{name} is stale: run `cargo run -p cloudwright-tests --bin renew -- presets`");
        let path = root().join("assets/presets").join(name).with_extension("cloudscene");
        let bytes = fs::read(path).expect("a preset's file");
        assert!(bytes == scene_file::write(&made).expect("finite numbers").as_bytes(), "{name}: not byte for byte");
        let derived = Derived::new(&scene);
        assert_eq!(check_with_sprites(&scene, derived.clouds()), [], "{name}");
        let counts = [scene.models.len(), scene.clouds.len(), scene.cameras.len()];
        assert_eq!(counts, [1, 1, 1], "{name}: one model, one cloud, one camera");
        assert_eq!(scene.cameras[0].name, "main", "{name}");
        let kept = derived.clouds()[0].sprites.len();
        assert!((5..=400).contains(&kept), "{name}: {kept} sprites, a cloud has 5 to 400 (MODEL, 2)");
    }
    assert_eq!(Preset::by_name("cumulus"), None);
}

#[test]
fn level_presets_suit_any_model() {
    let all = LevelPreset::all();
    assert!(all.len() > Preset::ALL.len(), "moods, and those of the presets");
    let mut scene = Preset::ALL[0].scene();
    for preset in all {
        scene.models[0].color_levels = preset.levels;
        assert_eq!(check(&scene), [], "{}", preset.name);
        assert_eq!(LevelPreset::by_name(preset.name), Some(preset), "names differ");
    }
    assert_eq!(LevelPreset::by_name("noon"), None);
}

#[test]
fn overcast_is_the_performance_scene() {
    let scene = scene_file::read(&fs::read(scene_path("overcast")).expect("shipped")).expect("sound");
    let derived = Derived::new(&scene);
    // The deck itself, and how it goes on to the horizon.
    let mut boxes = [0; 2];
    let mut sprites = [0; 2];
    for (cloud, placed) in scene.clouds.iter().zip(derived.clouds()) {
        let far = usize::from(cloud.name.starts_with("far"));
        boxes[far] += scene.model(cloud.model).expect("a model").boxes.len();
        sprites[far] += placed.sprites.len();
    }
    let [near, far] = sprites;
    assert!((180..=220).contains(&boxes[0]), "about 200 boxes, found {}", boxes[0]);
    assert!((19_000..=21_500).contains(&near), "about 20,000 sprites, found {near}");
    assert!((1..=near / 5).contains(&far), "at most a fifth as many far away, found {far}");
}

#[test]
fn aircraft_is_fresh() {
    let bytes = fs::read(root().join("assets/models/aircraft.glb")).expect("the aircraft");
    let made = authoring::aircraft::glb();
    assert!(bytes == made, "stale: run `cargo run -p cloudwright-tests --bin renew -- models`");
}

#[test]
fn atlas_is_fresh() {
    let bytes = fs::read(root().join("assets/atlas/clouds.png")).expect("the sheet");
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut texels = vec![0; reader.output_buffer_size().expect("of a known size")];
    reader.next_frame(&mut texels).expect("a whole PNG");
    let made = atlas::generate_sheet(atlas::BUILT_IN_SEED);
    assert!(texels == made, "stale: run `cargo run -p cloudwright-tests --bin renew -- atlas`");
}
