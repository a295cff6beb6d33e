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
//! editor of glTF changed is not read. A file without it is a model of what stands or flies (`reading.rs`).

mod animation;
mod container;
mod material;
mod reading;
mod sprites;

use super::motion::{Course, Motion, does_more, form_at_once, turn_of};
use super::quads;
use super::sun::Sun;
use super::{ExportError, Files, Leaving, Note, OptionKind, OptionRow};
use crate::formats::scene_file;
use crate::scene::{Camera, Scene};
use container::Buffer;
use glam::{DQuat, DVec3};
use serde_json::{Value, json};

pub(super) use reading::{looks_like, read};

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

const FLIES: &str = "flies";
/// What can be set of a file that is read.
pub(super) const READ_OPTIONS: &[OptionRow] = &[OptionRow {
    name: FLIES,
    kind: OptionKind::Flag(false),
    doc: "Whether a model is an aircraft, its nose along −z, and does not stand as terrain or a tower does:",
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
    material::write(&mut root, &mut buffer, leaving.atlas);
    let motion = Motion::new(scene, leaving.derived);
    let clouds = now.clouds.iter().take_while(|_| !leaving.watch.is_cancelled());
    let courses: Vec<Course> = clouds.map(|cloud| motion.course(cloud.placed)).collect();
    let clouds = sprites::write(&mut root, &mut buffer, &mut nodes, leaving, (still, plain), &courses);
    let clouds = clouds.ok_or(ExportError::Cancelled)?;
    let cameras = cameras(&mut root, &mut nodes, scene);
    sun(&mut root, &mut nodes, &Sun::of(now));
    animation::write(&mut root, &mut buffer, &mut nodes, leaving, (&motion, &cameras), (&clouds, &courses));
    let mut used = vec!["KHR_materials_unlit"];
    if root["extensions"].is_object() {
        used.push("KHR_lights_punctual");
    }
    if clouds.instanced {
        used.push(INSTANCING);
        root["extensionsRequired"] = json!([INSTANCING]);
    }
    if courses.iter().any(|course| !course.formed.is_empty()) {
        used.push("KHR_animation_pointer");
    }
    root["extensionsUsed"] = json!(used);
    root["nodes"] = Value::Array(nodes.all);
    let text = scene_file::write(scene).map_err(std::io::Error::from)?;
    root["scenes"] = json!([{ "name": scene.name, "nodes": nodes.top, "extras": { EXTRAS: text } }]);
    let bytes = buffer.into_glb(root);
    files.add(leaving.name, &mut |out| out.write_all(&bytes))?;
    Ok(notes(plain, clouds.clipped, &courses))
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

/// The sun, if it is up.
fn sun(root: &mut Value, nodes: &mut Nodes, sun: &Sun) {
    if sun.light <= 0.0 {
        return;
    }
    root["extensions"] = json!({ "KHR_lights_punctual": { "lights": [{
        "type": "directional",
        "name": "sun",
        "color": sun.color,
        "intensity": sun.light,
    }] } });
    let mut node = placed("sun", DVec3::ZERO, sun.turn);
    node["extensions"] = json!({ "KHR_lights_punctual": { "light": 0 } });
    nodes.add_top(node);
}

/// What became of what is there in another way.
fn notes(plain: bool, clipped: usize, courses: &[Course]) -> Vec<Note> {
    let mut notes = vec![
        Note::changed("sprites", "they face one camera, in the light of one moment"),
        Note::left_out("sky, haze and tone curve", "the viewer has its own"),
    ];
    if !plain {
        let how = "each sprite has their mean, and tiles have no common order; plain=yes keeps both";
        notes.push(Note::changed("corners' colours", how));
    }
    notes.extend(quads::note_of_cut(clipped));
    notes.extend(form_at_once(courses));
    notes.extend(does_more(courses));
    notes
}
