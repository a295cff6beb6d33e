//! What a file or a name holds is said so that all of it is seen, and nothing of it steers the terminal.

use crate::scenes::{aircraft, changed, good, replaced};
use crate::{Place, Ran};
use serde_json::json;

/// Clears the screen, rings, turns the line about, hides: ESC, BEL, CSI in one byte, RLO, ZWSP, BOM, a tag.
const UNSEEN: [char; 7] = ['\u{1b}', '\u{7}', '\u{9b}', '\u{202e}', '\u{200b}', '\u{feff}', '\u{e0041}'];
const EVIL: &str = "a\u{1b}[2J\u{7}\u{9b}2J\u{202e}gnp\u{200b}\u{feff}\u{e0041}\nb";
/// As it is said.
const SEEN: &str = "a\\u{1b}[2J\\u{7}\\u{9b}2J\\u{202e}gnp\\u{200b}\\u{feff}\\u{e0041} b";

fn said(ran: &Ran) -> String {
    format!("{}{}", ran.stdout, ran.stderr)
}

#[track_caller]
fn assert_seen(words: &str, said: &str) {
    assert!(!said.contains(UNSEEN), "cloudwright {words}: {said:?}");
    assert!(said.contains(SEEN), "cloudwright {words}: no {SEEN} in {said:?}");
}

#[test]
fn names_in_a_scene() {
    let place = Place::new();
    let scene = changed(|s| {
        aircraft(s, EVIL);
        s["name"] = json!(EVIL);
        s["clouds"][0]["name"] = json!(EVIL);
        s["cameras"][0]["name"] = json!(EVIL);
        s["paths"][0]["name"] = json!(EVIL);
    });
    place.put("bad.cloudscene", &scene);
    place.put("field.cloudscene", replaced("\"exposure_ev\"", &serde_json::to_string(EVIL).expect("JSON")).as_slice());
    place.put("value.cloudscene", &changed(|s| s["time_of_day_h"] = json!(EVIL)));
    place.put("format.cloudscene", &replaced("cloudwright-scene", EVIL.replace('\n', "\\n").as_str()));
    for words in ["info bad.cloudscene", "check bad.cloudscene", "fly bad.cloudscene --path x -o out"] {
        assert_seen(words, &said(&place.run(words)));
    }
    for words in ["check field.cloudscene", "render field.cloudscene -o a.png"] {
        assert_seen(words, &said(&place.run(words)));
    }
    // serde escapes what it quotes in its own way; a raw control character is no JSON.
    for words in ["check value.cloudscene", "check format.cloudscene"] {
        let said = said(&place.run(words));
        assert!(!said.contains(UNSEEN) && !said.is_empty(), "{words}: {said:?}");
    }
    let ran = place.run("info --json bad.cloudscene");
    assert!(!ran.stdout.contains(UNSEEN), "{}", ran.stdout);
    let answer: serde_json::Value = serde_json::from_str(&ran.stdout).expect("JSON");
    assert_eq!(answer["name"], json!(EVIL), "programs get the name as it is");
    let good_twice = place.run("info good.cloudscene");
    assert_eq!(good_twice.code, 0);
}

#[test]
fn words_on_the_command_line() {
    let place = Place::new();
    let evil_file = format!("{EVIL}.cloudscene");
    #[cfg(unix)]
    place.put(&evil_file, b"{");
    for words in [
        &["check", &evil_file][..],
        &["render", &evil_file, "-o", "out.png"],
        &["render", "good.cloudscene", "-o", EVIL],
        &["render", "good.cloudscene", "-o", "out.png", "--camera", EVIL],
        &["render", "good.cloudscene", "-o", "out.png", "--size", EVIL],
        &["render", "good.cloudscene", "-o", "out.png", &format!("--{EVIL}")],
        &["good.cloudscene", EVIL],
        &["new", "sky.cloudscene", "--preset", EVIL],
        &["chart", "good.cloudscene", "-o", "out", "--methods", EVIL],
    ] {
        let ran = place.run_words(words);
        assert!(ran.code == 2 || ran.code == 1, "{words:?}: {}", ran.code);
        assert_seen(&format!("{words:?}"), &said(&ran));
    }
}

#[test]
fn long_numbers_and_the_words_of_libraries() {
    let place = Place::new();
    let long = format!("1{}", "0".repeat(299));
    let text = good();
    assert!(text.contains("\"time_of_day_h\": 12"));
    place.put(
        "far.cloudscene",
        text.replacen("\"time_of_day_h\": 12", &format!("\"time_of_day_h\": {long}"), 1).as_bytes(),
    );
    let sheet = include_bytes!("../../../assets/atlas/clouds.png");
    place.put("own.cloudscene", &changed(|s| s["atlas"] = json!("own.png")));
    let ran = place.run("check far.cloudscene");
    assert!(ran.stdout.contains("error: 100000000000… (300 digits) is out of range"), "{}", ran.stdout);
    let ran = place.run(&format!("thin good.cloudscene -o out.cloudscene --tolerance {long}"));
    assert!(ran.stderr.contains("not 100000000000… (300 digits)"), "{}", ran.stderr);
    // Where the head must be, a chunk of another kind; and a sheet that is cut off.
    let mut chunk = sheet.to_vec();
    chunk[12..16].copy_from_slice(b"i\x1b[J");
    for (bytes, wanted) in [(&chunk[..], "its PNG is broken"), (&sheet[..999], "its PNG is cut off")] {
        place.put("own.png", bytes);
        let ran = place.run("check own.cloudscene");
        assert!(ran.stdout.contains(wanted) && !ran.stdout.contains(['{', '[']), "{}", ran.stdout);
    }
}
