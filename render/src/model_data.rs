//! The frame's aircraft on the GPU: each mesh uploaded once and kept while it is in view, and each frame where they are.

use crate::buffer::VertexBuffer;
use crate::{Gpu, RenderError};
use cloudwright_core::frame::Frame;
use cloudwright_core::version::Version;

/// One model's place, as models.wgsl reads it.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct ModelInstance {
    from_eye: [f32; 3],
    scale: f32,
    /// A unit quaternion: x, y, z, w.
    turn: [f32; 4],
    /// What the clouds' shadows leave of the directional light on it.
    sunlit: f32,
}

/// All that the models pass reads.
#[derive(Debug)]
pub(crate) struct ModelData {
    /// A [`ModelInstance`] for each model.
    pub(crate) placed: VertexBuffer,
    meshes: Vec<(Version, VertexBuffer)>,
    /// Each model's mesh, an index of the above.
    mesh_of: Vec<usize>,
}

impl ModelData {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self { placed: VertexBuffer::new(gpu, "the list of models in view"), meshes: Vec::new(), mesh_of: Vec::new() }
    }

    /// Brings everything up to date with `frame`.
    ///
    /// # Errors
    /// If the device can't hold a mesh.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>) -> Result<(), RenderError> {
        self.mesh_of.clear();
        self.meshes.retain(|(version, _)| frame.models.iter().any(|model| model.mesh.version() == *version));
        let mut placed = Vec::with_capacity(frame.models.len());
        for model in &frame.models {
            let version = model.mesh.version();
            let known = self.meshes.iter().position(|(known, _)| *known == version);
            if known.is_none() {
                let mut mesh = VertexBuffer::new(gpu, "a model's mesh");
                mesh.write(gpu, model.mesh.vertices())?;
                self.meshes.push((version, mesh));
            }
            self.mesh_of.push(known.unwrap_or(self.meshes.len() - 1));
            placed.push(ModelInstance {
                from_eye: model.from_eye.to_array(),
                scale: model.scale,
                turn: model.turn.to_array(),
                sunlit: model.sunlit,
            });
        }
        self.placed.write(gpu, &placed)
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.mesh_of.is_empty()
    }

    /// The mesh of each model, in the order of [`ModelData::placed`].
    pub(crate) fn meshes_in_order(&self) -> impl Iterator<Item = &VertexBuffer> {
        self.mesh_of.iter().filter_map(|mesh| self.meshes.get(*mesh)).map(|(_, mesh)| mesh)
    }
}
