//! A cloud: a model placed in the scene.

use super::{CloudId, CloudModel, FolderId, Formation, HasId, HowFarFormed, InScene, ModelId, Thing};
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
    /// What it is kept in; none: in no folder.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub folder: Option<FolderId>,
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
    /// How far it has formed, whatever the formation says; none: as that says, or whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formed: Option<HowFarFormed>,
    /// A factor of its sprites' opacity.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub opacity: f64,
    /// Heights above its base are multiplied with this; sprites keep their size.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub growth: f64,
    /// How much of the wind's way it goes along, 0 to 1.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub wind_share: f64,
    /// How much it rises, and grows, with the base that the air's temperature and dew point give, 0 to 1.
    #[serde(default = "one", skip_serializing_if = "is_one")]
    pub base_share: f64,
}

fn is_one(value: &f64) -> bool {
    *value == one()
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
            folder: None,
            position,
            heading_deg: 0.0,
            scale: 1.0,
            seed: None,
            formation: None,
            formed: None,
            opacity: 1.0,
            growth: 1.0,
            wind_share: 1.0,
            base_share: 1.0,
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

    fn hang_on(&mut self, thing: Thing) {
        if let Thing::Model(id) = thing {
            self.model = id;
        }
    }

    fn kept_in(&self) -> Option<(&'static str, Thing)> {
        Some(("folder", Thing::Folder(self.folder?)))
    }

    fn keep_in(&mut self, thing: Option<Thing>) {
        self.folder = if let Some(Thing::Folder(id)) = thing { Some(id) } else { None };
    }
}
