//! Version 1: `{ "format", "version": 1, "scene": { … } }`, the scene as its types say.

use super::{FORMAT, syntax_problem, without_place};
use crate::formats::pretty_json;
use crate::problem::Problem;
use crate::scene::Scene;
use crate::spelling::closest;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

#[derive(Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct File {
    format: String,
    version: u32,
    scene: Scene,
}

pub(super) fn read(text: &str) -> Result<Scene, Problem> {
    let mut json = serde_json::Deserializer::from_str(text);
    let file: File = serde_path_to_error::deserialize(&mut json).map_err(|error| {
        let path = error.path().to_string();
        data_problem(&path, error.inner())
    })?;
    json.end().map_err(|error| syntax_problem(text, &error))?;
    Ok(file.scene)
}

pub(super) fn write(scene: &Scene) -> Result<String, serde_json::Error> {
    let file = File { format: FORMAT.into(), version: 1, scene: scene.clone() };
    Ok(pretty_json::write(&serde_json::to_value(file)?))
}

pub(super) fn json_schema() -> Result<String, serde_json::Error> {
    Ok(pretty_json::write(&serde_json::to_value(schemars::schema_for!(File))?))
}

fn data_problem(path: &str, error: &serde_json::Error) -> Problem {
    // The head was read from the whole text before, so this is JSON: serde_json's “trailing characters” can only be
    // the sixth member of a list of five.
    let message = match without_place(error) {
        message if message == "trailing characters" => "the list is too long".into(),
        message => message,
    };
    let place = format!("line {}, {}", error.line(), path.strip_prefix("scene.").unwrap_or(path));
    let hint = hint(path, &message);
    Problem::error(place, message, hint)
}

/// What to do about one of serde's messages.
fn hint(path: &str, message: &str) -> String {
    // serde: unknown field `x`, expected one of `a`, `b` — backquoted names, the unknown one first.
    let mut names = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown field") || message.starts_with("unknown variant") {
        let unknown = names.next().unwrap_or_default();
        return match closest(unknown, names) {
            Some(name) => format!("did you mean `{name}`?"),
            None => "take it out, or use one of the names listed".into(),
        };
    }
    if message.starts_with("missing field") {
        return "add it; assets/scene.schema.json lists what a scene holds".into();
    }
    if message == "number out of range" {
        return "no number may be larger than 1.8e308; write one in the parameter's range".into();
    }
    if path.ends_with("color_levels") {
        return "a model has exactly five colour levels".into();
    }
    "assets/scene.schema.json says what may stand here".into()
}
