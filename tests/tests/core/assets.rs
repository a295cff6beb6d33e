//! What is checked in is what the makers make: a stale asset says how to renew it.

use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::check_with_sprites;
use cloudwright_tests::{atlas, authoring, root, scene_path};
use std::fs;

#[test]
fn schema_is_fresh() {
    let checked_in = fs::read_to_string(root().join("assets/scene.schema.json")).expect("the schema");
    let made = scene_file::json_schema().expect("types make a schema");
    assert!(checked_in == made, "stale: run `cargo run -p cloudwright-tests --bin renew -- schema`");
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
fn overcast_is_the_performance_scene() {
    let scene = scene_file::read(&fs::read(scene_path("overcast")).expect("shipped")).expect("sound");
    let derived = Derived::new(&scene);
    let boxes: usize =
        scene.clouds.iter().filter_map(|cloud| scene.model(cloud.model)).map(|model| model.boxes.len()).sum();
    let sprites: usize = derived.clouds().iter().map(|cloud| cloud.sprites.len()).sum();
    assert!((180..=220).contains(&boxes), "about 200 boxes, found {boxes}");
    assert!((19_000..=21_500).contains(&sprites), "about 20,000 sprites, found {sprites}");
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
