//! Random programs made of the functions that scripts have: whatever they ask for, they get an outcome that fits or an
//! error, and never half of a change.
//!
//! Calls are each function's own example, as it stands in the manual, and the same names with anything in the place of
//! what they take; in loops, in conditions, and within what catches their errors. New functions come in by themselves.

use crate::scene;
use cloudwright_core::document::Document;
use cloudwright_core::problem::{self, Severity};
use cloudwright_core::scene::{CameraPath, PathId, PathKey, Scene};
use cloudwright_scripts::bindings::SUBJECTS;
use cloudwright_scripts::{Fault, Patience, Plugin};
use glam::DVec3;
use proptest::prelude::*;
use proptest::test_runner::{RngAlgorithm, TestRng, TestRunner};
use std::cell::Cell;
use std::time::{Duration, Instant};

/// What the examples take for given.
const HEAD: &str = r#"
    let cloud = clouds()[0]; let model = models()[0]; let one = boxes(model)[0]; let camera = cameras()[0];
    let path = paths()[0]; let ids = [cloud]; let keys = fields(`path/${path}`).keys; let rows = [#{ rank: 2 }, #{ rank: 1 }];
    let seed = 3; let r = random(seed); let x = 0.3; let y = 2.5; let z = 0.7; let i = 0; let heading_deg = 30.0;
    let a = [0, 1, 2]; let b = [3.5, -4, 5e3]; let v = a; let list = [1, 2]; let places = [a, b];
    let from = a; let to = b;
"#;

/// Anything that can stand in a call; `$` is a number of a few.
const VALUES: &[&str] = &[
    "0",
    "1",
    "-1",
    "7",
    "$",
    "0.5",
    "-2.5e3",
    "1e308",
    "-1e-308",
    "9223372036854775807",
    "(0.0 / 0.0)",
    "(1.0 / 0.0)",
    "true",
    "()",
    "'c'",
    "\"\"",
    "\"x\"",
    "\"in_out\"",
    "[]",
    "#{ }",
    "a",
    "b",
    "places",
    "list",
    "cloud",
    "model",
    "one",
    "camera",
    "[cloud]",
    "[one]",
    "[cloud, cloud]",
    "clouds()",
    "boxes(model)",
    "selection()",
    "p",
    "r",
    "i",
    "`cloud/${cloud}`",
    "`cloud/${cloud}/opacity`",
    "`cloud/${cloud}/position`",
    "`model/${model}`",
    "`model/${model}/seed`",
    "`model/${model}/box/${one}`",
    "`model/${model}/box/${one}/size`",
    "`camera/${camera}`",
    "\"sky/exposure_ev\"",
    "\"time_of_day_h\"",
    "\"weather/wind_speed_mps\"",
    "\"ground\"",
    "\"no/such\"",
    "#{ model: model }",
    "#{ name: \"n\" }",
    "#{ center: b, size: [90, 90, 90] }",
    "#{ position: b }",
    "#{ leaves: \"step\" }",
    "#{ boxes: [#{ }] }",
    "#{ boxes: #{ } }",
    "#{ opacity: 0.1, scale: 2 }",
    "#{ after: \"repeat\" }",
    "`${places}`",
    "get(`cloud/${cloud}/position`)",
    "keys(\"sky/exposure_ev\")",
    "grid(2, 3, 100)",
    "Fn(\"run\")",
];

/// The example of a function, about things that the scene has.
fn example(usage: &str) -> String {
    // Of two ways the first; what is left open is a place or a size; a text between ` may have values in it.
    let usage = usage.split(", or ").next().unwrap_or(usage);
    [
        ("\"", "`"),
        ("cloud/7", "cloud/${cloud}"),
        ("model/3", "model/${model}"),
        ("path/3", "path/${path}"),
        ("camera/1", "camera/${camera}"),
        ("[7, 8]", "[cloud]"),
        ("[7]", "[cloud]"),
        ("[box", "[one"),
        ("[[one, 7", "[[one, 0"),
        ("keys: […]", "keys: keys"),
        ("[…]", "[90, 90, 90]"),
        ("sorted_by(list", "sorted_by(rows"),
        ("smoothstep(a, b", "smoothstep(0, 1"),
    ]
    .iter()
    .fold(usage.to_owned(), |text, (of, with)| text.replace(of, with))
}

fn value() -> impl Strategy<Value = String> {
    (prop::sample::select(VALUES), -3..30_i32).prop_map(|(value, number)| value.replace('$', &number.to_string()))
}

fn call() -> impl Strategy<Value = String> {
    let functions: Vec<(&str, String)> =
        SUBJECTS.iter().flat_map(|(_, list)| *list).map(|(name, usage, _)| (*name, example(usage))).collect();
    let function = prop::sample::select(functions);
    let arguments = prop::collection::vec(value(), 0..4);
    (function, arguments, 0..5).prop_map(|((name, example), arguments, dice)| match dice {
        0 | 1 => example,
        2 => format!("r.{name}({})", arguments.join(", ")),
        _ => format!("{name}({})", arguments.join(", ")),
    })
}

fn statement() -> impl Strategy<Value = String> {
    let leaf = (call(), value(), 0..8).prop_map(|(call, value, dice)| match dice {
        0 => format!("set({value}, {call});"),
        1 => format!("let v = {call}; set(`cloud/${{cloud}}/position`, v);"),
        2 => format!("cloud = {call};"),
        3 => format!("list += {call};"),
        4 => format!("{call};"),
        // So that a program goes on after its faults.
        _ => format!("try {{ {call}; }} catch {{ i += 1; }}"),
    });
    leaf.prop_recursive(3, 12, 4, |inner| {
        let block = prop::collection::vec(inner, 1..4).prop_map(|lines| lines.join(" "));
        (block, 0..4, 0..6).prop_map(|(block, dice, times)| match dice {
            0 => format!("for i in 0..{times} {{ {block} }}"),
            1 => format!("if i < {times} {{ {block} }}"),
            _ => format!("try {{ {block} }} catch {{ i += 1; }}"),
        })
    })
}

/// A ready-made cloud, and a flight past it.
fn with_a_path() -> Scene {
    let mut scene = scene();
    let id = PathId::new(&mut scene.next_id);
    let key = |time_s: f64| PathKey {
        time_s,
        position: DVec3::new(200.0 * time_s, 900.0, 50.0 * time_s * time_s),
        heading_deg: 90.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    let keys = [0.0, 9.0, 20.0].map(key).to_vec();
    scene.paths.push(CameraPath { id, name: "past".into(), field_of_view_deg: 60.0, keys });
    scene
}

/// Runs one, and holds it to what a run promises. Whether it changed the scene; none if it ended with an error.
fn check(kind: &str, body: &str) -> Result<Option<bool>, TestCaseError> {
    let head = format!(r#"const PLUGIN = #{{ name: "Dice", kind: "{kind}", sentence: "For tests." }};"#);
    let source = format!("{head}\nfn run(p) {{ {HEAD}\n{body}\n}}");
    let plugin = match Plugin::read(&source) {
        Ok(plugin) => plugin,
        Err(error) => {
            prop_assert!(error.fault != Fault::Broken, "{}\n{}", error, source);
            return Ok(None);
        }
    };
    let mut document = Document::new(with_a_path());
    let before = document.scene().clone();
    let patience = Patience { until: Some(Instant::now() + Duration::from_millis(500)), ..Patience::usual() };
    match plugin.run(&before, &plugin.values(), &patience) {
        Err(error) => {
            prop_assert!(error.fault != Fault::Broken, "{}\n{}", error, source);
            Ok(None)
        }
        Ok(outcome) => {
            let applied = outcome.apply(&plugin, &mut document);
            prop_assert!(applied.is_ok(), "{:?}\n{}", applied, source);
            let faults = problem::check(document.scene());
            let faults: Vec<_> = faults.iter().filter(|fault| fault.severity == Severity::Error).collect();
            prop_assert!(faults.is_empty(), "{:?}\n{}", faults, source);
            let changed = *document.scene() != before;
            document.undo();
            prop_assert!(*document.scene() == before, "not undone\n{}", source);
            Ok(Some(changed))
        }
    }
}

#[test]
fn random_programs_change_all_or_nothing() {
    let config = ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() };
    let mut runner = TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha));
    let (done, changed) = (Cell::new(0), Cell::new(0));
    let program = (prop::collection::vec(statement(), 1..7), 0..10);
    let ran = runner.run(&program, |(statements, dice)| {
        let kind = if dice == 0 { "exporter" } else { "edit" };
        let is_changed = check(kind, &statements.join("\n"))?;
        done.set(done.get() + 1);
        changed.set(changed.get() + u32::from(is_changed == Some(true)));
        Ok(())
    });
    ran.unwrap_or_else(|fault| panic!("{fault}"));
    // If hardly any went through, it would prove nothing.
    assert!(changed.get() * 20 > done.get(), "{} of {} changed the scene", changed.get(), done.get());
}

#[test]
fn examples_of_the_functions_are_programs() {
    let (mut count, mut through, mut failed) = (0, 0, Vec::new());
    let examples = SUBJECTS.iter().flat_map(|(_, list)| *list).map(|(_, usage, _)| example(usage));
    for example in examples {
        // A few are of exporters, or need what this scene lacks.
        let ran = check("edit", &format!("{example};")).unwrap_or_else(|fault| panic!("{fault}"));
        count += 1;
        through += u32::from(ran.is_some());
        if ran.is_none() {
            failed.push(example);
        }
    }
    assert!(through * 10 > count * 8, "{through} of {count} went through, not {failed:#?}");
}
