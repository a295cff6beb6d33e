//! A scene as glTF 2.0 in one binary file (`.glb`), for 3D programs, engines and web pages; and back.
//!
//! Clouds are nodes where they are at one moment; their sprites are quads that face one camera, with the light of that
//! moment. Either each quad is an instance (`EXT_mesh_gpu_instancing`, with the mean of its corners' colours as `_COLOR_0`),
//! or, plain, a cloud is a mesh of its own with the colours of all corners, from the farthest sprite to the nearest. The
//! sheet of tiles is embedded, the material unlit (`KHR_materials_unlit`). Cameras, camera paths and drifting clouds
//! are nodes with an animation, clouds that form or fade by the clock move their materials' alpha
//! (`KHR_animation_pointer`), the sun is a light (`KHR_lights_punctual`).
//!
//! Colours are linear light times the scene's exposure, at most 1: the tone curve is the viewer's. glTF knows straight
//! alpha alone, so the sheet's clear texels have the mean colour of their tile, and no rim darkens where it is filtered.
//! Axes and metres are ours.
//!
//! The scene file's text stands in the scene's `extras`, from which it comes back, bit for bit. What an
//! editor of glTF changed is not read.

mod container;
mod motion;
mod sampled;
mod sheet;
mod sprites;

use super::{Arrived, Arriving, Content, ExportError, Files, Leaving, Note, OptionKind, OptionRow};
use crate::formats::{Misread, scene_file};
use crate::scene::{Camera, Scene};
use crate::weather::Light;
use container::Buffer;
use glam::{DQuat, DVec3};
use serde_json::{Value, json};

pub use motion::{TOLERANCE_DEG, TOLERANCE_M, TOLERANCE_OPACITY};

/// The name under which the scene file's text stands in `extras`.
const EXTRAS: &str = "cloudwright_scene";
/// The largest file that is read, bytes.
pub const MAX_BYTES: usize = 1 << 30;
const INSTANCING: &str = "EXT_mesh_gpu_instancing";

const PLAIN: &str = "plain";
pub(super) const WRITE_OPTIONS: &[OptionRow] = &[OptionRow {
    name: PLAIN,
    kind: OptionKind::Flag(false),
    doc: "Whether each cloud is a mesh with the colours of all corners, for readers without instances:",
}];

/// The nodes of the file while they are made.
#[derive(Debug, Default)]
struct Nodes {
    all: Vec<Value>,
    /// Those that have no parent.
    top: Vec<usize>,
}

impl Nodes {
    fn add(&mut self, node: Value) -> usize {
        self.all.push(node);
        self.all.len() - 1
    }

    fn add_top(&mut self, node: Value) -> usize {
        let index = self.add(node);
        self.top.push(index);
        index
    }
}

pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let Leaving { scene, now, .. } = *leaving;
    let plain = leaving.options.flag(PLAIN);
    let still = leaving.still().ok_or(ExportError::Nothing("cameras"))?;
    let mut buffer = Buffer::default();
    let mut nodes = Nodes::default();
    let mut root = json!({ "asset": { "version": "2.0", "generator": "Cloudwright" }, "scene": 0 });
    sheet::write(&mut root, &mut buffer, leaving.atlas);
    let times = motion::times_of_clock(leaving);
    let clouds = sprites::write(&mut root, &mut buffer, &mut nodes, leaving, (still, plain, &times));
    let clouds = clouds.ok_or(ExportError::Cancelled)?;
    let cameras = cameras(&mut root, &mut nodes, scene);
    sun(&mut root, &mut nodes, &now.light, now.exposure);
    let moves = motion::write(&mut root, &mut buffer, &mut nodes, leaving, (&cameras, &clouds, &times));
    let mut used = vec!["KHR_materials_unlit"];
    if root["extensions"].is_object() {
        used.push("KHR_lights_punctual");
    }
    if clouds.instanced {
        used.push(INSTANCING);
        root["extensionsRequired"] = json!([INSTANCING]);
    }
    if moves.forms > 0 {
        used.push("KHR_animation_pointer");
    }
    root["extensionsUsed"] = json!(used);
    root["nodes"] = Value::Array(nodes.all);
    let text = scene_file::write(scene).map_err(std::io::Error::from)?;
    root["scenes"] = json!([{ "name": scene.name, "nodes": nodes.top, "extras": { EXTRAS: text } }]);
    let bytes = buffer.into_glb(root);
    files.add(leaving.name, &mut |out| out.write_all(&bytes))?;
    Ok(notes(plain, &clouds, &moves))
}

/// Whether bytes begin as binary glTF does.
pub(super) fn looks_like(bytes: &[u8]) -> bool {
    bytes.starts_with(b"glTF")
}

pub(super) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    #[derive(serde::Deserialize)]
    struct Root {
        #[serde(default)]
        scenes: Vec<Extras>,
    }
    #[derive(serde::Deserialize)]
    struct Extras {
        #[serde(default)]
        extras: Option<Value>,
    }
    let bytes = arriving.bytes;
    let head = bytes.first_chunk::<20>().ok_or_else(|| Misread::new("its head", "it is cut off"))?;
    let number = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
    if !looks_like(head) || number(4) != 2 || &head[16..20] != b"JSON" {
        return Err(Misread::new("its head", "it is no binary glTF of version 2"));
    }
    let text = bytes[20..].get(..number(12) as usize).ok_or_else(|| Misread::new("its text", "it is cut off"))?;
    let root: Root = serde_json::from_slice(text).map_err(|error| Misread::new("its text", error.to_string()))?;
    let held = root.scenes.iter().find_map(|scene| scene.extras.as_ref()?.get(EXTRAS)?.as_str());
    let held = held.ok_or_else(|| {
        Misread::new("its extras", "there is no scene; only what was exported from here gives its scene back")
    })?;
    let scene = scene_file::read(held.as_bytes()).map_err(|problems| match problems.first() {
        Some(problem) => Misread::new(format!("the scene in it, {}", problem.place), &problem.message),
        None => Misread::new("the scene in it", "it is broken"),
    })?;
    let notes = scene.atlas.iter().map(|name| Note::left_out(format!("the sheet “{name}”"), "put it beside the scene"));
    Ok(Arrived { notes: notes.collect(), content: Content::Scene(Box::new(scene)) })
}

/// The scene's own cameras; their nodes.
fn cameras(root: &mut Value, nodes: &mut Nodes, scene: &Scene) -> Vec<usize> {
    let node = |camera: &Camera| {
        let mut node = placed(&camera.name, camera.position, turn_of(camera));
        node["camera"] = json!(lens(root, camera.field_of_view_deg));
        nodes.add_top(node)
    };
    scene.cameras.iter().map(node).collect()
}

/// A lens of that vertical field of view; its index.
fn lens(root: &mut Value, field_of_view_deg: f64) -> usize {
    let perspective = json!({ "yfov": field_of_view_deg.to_radians(), "znear": 1.0, "zfar": 400_000.0 });
    push(root, "cameras", json!({ "type": "perspective", "perspective": perspective }))
}

/// Adds `item` to a list of the file; its index there.
fn push(root: &mut Value, list: &str, item: Value) -> usize {
    match root[list].as_array_mut() {
        Some(all) => {
            all.push(item);
            all.len() - 1
        }
        None => {
            root[list] = json!([item]);
            0
        }
    }
}

/// A node with a name, a place and a turn.
fn placed(name: &str, position: DVec3, turn: DQuat) -> Value {
    json!({ "name": name, "translation": position.to_array(), "rotation": turn.to_array() })
}

/// A camera of glTF looks along −z, its top along +y, as ours at heading 0.
fn turn_of(camera: &Camera) -> DQuat {
    let Camera { heading_deg, pitch_deg, roll_deg, position, .. } = *camera;
    crate::flight::PathPoint { position, heading_deg, pitch_deg, roll_deg }.turn()
}

/// A light from the sun: such that a white, matt face that looks at it is as bright as our directional light.
fn sun(root: &mut Value, nodes: &mut Nodes, light: &Light, exposure: f32) {
    let [r, g, b] = light.directional_max.to_array();
    let most = r.max(g).max(b);
    if most <= 0.0 {
        return;
    }
    root["extensions"] = json!({ "KHR_lights_punctual": { "lights": [{
        "type": "directional",
        "name": "sun",
        "color": [r / most, g / most, b / most],
        "intensity": f64::from(most * exposure) * std::f64::consts::PI,
    }] } });
    // It shines along its −z.
    let turn = DQuat::from_rotation_arc(DVec3::NEG_Z, -light.sun_direction.as_dvec3().normalize());
    let mut node = placed("sun", DVec3::ZERO, turn);
    node["extensions"] = json!({ "KHR_lights_punctual": { "light": 0 } });
    nodes.add_top(node);
}

/// What became of what is there in another way.
fn notes(plain: bool, clouds: &sprites::Written, moves: &motion::Moves) -> Vec<Note> {
    let mut notes = vec![
        Note::changed("sprites", "they face one camera, in the light of one moment"),
        Note::left_out("sky, haze and tone curve", "the viewer has its own"),
    ];
    if !plain {
        let how = "each sprite has their mean, and tiles have no common order; plain=yes keeps both";
        notes.push(Note::changed("corners' colours", how));
    }
    if clouds.clipped > 0 {
        notes.push(Note::changed(format!("{} corners", clouds.clipped), "brighter than 1, which is cut"));
    }
    if moves.forms > 0 {
        let what = format!("how {} clouds form", moves.forms);
        notes.push(Note::changed(what, "all sprites of a cloud at once"));
    }
    if moves.turns > 0 {
        let what = format!("how {} clouds turn, grow or stream", moves.turns);
        notes.push(Note::left_out(what, "they drift as they were at the moment"));
    }
    notes
}
