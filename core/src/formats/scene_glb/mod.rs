//! A scene as glTF 2.0 in one binary file (`.glb`), for 3D programs, engines and web pages; and back.
//!
//! Clouds are nodes where they are at one moment; their sprites are quads that face one camera, with the light of that
//! moment. Either each quad is an instance (`EXT_mesh_gpu_instancing`, with the mean of its corners' colours as `_COLOR_0`),
//! or, plain, a cloud is a mesh of its own with the colours of all corners, from the farthest sprite to the nearest. The
//! sheet of tiles is embedded, the material unlit (`KHR_materials_unlit`). Cameras, camera paths and drifting clouds
//! are nodes with an animation, the formation of clouds moves their materials' alpha (`KHR_animation_pointer`), the sun is a
//! light (`KHR_lights_punctual`).
//!
//! Colours are linear light times the scene's exposure, at most 1: the tone curve is the viewer's. glTF knows straight
//! alpha alone, so the sheet's clear texels have the mean colour of their tile, and no rim darkens where it is filtered.
//! Axes and metres are ours.
//!
//! The scene file's text stands in the scene's `extras`, from which [`read`] gives the scene back, bit for bit. What an
//! editor of glTF changed is not read.

mod container;
mod motion;
mod sampled;
mod sheet;
mod sprites;

use super::scene_file;
use crate::derived::Derived;
use crate::problem::Problem;
use crate::scene::{Camera, Scene};
use crate::sprites::Atlas;
use crate::watch::Watch;
use crate::weather::{Light, Moment, SceneNow, WeatherRules};
use container::Buffer;
use glam::{DQuat, DVec3};
use serde_json::{Value, json};

pub use motion::{TOLERANCE_DEG, TOLERANCE_M, TOLERANCE_OPACITY};

/// The name under which the scene file's text stands in `extras`.
const EXTRAS: &str = "cloudwright_scene";
/// The largest file that is read, bytes.
pub const MAX_BYTES: usize = 1 << 30;

/// What is to be made of a scene.
#[derive(Debug, Clone, Copy)]
pub struct Options<'a> {
    /// Where clouds are, and in which light.
    pub moment: Moment,
    /// Whom the sprites face; the scene's first camera, or one at the origin, if none.
    pub camera: Option<&'a Camera>,
    /// Whether meshes stand in for instances.
    pub plain: bool,
}

/// A file, and what of the scene it could not carry.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exported {
    /// The file's bytes.
    pub bytes: Vec<u8>,
    /// In words, a line each.
    pub lost: Vec<String>,
}

/// Why a file gives no scene.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// More than [`MAX_BYTES`].
    #[error("it is larger than {} MiB", MAX_BYTES >> 20)]
    TooLarge,
    /// Another kind of file, or broken.
    #[error("it is no binary glTF: {0}")]
    NotGlb(String),
    /// Made by another program.
    #[error("it holds no scene of Cloudwright's; only files that were exported from here give their scenes back")]
    NoScene,
    /// The scene in it is not one.
    #[error("the scene in it is broken: {}", .0.first().map_or(String::new(), ToString::to_string))]
    Broken(Vec<Problem>),
}

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

/// `scene`, whose sprites are in `derived` and whose tiles on `atlas`, as a file. None if `watch` is cancelled.
pub fn write(
    scene: &Scene,
    derived: &Derived,
    atlas: &Atlas,
    options: &Options<'_>,
    watch: &Watch,
) -> Option<Exported> {
    let now = SceneNow::new(scene, (derived.clouds(), derived.timeline()), options.moment, WeatherRules::default());
    let mut buffer = Buffer::default();
    let mut nodes = Nodes::default();
    let mut root = json!({
        "asset": { "version": "2.0", "generator": "Cloudwright" },
        "scene": 0,
    });
    let mut used = vec!["KHR_materials_unlit", "KHR_lights_punctual"];
    sheet::write(&mut root, &mut buffer, atlas);
    let clouds = sprites::write(&mut root, &mut buffer, &mut nodes, (scene, &now), options, watch)?;
    let cameras = cameras(&mut root, &mut nodes, scene);
    sun(&mut root, &mut nodes, &now.light, now.exposure);
    let moves = motion::write(&mut root, &mut buffer, &mut nodes, (scene, derived), (&cameras, &clouds));
    if !options.plain && !clouds.nodes.is_empty() {
        used.push("EXT_mesh_gpu_instancing");
        root["extensionsRequired"] = json!(["EXT_mesh_gpu_instancing"]);
    }
    if moves.forms {
        used.push("KHR_animation_pointer");
    }
    root["extensionsUsed"] = json!(used);
    root["nodes"] = Value::Array(nodes.all);
    let text = scene_file::write(scene).ok()?;
    root["scenes"] = json!([{ "name": scene.name, "nodes": nodes.top, "extras": { EXTRAS: text } }]);
    let lost = lost(scene, options, &clouds, &moves);
    Some(Exported { bytes: buffer.into_glb(root), lost })
}

/// The scene that was written into such a file.
///
/// # Errors
/// If the file is too large, no binary glTF, of another program, or broken.
pub fn read(bytes: &[u8]) -> Result<Scene, ReadError> {
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
    if bytes.len() > MAX_BYTES {
        return Err(ReadError::TooLarge);
    }
    let broken = |what: &str| ReadError::NotGlb(what.into());
    let head = bytes.first_chunk::<20>().ok_or_else(|| broken("its head is cut off"))?;
    let number = |at: usize| u32::from_le_bytes([head[at], head[at + 1], head[at + 2], head[at + 3]]);
    if !head.starts_with(b"glTF") || number(4) != 2 || &head[16..20] != b"JSON" {
        return Err(broken("it does not begin as one of version 2"));
    }
    let text = bytes[20..].get(..number(12) as usize).ok_or_else(|| broken("its text is cut off"))?;
    let root: Root = serde_json::from_slice(text).map_err(|error| broken(&error.to_string()))?;
    let held = root.scenes.iter().find_map(|scene| scene.extras.as_ref()?.get(EXTRAS)?.as_str());
    scene_file::read(held.ok_or(ReadError::NoScene)?.as_bytes()).map_err(ReadError::Broken)
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

/// What the file does not carry, of what the scene has.
fn lost(scene: &Scene, options: &Options<'_>, clouds: &sprites::Written, moves: &motion::Moves) -> Vec<String> {
    let mut lost = vec![
        "sky, haze and exposure's tone curve: the viewer has its own".to_owned(),
        "sprites face one camera, and keep that moment's light".to_owned(),
    ];
    if !options.plain {
        lost.push("corners have their sprite's mean colour, and tiles no common order (--plain has both)".into());
    }
    if clouds.clipped > 0 {
        lost.push(format!("{} corners are brighter than 1 and were clipped", clouds.clipped));
    }
    if scene.ground.is_some() {
        lost.push("the ground".into());
    }
    if !scene.aircraft.is_empty() {
        lost.push("aircraft: their models are files of their own".into());
    }
    if moves.turns > 0 {
        lost.push(format!("how {} clouds turn, grow or stream: they drift as they were at the moment", moves.turns));
    }
    lost
}
