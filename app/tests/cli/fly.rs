//! What `fly` writes, and what it keeps.

use crate::Place;
use crate::scenes::changed;
use serde_json::{Value, json};

/// Past the west cloud in a third of a second: eleven frames.
fn flight() -> Value {
    json!({ "id": 901, "name": "west", "field_of_view_deg": 55.0, "keys": [
        { "time_s": 0.0, "position": [-1000.0, 1000.0, 700.0], "heading_deg": 0.0, "pitch_deg": 0.0 },
        { "time_s": 0.3335, "position": [-950.0, 1010.0, 600.0], "heading_deg": 4.0, "pitch_deg": -2.0 },
    ] })
}

/// A folder with a scene of one flight, `west`, and a path of one key, `still`.
pub(crate) fn place() -> Place {
    let place = Place::new();
    let mut still = flight();
    (still["id"], still["name"]) = (json!(902), json!("still"));
    still["keys"].as_array_mut().expect("keys").truncate(1);
    let scene = changed(|scene| {
        scene["next_id"] = json!(910);
        scene["paths"] = json!([flight(), still]);
    });
    place.put("flown.cloudscene", &scene);
    place
}

fn fly(place: &Place, words: &str) -> String {
    let ran = place.run(&format!("fly flown.cloudscene --path west --size 64x36 --renderer cpu {words}"));
    assert_eq!((ran.code, ran.stdout.as_str()), (0, ""), "{words}: {}", ran.stderr);
    ran.stderr
}

fn frame(folder: &str, number: u32) -> String {
    format!("{folder}/west_{number:05}.png")
}

#[test]
fn a_frame_is_the_same_alone_or_in_a_sequence() {
    let place = place();
    for sorting in ["each-frame", "crossfade"] {
        let (all, some) = (format!("all_{sorting}"), format!("some_{sorting}"));
        fly(&place, &format!("-o {all} --sorting {sorting}"));
        fly(&place, &format!("-o {some} --sorting {sorting} --frames 4..7"));
        let count = |folder: &str| std::fs::read_dir(place.path(folder)).expect("made").count();
        // 0.3335 s × 30 is 10.005: frames 0 to 10.
        assert_eq!((count(&all), count(&some)), (11, 3), "{sorting}");
        for number in 4..7 {
            assert!(place.read(&frame(&all, number)) == place.read(&frame(&some, number)), "{sorting}: {number}");
        }
        assert!(place.read(&frame(&all, 4)) != place.read(&frame(&all, 10)), "{sorting}: the flight goes on");
    }
}

#[test]
fn methods_are_chosen_by_name() {
    let place = place();
    for (folder, named, said) in [
        ("truth", "--method truth --samples 4", "--truth --samples 4"),
        ("crossfade", "--method crossfade", "--sorting crossfade"),
        ("samples", "--method four-samples", "--samples 4"),
    ] {
        fly(&place, &format!("-o {folder} --frames 8..9 {named}"));
        fly(&place, &format!("-o {folder}_said --frames 8..9 {said}"));
        let (named_so, said_so) = (frame(folder, 8), frame(&format!("{folder}_said"), 8));
        assert!(place.read(&named_so) == place.read(&said_so), "{named} is not {said}");
    }
    fly(&place, "-o plain --frames 8..9");
    assert!(place.read(&frame("plain", 8)) != place.read(&frame("truth", 8)));
}

#[test]
fn a_broken_run_goes_on() {
    let place = place();
    fly(&place, "-o out --frames 0..5");
    let whole = place.read(&frame("out", 2));
    // No picture of ours, but whole and of the size: it is kept as it is.
    place.put(&frame("out", 0), &place.read(&frame("out", 4)));
    // The pixels are there, but the end of the file is not; then only a part; then another size.
    place.put(&frame("out", 1), &whole[..whole.len() - 6]);
    place.put(&frame("out", 2), &whole[..whole.len() / 2]);
    assert_eq!(place.run("render good.cloudscene -o out/west_00003.png --size 32x18 --renderer cpu").code, 0);
    assert!(fly(&place, "-o out --frames 0..6").contains("4 drawn, 2 kept"));
    assert!(place.read(&frame("out", 2)) == whole, "mended");
    assert!(place.read(&frame("out", 0)) == place.read(&frame("out", 4)), "kept");
    assert!(fly(&place, "-o out --frames 0..2 --anew").contains("2 drawn, 0 kept"));
    assert!(place.read(&frame("out", 0)) != place.read(&frame("out", 4)), "drawn anew");
    fly(&place, "-o fresh --frames 0..6");
    for number in [1, 2, 3, 5] {
        assert!(place.read(&frame("out", number)) == place.read(&frame("fresh", number)), "{number}");
    }
}

#[test]
fn what_cannot_be_flown_is_said_before_drawing() {
    let place = place();
    place.put("taken", b"a file");
    let fly = "fly flown.cloudscene --size 64x36 --renderer cpu";
    for (words, code, wanted) in [
        ("--path nowhere -o out", 2, &["flown.cloudscene", "“nowhere”", "west, still"][..]),
        ("--path still -o out", 2, &["“still”", "stands still"]),
        ("--path west -o taken", 3, &["taken", "it is a file"]),
        ("--path west -o taken/out", 3, &["taken/out", "folder"]),
        ("--path west -o none/out.mp4", 3, &["none/out.mp4", "make the folder"]),
        ("--path west -o out --fps 0", 2, &["--fps", "1..=240"]),
        ("--path west -o out --fps 241", 2, &["--fps", "1..=240"]),
        ("--path west -o out --frames 7..4", 2, &["--frames", "0..90"]),
        ("--path west -o out --frames 4..12", 2, &["--frames", "0..11"]),
    ] {
        place.refuses(&format!("{fly} {words}"), code, wanted);
    }
    place.refuses("fly flown.cloudscene --path west -o out.mp4 --size 65x36", 2, &["--size", "even"]);
    place.refuses("fly good.cloudscene --path west -o out", 2, &["good.cloudscene", "no paths"]);
}

#[test]
fn the_cpu_draws_the_aircraft_ahead() {
    let place = place();
    fly(&place, "-o empty --frames 2..4");
    place.put(
        "flown.cloudscene",
        &changed(|scene| {
            scene["next_id"] = json!(910);
            scene["paths"] = json!([flight()]);
            scene["aircraft"] = json!([{ "id": 903, "name": "leader", "path": 901, "ahead_s": 0.1, "scale": 1.0 }]);
        }),
    );
    fly(&place, "-o flown --frames 2..4");
    for frame in ["west_00002.png", "west_00003.png"] {
        let [empty, flown] = ["empty", "flown"].map(|folder| place.read(&format!("{folder}/{frame}")));
        assert!(empty != flown, "{frame}: the leader shows");
    }
}

#[test]
fn without_ffmpeg_the_frames_stay() {
    let place = place();
    let words = "fly flown.cloudscene --path west --size 64x36 --renderer cpu -o out.mp4 --frames 3..5";
    let ran = place.run_with(&[("PATH", "")], words);
    assert_eq!(ran.code, 3, "{}", ran.stderr);
    for wanted in ["no ffmpeg", "out_frames", "ffmpeg -framerate 30 -start_number 3", "-frames:v 2"] {
        assert!(ran.stderr.contains(wanted), "no “{wanted}” in: {}", ran.stderr);
    }
    assert!(!place.path("out.mp4").exists());
    assert!(place.path("out_frames/west_00003.png").exists() && place.path("out_frames/west_00004.png").exists());
}

/// In place of ffmpeg stands a script that writes what it was called with, or fails halfway.
#[cfg(unix)]
#[test]
fn a_video_is_whole_or_not_there() {
    use std::os::unix::fs::PermissionsExt;
    let place = place();
    let words = "fly flown.cloudscene --path west --size 64x36 --renderer cpu -o out.mp4 --frames 3..5";
    let path = place.path("bin").to_string_lossy().into_owned();
    std::fs::create_dir(place.path("bin")).expect("writable");
    for (ending, code) in [("echo broken >&2; exit 1", 3), ("exit 0", 0)] {
        let script = format!("#!/bin/sh\nfor last; do :; done\necho \"$@\" > \"$last\"\n{ending}\n");
        place.put("bin/ffmpeg", script.as_bytes());
        std::fs::set_permissions(place.path("bin/ffmpeg"), PermissionsExt::from_mode(0o755)).expect("allowed");
        let ran = place.run_with(&[("PATH", &path)], words);
        assert_eq!(ran.code, code, "{}", ran.stderr);
        assert_eq!(ran.stderr.contains("broken"), code != 0, "{}", ran.stderr);
        assert_eq!(place.path("out.mp4").exists(), code == 0, "{ending}");
        assert!(!place.path("out_frames/unfinished.mp4").exists(), "{ending}");
    }
    let called_with = String::from_utf8(place.read("out.mp4")).expect("text");
    for wanted in ["-framerate 30", "-start_number 3", "-i west_%05d.png", "-pix_fmt yuv420p", "-crf 18"] {
        assert!(called_with.contains(wanted), "no “{wanted}” in: {called_with}");
    }
}

/// Each is flown through both: what the first drew is not taken for the second's.
#[test]
fn paths_of_like_names_share_no_pictures() {
    let place = Place::new();
    let names = ["a/b", "a_b", "A_B", "a_b-2"];
    let scene = changed(|scene| {
        scene["next_id"] = json!(910);
        let path = |(number, name): (usize, &&str)| {
            let mut path = flight();
            (path["id"], path["name"]) = (json!(901 + number), json!(name));
            path["keys"][0]["position"][0] = json!(-1000 + 100 * number as i64);
            path
        };
        scene["paths"] = json!(names.iter().enumerate().map(path).collect::<Vec<_>>());
    });
    place.put("flown.cloudscene", &scene);
    let fly = |name: &str| {
        place.run(&format!("fly flown.cloudscene --path {name} --size 64x36 --renderer cpu -o out --frames 0..1"))
    };
    for name in names {
        let ran = fly(name);
        assert!(ran.code == 0 && ran.stderr.contains("1 drawn, 0 kept"), "{name}: {}", ran.stderr);
    }
    let mut files: Vec<_> =
        std::fs::read_dir(place.path("out")).expect("made").collect::<Result<_, _>>().expect("read");
    files.sort_by_key(std::fs::DirEntry::file_name);
    let found: Vec<String> = files.iter().map(|file| file.file_name().to_string_lossy().into_owned()).collect();
    assert_eq!(found, ["A_B-3_00000.png", "a_b-2-2_00000.png", "a_b-2_00000.png", "a_b_00000.png"]);
    assert!(fly("A_B").stderr.contains("0 drawn, 1 kept"));
}
