//! An aircraft that flies along a camera path.

use super::{AircraftId, HasId, InScene, PathId, Thing};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A model of an aircraft on its way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Aircraft {
    /// Its id.
    pub id: AircraftId,
    /// For people.
    pub name: String,
    /// A `.glb` beside the scene file, in metres, its nose along −z. None for the built-in aircraft.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub model: Option<String>,
    /// Along which path it flies.
    pub path: PathId,
    /// By how many seconds it is ahead of a camera on that path, which thus follows it; behind if negative.
    #[serde(default = "usual_lead")]
    pub ahead_s: f64,
    /// Scales the model.
    #[serde(default = "one")]
    pub scale: f64,
}

fn usual_lead() -> f64 {
    4.0
}

fn one() -> f64 {
    1.0
}

impl Aircraft {
    /// The built-in aircraft, before the camera on `path`.
    pub fn new(id: AircraftId, name: &str, path: PathId) -> Self {
        Self { id, name: name.into(), model: None, path, ahead_s: usual_lead(), scale: one() }
    }
}

impl HasId for Aircraft {
    type Id = AircraftId;
    fn id(&self) -> AircraftId {
        self.id
    }
}

impl InScene for Aircraft {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn hangs_on(&self) -> Option<(&'static str, Thing)> {
        Some(("path", Thing::Path(self.path)))
    }

    fn hang_on(&mut self, thing: Thing) {
        if let Thing::Path(id) = thing {
            self.path = id;
        }
    }

    /// Astern by some lengths of an aircraft at its usual speed.
    fn step_aside(&mut self) {
        self.ahead_s -= 0.5;
    }
}
