//! The scene file, `NAME.cloudscene`: JSON with a head that names format and version.
//!
//! Reading goes by version, one module each; writing is always the newest. The same scene gives the same bytes, and a
//! file written here comes back byte for byte. Until the first release, version 1 may gain fields that have defaults.

mod v1;

use crate::problem::{self, Problem, Severity};
use crate::scene::Scene;
use serde::Deserialize;

/// What the head says.
pub const FORMAT: &str = "cloudwright-scene";
/// Ending of a scene file's name, without the dot.
pub const EXTENSION: &str = "cloudscene";
/// Larger files are refused before they are read, bytes.
pub const MAX_BYTES: usize = 256 << 20;

/// Only the head; whatever else stands there is the version's own business.
#[derive(Deserialize)]
struct Head {
    format: String,
    version: u64,
}

/// Reads a scene.
///
/// # Errors
/// All that is wrong with it: with line and column if it is no JSON, with the path in the document otherwise.
pub fn read(bytes: &[u8]) -> Result<Scene, Vec<Problem>> {
    let text = as_text(bytes).map_err(|problem| vec![problem])?;
    let head: Head = serde_json::from_str(text).map_err(|error| vec![head_problem(text, &error)])?;
    if head.format != FORMAT {
        let message = format!("the format is “{}”", head.format);
        return Err(vec![Problem::error("format", message, format!("a scene says \"format\": \"{FORMAT}\""))]);
    }
    let scene = match head.version {
        1 => v1::read(text).map_err(|problem| vec![problem])?,
        version => {
            let message = format!("version {version} of the format is not known here");
            return Err(vec![Problem::error(
                "version",
                message,
                "this Cloudwright reads version 1; a newer one may read yours",
            )]);
        }
    };
    let errors: Vec<Problem> = problem::check(&scene).into_iter().filter(|p| p.severity == Severity::Error).collect();
    if errors.is_empty() { Ok(scene) } else { Err(problem::shortened(errors)) }
}

/// Writes a scene.
///
/// # Errors
/// If a number is NaN or infinite, which JSON cannot say; no scene that passes the checks has one.
pub fn write(scene: &Scene) -> Result<String, serde_json::Error> {
    v1::write(scene)
}

/// The JSON Schema of the newest version, as text.
///
/// # Errors
/// None in practice: the schema comes from the types.
pub fn json_schema() -> Result<String, serde_json::Error> {
    v1::json_schema()
}

fn as_text(bytes: &[u8]) -> Result<&str, Problem> {
    let hint = "a scene is a JSON text that Cloudwright saved, NAME.cloudscene";
    if bytes.is_empty() {
        return Err(Problem::error("line 1", "the file is empty", hint));
    }
    if bytes.starts_with(b"\xEF\xBB\xBF") {
        return Err(Problem::error(
            "line 1",
            "the text begins with a byte order mark",
            "save it as UTF-8 without the mark",
        ));
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let line = bytes[..error.valid_up_to()].iter().filter(|b| **b == b'\n').count() + 1;
        Problem::error(format!("line {line}"), "this is not text", hint)
    })
}

fn head_problem(text: &str, error: &serde_json::Error) -> Problem {
    if error.is_data() {
        return Problem::error(
            format!("line {}", error.line()),
            format!("the head does not name format and version: {}", without_place(error)),
            format!("a scene begins {{ \"format\": \"{FORMAT}\", \"version\": 1, …"),
        );
    }
    syntax_problem(text, error)
}

/// For a text that is not JSON, or is cut off.
fn syntax_problem(text: &str, error: &serde_json::Error) -> Problem {
    let place = format!("line {}, column {}", error.line(), error.column());
    let hint = if error.is_eof() {
        format!("the file is cut off after {} lines; take an older copy", text.lines().count())
    } else {
        "mend the JSON there, or take an older copy".into()
    };
    Problem::error(place, without_place(error), hint)
}

/// serde_json's words without its own " at line 1 column 2".
pub(super) fn without_place(error: &serde_json::Error) -> String {
    let text = error.to_string();
    text.rsplit_once(" at line ").map_or(text.clone(), |(message, _)| message.into())
}
