//! A part of a scene as text, for the system's clipboard: JSON with a head that names format and version.
//!
//! `{ "format": "cloudwright-clip", "version": 1, "holds": "things", "clouds": [ … ], "models": [ … ] }`: lists as in a scene
//! file, and what they are. A clipboard may hold anything, so what can't be read is told with place and hint, and in few
//! words: the text may be a novel.

use super::{pretty_json, scene_file};
use crate::arrange::clip::{Clip, Holds};
use crate::problem::{self, Problem, Severity};
// The types that the rows name.
use crate::scene::*;
use crate::spelling::closest;
use serde::{Deserialize, Serialize};

/// What the head says.
pub const FORMAT: &str = "cloudwright-clip";
/// The version that is written.
const VERSION: u32 = 1;
/// Of a message that quotes the text, characters.
const LONGEST: usize = 160;

/// Only the head; whatever else stands there is the version's own business.
#[derive(Deserialize)]
struct Head {
    format: String,
    version: u64,
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        #[derive(Serialize, Deserialize)]
        #[serde(deny_unknown_fields)]
        struct File {
            format: String,
            version: u32,
            holds: Holds,
            next_id: IdCounter,
            $(#[serde(default, skip_serializing_if = "List::is_empty")] $list: List<$Value>,)*
        }

        impl From<File> for Clip {
            fn from(file: File) -> Self {
                let scene = Scene { next_id: file.next_id, $($list: file.$list,)* ..Scene::default() };
                Self { holds: file.holds, scene }
            }
        }

        impl From<&Clip> for File {
            fn from(Clip { holds, scene }: &Clip) -> Self {
                let (format, version) = (FORMAT.into(), VERSION);
                Self { format, version, holds: *holds, next_id: scene.next_id, $($list: scene.$list.clone(),)* }
            }
        }
    };
}
kinds!(lists);

/// Writes a clip.
///
/// # Errors
/// If a number is NaN or infinite, which JSON cannot say; no scene that passes the checks has one.
pub fn write(clip: &Clip) -> Result<String, serde_json::Error> {
    Ok(pretty_json::write(&serde_json::to_value(File::from(clip))?))
}

/// Reads a clip out of a text that may be anything.
///
/// # Errors
/// What is wrong with it first, with line and column, or the place in the clip.
pub fn read(text: &str) -> Result<Clip, Problem> {
    if text.len() > scene_file::MAX_BYTES {
        let message = format!("the text is {} MB long", text.len() >> 20);
        return Err(Problem::error("", message, format!("no more than {} MB are pasted", scene_file::MAX_BYTES >> 20)));
    }
    let head: Head = serde_json::from_str(text).map_err(|error| no_clip(text, &error))?;
    match (head.format.as_str(), head.version) {
        (FORMAT, 1) => {}
        (FORMAT, version) => {
            let message = format!("it is of version {version}, which is not known here");
            return Err(Problem::error("version", message, "copy it in this Cloudwright, or paste it in a newer one"));
        }
        (scene_file::FORMAT, _) => {
            let hint = "open it as a file, or take clouds out of it by “Append from scene…” in the File menu";
            return Err(Problem::error("format", "it is a whole scene", hint));
        }
        (other, _) => {
            let message = shortened(&format!("the format is “{other}”"));
            return Err(Problem::error(
                "format",
                message,
                format!("what is copied here says \"format\": \"{FORMAT}\""),
            ));
        }
    }
    let mut json = serde_json::Deserializer::from_str(text);
    let file: File = serde_path_to_error::deserialize(&mut json).map_err(|error| {
        let (path, message) = (error.path().to_string(), scene_file::without_place(error.inner()));
        let place = format!("line {}, {}", error.inner().line(), shortened(&path));
        Problem::error(place, shortened(&message), hint(&message))
    })?;
    let clip = Clip::from(file);
    match problem::check(&clip.scene).into_iter().find(|problem| problem.severity == Severity::Error) {
        Some(Problem { place, message, hint, .. }) => Err(Problem::error(place, shortened(&message), hint)),
        None => Ok(clip),
    }
}

/// For a text that is no JSON, or JSON of something else.
fn no_clip(text: &str, error: &serde_json::Error) -> Problem {
    let place = format!("line {}, column {}", error.line(), error.column());
    let message = shortened(&scene_file::without_place(error));
    if error.is_data() {
        return Problem::error(place, format!("it is not out of Cloudwright: {message}"), "copy clouds or boxes first");
    }
    if !text.contains(FORMAT) {
        return Problem::error(place, "the text is no part of a scene", "copy clouds, boxes, cameras or keys first");
    }
    Problem::error(place, format!("the text is broken: {message}"), "copy it once more")
}

/// What to do about one of serde's messages.
fn hint(message: &str) -> String {
    // serde: unknown field `x`, expected one of `a`, `b` — backquoted names, the unknown one first.
    let mut names = message.split('`').skip(1).step_by(2);
    if message.starts_with("unknown") {
        let unknown = names.next().unwrap_or_default();
        if let Some(name) = closest(unknown, names) {
            return format!("did you mean `{name}`?");
        }
    }
    "copy it once more; assets/scene.schema.json says what may stand in its lists".into()
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::arrange::clip;
    use crate::problem::scene_with_flight;

    fn text() -> String {
        let scene = scene_with_flight();
        let chosen = [Thing::Cloud(scene.clouds[0].id), Thing::Aircraft(scene.aircraft[0].id)];
        write(&clip::things(&scene, &chosen).expect("some")).expect("finite numbers")
    }

    #[test]
    fn comes_back_as_it_was_written() {
        let scene = scene_with_flight();
        let model = &scene.models[0];
        for clip in [
            clip::things(&scene, &[Thing::Cloud(scene.clouds[0].id), Thing::Camera(scene.cameras[0].id)]),
            clip::boxes(&scene, model.id, &[model.boxes[0].id]),
        ] {
            let clip = clip.expect("some");
            let text = write(&clip).expect("finite numbers");
            assert!(text.contains("\"format\": \"cloudwright-clip\"") && text.contains("\"version\": 1"), "{text}");
            assert_eq!(read(&text), Ok(clip));
        }
    }

    #[test]
    fn anything_else_is_told_with_place_and_hint() {
        let text = text();
        let novel = "It was a bright cold day in April. ".repeat(30_000);
        let scene = scene_file::write(&scene_with_flight()).expect("finite numbers");
        let cases: [(&str, &str, &str); 14] = [
            ("", "line 1, column 0", "no part of a scene"),
            (&novel, "line 1, column 1", "no part of a scene"),
            ("\u{0}\u{1}PNG", "line 1", "no part of a scene"),
            ("[1, 2, 3]", "line 1", "not out of Cloudwright"),
            ("{\"format\": 7}", "line 1", "not out of Cloudwright"),
            ("{\"format\": \"gltf\", \"version\": 2}", "format", "gltf"),
            (&text[..text.len() / 2], "line ", "broken"),
            (&text.replace("\"version\": 1", "\"version\": 2"), "version", "version 2"),
            (&text.replace("\"things\"", "\"dogs\""), "line 4, holds", "unknown variant"),
            (&text.replace("\"clouds\"", "\"cluods\""), "line ", "unknown field"),
            (&text.replace("\"sprite_count\": 30", "\"sprite_count\": -30"), "models[0].boxes[0].sprite_count", "-30"),
            (&text.replace("\"scale\": 1", "\"scale\": -1"), "clouds[0].scale", "-1"),
            (&text.replace("\"next_id\": ", "\"next_id\": 99999999999999999"), "next_id", "no ids"),
            (&scene, "format", "whole scene"),
        ];
        for (bad, place, words) in cases {
            let shown = &bad[..bad.len().min(60)];
            let problem = read(bad).expect_err(shown);
            assert!(problem.place.contains(place), "{shown}: {problem}");
            assert!(problem.message.contains(words), "{shown}: {problem}");
            assert!(!problem.hint.is_empty() && problem.to_string().len() < 600, "{shown}: {problem}");
        }
        let did_you_mean = read(&text.replace("\"clouds\"", "\"cluods\"")).expect_err("a slip");
        assert!(did_you_mean.hint.contains("`clouds`"), "{did_you_mean}");
    }
}
