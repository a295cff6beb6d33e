//! Aircraft and props as one eye sees them at one moment.

use crate::flight::{PathCurve, PathPoint};
use crate::formats::model_glb;
use crate::model_mesh::ModelMesh;
use crate::scene::{Aircraft, CameraPath, List, PathId, Prop};
use crate::weather::SceneNow;
use glam::{DVec3, Quat, Vec3};
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;
use std::sync::{Arc, LazyLock};

/// A mesh and where it is.
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
    /// What the clouds' shadows leave of the directional light on it, 0 to 1.
    pub sunlit: f32,
}

static BUILT_IN: LazyLock<Arc<ModelMesh>> = LazyLock::new(|| {
    // The file is checked in and read by a test of its own; an unreadable one would show as no aircraft.
    let read = model_glb::read(include_bytes!("../../assets/models/aircraft.glb"));
    Arc::new(read.unwrap_or_else(|_| ModelMesh::new(Vec::new())))
});

/// The shapes of aircraft and props that have a file of their own, by its name.
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

/// What flies on `paths` in a scene `now`, and what stands in it, as seen from `eye`, `clock_s` into the paths; an aircraft
/// without a path is left out, and a prop whose file isn't here. Before and after its path an aircraft stands at the end
/// of it.
pub(crate) fn models_in_view(
    paths: &List<CameraPath>,
    now: &SceneNow<'_>,
    meshes: &Meshes,
    clock_s: f64,
    eye: DVec3,
) -> Vec<ModelInView> {
    let mut models = props(&now.props, meshes, eye);
    if !now.aircraft.is_empty() {
        models.extend(aircraft((paths, &now.aircraft), meshes, clock_s, eye));
    }
    models.iter_mut().for_each(|model| model.sunlit = now.sunlit(eye + model.from_eye.as_dvec3()));
    models
}

fn in_view(mesh: Arc<ModelMesh>, place: PathPoint, scale: f64, eye: DVec3) -> ModelInView {
    let (from_eye, turn) = ((place.position - eye).as_vec3(), place.turn().as_quat());
    ModelInView { mesh, from_eye, turn, scale: scale as f32, sunlit: 1.0 }
}

fn props(props: &List<Prop>, meshes: &Meshes, eye: DVec3) -> Vec<ModelInView> {
    let one = |prop: &Prop| {
        let Prop { position, heading_deg, pitch_deg, roll_deg, scale, .. } = *prop;
        let place = PathPoint { position, heading_deg, pitch_deg, roll_deg };
        Some(in_view(Arc::clone(meshes.0.get(&prop.model)?), place, scale, eye))
    };
    props.iter().filter_map(one).collect()
}

fn aircraft(
    (paths, aircraft): (&List<CameraPath>, &List<Aircraft>),
    meshes: &Meshes,
    clock_s: f64,
    eye: DVec3,
) -> Vec<ModelInView> {
    let flown: FxHashSet<PathId> = aircraft.iter().map(|aircraft| aircraft.path).collect();
    let flown = paths.iter().filter(|path| flown.contains(&path.id));
    let curves: FxHashMap<PathId, PathCurve> = flown.map(|path| (path.id, PathCurve::new(path))).collect();
    let flying = aircraft.iter().filter_map(|aircraft| {
        let place = curves.get(&aircraft.path)?.attitude_at(clock_s + aircraft.ahead_s);
        Some(in_view(meshes.of(aircraft), place, aircraft.scale, eye))
    });
    flying.collect()
}
