//! An aircraft as one eye sees it at one moment.

use crate::model_mesh::ModelMesh;
use glam::{Quat, Vec3};
use std::sync::Arc;

/// A mesh and where it is. Only the GPU renderer draws it; those of the CPU leave it out.
#[derive(Debug, Clone)]
pub struct ModelInView {
    /// Its shape and colours.
    pub mesh: Arc<ModelMesh>,
    /// Where the mesh's origin lies from the eye, metres, world axes. The difference is to be taken in f64.
    pub from_eye: Vec3,
    /// How the mesh is turned: from its own axes to the world's, unit.
    pub turn: Quat,
    /// Metres in the world for a metre of the mesh, greater than 0.
    pub scale: f32,
}
