//! The shape of an aircraft: coloured triangles, as a file's reader makes them and the renderers draw them.
//!
//! Three vertices a triangle and none shared, so that flat and smooth faces are the same thing and there is nothing to
//! look up. Lengths are metres; the axes are glTF's, which are the world's: +y up, and the nose points along −z, which
//! is north for a model that is not turned. The origin is where the aircraft is on its path.

use crate::color::Rgb;
use crate::version::Version;
use glam::Vec3;

/// A corner of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub struct ModelVertex {
    /// Metres from the model's origin.
    pub position: Vec3,
    /// Unit, out of the surface; the side that it points to is the one from which the triangle runs counter-clockwise.
    pub normal: Vec3,
    /// The share of the light that the surface gives back, 0 to 1.
    pub color: Rgb,
}

/// Triangles that don't change, with a number by which a renderer knows what it has uploaded.
#[derive(Debug, Clone)]
pub struct ModelMesh {
    vertices: Vec<ModelVertex>,
    version: Version,
}

impl PartialEq for ModelMesh {
    fn eq(&self, other: &Self) -> bool {
        self.version == other.version
    }
}

impl ModelMesh {
    /// From vertices, three a triangle; one or two left over at the end are dropped.
    pub fn new(mut vertices: Vec<ModelVertex>) -> Self {
        vertices.truncate(vertices.len() / 3 * 3);
        Self { vertices, version: Version::fresh() }
    }

    /// Three a triangle.
    pub fn vertices(&self) -> &[ModelVertex] {
        &self.vertices
    }

    /// Tells this mesh from every other.
    pub fn version(&self) -> Version {
        self.version
    }
}
