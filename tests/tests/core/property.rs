//! The table of properties against a scene with everything, the file's schema, and the file's own reader.

use cloudwright_core::document::{Document, Edit, EditError};
use cloudwright_core::formats::scene_file;
use cloudwright_core::property::{Address, Kind, Refusal, Value, addresses, place, tables, value};
use cloudwright_core::scene::{Category, Scene};
use cloudwright_tests::root;
use cloudwright_tests::small_scenes::everything;
use serde_json::Value as Json;
use std::collections::BTreeSet;
use std::fs;

/// Every address of the scene with everything, with its value.
fn all(scene: &Scene) -> Vec<(Address, Value)> {
    addresses(scene).into_iter().map(|each| (each, value(scene, each).expect("it is listed"))).collect()
}

/// Another value that the scene can have: near the old one, for what must stay in order.
fn another(address: Address, value: &Value) -> Value {
    let new = match (&address.property.kind, value) {
        (Kind::Integer(_), Value::Number(old)) => Value::Number(old + 1.0),
        (kind, Value::Number(old)) => {
            let range = kind.number().expect("a number has a range");
            let step = (range.max - range.min) * 1e-5;
            let new = if old + step <= range.max { old + step } else { old - step };
            // What is kept as f32 comes back whole.
            Value::Number(f64::from(new as f32))
        }
        (Kind::Flag, Value::Flag(old)) => Value::Flag(!old),
        (Kind::Seed, Value::Whole(old)) => Value::Whole(old + 1),
        (Kind::Seed, Value::None) => Value::Whole(7),
        (Kind::Text, Value::Text(_)) if address.property.path == "date" => Value::Text("2011-11-11".into()),
        (Kind::Text, Value::Text(_)) if address.property.path == "property" => Value::Text("sky/turbidity".into()),
        (Kind::Text, Value::Text(old)) => Value::Text(format!("{old} and {address}")),
        (Kind::Choice(choices), Value::Text(old)) => {
            let other = choices.iter().find(|choice| choice.name != old).expect("two choices");
            Value::Text(other.name.into())
        }
        (Kind::Choice(choices), Value::None) => Value::Text(choices[0].name.into()),
        (Kind::Category, _) => Value::Text(Category::Wisps.name().into()),
        (Kind::Folder | Kind::Group, Value::Whole(_)) => Value::None,
        // Others of these are not in the scene, or in the same model.
        (Kind::Folder | Kind::Group | Kind::Model | Kind::Path, same) => same.clone(),
        (kind, value) => panic!("{address} is {value:?}, and of kind {kind:?}"),
    };
    let is_id = matches!(address.property.kind, Kind::Folder | Kind::Group | Kind::Model | Kind::Path);
    assert!(new != *value || is_id, "{address}");
    new
}

/// Equal, or as near as angles come back from a quaternion.
fn same(address: Address, a: &Value, b: &Value) -> bool {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) if address.property.path.starts_with("orientation") => {
            (a - b).abs() < 1e-9
        }
        _ => a == b,
    }
}

#[test]
fn each_is_found_by_its_address() {
    let scene = everything();
    for (address, _) in all(&scene) {
        assert_eq!(address.to_string().parse::<Address>(), Ok(address));
    }
    let names: BTreeSet<String> = addresses(&scene).iter().map(Address::to_string).collect();
    assert_eq!(names.len(), addresses(&scene).len(), "no two are called the same");
    for known in ["time_of_day_h", "sky/exposure_ev", "sky/ambient/0/value/g", "camera/1/field_of_view_deg"] {
        assert!(names.contains(known), "{known} is not among {names:?}");
    }
}

#[test]
fn each_kind_of_thing_is_in_the_scene_with_everything() {
    let there: Vec<String> = addresses(&everything()).iter().map(|address| pattern(&address.to_string())).collect();
    for table in tables() {
        for property in (table.properties)() {
            let name = format!("{}/{}", table.pattern, property.path.replace('.', "/"));
            let wanted = format!(
                "{}{}",
                name.trim_start_matches('/'),
                if property.parts.names()[0].is_empty() { "" } else { "/" }
            );
            assert!(there.iter().any(|each| each.starts_with(&wanted)), "{wanted} is in no address");
        }
    }
}

/// Numbers of an address or place left out.
fn pattern(name: &str) -> String {
    let of = |segment: &str| if segment.parse::<u64>().is_ok() { "N".into() } else { segment.to_owned() };
    name.split('/').map(of).collect::<Vec<_>>().join("/")
}

#[test]
fn setting_what_is_there_changes_nothing() {
    let scene = everything();
    for (address, value) in all(&scene) {
        let mut document = Document::new(scene.clone());
        let edit = Edit::set(&scene, address, &value).unwrap_or_else(|error| panic!("{error}"));
        document.edit("Set", [edit]).unwrap_or_else(|error| panic!("{address}: {error}"));
        assert_eq!(*document.scene(), scene, "{address}");
        assert!(document.undo().is_none(), "{address} made an undo point");
    }
}

#[test]
fn what_is_set_is_there_and_undo_takes_it_back() {
    let scene = everything();
    for (address, before) in all(&scene) {
        let new = another(address, &before);
        let mut document = Document::new(scene.clone());
        let edit = Edit::set(&scene, address, &new).unwrap_or_else(|error| panic!("{error}"));
        document.edit("Set", [edit]).unwrap_or_else(|error| panic!("{address} to {new:?}: {error}"));
        let got = value(document.scene(), address).expect("still there");
        assert!(same(address, &got, &new), "{address}: {got:?}, wanted {new:?}");
        document.undo();
        assert_eq!(*document.scene(), scene, "{address}");
    }
}

#[test]
fn what_is_out_of_range_or_of_another_kind_is_refused() {
    let scene = everything();
    for (address, _) in all(&scene) {
        let refused = |value: &Value| match Edit::set(&scene, address, value) {
            Err(EditError::Refused { address: at, refusal }) => {
                assert_eq!(at, address);
                refusal
            }
            other => panic!("{address} took {value:?}: {other:?}"),
        };
        if let Some(range) = address.property.kind.number() {
            for wild in [range.max + 1.0, range.min - 1.0, f64::NAN, f64::INFINITY] {
                assert!(matches!(refused(&Value::Number(wild)), Refusal::OutOfRange { .. }), "{address}");
            }
            assert!(matches!(refused(&Value::Text("1".into())), Refusal::WrongKind { .. }));
        } else {
            assert!(matches!(refused(&Value::Number(1.0)), Refusal::WrongKind { .. }));
        }
        if let Kind::Integer(range) = &address.property.kind {
            assert!(matches!(refused(&Value::Number(range.max - 0.5)), Refusal::WrongKind { .. }), "{address}");
        }
        if address.property.none.is_none() {
            assert!(matches!(refused(&Value::None), Refusal::WrongKind { .. }));
        }
    }
}

/// What a thing of the kind may have, and this one has not.
#[test]
fn what_is_not_there_is_not_set() {
    let scene = everything();
    let [whole, forming] = [0, 1].map(|at: usize| scene.clouds[at].id);
    assert!(scene.clouds[0].formation.is_none() && scene.clouds[1].formation.is_some());
    for path in ["core_s", "threshold"] {
        let [gone, there] = [whole, forming].map(|id| format!("cloud/{id}/formation/{path}").parse().expect(path));
        assert!(value(&scene, there).is_some() && value(&scene, gone).is_none(), "{path}");
        let error = Edit::set(&scene, gone, &Value::Number(0.5));
        assert!(matches!(error, Err(EditError::Refused { refusal: Refusal::NotThere, .. })), "{path}: {error:?}");
    }
}

/// A range's ends never cross: each pushes the other along.
#[test]
fn ends_push_each_other_along() {
    let scene = everything();
    let ends = |scene: &Scene| scene.models[0].boxes[0].width;
    let [from, to] = ends(&scene);
    let name = format!("model/{}/box/{}/width", scene.models[0].id, scene.models[0].boxes[0].id);
    for (end, number, want) in [
        ("0", to + 5.0, [to + 5.0; 2]),
        ("1", from - 1.0, [from - 1.0; 2]),
        ("0", from - 1.0, [from - 1.0, to]),
        ("1", to + 5.0, [from, to + 5.0]),
    ] {
        let mut document = Document::new(scene.clone());
        let address = format!("{name}/{end}").parse().expect("a property");
        let edit = Edit::set(&scene, address, &Value::Number(number)).expect("in range");
        document.edit("Set", [edit]).expect("in order");
        assert_eq!(ends(document.scene()), want, "{end} to {number}");
    }
}

/// The door by which a number comes in that no field would take: a file. Its refusal says where it stands.
#[test]
fn a_file_with_a_number_out_of_range_is_refused_at_its_place() {
    let scene = everything();
    let json: Json = serde_json::from_str(&scene_file::write(&scene).expect("finite")).expect("JSON");
    for address in addresses(&scene) {
        let Some(range) = address.property.kind.number() else { continue };
        // The file has a box's turn as a quaternion.
        if address.property.path.starts_with("orientation") {
            continue;
        }
        let place = place(&scene, address).expect("it is listed");
        let mut broken = json.clone();
        let wild = range.max + 1.0;
        let integer = matches!(address.property.kind, Kind::Integer(_));
        *at(&mut broken["scene"], &place) = if integer { Json::from(wild as u64) } else { Json::from(wild) };
        let problems = scene_file::read(broken.to_string().as_bytes()).expect_err("out of range");
        assert!(
            problems.iter().any(|problem| problem.place == place && problem.message.contains("out of range")),
            "{address}: nothing at {place} among {problems:#?}"
        );
    }
}

/// What stands at a place such as `models[0].boxes[1].center.x`.
fn at<'a>(json: &'a mut Json, place: &str) -> &'a mut Json {
    place.split(['.', '[']).fold(json, |json, step| {
        let step = step.trim_end_matches(']');
        let axis = ["x", "y", "z"].iter().position(|axis| *axis == step);
        let channel = ["r", "g", "b", "a"].iter().position(|channel| *channel == step);
        match step.parse::<usize>().ok().or(axis).or(channel) {
            Some(index) => &mut json[index],
            None => &mut json[step],
        }
    })
}

/// Numbers of the file that are no properties, and why.
const LEFT_OUT: &[&str] = &[
    // What things are called by, and the counter behind it.
    "next_id",
    "cameras[].id",
    "models[].id",
    "models[].groups[].id",
    "models[].boxes[].id",
    "models[].boxes[].sprite_edits[].index",
    "folders[].id",
    "clouds[].id",
    "paths[].id",
    "aircraft[].id",
    "props[].id",
    "tracks[].id",
    // What keys say, checks of their own hold against the property that they are of (core/src/problem/tracks.rs).
    "tracks[].keys[].time_s",
    "tracks[].keys[].turns",
    "tracks[].keys[].value",
    "tracks[].keys[].value[]",
    "tracks[].keys[].handles.arrives",
    "tracks[].keys[].handles.arrives[]",
    "tracks[].keys[].handles.leaves",
    "tracks[].keys[].handles.leaves[]",
    // Three angles stand for the four numbers.
    "models[].boxes[].orientation[]",
];

#[test]
fn each_number_of_the_file_is_in_the_table() {
    let scene = everything();
    let count = |place: &str| {
        let mut pattern = String::new();
        for step in place.split(['.', '[']) {
            let step = step.trim_end_matches(']');
            let is_part = step.parse::<usize>().is_ok() || (step.len() == 1 && "xyzrgba".contains(step));
            pattern += if is_part { "[]" } else { "." };
            pattern += if is_part { "" } else { step };
        }
        pattern.trim_start_matches('.').to_owned()
    };
    let in_table: BTreeSet<String> =
        addresses(&scene).into_iter().filter_map(|address| place(&scene, address)).map(|place| count(&place)).collect();
    let text = fs::read_to_string(root().join("assets/scene.schema.json")).expect("the schema");
    let schema: Json = serde_json::from_str(&text).expect("JSON");
    let mut in_file = BTreeSet::new();
    numbers(&schema, &schema["properties"]["scene"], String::new(), &mut in_file);
    assert!(in_file.len() > 60, "the schema is read: {in_file:?}");
    for number in &in_file {
        let left_out = LEFT_OUT.contains(&number.as_str());
        assert!(in_table.contains(number) != left_out, "{number}: a row in core/src/property/, or a reason here");
    }
    for number in LEFT_OUT {
        assert!(in_file.contains(*number), "{number} is no number of the file");
    }
}

/// Where the schema allows numbers.
fn numbers(schema: &Json, node: &Json, place: String, found: &mut BTreeSet<String>) {
    if let Some(name) = node["$ref"].as_str().and_then(|name| name.strip_prefix("#/$defs/")) {
        return numbers(schema, &schema["$defs"][name], place, found);
    }
    let is = |kind: &str| {
        node["type"] == kind || node["type"].as_array().is_some_and(|kinds| kinds.iter().any(|each| each == kind))
    };
    if is("number") || is("integer") {
        found.insert(place.clone());
    }
    if is("array") {
        numbers(schema, &node["items"], format!("{place}[]"), found);
    }
    for (name, each) in node["properties"].as_object().into_iter().flatten() {
        let dot = if place.is_empty() { "" } else { "." };
        numbers(schema, each, format!("{place}{dot}{name}"), found);
    }
    for each in ["oneOf", "anyOf"].iter().filter_map(|key| node[*key].as_array()).flatten() {
        numbers(schema, each, place.clone(), found);
    }
}

#[test]
fn an_address_of_nothing_is_refused_with_a_hint() {
    for (text, hint) in [
        ("cloud/7/headng_deg", "did you mean cloud/7/heading_deg?"),
        ("sky/exposure", "did you mean sky/exposure_ev?"),
        ("model/3/box/9/width/2", "did you mean model/3/box/9/width/"),
        ("cloud/+7/scale", "things are"),
        ("cloud/07/scale", "things are"),
        ("cloud/99999999999999999999/scale", "things are"),
        ("cloud/7", "things are"),
        ("cloud/7/", "things are"),
        ("", "things are"),
        ("////", "things are"),
    ] {
        let error = text.parse::<Address>().expect_err(text);
        assert!(error.hint.contains(hint), "{text}: {error}");
    }
    let gone: Address = "cloud/999/scale".parse().expect("such a thing could be");
    assert_eq!(value(&everything(), gone), None);
    assert!(matches!(
        Edit::set(&everything(), gone, &Value::Number(1.0)),
        Err(EditError::Refused { refusal: Refusal::NotThere, .. })
    ));
}

#[test]
fn refusals_are_plain_sentences() {
    for (address, value, want) in [
        ("sky/exposure_ev", Value::Text("much".into()), "sky/exposure_ev: “much” is not a number"),
        ("sky/exposure_ev", Value::Number(99.0), "sky/exposure_ev: 99 is outside -20 to 20"),
        ("place/date", Value::Text("soon".into()), "place/date: “soon” is not text that is allowed here"),
        ("camera/9/roll_deg", Value::Number(1.0), "camera/9/roll_deg: it is not there"),
    ] {
        let address = address.parse().expect("a property");
        let error = Edit::set(&Scene::default(), address, &value).expect_err(want);
        assert_eq!(error.to_string(), want);
    }
}
