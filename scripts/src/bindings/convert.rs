//! The engine's values to numbers, vectors, properties' values and JSON, and back.

use crate::error::{Said, did_you_mean};
use crate::limits::LIST_ITEMS;
use cloudwright_core::property::{Kind, Property, Value};
use rhai::{Array, Dynamic, Map};
use serde::de::DeserializeOwned;
use serde_json::Value as Json;

/// Deeper values are no thing of a scene.
const DEPTH: usize = 16;

/// What `value` is, in words.
pub(super) fn kind(value: &Dynamic) -> String {
    match value.type_name() {
        "()" => "nothing".into(),
        "i64" => format!("the whole number {value}"),
        "f64" => format!("the number {value}"),
        "bool" => value.to_string(),
        "string" | "char" => format!("the text “{}”", value.to_string().chars().take(40).collect::<String>()),
        "array" => "a list".into(),
        "map" => "a map".into(),
        "Fn" => "a function".into(),
        other => other.rsplit("::").next().unwrap_or(other).into(),
    }
}

fn wanted(what: &str, value: &Dynamic, wanted: &str) -> Said {
    Said::script(format!("{what} is {}, where {wanted} is expected", kind(value)), "")
}

/// A finite number.
pub(super) fn number(what: &str, value: &Dynamic) -> Result<f64, Said> {
    let number = value.as_float().or_else(|_| value.as_int().map(|whole| whole as f64));
    match number {
        Ok(number) if number.is_finite() => Ok(number),
        Ok(number) => Err(Said::script(format!("{what} is {number}"), "was something divided by zero?")),
        Err(_) => Err(wanted(what, value, "a number")),
    }
}

pub(super) fn whole(what: &str, value: &Dynamic) -> Result<i64, Said> {
    match value.as_int() {
        Ok(whole) => Ok(whole),
        Err(_) => {
            let number = number(what, value).map_err(|_| wanted(what, value, "a whole number"))?;
            let fits = number.fract() == 0.0 && number.abs() < 9e15;
            if fits { Ok(number as i64) } else { Err(wanted(what, value, "a whole number")) }
        }
    }
}

/// A whole number from 0.
pub(super) fn count(what: &str, value: &Dynamic) -> Result<u64, Said> {
    whole(what, value)?.try_into().map_err(|_| wanted(what, value, "a whole number from 0"))
}

/// How many items to make.
pub(super) fn items(what: &str, value: &Dynamic) -> Result<usize, Said> {
    let count = count(what, value)?;
    let fits = usize::try_from(count).ok().filter(|count| *count <= LIST_ITEMS);
    fits.ok_or_else(|| Said::limit(format!("{what} is {count}"), format!("a list has {LIST_ITEMS} items at most")))
}

pub(super) fn text(what: &str, value: &Dynamic) -> Result<String, Said> {
    value.clone().into_string().map_err(|_| wanted(what, value, "a text"))
}

pub(super) fn list(what: &str, value: &Dynamic) -> Result<Vec<Dynamic>, Said> {
    value.read_lock::<Array>().map(|list| list.clone()).ok_or_else(|| wanted(what, value, "a list"))
}

pub(super) fn vector(what: &str, value: &Dynamic) -> Result<[f64; 3], Said> {
    let Some(list) = value.read_lock::<Array>() else {
        return Err(wanted(what, value, "a list of three numbers, [x, y, z],"));
    };
    let [x, y, z] = list.as_slice() else {
        let message = format!("{what} is a list of {}, where one of three numbers is expected", list.len());
        return Err(Said::script(message, "[x, y, z], or [r, g, b]"));
    };
    Ok([number(what, x)?, number(what, y)?, number(what, z)?])
}

pub(super) fn of_vector(vector: [f64; 3]) -> Dynamic {
    Dynamic::from_array(vector.map(Dynamic::from_float).to_vec())
}

pub(super) fn of_id(id: u64) -> Result<Dynamic, Said> {
    let id = i64::try_from(id).map_err(|_| Said::script(format!("the id {id} is too large for scripts"), ""))?;
    Ok(Dynamic::from_int(id))
}

/// A list of places.
pub(super) fn places(what: &str, value: &Dynamic) -> Result<Vec<[f64; 3]>, Said> {
    list(what, value)?.iter().map(|place| vector("a place", place)).collect()
}

pub(super) fn of_places(places: impl IntoIterator<Item = [f64; 3]>) -> Array {
    places.into_iter().map(of_vector).collect()
}

/// What the engine hands over as a map, as a map.
pub(super) fn map(what: &str, value: &Dynamic) -> Result<Map, Said> {
    value.read_lock::<Map>().map(|map| map.clone()).ok_or_else(|| {
        Said::script(format!("{what} is {}, where a map is expected", kind(value)), "#{ name: value, … }")
    })
}

/// The fields of a thing as in the file, as a map.
pub(super) fn of_thing<T: serde::Serialize>(thing: &T) -> Result<Dynamic, Said> {
    serde_json::to_value(thing).map(of_json).map_err(|error| Said::script(error.to_string(), ""))
}

/// No deeper than the file's own types are.
fn of_json(json: Json) -> Dynamic {
    match json {
        Json::Null => Dynamic::UNIT,
        Json::Bool(flag) => flag.into(),
        Json::Number(number) => match number.as_i64().filter(|_| !number.is_f64()) {
            Some(whole) => whole.into(),
            None => number.as_f64().unwrap_or_default().into(),
        },
        Json::String(text) => text.into(),
        Json::Array(list) => Dynamic::from_array(list.into_iter().map(of_json).collect()),
        Json::Object(fields) => {
            let fields = fields.into_iter().map(|(name, value)| (name.into(), of_json(value)));
            Dynamic::from_map(fields.collect())
        }
    }
}

/// A property's value, for the script.
pub(super) fn of_value(property: &Property, value: &Value) -> Result<Dynamic, Said> {
    Ok(match value {
        Value::None => Dynamic::UNIT,
        Value::Flag(flag) => Dynamic::from_bool(*flag),
        Value::Number(number) if matches!(property.kind, Kind::Integer(_)) => Dynamic::from_int(*number as i64),
        Value::Number(number) => Dynamic::from_float(*number),
        Value::Whole(whole) => of_id(*whole)?,
        Value::Text(text) => text.into(),
    })
}

/// What a script gives a property.
pub(super) fn value(what: &str, property: &Property, value: &Dynamic) -> Result<Value, Said> {
    if value.is_unit() && property.none.is_some() {
        return Ok(Value::None);
    }
    Ok(match property.kind {
        Kind::Number(_) | Kind::Angle(_) | Kind::Integer(_) | Kind::Color(_) => Value::Number(number(what, value)?),
        Kind::Seed | Kind::Model | Kind::Folder | Kind::Group | Kind::Path => Value::Whole(count(what, value)?),
        Kind::Flag => Value::Flag(value.as_bool().map_err(|_| wanted(what, value, "true or false"))?),
        Kind::Text => Value::Text(text(what, value)?),
        Kind::Choice(choices) => {
            let name = text(what, value)?;
            if !choices.iter().any(|choice| choice.name == name) {
                let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
                let near = did_you_mean(&name, names.iter().copied());
                let space = if near.is_empty() { "" } else { " " };
                let hint = format!("{near}{space}the names are {}", names.join(", "));
                return Err(Said::script(format!("{what} is “{name}”"), hint));
            }
            Value::Text(name)
        }
        Kind::Category => Value::Text(text(what, value)?),
    })
}

fn json(what: &str, value: &Dynamic, depth: usize) -> Result<Json, Said> {
    if depth == DEPTH {
        return Err(Said::script(format!("{what} is nested too deep"), ""));
    }
    if let Some(list) = value.read_lock::<Array>() {
        return list.iter().map(|each| json(what, each, depth + 1)).collect::<Result<_, _>>().map(Json::Array);
    }
    if let Some(map) = value.read_lock::<Map>() {
        let field = |(name, each): (&rhai::Identifier, &Dynamic)| {
            Ok((name.to_string(), json(&format!("{what}.{name}"), each, depth + 1)?))
        };
        return map.iter().map(field).collect::<Result<_, _>>().map(Json::Object);
    }
    Ok(match value.type_name() {
        "()" => Json::Null,
        "bool" => value.as_bool().unwrap_or_default().into(),
        "i64" => value.as_int().unwrap_or_default().into(),
        "f64" => {
            let number = number(what, value)?;
            // What counts is a whole number in the file, whichever way it was computed.
            let whole = number.fract() == 0.0 && number.abs() < 9e15 && number != 0.0;
            if whole { (number as i64).into() } else { number.into() }
        }
        "string" | "char" => value.to_string().into(),
        _ => return Err(wanted(what, value, "a number, a text, a list or a map")),
    })
}

/// `usual` with what `fields` say in its place; names are the file's. `refused` may not be among them.
pub(super) fn filled<T>(what: &str, usual: &T, fields: &Map, refused: &[(&str, &str)]) -> Result<T, Said>
where
    T: serde::Serialize + DeserializeOwned,
{
    let broken = |error: &dyn std::fmt::Display| Said::script(format!("{what}: {error}"), "");
    let Json::Object(mut whole) = serde_json::to_value(usual).map_err(|error| broken(&error))? else {
        return Err(broken(&"it has no fields"));
    };
    for (name, value) in fields {
        if let Some((_, hint)) = refused.iter().find(|(refused, _)| refused == name) {
            return Err(Said::script(format!("{what}: `{name}` can't be given here"), *hint));
        }
        whole.insert(name.to_string(), json(&format!("{what}.{name}"), value, 0)?);
    }
    serde_path_to_error::deserialize(Json::Object(whole)).map_err(|error| {
        let path = error.path().to_string();
        let message = error.into_inner().to_string();
        let place = if path == "." { what.to_owned() } else { format!("{what}.{path}") };
        unknown_name(&place, &message).unwrap_or_else(|| Said::script(format!("{place}: {message}"), ""))
    })
}

/// Of "unknown field `heigth`, expected one of `height`, …": what was meant.
fn unknown_name(place: &str, message: &str) -> Option<Said> {
    let mut names = message.split('`').skip(1).step_by(2);
    let unknown = message.starts_with("unknown ").then(|| names.next())??;
    let names: Vec<&str> = names.collect();
    let near = did_you_mean(unknown, names.iter().copied());
    let hint = if near.is_empty() { format!("there are {}", names.join(", ")) } else { near };
    Some(Said::script(format!("{place}: there is no `{unknown}`"), hint))
}
