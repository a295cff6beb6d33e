//! An aircraft as one eye sees it at one moment.

use crate::flight::PathCurve;
use crate::model_mesh::ModelMesh;
use crate::scene::Scene;
use glam::{DVec3, Quat, Vec3};
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

/// The aircraft of `scene` that fly with the built-in mesh, `clock_s` into their paths, as seen from `eye`. Those that
/// name a file of their own are left out: nobody reads it yet.
pub fn aircraft_in_view(scene: &Scene, clock_s: f64, eye: DVec3) -> Vec<ModelInView> {
    let flying = scene.aircraft.iter().filter(|aircraft| aircraft.model.is_none());
    let in_view = flying.filter_map(|aircraft| {
        let place = PathCurve::new(scene.path(aircraft.path)?).attitude_at(clock_s + aircraft.ahead_s);
        Some(ModelInView {
            mesh: ModelMesh::built_in(),
            from_eye: (place.position - eye).as_vec3(),
            turn: place.turn().as_quat(),
            scale: aircraft.scale as f32,
        })
    });
    in_view.collect()
}
