//! A model that came in: what a scene makes of it.
//!
//! A prop, which stands, or an aircraft, which flies along a camera path; a scene without a path gets one. Scenes name
//! models and don't hold them: the file has to lie beside the scene's.

use super::Note;
use crate::arrange::Names;
use crate::document::{Edit, ListEdit};
use crate::model_mesh::ModelMesh;
use crate::scene::{Aircraft, AircraftId, CameraPath, IdCounter, PathId, PathKey, Prop, PropId, Scene, Thing};
use glam::{DVec3, Vec3};

/// The way of an aircraft in a scene without paths: so long, metres, at a light aircraft's speed.
const WAY_M: f64 = 1600.0;
const SPEED_MPS: f64 = 80.0;

/// A shape from elsewhere.
#[derive(Debug, Clone, PartialEq)]
pub struct ArrivedModel {
    /// What it may be called.
    pub name: String,
    /// Of how many triangles it is.
    pub triangles: usize,
    /// Its width, height and length, metres.
    pub size: Vec3,
    /// Whether it is an aircraft.
    pub flies: bool,
}

impl ArrivedModel {
    /// What there is to say of a shape.
    pub(super) fn of(mesh: &ModelMesh, name: &str, flies: bool) -> Self {
        let points = || mesh.vertices().iter().map(|vertex| vertex.position);
        let size = points().reduce(Vec3::max).unwrap_or_default() - points().reduce(Vec3::min).unwrap_or_default();
        Self { name: name.into(), triangles: mesh.vertices().len() / 3, size, flies }
    }

    /// Edits by which `scene` has it as the file of that name, ready for one transaction; what it is there; and what was
    /// taken for granted. It stands at `at`, or flies along the first path, or else level, northwards and through `at`.
    pub fn put(&self, scene: &Scene, file_name: &str, at: DVec3) -> (Vec<Edit>, Thing, Vec<Note>) {
        if self.flies { self.fly(scene, file_name, at) } else { self.stand(scene, file_name, at) }
    }

    fn stand(&self, scene: &Scene, file_name: &str, at: DVec3) -> (Vec<Edit>, Thing, Vec<Note>) {
        let mut ids = scene.next_id;
        let id = PropId::new(&mut ids);
        let name = Names::new(scene.props.iter().map(|one| one.name.as_str())).free(&self.name);
        let value = Prop { name, ..Prop::new(id, file_name, at) };
        let edits = vec![Edit::NextId(ids), Edit::Prop(ListEdit::Insert { at: usize::MAX, value })];
        (edits, Thing::Prop(id), Vec::new())
    }

    fn fly(&self, scene: &Scene, file_name: &str, at: DVec3) -> (Vec<Edit>, Thing, Vec<Note>) {
        let mut ids: IdCounter = scene.next_id;
        let mut edits = Vec::new();
        let (path, along) = match scene.paths.first() {
            Some(path) => (path.id, format!("“{}”, the scene's first; another can be chosen", path.name)),
            None => {
                let path = level(PathId::new(&mut ids), at);
                let id = path.id;
                edits.push(Edit::Path(ListEdit::Insert { at: usize::MAX, value: path }));
                (id, format!("a new one of {WAY_M} m, as an aircraft flies along a path and the scene has none"))
            }
        };
        let name = Names::new(scene.aircraft.iter().map(|one| one.name.as_str())).free(&self.name);
        let id = AircraftId::new(&mut ids);
        let value = Aircraft { model: Some(file_name.into()), ..Aircraft::new(id, &name, path) };
        edits.push(Edit::Aircraft(ListEdit::Insert { at: usize::MAX, value }));
        edits.insert(0, Edit::NextId(ids));
        (edits, Thing::Aircraft(id), vec![Note::assumed("path", along)])
    }
}

fn level(id: PathId, at: DVec3) -> CameraPath {
    let key = |time_s: f64| PathKey {
        time_s,
        position: at + DVec3::Z * (0.5 * WAY_M - time_s * SPEED_MPS),
        heading_deg: 0.0,
        pitch_deg: 0.0,
        roll_deg: 0.0,
    };
    CameraPath::new(id, "path", vec![key(0.0), key(WAY_M / SPEED_MPS)])
}
