//! Shading groups: sprites that take the sun as one lump (W).

use super::{GroupId, HasId};
use glam::DVec3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a group takes the directional light.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GroupLight {
    /// Share of the light on the side away from the sun.
    pub c_min: f64,
    /// Share of the light at right angles to the sun.
    pub c_med: f64,
    /// Share of the light on the side that faces the sun.
    pub c_max: f64,
    /// The point that the group's sides are seen from.
    #[serde(default, skip_serializing_if = "GroupCenter::is_mean")]
    pub center: GroupCenter,
}

/// Where a group's centre lies.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GroupCenter {
    /// The mean of its kept sprites' centres.
    #[default]
    Mean,
    /// The mean, moved by this share of the way towards the cloud's centre: lumps share more of the cloud's own form.
    Pulled(f64),
    /// Put there by hand, metres in the model's space.
    At(#[schemars(with = "[f64; 3]")] DVec3),
}

impl GroupCenter {
    fn is_mean(&self) -> bool {
        *self == Self::Mean
    }
}

/// A group with a name, for boxes and sprites to share.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShadingGroup {
    /// Its id.
    pub id: GroupId,
    /// For people.
    #[serde(default)]
    pub name: String,
    /// How it takes the sun.
    pub light: GroupLight,
}

impl Default for GroupLight {
    fn default() -> Self {
        Self { c_min: 0.0, c_med: 0.42, c_max: 1.0, center: GroupCenter::Mean }
    }
}

impl HasId for ShadingGroup {
    type Id = GroupId;
    fn id(&self) -> GroupId {
        self.id
    }
}
