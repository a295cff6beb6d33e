//! A cloud: a model placed in the scene.

use super::{CloudId, CloudModel, Formation, HasId, InScene, ModelId, Thing};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A placement of a [`super::CloudModel`].
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Cloud {
    /// Its id.
    pub id: CloudId,
    /// For people.
    pub name: String,
    /// What is placed.
    pub model: ModelId,
    /// Where the model's origin comes to lie, metres in the world.
    #[schemars(with = "[f64; 3]")]
    pub position: DVec3,
    /// Turns the model clockwise, seen from above.
    #[serde(default)]
    pub heading_deg: f64,
    /// Scales boxes, sprites and cull metres alike.
    #[serde(default = "one")]
    pub scale: f64,
    /// Sprites of its own instead of those of the model's seed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// How it comes or goes over time; none: it is whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formation: Option<Formation>,
}

fn one() -> f64 {
    1.0
}

impl Cloud {
    /// A placement of `model` under its name, unturned and unscaled.
    pub fn new(id: CloudId, model: &CloudModel, position: DVec3) -> Self {
        Self {
            id,
            name: model.name.clone(),
            model: model.id,
            position,
            heading_deg: 0.0,
            scale: 1.0,
            seed: None,
            formation: None,
        }
    }
}

impl HasId for Cloud {
    type Id = CloudId;
    fn id(&self) -> CloudId {
        self.id
    }
}

impl InScene for Cloud {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }

    fn hangs_on(&self) -> Option<(&'static str, Thing)> {
        Some(("model", Thing::Model(self.model)))
    }
}
