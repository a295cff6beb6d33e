//! What `chart` measures, writes, keeps, and refuses.

use crate::Place;
use crate::scenes::changed;
use cloudwright::chart::report::{Report, read};
use serde_json::json;

/// A folder with a scene of two flights: `west`, past a cloud and into it, and `short`, of one frame.
fn place() -> Place {
    let place = Place::new();
    let flight = |id: u64, name: &str, end_s: f64| {
        json!({ "id": id, "name": name, "field_of_view_deg": 55.0, "keys": [
            { "time_s": 0.0, "position": [-1000.0, 1000.0, 500.0], "heading_deg": 0.0, "pitch_deg": 0.0 },
            { "time_s": end_s, "position": [-950.0, 960.0, 100.0], "heading_deg": 4.0, "pitch_deg": -2.0 },
        ] })
    };
    let mut still = flight(903, "still", 1.0);
    still["keys"].as_array_mut().expect("keys").truncate(1);
    let scene = changed(|scene| {
        scene["next_id"] = json!(910);
        scene["paths"] = json!([flight(901, "west", 4.0), flight(902, "short", 0.02), still]);
    });
    place.put("flown.cloudscene", &scene);
    place
}

fn chart(place: &Place, words: &str) -> (String, String) {
    let ran = place.run(&format!("chart flown.cloudscene --size 48x27 --repeat 1 {words}"));
    assert_eq!(ran.code, 0, "{words}: {}", ran.stderr);
    (ran.stdout, ran.stderr)
}

fn report(place: &Place, folder: &str) -> Report {
    read(&place.read(&format!("{folder}/chart.json"))).expect("a chart")
}

fn error(report: &Report, name: &str) -> f64 {
    let method = report.methods.iter().find(|method| method.name == name);
    method.and_then(|method| method.error.flip_mean).unwrap_or_else(|| panic!("{name}: no error"))
}

#[test]
fn a_flight_is_measured_and_traps_lie_far_off() {
    let place = place();
    let (words, _) = chart(&place, "-o out --methods truth,fast,half,view-plane,no-lock,eight-bits");
    let report = report(&place, "out");
    assert!(!report.unfinished && report.left_out.is_empty());
    assert_eq!(report.view, Some(cloudwright::chart::report::Viewpoint::Path("west".into())), "the first path");
    assert_eq!(error(&report, "truth"), 0.0);
    let fast = error(&report, "fast");
    // As in the tests of the table of methods: what is shipped is near, what is known to fail farther.
    assert!(fast < 0.05, "{fast}");
    for name in ["half", "view-plane", "eight-bits"] {
        assert!(error(&report, name) > fast, "{name}");
    }
    for method in &report.methods {
        assert_eq!(method.frames.len(), 5, "{}", method.name);
        assert!(method.cost.frame_ms > Some(0.0) && method.cost.counts.sprites > 0, "{}", method.name);
        assert!(method.stability.is_some(), "{}", method.name);
        assert!(!(method.known_to_fail && method.on_front), "{}", method.name);
        assert!(words.contains(&method.name), "{words}");
    }
    assert!(words.contains("cheapest within FLIP 0.02") || words.contains("no method keeps within"), "{words}");
    let page = String::from_utf8(place.read("out/chart.html")).expect("text");
    assert!(page.starts_with("<!DOCTYPE html>") && page.trim_end().ends_with("</html>"));
    assert_eq!(page.matches("<img").count(), 1 + 2 * (report.methods.len() - 1), "truth, and two for each other");
}

#[test]
fn json_answers_with_the_file() {
    let place = place();
    let (words, _) = chart(&place, "-o out --camera above --methods fast,quarter --json");
    assert_eq!(words.as_bytes(), place.read("out/chart.json"));
    let report = report(&place, "out");
    assert!(report.methods.iter().all(|method| method.stability.is_none() && method.frames.len() == 1), "a still");
}

#[test]
fn what_can_not_be_measured_is_named_and_left_out() {
    let place = place();
    let (_, said) = chart(&place, "-o out --camera above --methods fast,crossfade,fast");
    assert!(said.contains("left out: crossfade: it would draw what “fast” draws"), "{said}");
    let report = report(&place, "out");
    let left_out: Vec<&str> = report.left_out.iter().map(|one| one.name.as_str()).collect();
    assert_eq!((left_out, report.methods.len()), (vec!["crossfade"], 1));
    assert!(String::from_utf8_lossy(&place.read("out/chart.html")).contains("crossfade"));
}

#[test]
fn a_second_run_goes_on() {
    let place = place();
    chart(&place, "-o out --methods fast,half");
    let first = report(&place, "out");
    // Nothing is left to do: figures stay as they are, times too.
    chart(&place, "-o out --methods fast,half");
    assert_eq!(report(&place, "out"), first);
    // As if broken off in the middle: one method is whole, the other lacks three places; a mark shows what is kept.
    let mut broken = first.clone();
    broken.unfinished = true;
    broken.methods[0].frames[2].error.flip_mean = Some(0.125);
    broken.methods[1].frames.truncate(3);
    place.put("out/chart.json", cloudwright::chart::report::write(&broken).expect("JSON").as_bytes());
    chart(&place, "-o out --methods fast,half");
    let second = report(&place, "out");
    assert!(!second.unfinished);
    assert_eq!(second.methods[0].frames[2].error.flip_mean, Some(0.125), "kept");
    let errors = |report: &Report| report.methods[1].frames.iter().map(|f| f.error.clone()).collect::<Vec<_>>();
    assert_eq!(errors(&second), errors(&first), "measured again, the same");
    // Another method joins; another time of day is something else.
    chart(&place, "-o out --methods fast,half,quarter");
    assert_eq!(report(&place, "out").methods[0].frames[2].error.flip_mean, Some(0.125));
    let (_, said) = chart(&place, "-o out --methods fast --time 20:00");
    assert!(said.contains("measured anew"), "{said}");
    assert_ne!(report(&place, "out").methods[0].frames[2].error.flip_mean, Some(0.125));
}

/// Ctrl-C sends the same signal.
#[cfg(unix)]
#[test]
fn an_interrupted_run_is_gone_on_with() {
    let place = place();
    let words = "chart flown.cloudscene -o out --size 256x144 --repeat 1 --methods fast,half";
    let mut child = std::process::Command::new(env!("CARGO_BIN_EXE_cloudwright"))
        .args(words.split_whitespace())
        .current_dir(place.path(""))
        .stdout(std::process::Stdio::null())
        .stderr(std::process::Stdio::null())
        .spawn()
        .expect("the binary runs");
    let measured = || {
        let report = read(&std::fs::read(place.path("out/chart.json")).ok()?).ok()?;
        report.methods.first()?.frames.first()?.drawn_ms?;
        Some(report)
    };
    while measured().is_none() {
        assert_eq!(child.try_wait().expect("it can be asked"), None, "it ended before it measured anything");
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let sent = std::process::Command::new("kill").args(["-INT", &child.id().to_string()]).status();
    assert!(sent.expect("kill runs").success());
    assert!(!child.wait().expect("it ends").success());
    let kept = report(&place, "out");
    assert!(kept.unfinished, "interrupted in the middle");
    let ran = place.run(words);
    assert_eq!(ran.code, 0, "{}", ran.stderr);
    let whole = report(&place, "out");
    assert!(!whole.unfinished);
    // Times differ from run to run, so equal ones are kept ones.
    assert_eq!(whole.methods[0].frames[0], kept.methods[0].frames[0]);
    assert_eq!(whole.methods[0].frames.len(), 5);
}

#[test]
fn odd_sizes_and_short_flights_have_an_answer() {
    let place = place();
    for (size, words) in
        [("1x1", "--path west"), ("16384x1", "--path short"), ("1x64", "--camera above"), ("48x27", "--path short")]
    {
        let ran = place
            .run(&format!("chart flown.cloudscene -o {size} --size {size} --repeat 1 --methods fast,half {words}"));
        assert_eq!(ran.code, 0, "{size} {words}: {}", ran.stderr);
        let report = report(&place, size);
        assert_eq!(report.methods.len(), 2, "{size} {words}");
        assert_eq!(report.methods[0].stability.is_some(), words == "--path west", "{size} {words}");
    }
}

#[test]
fn what_can_not_be_charted_is_said_before_drawing() {
    let place = place();
    place.put("taken", b"a file");
    place.put("bare.cloudscene", &changed(|scene| scene["clouds"] = json!([])));
    std::fs::create_dir_all(place.path("other/chart.html")).expect("writable");
    std::fs::create_dir(place.path("foreign")).expect("writable");
    place.put("foreign/chart.json", b"{ \"format\": \"poem\", \"version\": 1 }");
    let flown = "flown.cloudscene --size 48x27";
    for (words, code, wanted) in [
        (format!("{flown} -o taken"), 3, &["taken", "it is a file"][..]),
        (format!("{flown} -o other"), 3, &["chart.html", "folder"]),
        (format!("{flown} -o foreign"), 2, &["chart.json", "poem"]),
        (format!("{flown} -o out --path nowhere"), 2, &["“nowhere”", "west, short, still"]),
        (format!("{flown} -o out --path still"), 2, &["“still”", "stands still"]),
        (format!("{flown} -o out --camera nowhere"), 2, &["“nowhere”", "above"]),
        (format!("{flown} -o out --camera above --path west"), 2, &["--camera", "--path"]),
        (format!("{flown} -o out --camera above --methods crossfade"), 2, &["none is left", "crossfade", "fast"]),
        (format!("{flown} -o out --methods fast,turth"), 2, &["--methods", "'turth'", "did you mean `truth`?"]),
        (format!("{flown} -o out --methods turbo,fast"), 2, &["--methods", "no such method", "lazy-simgear"]),
        (format!("{flown} -o out --repeat 0"), 2, &["--repeat", "1..=100"]),
        (format!("{flown} -o out --tolerance 2"), 2, &["--tolerance", "0 to 1"]),
        ("flown.cloudscene -o out --size 16384x16384".into(), 2, &["--size"]),
        ("bare.cloudscene -o out".into(), 2, &["bare.cloudscene", "no sprites"]),
    ] {
        place.refuses(&format!("chart {words}"), code, wanted);
    }
}
