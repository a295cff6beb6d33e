//! A cloud model: boxes, colours and groups, defined once and placed often.

use super::color_levels::default_levels;
use super::{Category, CloudBox, ColorLevels, HasId, InScene, List, ModelId, ShadingGroup};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A kind of cloud.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CloudModel {
    /// Its id.
    pub id: ModelId,
    /// For people.
    pub name: String,
    /// Which tiles its boxes show unless they say otherwise.
    pub category: Category,
    /// Part of the key of all its random numbers; a cloud may have its own.
    pub seed: u64,
    /// How close sprites may lie.
    #[serde(default)]
    pub cull_radius: CullRadius,
    /// Ambient light over the height.
    pub color_levels: ColorLevels,
    /// How much of the sun's light goes by the cloud that it comes through, 0 to 1; the rest goes by the shading groups.
    #[serde(default, skip_serializing_if = "is_none")]
    pub self_shadow: f64,
    /// How much the sun shines through thin cloud before it, 0 to 1.
    #[serde(default, skip_serializing_if = "is_none")]
    pub halo: f64,
    /// Shading groups that several boxes or single sprites share.
    #[serde(default, skip_serializing_if = "List::is_empty")]
    pub groups: List<ShadingGroup>,
    /// Where its sprites are strewn.
    #[serde(default)]
    pub boxes: List<CloudBox>,
}

/// A candidate whose centre lies closer than this to one already kept is dropped.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CullRadius {
    /// A share of the candidate's own smaller side (W's paper: 1/3, dense 1/5 to 1/6).
    SpriteFraction(f64),
    /// A share of the cloud's height, from the lowest to the highest of its candidates' spheres (W's slides: 1/3,
    /// dense 1/5).
    CloudHeightFraction(f64),
    /// Metres in the model's space.
    Metres(f64),
}

fn is_none(share: &f64) -> bool {
    *share == 0.0
}

impl Default for CullRadius {
    fn default() -> Self {
        Self::SpriteFraction(1.0 / 3.0)
    }
}

impl CloudModel {
    /// A model without boxes.
    pub fn new(id: ModelId, name: &str, category: Category) -> Self {
        Self {
            id,
            name: name.into(),
            category,
            seed: 1,
            cull_radius: CullRadius::default(),
            color_levels: default_levels(),
            self_shadow: 0.0,
            halo: 0.0,
            groups: List::new(),
            boxes: List::new(),
        }
    }
}

impl HasId for CloudModel {
    type Id = ModelId;
    fn id(&self) -> ModelId {
        self.id
    }
}

impl InScene for CloudModel {
    fn name(&self) -> &str {
        &self.name
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.name
    }
}
