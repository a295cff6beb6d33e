//! Kinds of cloud: each is a weighting of the atlas's tiles.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What kind of cloud a box holds; it decides which tiles its sprites show.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Category {
    /// Small fair-weather heaps.
    CumulusHumilis,
    /// Towering heaps.
    CumulusCongestus,
    /// Puffs alone: the hardest outline.
    SolidCumulus,
    /// Rolls and patches of heaps.
    Stratocumulus,
    /// Small flakes, high up.
    Altocumulus,
    /// A grey sheet.
    Stratus,
    /// A dark, thick, ragged sheet.
    Nimbostratus,
    /// The thunder cloud's tower.
    Cumulonimbus,
    /// The dark, level underside of any heap.
    FlatBase,
    /// Torn rags and veils.
    Wisps,
}

impl Category {
    /// All of them, in the order in which they are offered.
    pub const ALL: [Self; 10] = [
        Self::CumulusHumilis,
        Self::CumulusCongestus,
        Self::SolidCumulus,
        Self::Stratocumulus,
        Self::Altocumulus,
        Self::Stratus,
        Self::Nimbostratus,
        Self::Cumulonimbus,
        Self::FlatBase,
        Self::Wisps,
    ];

    /// As in the file.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CumulusHumilis => "cumulus_humilis",
            Self::CumulusCongestus => "cumulus_congestus",
            Self::SolidCumulus => "solid_cumulus",
            Self::Stratocumulus => "stratocumulus",
            Self::Altocumulus => "altocumulus",
            Self::Stratus => "stratus",
            Self::Nimbostratus => "nimbostratus",
            Self::Cumulonimbus => "cumulonimbus",
            Self::FlatBase => "flat_base",
            Self::Wisps => "wisps",
        }
    }

    /// How often each of the sixteen tiles is chosen, row by row (MODEL: row 0 three wisps and a flat base, row 1
    /// general, rows 2 and 3 puffs). Whole numbers, so that every machine chooses alike; never all zero.
    pub const fn tile_weights(self) -> [u32; 16] {
        match self {
            Self::CumulusHumilis => [1, 1, 1, 0, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5],
            Self::CumulusCongestus => [1, 1, 0, 0, 1, 1, 1, 1, 8, 8, 8, 8, 8, 8, 8, 8],
            Self::SolidCumulus => [0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1],
            Self::Stratocumulus => [2, 2, 2, 0, 6, 6, 6, 6, 2, 2, 2, 2, 2, 2, 2, 2],
            Self::Altocumulus => [2, 2, 2, 0, 5, 5, 5, 5, 1, 1, 1, 1, 1, 1, 1, 1],
            Self::Stratus => [6, 6, 6, 0, 1, 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0],
            Self::Nimbostratus => [4, 4, 4, 0, 3, 3, 3, 3, 0, 0, 0, 0, 0, 0, 0, 0],
            Self::Cumulonimbus => [0, 0, 0, 0, 1, 1, 1, 1, 10, 10, 10, 10, 10, 10, 10, 10],
            Self::FlatBase => [0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
            Self::Wisps => [1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
        }
    }
}
