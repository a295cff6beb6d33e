//! Scenes as a web page: one file that asks for nothing, whose numbers are the scene's. How it looks is judged in a browser
//! (tests/judges/web.mjs).

use super::{left, left_at};
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::{base64, scene_file};
use cloudwright_core::scene::Scene;
use cloudwright_core::weather::{Light, WeatherRules, clouds_now};
use cloudwright_tests::scene_path;
use cloudwright_tests::small_scenes::{everything, heap};
use flate2::read::ZlibDecoder;
use serde_json::Value;
use std::io::Read;

/// A page as its script reads it.
struct Page {
    text: String,
    header: Value,
    block: Vec<u8>,
}

impl Page {
    fn of(scene: &Scene) -> Self {
        let text = String::from_utf8(left(scene, "index.html", &[])).expect("UTF-8");
        let of = |id: &str| {
            let (_, rest) = text.split_once(&format!("id=\"{id}\">")).expect("it is there");
            rest.split_once("</script>").expect("it ends").0
        };
        let header = serde_json::from_str(of("header")).expect("JSON");
        let mut block = Vec::new();
        let packed = base64::decode(of("block")).expect("base 64");
        ZlibDecoder::new(packed.as_slice()).read_to_end(&mut block).expect("zlib");
        Self { header, block, text }
    }

    fn floats(&self, name: &str) -> Vec<f32> {
        let sections = self.header["sections"].as_array().expect("a list");
        let section = sections.iter().find(|section| section["name"] == name).expect("it is there");
        let [from, bytes] = ["from", "bytes"].map(|key| section[key].as_u64().expect("a number") as usize);
        let words = self.block[from..from + bytes].as_chunks::<4>().0;
        words.iter().map(|word| f32::from_le_bytes(*word)).collect()
    }
}

fn shipped(name: &str) -> Scene {
    scene_file::read(&std::fs::read(scene_path(name)).expect("readable")).expect("sound")
}

/// The numbers of rows that begin with their second, as the page has them between two.
fn at_second(rows: &[&[f32]], second: f32) -> Vec<f64> {
    let next = rows.iter().position(|row| row[0] > second).unwrap_or(rows.len() - 1);
    let (from, to) = (rows[next.saturating_sub(1)], rows[next]);
    let share = if to[0] > from[0] { ((second - from[0]) / (to[0] - from[0])).clamp(0.0, 1.0) } else { 0.0 };
    from[1..].iter().zip(&to[1..]).map(|(a, b)| f64::from(a + (b - a) * share)).collect()
}

#[test]
fn a_page_is_whole() {
    let scene = everything();
    let page = Page::of(&scene);
    assert_eq!((&page.header["format"], &page.header["version"]), (&"cloudwright-web".into(), &1.into()));
    for outside in ["http:", "https:", "src=", "href=", "@import", "url(", "import ", "fetch("] {
        assert!(!page.text.contains(outside), "it asks for something by {outside}");
    }
    for mark in ["/*STYLE*/", "/*SCRIPT*/", "/*FRAME*/", "/*HEADER*/", "/*BLOCK*/"] {
        assert!(!page.text.contains(mark), "{mark} was not filled");
    }
    let again = left(&scene, "index.html", &[]);
    assert!(again == page.text.as_bytes(), "the same scene, the same bytes");
}

#[test]
fn names_stay_text() {
    let hostile = "</script><script>alert(1)</script><!-- <script> \u{2028}\" /*BLOCK*/ /*HEADER*/";
    let mut scene = heap(20);
    let count = |page: &Page| page.text.matches("<script").count() + page.text.matches("<!--").count();
    let plain = count(&Page::of(&scene));
    scene.name = hostile.into();
    scene.clouds.iter_mut().for_each(|cloud| cloud.name = hostile.into());
    scene.cameras.iter_mut().for_each(|camera| camera.name = hostile.into());
    let page = Page::of(&scene);
    assert_eq!(count(&page), plain, "no script of a name's");
    assert_eq!(
        (page.header["name"].as_str(), page.header["cameras"][0]["name"].as_str()),
        (Some(hostile), Some(hostile))
    );
    assert!(!page.block.is_empty());
}

#[test]
fn all_sprites_are_there() {
    for name in ["overcast", "fair_weather"] {
        let scene = shipped(name);
        let derived = Derived::new(&scene);
        let page = Page::of(&scene);
        let clouds = page.header["clouds"].as_array().expect("a list");
        assert_eq!(clouds.len(), derived.clouds().len(), "{name}");
        let sprites = page.floats("sprites");
        for (listed, placed) in clouds.iter().zip(derived.clouds()) {
            let first = listed["first_sprite"].as_u64().expect("a number") as usize;
            assert_eq!(listed["sprites"].as_u64(), Some(placed.sprites.len() as u64), "{name}");
            for (i, sprite) in placed.sprites.iter().enumerate() {
                let at = 8 * (first + i);
                let want = [sprite.position.x, sprite.position.y, sprite.position.z, sprite.width, sprite.height];
                assert_eq!(sprites[at..at + 5], want, "{name}: {i} of {}", placed.name);
            }
        }
    }
}

/// Twice the tolerance of glTF's keys: once where keys are set, once where those on a line are dropped.
#[test]
fn what_moves_is_near_where_it_is() {
    const TOLERANCE_M: f64 = 2.0 * cloudwright_core::exchange::motion::TOLERANCE_M + 0.01;
    for name in ["lee", "front", "summer_day"] {
        let scene = shipped(name);
        let derived = Derived::new(&scene);
        let page = Page::of(&scene);
        let end_s = page.header["end_s"].as_f64().expect("a number");
        assert!(end_s > 0.0, "{name} moves");
        let keys = page.floats("cloud_keys");
        for second in [0.0, 0.137, 0.5, 0.71, 0.99].map(|share| share * end_s) {
            let now = clouds_now(derived.clouds(), derived.timeline(), second, WeatherRules::default());
            for (listed, cloud) in page.header["clouds"].as_array().expect("a list").iter().zip(&now) {
                let [first, count] = ["first_key", "keys"].map(|key| listed[key].as_u64().expect("a number") as usize);
                let rows: Vec<&[f32]> = keys[11 * first..11 * (first + count)].chunks(11).collect();
                let numbers = at_second(&rows, second as f32);
                // Whoever has drifted out and comes in again jumps where nothing of it shows.
                if cloud.formed.core < 0.01 {
                    continue;
                }
                let off = (cloud.displacement - glam::DVec3::from_slice(&numbers[..3])).length();
                assert!(off < TOLERANCE_M, "{name} at {second} s: {} is off by {off} m", cloud.placed.name);
                assert!((f64::from(cloud.formed.core) - numbers[3]).abs() < 0.01, "{name}: {}", cloud.placed.name);
            }
        }
    }
}

#[test]
fn light_is_that_of_the_hour() {
    let scene = shipped("fair_weather");
    let page = Page::of(&scene);
    let fields = page.header["light_fields"].as_array().expect("a list");
    let length: u64 = fields.iter().map(|field| field[1].as_u64().expect("a number")).sum();
    let rows = page.floats("light_by_hour");
    assert_eq!(rows.len() as u64, 241 * length);
    for (at, row) in rows.chunks(length as usize).enumerate() {
        let hour = at as f64 / 10.0;
        let light = Light::at(&scene, hour);
        assert_eq!((row[0], &row[1..4]), (hour as f32, &light.direction.to_array()[..]));
        assert_eq!(row[4..8], light.ambient_max.to_array(), "at {hour}");
    }
    assert_eq!(page.floats("light_by_clock").len() as u64, length + 1, "no clock moves it");
}

#[test]
fn a_page_begins_at_the_moment() {
    let (files, notes) = left_at(&shipped("fair_weather"), "index.html", &[], 12.5).expect("it leaves");
    let text = String::from_utf8_lossy(&files[0].1);
    assert!(text.contains(r#""start":{"camera":0,"clock_s":12.5,"time_h":null}"#));
    let told: Vec<String> = notes.iter().map(ToString::to_string).collect();
    assert!(told.iter().any(|note| note.contains("paths, aircraft")), "{told:?}");
}

/// What one would send by mail: servers take some 20 MB, and mail makes a third more of it.
#[test]
fn pages_are_small() {
    let bytes = left(&shipped("overcast"), "index.html", &[]).len();
    assert!(bytes < 5_000_000, "{bytes}");
}
