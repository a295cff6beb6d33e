//! Flight Simulator 2004's clouds: byte for byte, and as scenes.

use super::{arrived, groups, left, left_at, scene_of, sprites};
use cloudwright_core::exchange::NoteKind;
use cloudwright_core::formats::cld::{self, Cld, CldLevel, CldSprite};
use cloudwright_core::scene::Scene;
use cloudwright_tests::small_scenes::{crowd, heap};
use glam::DVec3;

/// A file put together by hand, byte by byte.
pub(super) fn by_hand() -> Vec<u8> {
    let mut bytes = vec![0x8C, 0x23, 0, 0, 2, 0, 0, 0];
    bytes.extend(b"cumulus01.bmp\0");
    bytes.extend(2_u32.to_le_bytes());
    for (level, color) in [(0.0_f32, 0xFF40_4A60_u32), (1.0, 0xF0FF_FEF0)] {
        bytes.extend(level.to_le_bytes());
        bytes.extend(color.to_le_bytes());
    }
    for (position, shorts, uv) in [
        ([10.5_f32, 200.25, -30.0], [1_i16, 0, 180, 180, 120, 120, 0, 0], [0.25_f32, 0.0, 0.5, 0.25]),
        ([-60.0, 250.0, 45.125], [2, 0, 150, 220, 150, 220, -5, 5], [0.75, 0.75, 1.0, 1.0]),
    ] {
        bytes.extend(position.iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend(shorts.iter().flat_map(|number| number.to_le_bytes()));
        bytes.extend(uv.iter().flat_map(|number| number.to_le_bytes()));
    }
    bytes.extend(b"and more");
    bytes
}

#[test]
fn what_is_read_is_written_byte_for_byte() {
    let bytes = by_hand();
    let cld = cld::read(&bytes).expect("sound");
    assert_eq!((cld.texture.as_slice(), cld.levels.len(), cld.sprites.len()), (&b"cumulus01.bmp"[..], 2, 2));
    assert_eq!(cld.levels[1], CldLevel { level: 1.0, color: 0xF0FF_FEF0 });
    let second = CldSprite {
        position: [-60.0, 250.0, 45.125],
        shading: 2,
        group: 0,
        width: [150, 220],
        length: [150, 220],
        rotation_deg: [-5, 5],
        uv: [[0.75, 0.75], [1.0, 1.0]],
    };
    assert_eq!((cld.sprites[1], cld.rest.as_slice()), (second, &b"and more"[..]));
    assert_eq!(cld::write(&cld), bytes);
}

#[test]
fn a_file_becomes_a_cloud() {
    let arrived = arrived(&by_hand(), "a.cld", &[]).expect("sound");
    let scene = scene_of(&arrived, DVec3::new(0.0, 1000.0, 0.0));
    let model = &scene.models[0];
    assert_eq!((model.name.as_str(), model.groups.len(), model.boxes.len()), ("came in", 2, 2));
    let all = sprites(&scene);
    // z runs forward in the file, and backward here.
    assert!(all[0].0.distance(DVec3::new(10.5, 1200.25, 30.0)) < 1e-3, "{}", all[0].0);
    assert!(all[1].0.distance(DVec3::new(-60.0, 1250.0, -45.125)) < 1e-3, "{}", all[1].0);
    // The first shows the lowest row's second tile, the second the highest row's last.
    assert_eq!((all[0].1.tile, all[1].1.tile), (13, 3));
    assert_eq!((all[0].1.width, all[0].1.height), (180.0, 120.0));
    assert!((150.0..=220.0).contains(&all[1].1.width), "drawn from the file's range");
    assert!(model.color_levels[0].color.rgb.b > model.color_levels[0].color.rgb.r, "blue is the lowest byte");
    assert!((model.color_levels[4].color.a - 240.0 / 255.0).abs() < 1e-6, "alpha the highest");
    let said: Vec<String> = arrived.notes.iter().map(ToString::to_string).collect();
    for wanted in ["cumulus01.bmp", "2 colour levels", "8 bytes", "a length of 1 is 1 m"] {
        assert!(said.iter().any(|note| note.contains(wanted)), "no “{wanted}” in {said:#?}");
    }
}

/// The heap with a turn, a scale and a shading group that two boxes share.
fn turned() -> Scene {
    let mut scene = heap(60);
    let cloud = scene.clouds.get_mut(0).expect("one");
    (cloud.heading_deg, cloud.scale) = (30.0, 1.5);
    scene
}

#[test]
fn a_cloud_comes_back() {
    let before = turned();
    let bytes = left(&before, "a.cld", &[("unit_m", "0.01")]);
    let arrived = arrived(&bytes, "a.cld", &[("unit_m", "0.01")]).expect("sound");
    let after = scene_of(&arrived, before.clouds[0].position);
    let (was, is) = (sprites(&before), sprites(&after));
    // Boxes come in the order of their first sprites, so sprites keep theirs.
    assert_eq!(was.len(), is.len());
    for ((place, sprite), (place_after, sprite_after)) in was.iter().zip(&is) {
        assert!(place.distance(*place_after) < 1e-3, "{place} became {place_after}");
        assert_eq!(sprite.tile, sprite_after.tile);
        assert!((sprite.width - sprite_after.width).abs() < 0.0051, "{sprite:?} {sprite_after:?}");
        assert!((sprite.height - sprite_after.height).abs() < 0.0051);
        let turned = (sprite.rotation - sprite_after.rotation).to_degrees().rem_euclid(360.0);
        assert!(turned.min(360.0 - turned) < 0.51, "{turned}");
    }
    assert_eq!(groups(&was), groups(&is));
    for (was, is) in before.models[0].color_levels.iter().zip(&after.models[0].color_levels) {
        assert!((was.height - is.height).abs() < 1e-6);
        for (was, is) in was.color.to_array().iter().zip(is.color.to_array()) {
            assert!((was.min(1.0) - is).abs() < 0.006, "{was} became {is}: more than a step of eight bits of sRGB");
        }
    }
    // What came in leaves as it came.
    let (again, before) = (left(&after, "a.cld", &[("unit_m", "0.01")]), cld::read(&bytes).expect("sound"));
    let again = cld::read(&again).expect("sound");
    assert_eq!((again.levels, again.sprites.len()), (before.levels, before.sprites.len()));
    for (was, is) in before.sprites.iter().zip(&again.sprites) {
        let near = was.position.iter().zip(is.position).all(|(was, is)| (was - is).abs() < 0.05);
        assert!(near && CldSprite { position: was.position, ..*is } == *was, "{was:?} {is:?}");
    }
}

#[test]
fn ranges_stay_ranges() {
    let sprite = |x: f32, group: i16, width: [i16; 2], turn: [i16; 2]| CldSprite {
        position: [x, 100.0, 7.0],
        shading: group,
        group,
        width,
        length: [90, 110],
        rotation_deg: turn,
        uv: [[0.0, 0.5], [0.25, 0.75]],
    };
    let sprites = vec![
        sprite(1.0, 0, [100, 140], [-5, 5]),
        sprite(400.0, 0, [100, 140], [-5, 5]),
        sprite(2.0, 1, [100, 150], [0, 360]),
    ];
    let levels = (0..5).map(|at| CldLevel { level: at as f32 / 4.0, color: 0xFFC0_C0C0 }).collect();
    let file = Cld { texture: b"clouds.bmp".to_vec(), levels, sprites, rest: Vec::new() };
    let scene = scene_of(&arrived(&cld::write(&file), "a.cld", &[]).expect("sound"), DVec3::ZERO);
    let back = cld::read(&left(&scene, "a.cld", &[("ranges", "yes")])).expect("sound");
    for (was, is) in file.sprites.iter().zip(&back.sprites) {
        let near = was.position.iter().zip(is.position).all(|(was, is)| (was - is).abs() < 1e-3);
        assert!(near && CldSprite { position: was.position, shading: was.shading, ..*is } == *was, "{was:?} {is:?}");
    }
    assert_eq!(back.levels, file.levels);
}

#[test]
fn each_cloud_has_a_file_and_losses_are_told() {
    let (files, notes) = left_at(&crowd(3), "sky.cld", &[], 0.0).expect("they leave");
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["sky.cld", "sky_2.cld", "sky_3.cld"]);
    assert!(files.iter().all(|(_, bytes)| cld::read(bytes).is_ok_and(|cld| !cld.sprites.is_empty())));
    let left_out = notes.iter().find(|note| note.kind == NoteKind::LeftOut).expect("a note");
    assert!(left_out.what.contains("light") && left_out.what.contains("cameras"), "{left_out}");
    let rounded = notes.iter().find(|note| note.how.contains("rounded to 1 m")).expect("a note");
    assert_eq!(rounded.kind, NoteKind::Changed);
    assert!(left_at(&Scene::default(), "sky.cld", &[], 0.0).is_err(), "nothing to write");
    let (_, notes) = left_at(&heap(20), "sky.cld", &[("unit_m", "0.001")], 0.0).expect("it leaves");
    assert!(notes.iter().any(|note| note.how.contains("cut to 32.767 m")), "{notes:?}");
}

#[test]
fn what_is_broken_is_told_with_its_place() {
    let sound = by_hand();
    let with = |at: usize, bytes: &[u8]| {
        let mut broken = sound.clone();
        broken[at..at + bytes.len()].copy_from_slice(bytes);
        broken
    };
    for (bytes, wanted) in [
        (Vec::new(), "byte 0: it ends before its first number"),
        (b"PNG0".to_vec(), "byte 0: it begins with 0x30474e50"),
        (0x238C_u32.to_be_bytes().to_vec(), "byte 0: its bytes are in the order of another"),
        (with(4, &u32::MAX.to_le_bytes()), "byte 42: it tells of 4294967295 sprites, and has room for 2"),
        (with(22, &u32::MAX.to_le_bytes()), "colour levels, and has room for"),
        (with(21, b"x"), "byte 0"),
        (sound[..60].to_vec(), "it tells of 2 sprites, and has room for 0"),
        (with(42, &f32::NAN.to_le_bytes()), "byte 42: a sprite's x is no number"),
        (with(46, &1e30_f32.to_le_bytes()), "sprite 0: it lies more than 1000 km"),
        ([&[0x8C, 0x23, 0, 0, 1, 0, 0, 0][..], &[b'x'; 200][..]].concat(), "byte 8: the texture's name has no end"),
        (with(4, &0_u32.to_le_bytes()), "byte 4: the cloud has no sprites"),
    ] {
        let Err(misread) = arrived(&bytes, "a.cld", &[]) else {
            // A name that has lost its end goes on into what stands behind it.
            assert_eq!(wanted, "byte 0");
            continue;
        };
        assert!(misread.to_string().contains(wanted) || wanted == "byte 0", "“{misread}”, not “{wanted}”");
    }
}

/// A scene of 6,000 sprites, written and read (tests/benches/core.rs has the time).
#[test]
fn six_thousand_sprites() {
    let bytes = left(&heap(3000), "a.cld", &[]);
    let cld = cld::read(&bytes).expect("sound");
    assert!(cld.sprites.len() > 500, "{}", cld.sprites.len());
    assert_eq!(cld::write(&cld), bytes);
}
