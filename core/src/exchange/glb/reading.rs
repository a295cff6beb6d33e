//! A binary glTF file that comes in: the scene that it was made from, or else the shape of a prop or an aircraft.

use super::{EXTRAS, FLIES};
use crate::exchange::{Arrived, ArrivedModel, Arriving, Content, Note};
use crate::formats::{Misread, model_glb, scene_file};
use serde::Deserialize;
use serde::de::IgnoredAny;
use serde_json::Value;

/// What of a file is looked at.
#[derive(Deserialize)]
struct Root {
    #[serde(default)]
    scenes: Vec<Extras>,
    #[serde(default)]
    textures: Vec<IgnoredAny>,
    #[serde(default)]
    skins: Vec<IgnoredAny>,
    #[serde(default)]
    animations: Vec<IgnoredAny>,
    #[serde(default)]
    cameras: Vec<IgnoredAny>,
}

#[derive(Deserialize)]
struct Extras {
    #[serde(default)]
    extras: Option<Value>,
}

/// Whether bytes begin as binary glTF does.
pub(in crate::exchange) fn looks_like(bytes: &[u8]) -> bool {
    bytes.starts_with(b"glTF")
}

pub(in crate::exchange) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let bytes = arriving.bytes;
    let head = bytes.first_chunk::<20>().ok_or_else(|| Misread::new("its head", "it is cut off"))?;
    let number = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
    if !looks_like(head) || number(4) != 2 || &head[16..20] != b"JSON" {
        return Err(Misread::new("its head", "it is no binary glTF of version 2"));
    }
    let text = bytes[20..].get(..number(12) as usize).ok_or_else(|| Misread::new("its text", "it is cut off"))?;
    let root: Root = serde_json::from_slice(text).map_err(|error| Misread::new("its text", error.to_string()))?;
    let held = root.scenes.iter().find_map(|scene| scene.extras.as_ref()?.get(EXTRAS)?.as_str());
    match held {
        Some(text) => scene(text),
        None => model(&root, arriving),
    }
}

/// The scene that the file was made from.
fn scene(text: &str) -> Result<Arrived, Misread> {
    let scene = scene_file::read(text.as_bytes()).map_err(|problems| match problems.first() {
        Some(problem) => Misread::new(format!("the scene in it, {}", problem.place), &problem.message),
        None => Misread::new("the scene in it", "it is broken"),
    })?;
    let notes = scene.atlas.iter().map(|name| Note::left_out(format!("the sheet “{name}”"), "put it beside the scene"));
    Ok(Arrived { notes: notes.collect(), content: Content::Scene(Box::new(scene)) })
}

/// A model from elsewhere.
fn model(root: &Root, arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let mesh = model_glb::read(arriving.bytes).map_err(|error| Misread::new("its model", error.to_string()))?;
    let lists = [
        ("textures", &root.textures),
        ("skins", &root.skins),
        ("animations", &root.animations),
        ("cameras", &root.cameras),
    ];
    let left: Vec<&str> = lists.into_iter().filter(|(_, list)| !list.is_empty()).map(|(name, _)| name).collect();
    let note = Note::left_out(left.join(", "), "a model is its triangles, with the colours of faces and vertices");
    Ok(Arrived {
        notes: if left.is_empty() { Vec::new() } else { vec![note] },
        content: Content::Model(ArrivedModel::of(&mesh, arriving.name, arriving.options.flag(FLIES))),
    })
}
