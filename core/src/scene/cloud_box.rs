//! A box: where sprites are strewn, and how they look.

use super::{BoxId, Category, GroupId, GroupLight, HasId};
use glam::{DQuat, DVec3};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A box of a cloud model, filled with sprites.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CloudBox {
    /// Its id; part of the key of its sprites' random numbers unless it has a `key`.
    pub id: BoxId,
    /// For people.
    #[serde(default)]
    pub name: String,
    /// The middle, metres in the model's space.
    #[schemars(with = "[f64; 3]")]
    pub center: DVec3,
    /// Full extent along the box's own axes, metres.
    #[schemars(with = "[f64; 3]")]
    pub size: DVec3,
    /// The box's turn in the model's space, a unit quaternion (x, y, z, w).
    #[serde(default, skip_serializing_if = "is_identity")]
    #[schemars(with = "[f64; 4]")]
    pub orientation: DQuat,
    /// How many sprites are tried, before culling.
    pub sprite_count: u32,
    /// Smallest and largest width, metres. One draw scales width and height together: equal ranges give squares.
    pub width: [f64; 2],
    /// Smallest and largest height, metres.
    pub height: [f64; 2],
    /// Range of the sprites' own turn, counter-clockwise as seen.
    pub rotation_deg: [f64; 2],
    /// Another kind of cloud than the model's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub category: Option<Category>,
    /// A shading group of the model's that this box shares; none: the box is a group of its own.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<GroupId>,
    /// How the box's own group takes the sun.
    #[serde(default)]
    pub light: GroupLight,
    /// The box's own group falls into this many lumps along the box's axes, each with a centre of its own.
    #[serde(default = "one_lump", skip_serializing_if = "is_one_lump")]
    pub lumps: [u32; 3],
    /// Stands for the id in the key of its sprites' random numbers: copies look alike, another number rolls it anew.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub key: Option<u64>,
    /// Stands for the cloud's seed: what was joined from another cloud keeps its looks.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// What the artist changed by hand about single sprites.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub sprite_edits: Vec<SpriteEdit>,
}

/// What was changed about one sprite; all else is generated.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpriteEdit {
    /// Which sprite of the box.
    pub index: u32,
    /// Moved here by hand: in the box, −½ to ½ along each of its axes (beyond is allowed). Never culled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    #[schemars(with = "Option<[f64; 3]>")]
    pub moved: Option<DVec3>,
    /// Its width, set by hand, metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    /// Its height, set by hand, metres.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    /// Its own turn, set by hand, counter-clockwise as seen.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub rotation_deg: Option<f64>,
    /// The tile that it shows, set by hand: 0 to 15, row by row.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tile: Option<u32>,
    /// Taken out by hand.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub dropped: bool,
    /// Put into a group of the model's by hand.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub group: Option<GroupId>,
}

fn is_identity(q: &DQuat) -> bool {
    *q == DQuat::IDENTITY
}

fn one_lump() -> [u32; 3] {
    [1, 1, 1]
}

fn is_one_lump(lumps: &[u32; 3]) -> bool {
    *lumps == one_lump()
}

impl SpriteEdit {
    /// Of that sprite, with nothing changed.
    pub fn new(index: u32) -> Self {
        Self {
            index,
            moved: None,
            width: None,
            height: None,
            rotation_deg: None,
            tile: None,
            dropped: false,
            group: None,
        }
    }
}

impl CloudBox {
    /// What its sprites' random numbers are keyed by, besides their index: seed and key.
    pub fn random_key(&self, cloud_seed: u64) -> (u64, u64) {
        (self.seed.unwrap_or(cloud_seed), self.key.unwrap_or(self.id.0))
    }

    /// A box of 500 m with 30 square sprites of 150 to 250 m.
    pub fn new(id: BoxId, center: DVec3) -> Self {
        Self {
            id,
            name: String::new(),
            center,
            size: DVec3::splat(500.0),
            orientation: DQuat::IDENTITY,
            sprite_count: 30,
            width: [150.0, 250.0],
            height: [150.0, 250.0],
            rotation_deg: [0.0, 360.0],
            category: None,
            group: None,
            light: GroupLight::default(),
            lumps: one_lump(),
            key: None,
            seed: None,
            sprite_edits: Vec::new(),
        }
    }
}

impl HasId for CloudBox {
    type Id = BoxId;
    fn id(&self) -> BoxId {
        self.id
    }
}
