//! Ready-made clouds to start from: one of each kind, and colour levels for them.
//!
//! A preset is a small scene file embedded in the program: one cloud model, one cloud of it, and a camera `main` that
//! frames it. The whole scene is what `cloudwright new` writes and what pictures to choose from show; [`Preset::place`] takes its
//! model alone into an open scene. The files are made by tests/src/authoring/presets; a test opens each.

mod levels;
mod place;

pub use levels::LevelPreset;

use crate::formats::scene_file;
use crate::scene::Scene;
use std::fmt;
use std::hash::{Hash, Hasher};

/// A ready-made cloud. Presets are told apart by their names.
#[derive(Clone, Copy)]
pub struct Preset {
    /// As on the command line.
    pub name: &'static str,
    /// As on screen.
    pub label: &'static str,
    /// One sentence for the artist.
    pub help: &'static str,
    file: &'static str,
}

macro_rules! presets {
    ($($name:literal, $label:literal, $help:literal;)*) => {
        &[$(Preset {
            name: $name,
            label: $label,
            help: $help,
            file: include_str!(concat!("../../../assets/presets/", $name, ".cloudscene")),
        }),*]
    };
}

impl Preset {
    /// All of them, in the order in which they are offered.
    pub const ALL: &'static [Self] = presets! {
        "cumulus_humilis", "Cumulus humilis", "A small heap of a fine day: a level base, wider than it is high.";
        "cumulus_congestus", "Cumulus congestus", "A towering heap like a cauliflower, higher than it is wide.";
        "solid_cumulus", "Solid cumulus", "Puffs alone: a round, hard outline without a torn edge.";
        "stratocumulus", "Stratocumulus", "Broad rolls of flattened heaps with gaps between them.";
        "altocumulus", "Altocumulus", "A patch of small flakes in ranks, high up.";
        "stratus", "Stratus", "A low, soft, grey sheet that thins out at its edges.";
        "nimbostratus", "Nimbostratus", "A dark, thick sheet with rain beneath it.";
        "cumulonimbus", "Cumulonimbus", "A thunder cloud: dark base, high tower, and an anvil drawn out by the wind.";
        "wisps", "Wisps", "Torn rags that let the sky through.";
    };

    /// The preset of that name.
    pub fn by_name(name: &str) -> Option<&'static Self> {
        Self::ALL.iter().find(|preset| preset.name == name)
    }

    /// Its whole scene. (A file that could not be read would be an empty scene; a test reads them all.)
    pub fn scene(&self) -> Scene {
        scene_file::read(self.file.as_bytes()).unwrap_or_default()
    }
}

impl PartialEq for Preset {
    fn eq(&self, other: &Self) -> bool {
        self.name == other.name
    }
}

impl Eq for Preset {}

impl Hash for Preset {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
    }
}

impl fmt::Debug for Preset {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_tuple("Preset").field(&self.name).finish()
    }
}
