//! A model's file to triangles: glTF 2.0, as one binary file (`.glb`) or as text (`.gltf`) with its data inside.
//!
//! Read are the triangles of the file's scene, with the transforms of its nodes, their normals (flat where there are
//! none) and colours: a material's base colour times the vertices' own. Left out are textures, transparency, skins,
//! animation and all that shines; an artist who wants colours paints faces or vertices.
//!
//! The crate gltf opens the container and names the JSON's fields. Its own checks and readers may panic at what is
//! broken, so every index and length is checked here instead.

mod data;
mod primitive;

use crate::model_mesh::{ModelMesh, ModelVertex};
use data::Data;
use glam::{Mat4, Quat, Vec3};
use gltf::json::{Index, Node, Root};
use primitive::Primitive;

/// The largest file, bytes.
pub const MAX_BYTES: usize = 64 << 20;
/// The most vertices, counted where they are drawn: three a triangle.
pub const MAX_VERTICES: usize = 2_000_000;
/// The farthest a vertex may be from the model's origin, metres.
pub const MAX_REACH_M: f32 = 100_000.0;

/// Why a file is not a model.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ModelError {
    /// More than [`MAX_BYTES`]: its size, bytes.
    #[error("it has {} MiB; a model has at most {}", .0.div_ceil(1 << 20), MAX_BYTES >> 20)]
    TooLarge(usize),
    /// Another kind of file.
    #[error("it is not glTF; export the model as glTF 2.0 binary (.glb)")]
    NotGltf,
    /// What is wrong, and where.
    #[error("it is broken: {0}; export it again")]
    Broken(String),
    /// Data in a file of its own: its name.
    #[error("it needs the file “{0}” beside it; export the model as one file (.glb)")]
    NeedsFile(String),
    /// Data packed in a way that is not read: the glTF extension's name.
    #[error("its geometry is packed by {0}, which is not read; export it without compression")]
    Packed(String),
    /// Nothing to draw.
    #[error("its scene has no triangles")]
    NoTriangles,
    /// More than [`MAX_VERTICES`].
    #[error("it has more than {MAX_VERTICES} vertices, three a triangle; make it simpler")]
    TooManyVertices,
    /// A vertex that is no number, or beyond [`MAX_REACH_M`].
    #[error("a vertex is no number, or more than {} km from the model's origin; is it in metres?", MAX_REACH_M / 1e3)]
    OutOfReach,
}

/// Extensions that pack geometry.
const PACKINGS: [&str; 3] = ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"];

/// The triangles of a glTF file's scene, in metres, the nose along −z.
///
/// # Errors
/// If the file is none, is broken, needs other files, has no triangles or too many, or is of no sensible size.
pub fn read(bytes: &[u8]) -> Result<ModelMesh, ModelError> {
    if bytes.len() > MAX_BYTES {
        return Err(ModelError::TooLarge(bytes.len()));
    }
    let gltf::Gltf { document, blob } = open(bytes)?;
    let root = document.into_json();
    if let Some(packing) = root.extensions_required.iter().find(|name| PACKINGS.contains(&name.as_str())) {
        return Err(ModelError::Packed(packing.clone()));
    }
    let vertices = vertices(&root, &Data::new(&root, blob)?)?;
    if vertices.is_empty() { Err(ModelError::NoTriangles) } else { Ok(ModelMesh::new(vertices)) }
}

/// The container and its JSON, nothing in it checked.
fn open(bytes: &[u8]) -> Result<gltf::Gltf, ModelError> {
    if bytes.starts_with(b"glTF") {
        // The crate subtracts the head's 12 bytes from the length that the head tells, and may overflow.
        let length = bytes.get(8..).and_then(|rest| rest.first_chunk()).map_or(0, |field| u32::from_le_bytes(*field));
        if length < 12 {
            return Err(broken("its head is cut off"));
        }
    } else if !bytes.trim_ascii_start().starts_with(b"{") {
        return Err(ModelError::NotGltf);
    }
    gltf::Gltf::from_slice_without_validation(bytes).map_err(|error| ModelError::Broken(error.to_string()))
}

/// The triangles below the nodes of the file's own scene, or of its first.
fn vertices(root: &Root, data: &Data<'_>) -> Result<Vec<ModelVertex>, ModelError> {
    let mut vertices = Vec::new();
    let Some(scene) = root.scene.map_or(root.scenes.first(), |index| root.get(index)) else { return Ok(vertices) };
    let mut open: Vec<(Index<Node>, Mat4)> = scene.nodes.iter().rev().map(|&node| (node, Mat4::IDENTITY)).collect();
    let mut met = vec![false; root.nodes.len()];
    let mut budget = Budget(MAX_VERTICES);
    while let Some((index, parent)) = open.pop() {
        let (Some(node), Some(met)) = (root.get(index), met.get_mut(index.value())) else {
            return Err(broken(format!("it has no node {index}")));
        };
        // In a tree, each node is met once; a loop would have no end.
        if std::mem::replace(met, true) {
            return Err(broken(format!("node {index} has two parents")));
        }
        let world = parent * transform(node);
        open.extend(node.children.iter().flatten().rev().map(|&child| (child, world)));
        if let Some(mesh) = node.mesh {
            let mesh = root.get(mesh).ok_or_else(|| broken(format!("it has no mesh {mesh}")))?;
            for primitive in &mesh.primitives {
                if let Some(primitive) = Primitive::read(root, data, primitive, &mut budget)? {
                    primitive.place(world, &mut vertices)?;
                }
            }
        }
    }
    Ok(vertices)
}

/// How many more vertices may be read.
struct Budget(usize);

impl Budget {
    fn spend(&mut self, vertices: usize) -> Result<(), ModelError> {
        self.0 = self.0.checked_sub(vertices).ok_or(ModelError::TooManyVertices)?;
        Ok(())
    }
}

fn transform(node: &Node) -> Mat4 {
    if let Some(matrix) = &node.matrix {
        return Mat4::from_cols_array(matrix);
    }
    Mat4::from_scale_rotation_translation(
        node.scale.map_or(Vec3::ONE, Vec3::from_array),
        Quat::from_array(node.rotation.unwrap_or_default().0),
        node.translation.map_or(Vec3::ZERO, Vec3::from_array),
    )
}

fn broken(what: impl Into<String>) -> ModelError {
    ModelError::Broken(what.into())
}
