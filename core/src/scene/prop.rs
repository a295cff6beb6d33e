//! A model that stands in the scene.

use super::{HasId, InScene, PoseMut, PropId};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Terrain, a tower, a ship: a shape from a file, at a place.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Prop {
    /// Its id.
    pub id: PropId,
    /// For people.
    pub name: String,
    /// A `.glb` beside the scene file, in metres, y up.
    pub model: String,
    /// Where the file's origin comes to lie, metres in the world.
    #[schemars(with = "[f64; 3]")]
    pub position: DVec3,
    /// Turns it clockwise, seen from above.
    #[serde(default)]
    pub heading_deg: f64,
    /// Raises its north.
    #[serde(default)]
    pub pitch_deg: f64,
    /// Lowers its east.
    #[serde(default)]
    pub roll_deg: f64,
    /// Scales the model.
    #[serde(default = "one")]
    pub scale: f64,
}

fn one() -> f64 {
    1.0
}

impl Prop {
    /// The file of that name as it is, its origin at `position`.
    pub fn new(id: PropId, model: &str, position: DVec3) -> Self {
        let [heading_deg, pitch_deg, roll_deg] = [0.0; 3];
        let (name, model) = ("prop".into(), model.into());
        Self { id, name, model, position, heading_deg, pitch_deg, roll_deg, scale: one() }
    }
}

impl HasId for Prop {
    type Id = PropId;
    fn id(&self) -> PropId {
        self.id
    }
}

impl InScene for Prop {
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

    fn points(&self) -> Vec<DVec3> {
        vec![self.position]
    }

    /// Eastwards.
    fn step_aside(&mut self) {
        self.position.x += 10.0 * self.scale;
    }
}
