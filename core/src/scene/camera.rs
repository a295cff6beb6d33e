//! A named camera, as saved.

use super::{CameraId, HasId, IdCounter, InScene, PoseMut};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Of a new camera or path.
pub(super) const USUAL_FIELD_OF_VIEW_DEG: f64 = 50.0;

/// A point of view with a name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Its id.
    pub id: CameraId,
    /// What the command line calls it.
    pub name: String,
    /// The eye, metres in the world.
    #[schemars(with = "[f64; 3]")]
    pub position: DVec3,
    /// Clockwise from north, seen from above.
    pub heading_deg: f64,
    /// Up is positive.
    pub pitch_deg: f64,
    /// Right wing down is positive.
    #[serde(default)]
    pub roll_deg: f64,
    /// Vertical field of view.
    pub field_of_view_deg: f64,
}

impl Camera {
    /// A level camera that looks north.
    pub fn new(id: CameraId, name: &str, position: DVec3) -> Self {
        Self {
            id,
            name: name.into(),
            position,
            heading_deg: 0.0,
            pitch_deg: 0.0,
            roll_deg: 0.0,
            field_of_view_deg: USUAL_FIELD_OF_VIEW_DEG,
        }
    }

    /// A camera that has no id because it is in no scene: the editor's own view.
    pub fn free(position: DVec3) -> Self {
        Self::new(CameraId::new(&mut IdCounter(0)), "view", position)
    }
}

impl HasId for Camera {
    type Id = CameraId;
    fn id(&self) -> CameraId {
        self.id
    }
}

impl InScene for Camera {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn poses_mut(&mut self) -> Vec<PoseMut<'_>> {
        let Self { position, heading_deg, pitch_deg, roll_deg, .. } = self;
        vec![PoseMut { position, attitude_deg: Some([heading_deg, pitch_deg, roll_deg]) }]
    }
}
