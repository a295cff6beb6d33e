//! Scenes that leave for other tools and come in from them: there and back, and what is broken.

mod cld;
mod cry_cloud;
mod flightgear;
mod glb;
mod mutated;
mod usd;
mod volume;
mod web;
mod wpr;
mod xml;

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::exchange::{Arrived, ArrivedCloud, Arriving, Content, ExportError, Files, Format, Leaving, Note};
use cloudwright_core::formats::Misread;
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::{Atlas, Sprite};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{Moment, SceneNow, WeatherRules};
use glam::DVec3;
use std::io::{self, Write};

/// Files in memory.
#[derive(Default)]
struct Memory(Vec<(String, Vec<u8>)>);

impl Files for Memory {
    fn add(&mut self, name: &str, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let mut bytes = Vec::new();
        fill(&mut bytes)?;
        self.0.push((name.into(), bytes));
        Ok(())
    }
}

/// What `scene` leaves at that second under `name`, with what was set and what was not carried.
fn left_at(
    scene: &Scene,
    name: &str,
    set: &[(&str, &str)],
    clock_s: f64,
) -> Result<(Vec<(String, Vec<u8>)>, Vec<Note>), ExportError> {
    let format = Format::to_write(None, name).expect("an ending");
    let mut options = format.usual_for_writing();
    set.iter().for_each(|(name, value)| options.set(name, value).expect("an option"));
    let derived = Derived::new(scene);
    derived.bake(&Watch::default());
    let moment = Moment::at(clock_s);
    let now = SceneNow::new(scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
    let (options, watch) = (&options, &Watch::default());
    let view = scene.cameras.first().map(|camera| View::new(camera, 1, 1));
    let (view, atlas) = (view.as_ref(), Atlas::built_in());
    let leaving = Leaving { scene, derived: &derived, moment, now: &now, atlas, view, name, options, watch };
    let mut files = Memory::default();
    let notes = format.write(&leaving, &mut files)?;
    Ok((files.0, notes))
}

/// The bytes of the one file that `scene` leaves.
fn left(scene: &Scene, name: &str, set: &[(&str, &str)]) -> Vec<u8> {
    let (mut files, _) = left_at(scene, name, set, 0.0).expect("it leaves");
    assert_eq!(files.len(), 1, "{name}");
    files.remove(0).1
}

fn arrived(bytes: &[u8], name: &str, set: &[(&str, &str)]) -> Result<Arrived, Misread> {
    let format = Format::to_read(None, name, bytes).expect("an ending");
    let mut options = format.usual_for_reading();
    set.iter().for_each(|(name, value)| options.set(name, value).expect("an option"));
    format.read(&Arriving { bytes, name: "came in", options: &options })
}

/// An empty scene with what came in, around `at`.
fn scene_of(arrived: &Arrived, at: DVec3) -> Scene {
    let Content::Clouds(clouds) = &arrived.content else { panic!("no clouds") };
    let mut document = cloudwright_core::document::Document::new(Scene::default());
    let (edits, placed) = ArrivedCloud::place_all(clouds, document.scene(), at);
    document.edit("Import", edits).expect("it fits");
    assert_eq!(placed.len(), document.scene().clouds.len());
    document.scene().clone()
}

/// All sprites, in the world.
fn sprites(scene: &Scene) -> Vec<(DVec3, Sprite)> {
    let derived = Derived::new(scene);
    let of = |cloud: &cloudwright_core::sprites::PlacedCloud| {
        let at = |sprite: &Sprite| (cloud.origin + sprite.position.as_dvec3(), *sprite);
        cloud.sprites.iter().map(at).collect::<Vec<_>>()
    };
    derived.clouds().iter().flat_map(of).collect()
}

/// How many different groups there are, and for each sprite which it has, numbered as they come.
fn groups(sprites: &[(DVec3, Sprite)]) -> Vec<usize> {
    let mut known: Vec<u32> = Vec::new();
    let mut number = |group: u32| {
        known.iter().position(|each| *each == group).unwrap_or_else(|| {
            known.push(group);
            known.len() - 1
        })
    };
    sprites.iter().map(|(_, sprite)| number(sprite.group)).collect()
}

#[test]
fn endings_choose_formats() {
    for (name, wanted) in [
        ("sky.json", Some("json")),
        ("SKY.CSV", Some("csv")),
        ("a.b.cld", Some("cld")),
        ("a.glb", Some("glb")),
        ("a.usda", Some("usd")),
        ("a.USDZ", Some("usd")),
        ("DIR.html", Some("web")),
        ("Fog.WPR", Some("wpr")),
        ("a.xml", Some("cryengine")),
        ("cloudlayers.xml", Some("flightgear")),
        ("sky.vol", Some("vol")),
        ("sky.vdb", Some("vdb")),
        ("cu.voxels.png", Some("flightgear-voxels")),
        ("sky.png", None),
        ("json", None),
    ] {
        assert_eq!(Format::to_write(None, name).ok().map(|format| format.name), wanted, "{name}");
    }
    assert_eq!(Format::to_write(Some("csv"), "x.json").expect("named").name, "csv");
    assert!(Format::to_read(None, "x.json", b"{}").is_err(), "only written");
    // Of what ends alike, the one that knows the bytes.
    for (bytes, wanted) in [(cry_cloud::BY_HAND, "cryengine"), (flightgear::BY_HAND, "flightgear"), ("", "cryengine")] {
        assert_eq!(Format::to_read(None, "x.xml", bytes.as_bytes()).map(|format| format.name), Ok(wanted));
    }
    let error = Format::to_write(Some("cldd"), "x.json").expect_err("unknown").to_string();
    assert!(error.contains("“cldd”"), "{error}");
}
