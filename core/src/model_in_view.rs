//! Aircraft as one eye sees them at one moment.

use crate::flight::PathCurve;
use crate::formats::model_glb;
use crate::model_mesh::ModelMesh;
use crate::scene::{Aircraft, CameraPath, List, PathId};
use glam::{DVec3, Quat, Vec3};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

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

static BUILT_IN: LazyLock<Arc<ModelMesh>> = LazyLock::new(|| {
    // The file is checked in and read by a test of its own; an unreadable one would show as no aircraft.
    let read = model_glb::read(include_bytes!("../../assets/models/aircraft.glb"));
    Arc::new(read.unwrap_or_else(|_| ModelMesh::new(Vec::new())))
});

/// The shapes of aircraft that have a file of their own, by its name.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Meshes(BTreeMap<String, Arc<ModelMesh>>);

impl Meshes {
    /// The light aircraft that ships with Cloudwright (assets/models/aircraft.glb).
    pub fn built_in() -> Arc<ModelMesh> {
        Arc::clone(&BUILT_IN)
    }

    /// The shape of the file of that name.
    pub fn insert(&mut self, name: String, mesh: ModelMesh) {
        self.0.insert(name, Arc::new(mesh));
    }

    /// That of `aircraft`; the built-in one stands in for a file that isn't here.
    fn of(&self, aircraft: &Aircraft) -> Arc<ModelMesh> {
        let own = aircraft.model.as_ref().and_then(|name| self.0.get(name));
        own.map_or_else(Self::built_in, Arc::clone)
    }
}

/// The `aircraft` that fly on `paths` as seen from `eye`, `clock_s` into their paths; one that has no path is left out. Before and
/// after its path an aircraft stands at the end of it.
pub fn aircraft_in_view(
    (paths, aircraft): (&List<CameraPath>, &List<Aircraft>),
    meshes: &Meshes,
    clock_s: f64,
    eye: DVec3,
) -> Vec<ModelInView> {
    if aircraft.is_empty() {
        return Vec::new();
    }
    let flown: FxHashSet<PathId> = aircraft.iter().map(|aircraft| aircraft.path).collect();
    let flown = paths.iter().filter(|path| flown.contains(&path.id));
    let curves: FxHashMap<PathId, PathCurve> = flown.map(|path| (path.id, PathCurve::new(path))).collect();
    let in_view = aircraft.iter().filter_map(|aircraft| {
        let place = curves.get(&aircraft.path)?.attitude_at(clock_s + aircraft.ahead_s);
        Some(ModelInView {
            mesh: meshes.of(aircraft),
            from_eye: (place.position - eye).as_vec3(),
            turn: place.turn().as_quat(),
            scale: aircraft.scale as f32,
        })
    });
    in_view.collect()
}
