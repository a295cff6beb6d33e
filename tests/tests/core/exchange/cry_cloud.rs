//! Clouds of CryEngine and Lumberyard.

use super::{arrived, left, left_at, scene_of, sprites};
use cloudwright_core::formats::cry_cloud::{self, CryCloud, CrySprite};
use cloudwright_tests::small_scenes::{crowd, heap};
use glam::DVec3;

pub(super) const BY_HAND: &str = r#"<Cloud TextureNumRows="4" TextureNumCols="4" Density="0.8" Material="materials/clouds/cumulus">
 <Sprite Pos="10.5,-30,200.25" texID="13" Radius="90" Angle="-12.5"/>
 <Sprite Pos="-60,45.125,250" texID="3"/>
</Cloud>
"#;

#[test]
fn there_and_back_as_text() {
    let cloud = cry_cloud::read(BY_HAND.as_bytes()).expect("sound");
    let first = CrySprite { position: [10.5, -30.0, 200.25], tile: 13, radius: 90.0, angle_deg: -12.5 };
    // As in the engine, what a sprite does not say is as of the one before, but for its angle.
    let second = CrySprite { position: [-60.0, 45.125, 250.0], tile: 3, radius: 90.0, angle_deg: 0.0 };
    let wanted = CryCloud {
        rows: 4,
        columns: 4,
        density: Some(0.8),
        material: "materials/clouds/cumulus".into(),
        sprites: vec![first, second],
        unknown: Vec::new(),
    };
    assert_eq!(cloud, wanted);
    let written = String::from_utf8(cry_cloud::write(&cloud)).expect("text");
    assert_eq!(written, BY_HAND.replace("texID=\"3\"/>", "texID=\"3\" Radius=\"90\"/>"));
}

#[test]
fn a_file_becomes_a_cloud() {
    let arrived = arrived(BY_HAND.as_bytes(), "a.xml", &[]).expect("sound");
    let all = sprites(&scene_of(&arrived, DVec3::new(0.0, 1000.0, 0.0)));
    // y runs forward and z up in the file.
    assert!(all[0].0.distance(DVec3::new(10.5, 1200.25, 30.0)) < 1e-3, "{}", all[0].0);
    assert_eq!((all[0].1.tile, all[0].1.width, all[0].1.height), (13, 180.0, 180.0));
    assert!((all[0].1.rotation.to_degrees() + 12.5).abs() < 1e-3);
    let said: Vec<String> = arrived.notes.iter().map(ToString::to_string).collect();
    assert!(said.iter().any(|note| note == "not carried: material, density"), "{said:?}");
}

#[test]
fn a_cloud_comes_back() {
    let before = heap(60);
    let arrived = arrived(&left(&before, "a.xml", &[]), "a.xml", &[]).expect("sound");
    let (was, is) = (sprites(&before), sprites(&scene_of(&arrived, before.clouds[0].position)));
    assert_eq!(was.len(), is.len());
    for ((place, sprite), (place_after, sprite_after)) in was.iter().zip(&is) {
        assert!(place.distance(*place_after) < 1e-3, "{place} became {place_after}");
        assert_eq!(sprite.tile, sprite_after.tile);
        let side = (sprite.width * sprite.height).sqrt();
        assert!((side - sprite_after.width).abs() < 1e-3 && (side - sprite_after.height).abs() < 1e-3);
        let turned = (sprite.rotation - sprite_after.rotation).to_degrees().rem_euclid(360.0);
        assert!(turned.min(360.0 - turned) < 1e-3, "{turned}");
    }
    let (files, _) = left_at(&crowd(2), "sky.xml", &[], 0.0).expect("they leave");
    assert_eq!(files.iter().map(|(name, _)| name.as_str()).collect::<Vec<_>>(), ["sky.xml", "sky_2.xml"]);
}

#[test]
fn what_is_broken_is_told_with_its_line() {
    for (from, to, wanted) in [
        ("Radius=\"90\"", "Radius=\"NaN\"", "line 2: Sprite: “NaN” is no number"),
        ("10.5,-30,200.25", "10.5,-30", "line 2: Sprite: “10.5,-30” is no place"),
        ("-60,", "1e9,", "sprite 1: it lies more than"),
        ("texID=\"3\"", "texID=\"-3\"", "line 3: Sprite: “-3” is no whole number"),
        ("<Cloud", "<Clouds", "line "),
        ("</Cloud>", "", ": it ends within Cloud"),
    ] {
        let error = arrived(BY_HAND.replace(from, to).as_bytes(), "a.xml", &[]).expect_err(from).to_string();
        assert!(error.contains(wanted), "“{error}”, not “{wanted}”");
    }
}
