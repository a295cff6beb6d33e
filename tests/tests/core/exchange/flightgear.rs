//! FlightGear's clouds and layers. The simulator's own file is read by `tests/tests/flightgear_data.rs`, where it is there.

use super::{arrived, left, left_at, scene_of, sprites};
use cloudwright_core::formats::flightgear::{self, FgBox, FgCloud};
use cloudwright_core::problem;
use cloudwright_core::scene::{Category, Scene};
use cloudwright_tests::small_scenes::crowd;
use glam::DVec3;

/// Two kinds of cloud, a group of both, and two layers of it.
pub(super) const BY_HAND: &str = r#"<?xml version="1.0"?>
<!-- Written for this test. -->
<PropertyList>
  <clouds>
    <cu-tiny>
      <min-cloud-width-m>700</min-cloud-width-m>
      <max-cloud-width-m>900</max-cloud-width-m>
      <min-cloud-height-m>300</min-cloud-height-m>
      <max-cloud-height-m>300</max-cloud-height-m>
      <num-sprites>12</num-sprites>
      <texture>mine.png</texture>
      <num-textures-x>2</num-textures-x>
      <min-bottom-lighting-factor>0.25</min-bottom-lighting-factor>
      <max-bottom-lighting-factor>0.25</max-bottom-lighting-factor>
      <min-shade-lighting-factor>0.5</min-shade-lighting-factor>
      <max-shade-lighting-factor>0.5</max-shade-lighting-factor>
      <min-sprite-width-m>100</min-sprite-width-m>
      <max-sprite-width-m>180</max-sprite-width-m>
      <min-sprite-height-m>100</min-sprite-height-m>
      <max-sprite-height-m>120</max-sprite-height-m>
      <height-map-texture>true</height-map-texture>
      <sparkle>3</sparkle>
    </cu-tiny>
    <st-bare/>
  </clouds>
  <boxes>
    <pair>
      <box><type>cu-tiny</type><count>2</count><width>1500</width><height>0</height><hdist>2</hdist></box>
      <box><type>st-bare</type><count>1</count><width>0</width><height>0</height></box>
    </pair>
  </boxes>
  <layers>
    <cu><cloud><name>pair</name><count>1</count></cloud><cloud><name>gone</name></cloud></cu>
    <st><cloud><name>pair</name><count>2</count></cloud><grid-z-rand type="double">100.0</grid-z-rand></st>
  </layers>
</PropertyList>
"#;

#[test]
fn what_is_read_is_written() {
    let layers = flightgear::read(BY_HAND.as_bytes()).expect("sound");
    assert_eq!((layers.clouds.len(), layers.groups.len(), layers.layers.len()), (2, 1, 2));
    let tiny = &layers.clouds[0];
    assert_eq!((tiny.width_m, tiny.sprites, tiny.tiles, tiny.rows_by_height), ([700.0, 900.0], 12, [2, 4], true));
    // Where the file says nothing, SimGear's values hold.
    assert_eq!((tiny.bottom, tiny.middle, tiny.shade), ([0.25; 2], [1.0; 2], [0.5; 2]));
    assert_eq!(layers.clouds[1], FgCloud::new("st-bare"));
    let first =
        FgBox { cloud: "cu-tiny".into(), count: 2.0, width_m: 1500.0, height_m: 0.0, gathered: 2, gathered_up: 1 };
    assert_eq!(layers.groups[0].1[0], first);
    assert_eq!((layers.layers[1].uneven_m, layers.unknown.as_slice()), (100.0, &["sparkle".to_owned()][..]));
    let again = flightgear::read(&flightgear::write(&layers)).expect("sound");
    assert_eq!(again, flightgear::FgLayers { unknown: Vec::new(), ..layers });
}

#[test]
fn kinds_become_models_and_layers_clouds() {
    let arrived = arrived(BY_HAND.as_bytes(), "cloudlayers.xml", &[]).expect("sound");
    let scene = scene_of(&arrived, DVec3::new(0.0, 1000.0, 0.0));
    assert_eq!(problem::check(&scene).iter().filter(|each| each.severity == problem::Severity::Error).count(), 0);
    let tiny = &scene.models[0];
    assert_eq!(
        (tiny.name.as_str(), tiny.category, tiny.boxes[0].sprite_count),
        ("cu-tiny", Category::CumulusHumilis, 12)
    );
    assert_eq!((tiny.boxes[0].size, tiny.boxes[0].width), (DVec3::new(700.0, 200.0, 700.0), [100.0, 180.0]));
    assert_eq!(scene.models[1].category, Category::Stratus);
    let of = |model: usize| scene.clouds.iter().filter(|cloud| cloud.model == scene.models[model].id).count();
    assert_eq!((of(0), of(1)), (6, 3), "each layer has as many groups as it weighs");
    let bottom =
        sprites(&scene).iter().map(|(at, sprite)| at.y - 0.5 * f64::from(sprite.height)).fold(f64::MAX, f64::min);
    assert!(bottom > 900.0, "{bottom}");
    let said: Vec<String> = arrived.notes.iter().map(ToString::to_string).collect();
    for wanted in ["“gone” in layer “cu”", "sparkle", "2 kinds of cloud: their sizes vary"] {
        assert!(said.iter().any(|note| note.contains(wanted)), "no “{wanted}” in {said:#?}");
    }
}

/// How large, how many, of what and in which light: all but by chance.
#[test]
fn kinds_come_back() {
    let arrived = arrived(BY_HAND.as_bytes(), "cloudlayers.xml", &[]).expect("sound");
    let scene = scene_of(&arrived, DVec3::new(0.0, 1000.0, 0.0));
    let back = flightgear::read(&left(&scene, "cloudlayers.xml", &[])).expect("sound");
    let tiny = back.clouds.iter().find(|cloud| cloud.name == "cu-tiny").expect("there");
    assert_eq!((tiny.width_m, tiny.height_m, tiny.sprites), ([800.0; 2], [300.0; 2], 12));
    assert_eq!((tiny.sprite_width_m, tiny.sprite_height_m), ([100.0, 180.0], [100.0, 120.0]));
    assert_eq!((tiny.bottom, tiny.middle, tiny.top, tiny.shade), ([0.25; 2], [1.0; 2], [1.0; 2], [0.5; 2]));
    assert_eq!(back.layers.iter().map(|layer| layer.name.as_str()).collect::<Vec<_>>(), ["cu", "st"]);
    assert_eq!(back.groups.iter().map(|(_, boxes)| boxes[0].count).collect::<Vec<_>>(), [6.0, 3.0]);
}

#[test]
fn a_scene_becomes_kinds_of_cloud() {
    let (files, notes) = left_at(&crowd(30), "cloudlayers.xml", &[], 0.0).expect("it leaves");
    let layers = flightgear::read(&files[0].1).expect("sound");
    let names: Vec<&str> = layers.clouds.iter().map(|cloud| cloud.name.as_str()).collect();
    assert_eq!((files.len(), names), (1, vec!["low", "round", "flat"]));
    assert!(layers.clouds.iter().all(|cloud| cloud.sprites == 24 && cloud.width_m[0] > 150.0), "{:?}", layers.clouds);
    assert!(notes.iter().any(|note| note.how.contains("by chance")));
    assert!(left_at(&Scene::default(), "cloudlayers.xml", &[], 0.0).is_err());
}

#[test]
fn what_is_broken_is_told_with_its_place() {
    for (from, to, wanted) in [
        ("<num-sprites>12", "<num-sprites>-3", "line 10: num-sprites: “-3” is no whole number"),
        ("<num-sprites>12", "<num-sprites>99999", "clouds/cu-tiny: it has 99999 sprites"),
        ("<min-cloud-width-m>700", "<min-cloud-width-m>NaN", "line 6: min-cloud-width-m: “NaN” is no number"),
        (
            "<max-sprite-width-m>180",
            "<max-sprite-width-m>18",
            "clouds/cu-tiny: the sprites' width goes from 100 to 18 m",
        ),
        ("<count>2</count><width>", "<count>1e9</count><width>", "layers: more than 4000 clouds"),
        ("<name>gone</name>", "", "it has no name"),
        ("<PropertyList>", "<List>", "line "),
    ] {
        let error = arrived(BY_HAND.replace(from, to).as_bytes(), "cloudlayers.xml", &[]).expect_err(from).to_string();
        assert!(error.contains(wanted), "“{error}”, not “{wanted}”");
    }
}
