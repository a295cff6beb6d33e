//! Files with anything in them: refused in words, or made a sound scene of; never a panic, never more memory than they
//! have bytes for.

use super::{arrived, cld, cry_cloud, flightgear, left, scene_of, wpr};
use cloudwright_core::document::Document;
use cloudwright_core::exchange::Content;
use cloudwright_core::problem::{self, Severity};
use cloudwright_core::reported::Sky;
use cloudwright_core::scene::Scene;
use cloudwright_tests::small_scenes::heap;
use glam::DVec3;
use proptest::prelude::*;
use std::sync::LazyLock;

/// A change of a file: where, as a share of it; what; with which number.
type Change = (f64, u8, u32);

fn changes() -> impl Strategy<Value = Vec<Change>> {
    prop::collection::vec((0.0..1.0, any::<u8>(), any::<u32>()), 1..6)
}

fn changed(bytes: &[u8], changes: &[Change]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for (share, what, number) in changes {
        let at = (share * bytes.len() as f64) as usize;
        let put = |bytes: &mut Vec<u8>, new: &[u8]| {
            let end = (at + new.len()).min(bytes.len());
            bytes.splice(at..end, new[..end - at].iter().copied());
        };
        match what % 8 {
            0 => bytes.truncate(at),
            1 => put(&mut bytes, &[*number as u8]),
            2 => put(&mut bytes, &number.to_le_bytes()),
            3 => put(&mut bytes, &f32::NAN.to_le_bytes()),
            4 => put(&mut bytes, &1e30_f32.to_le_bytes()),
            5 => put(&mut bytes, &u32::MAX.to_le_bytes()),
            6 => {
                bytes.drain(at..(at + *number as usize % 40).min(bytes.len()));
            }
            _ => {
                let copied: Vec<u8> = bytes[at..(at + *number as usize % 400).min(bytes.len())].to_vec();
                bytes.splice(at..at, copied);
            }
        }
    }
    bytes
}

/// A text put in the place of another: where, and which.
type Words = Vec<(f64, usize)>;

fn texts() -> impl Strategy<Value = Words> {
    prop::collection::vec((0.0..1.0, 0..WORDS.len()), 1..5)
}

const WORDS: [&str; 14] = [
    "NaN",
    "inf",
    "-1e308",
    "1e400",
    "",
    "-0",
    "<a>",
    "</CloudLayer>",
    "&lt;",
    "&#0;",
    "&lol;",
    "<!DOCTYPE a [",
    "]]>",
    "é",
];

/// Text with numbers, as far as it has any, in place of which stands something else.
fn reworded(bytes: &[u8], words: &Words) -> Vec<u8> {
    let mut text = String::from_utf8_lossy(bytes).into_owned();
    for (share, word) in words {
        let mut from = (share * text.len() as f64) as usize;
        while !text.is_char_boundary(from) {
            from -= 1;
        }
        let Some(start) = text[from..].find(|c: char| c.is_ascii_digit()).map(|at| from + at) else { continue };
        let end = text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |at| start + at);
        text.replace_range(start..end, WORDS[*word]);
    }
    text.into_bytes()
}

/// What comes of a file is sound, or is refused with a place.
fn check(bytes: &[u8], name: &str) {
    match arrived(bytes, name, &[]) {
        Err(misread) => assert!(!misread.place.is_empty() && !misread.message.is_empty(), "{misread}"),
        Ok(arrived) => match &arrived.content {
            Content::Clouds(_) => {
                let scene = scene_of(&arrived, DVec3::new(0.0, 1000.0, 0.0));
                let errors = problem::check(&scene).into_iter().filter(|each| each.severity == Severity::Error);
                assert_eq!(errors.collect::<Vec<_>>(), []);
            }
            Content::Model(model) => {
                assert!(model.triangles > 0 && model.size.is_finite());
                let (edits, ..) = model.put(&Scene::default(), "a.glb", DVec3::ZERO);
                Document::new(Scene::default()).edit("Import", edits).expect("it fits");
            }
            Content::Scene(scene) => {
                let errors = problem::check(scene).into_iter().filter(|each| each.severity == Severity::Error);
                assert_eq!(errors.collect::<Vec<_>>(), []);
            }
            Content::Weather(preset) => {
                let sky = Sky::of_preset(preset, &Scene::default());
                let numbers = sky.layers.iter().flat_map(|layer| [layer.base_m, layer.thickness_m, layer.oktas]);
                let air = sky.air.values().into_iter().map(|(_, value)| value);
                assert!(numbers.chain(air).all(f64::is_finite), "{sky:?}");
            }
        },
    }
}

static GLB: LazyLock<Vec<u8>> = LazyLock::new(|| left(&heap(2), "a.glb", &[]));
const MODEL: &[u8] = include_bytes!("../../../../assets/models/aircraft.glb");

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn glb_files(changes in changes()) {
        check(&changed(&GLB, &changes), "a.glb");
    }

    #[test]
    fn models(changes in changes(), words in texts()) {
        check(&changed(MODEL, &changes), "a.glb");
        check(&reworded(MODEL, &words), "a.glb");
    }

    #[test]
    fn cld_files(changes in changes()) {
        check(&changed(&cld::by_hand(), &changes), "a.cld");
    }

    #[test]
    fn cry_clouds(changes in changes(), words in texts()) {
        check(&changed(cry_cloud::BY_HAND.as_bytes(), &changes), "a.xml");
        check(&reworded(cry_cloud::BY_HAND.as_bytes(), &words), "a.xml");
    }

    #[test]
    fn flightgear_layers(changes in changes(), words in texts()) {
        check(&changed(flightgear::BY_HAND.as_bytes(), &changes), "cloudlayers.xml");
        check(&reworded(flightgear::BY_HAND.as_bytes(), &words), "cloudlayers.xml");
    }

    #[test]
    fn weather_presets(which in 0..5_usize, changes in changes(), words in texts()) {
        let (_, bytes) = &wpr::real()[which];
        check(&changed(bytes, &changes), "a.WPR");
        check(&reworded(bytes, &words), "a.WPR");
    }
}
