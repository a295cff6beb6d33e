//! A camera's flight: where it is and where it looks at given times. Between the keys runs [`crate::flight::PathCurve`].

use super::camera::USUAL_FIELD_OF_VIEW_DEG;
use super::{HasId, IdCounter, InScene, PathId, PoseMut};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A way through the scene with a name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CameraPath {
    /// Its id.
    pub id: PathId,
    /// What the command line calls it.
    pub name: String,
    /// Vertical field of view.
    pub field_of_view_deg: f64,
    /// At least one, in rising order of time (the checks see to it).
    pub keys: Vec<PathKey>,
}

/// A moment of a flight.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PathKey {
    /// Seconds. The flight begins at its first key, whatever that one's time is.
    pub time_s: f64,
    /// The eye, metres in the world.
    #[schemars(with = "[f64; 3]")]
    pub position: DVec3,
    /// Clockwise from north, seen from above.
    pub heading_deg: f64,
    /// Up is positive.
    pub pitch_deg: f64,
    /// Right wing down is positive.
    #[serde(default, skip_serializing_if = "is_level")]
    pub roll_deg: f64,
}

fn is_level(roll_deg: &f64) -> bool {
    *roll_deg == 0.0
}

impl CameraPath {
    /// A path with a camera's usual field of view.
    pub fn new(id: PathId, name: &str, keys: Vec<PathKey>) -> Self {
        Self { id, name: name.into(), field_of_view_deg: USUAL_FIELD_OF_VIEW_DEG, keys }
    }

    /// Whether a view that goes along either sees the same, whatever they are called.
    pub fn goes_as(&self, other: &Self) -> bool {
        self.keys == other.keys && self.field_of_view_deg == other.field_of_view_deg
    }

    /// A path that has no id because it is in no scene: one that is being recorded.
    pub fn free(keys: Vec<PathKey>) -> Self {
        Self::new(PathId::new(&mut IdCounter(0)), "path", keys)
    }
}

impl HasId for CameraPath {
    type Id = PathId;
    fn id(&self) -> PathId {
        self.id
    }
}

impl InScene for CameraPath {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn poses_mut(&mut self) -> Vec<PoseMut<'_>> {
        let poses = self.keys.iter_mut().map(|PathKey { position, heading_deg, pitch_deg, roll_deg, .. }| PoseMut {
            position,
            attitude_deg: Some([heading_deg, pitch_deg, roll_deg]),
        });
        poses.collect()
    }

    fn points(&self) -> Vec<DVec3> {
        self.keys.iter().map(|key| key.position).collect()
    }
}
