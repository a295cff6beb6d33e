//! What the program says as JSON is what its schemas say: each answer holds to its own, closed against what that doesn't
//! name; and a schema refuses another's answer.

use crate::Place;
use serde_json::{Value, json};
use std::path::Path;

/// The checked-in schema of that name.
fn schema(name: &str) -> Value {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../assets/schemas");
    let text = std::fs::read(folder.join(format!("{name}.schema.json"))).expect("it is checked in");
    serde_json::from_slice(&text).expect("JSON")
}

/// `schema`, with nothing allowed that it doesn't name. What several alternatives of one object name stays open in each.
fn closed(mut schema: Value) -> Value {
    fn close(schema: &mut Value) {
        match schema {
            Value::Object(object) => {
                let is_object = object.contains_key("properties");
                for (key, part) in object.iter_mut() {
                    if !(is_object && ["anyOf", "oneOf", "allOf"].contains(&key.as_str())) {
                        close(part);
                    }
                }
                if is_object {
                    object.insert("unevaluatedProperties".into(), json!(false));
                }
            }
            Value::Array(parts) => parts.iter_mut().for_each(close),
            _ => {}
        }
    }
    close(&mut schema);
    schema
}

fn faults(name: &str, answer: &Value) -> Vec<String> {
    let validator = jsonschema::draft202012::new(&closed(schema(name))).expect("a sound schema");
    validator.iter_errors(answer).map(|error| format!("{}: {error}", error.instance_path())).collect()
}

fn holds(name: &str, text: &[u8]) -> Value {
    let answer: Value = serde_json::from_slice(text).expect("JSON");
    assert_eq!(faults(name, &answer), [""; 0], "{name}: {answer:#}");
    answer
}

#[test]
fn answers_hold_to_their_schemas() {
    let place = Place::new();
    place.put("bad.cloudscene", b"{}");
    place.put("moving.cloudscene", &moving());
    let metar = "EDDF 171320Z 24012G22KT 9999 -SHRA SCT035CB BKN120 18/09 Q1015";
    for (name, words) in [
        ("info", &["info", "--json", "good.cloudscene"][..]),
        ("info", &["info", "--json", "moving.cloudscene"]),
        ("check", &["check", "--json", "good.cloudscene", "bad.cloudscene"]),
        ("formats", &["formats", "--json"]),
        ("exchange", &["export", "--json", "good.cloudscene", "-o", "out.cld"]),
        ("exchange", &["import", "--json", "out.cld", "-o", "in.cloudscene"]),
        ("weather", &["weather", "--json", "--metar", metar]),
        ("weather", &["weather", "--json", "--metar", "EDDF 171320Z CAVOKK"]),
        ("chart", &["chart", "--json", "good.cloudscene", "-o", "chart", "--size", "32x18", "--methods", "truth,fast"]),
    ] {
        let ran = place.run_words(words);
        holds(name, ran.stdout.as_bytes());
    }
    holds("chart", &place.read("chart/chart.json"));
    for shaded in ["", "--shaded"] {
        place.run(&format!("export good.cloudscene -o sprites.json {shaded}"));
        let written = holds("sprites", &place.read("sprites.json"));
        assert_eq!(written["format"], "cloudwright-sprites");
    }
}

/// A scene with a path and a track.
fn moving() -> Vec<u8> {
    crate::scenes::changed(|scene| {
        scene["next_id"] = json!(910);
        scene["paths"] = json!([{ "id": 901, "name": "west", "field_of_view_deg": 55.0, "keys": [
            { "time_s": 0.0, "position": [-1000.0, 1000.0, 500.0], "heading_deg": 0.0, "pitch_deg": 0.0 },
            { "time_s": 4.0, "position": [-950.0, 960.0, 100.0], "heading_deg": 4.0, "pitch_deg": -2.0 },
        ] }]);
        scene["tracks"] = json!([{ "id": 902, "property": "weather/humidity", "keys": [
            { "time_s": 0.0, "value": 1.0 }, { "time_s": 9.0, "value": 0.5 },
        ] }]);
    })
}

#[test]
fn schemas_refuse_what_is_no_such_answer() {
    let place = Place::new();
    let mut info: Value = serde_json::from_str(&place.run("info --json good.cloudscene").stdout).expect("JSON");
    assert!(!faults("exchange", &info).is_empty() && !faults("sprites", &info).is_empty());
    info["total"]["sprites"] = json!("many");
    assert!(faults("info", &info)[0].contains("/total/sprites"), "{:?}", faults("info", &info));
    info["total"] = json!({});
    assert!(!faults("info", &info).is_empty(), "what is left out");
    assert_eq!(place.run("export good.cloudscene -o sprites.json").code, 0);
    let mut sprites: Value = serde_json::from_slice(&place.read("sprites.json")).expect("JSON");
    sprites["clouds"][0]["colour"] = json!(1);
    assert!(!faults("sprites", &sprites).is_empty(), "what no one named");
}
