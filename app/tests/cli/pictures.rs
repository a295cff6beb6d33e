//! What `render` writes.

use crate::Place;
use crate::scenes::changed;
use serde_json::json;

struct Png {
    width: u32,
    height: u32,
    is_srgb: bool,
    pixels: Vec<u8>,
}

fn decode(bytes: &[u8]) -> Png {
    let mut reader = png::Decoder::new(std::io::Cursor::new(bytes)).read_info().expect("a PNG");
    let mut pixels = vec![0; reader.output_buffer_size().expect("its size")];
    reader.next_frame(&mut pixels).expect("whole");
    let info = reader.info();
    Png { width: info.width, height: info.height, is_srgb: info.srgb.is_some(), pixels }
}

fn draw(place: &Place, words: &str) -> Png {
    let ran = place.run(&format!("render good.cloudscene -o out.png --size 64x36 {words}"));
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    // Graphics drivers may have said something before.
    assert!(ran.stderr.contains("renderer: "), "{words}: {}", ran.stderr);
    decode(&place.read("out.png"))
}

/// Mean absolute difference of two pictures' bytes.
fn difference(a: &Png, b: &Png) -> f64 {
    let sum: u64 = a.pixels.iter().zip(&b.pixels).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / a.pixels.len() as f64
}

#[test]
fn a_picture_of_the_size_asked_for() {
    let place = Place::new();
    let picture = draw(&place, "--renderer cpu");
    assert_eq!((picture.width, picture.height, picture.is_srgb), (64, 36, true));
    let sky = &picture.pixels[..3];
    assert!(sky[2] > sky[0], "the sky is blue: {sky:?}");
    assert_eq!(place.files(), ["good.cloudscene", "out.png"], "nothing else is left");
}

/// Twice, and on one thread and on two: byte for byte.
#[test]
fn the_same_scene_gives_the_same_files() {
    let place = Place::new();
    for (file, words) in [
        ("out.png", "render good.cloudscene --renderer cpu --size 200x120 -o"),
        ("out.png", "render good.cloudscene --truth --samples 4 --size 64x36 -o"),
        ("out.json", "export good.cloudscene --shaded --time 18:00 --camera main -o"),
        ("out.csv", "export good.cloudscene -o"),
    ] {
        let written = |threads| {
            let ran = place.run_on(threads, &format!("{words} {file}"));
            assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
            place.read(file)
        };
        let first = written("1");
        assert!(first == written("1"), "{words}: another file the second time");
        assert!(first == written("2"), "{words}: another file on two threads");
    }
}

#[test]
fn camera_and_time_make_another_picture() {
    let place = Place::new();
    let plain = draw(&place, "--renderer cpu");
    assert!(difference(&plain, &draw(&place, "--renderer cpu --camera above")) > 1.0);
    assert!(difference(&plain, &draw(&place, "--renderer cpu --time 20:30")) > 1.0);
    assert!(difference(&plain, &draw(&place, "--renderer cpu --camera main --time 12:00")) == 0.0, "the defaults");
}

#[test]
fn samples_and_truth_draw_the_same_scene() {
    let place = Place::new();
    let plain = draw(&place, "--renderer cpu");
    for words in ["--renderer cpu --samples 16", "--truth", "--truth --samples 4", "--renderer auto"] {
        let other = draw(&place, words);
        // The same clouds at the same place, but edges differ by a pixel's share: a few grey levels on the mean.
        assert!(difference(&plain, &other) < 4.0, "{words}: {}", difference(&plain, &other));
    }
    assert!(difference(&plain, &draw(&place, "--renderer cpu --samples 16")) > 0.0, "edges are smoother");
    assert!(difference(&plain, &draw(&place, "--renderer cpu --tolerance 1")) > 0.0, "sprites are merged");
}

/// A method by its name is what the other options ask for, to the byte.
#[test]
fn methods_are_chosen_by_name() {
    let place = Place::new();
    for (named, said) in [
        ("--method truth", "--truth"),
        ("--method truth --samples 4", "--truth --samples 4"),
        ("--method fast", "--renderer cpu"),
        ("--method fast", "--renderer cpu --tolerance 0"),
        ("--method auto", "--renderer cpu --tolerance 0.01"),
        ("--method fast --renderer cpu --samples 4", "--renderer cpu --samples 4"),
        ("--method four-samples", "--renderer cpu --samples 4"),
        ("--method four-samples --samples 1", "--renderer cpu"),
        // In a still there is no older order, and nothing was locked on the way.
        ("--method crossfade", "--renderer cpu"),
    ] {
        assert!(draw(&place, named).pixels == draw(&place, said).pixels, "{named} is not {said}");
    }
    let plain = draw(&place, "--renderer cpu");
    let off = |name: &str| difference(&plain, &draw(&place, &format!("--method {name}")));
    for other in ["no-mips", "eight-bits", "view-plane"] {
        assert!(off(other) > 0.0, "{other}");
    }
    // The fewer sprites, the farther off: none of the three is another.
    let [three_quarters, half, quarter] = ["three-quarters", "half", "quarter"].map(off);
    assert!(0.0 < three_quarters && three_quarters < half && half < quarter, "{three_quarters} {half} {quarter}");
    let ran = place.run("render good.cloudscene -o out.png --size 64x36 --method four-samples");
    assert!(ran.stderr.contains("renderer: CPU, four-samples with 4 samples a pixel"), "{}", ran.stderr);
}

#[test]
fn an_old_picture_is_replaced_only_by_a_whole_one() {
    let place = Place::new();
    place.put("out.png", b"old");
    place.put("bad.cloudscene", b"{");
    assert_eq!(place.run("render bad.cloudscene -o out.png").code, 2);
    assert_eq!(place.read("out.png"), b"old");
    draw(&place, "");
    assert_ne!(place.read("out.png"), b"old");
}

#[test]
fn a_scene_of_its_own_atlas() {
    let place = Place::new();
    place.put("own.png", include_bytes!("../../../assets/atlas/clouds.png"));
    place.put("good.cloudscene", &changed(|s| s["atlas"] = json!("own.png")));
    let own = draw(&place, "--renderer cpu");
    let built_in = draw(&Place::new(), "--renderer cpu");
    assert!(difference(&own, &built_in) == 0.0, "the same sheet gives the same picture");
    assert_eq!(place.run("check good.cloudscene").code, 0);
    place.put("own.png", b"\x89PNG broken");
    place.refuses("render good.cloudscene -o other.png", 2, &["good.cloudscene: atlas: error", "512 × 512"]);
}
