//! How pictures are drawn into files, as it is remembered.

use crate::picture_kind::PictureKind;
use serde::{Deserialize, Serialize};

/// Of one picture. What a file of settings says beyond what can be is brought within it.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct PictureSettings {
    size: [u32; 2],
    #[serde(skip_serializing_if = "Option::is_none")]
    samples_side: Option<u32>,
    /// As what it is written.
    pub kind: PictureKind,
    /// Whether an OpenEXR file has layers.
    pub layers: bool,
    /// The name of the method that draws; what ships, if none is said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub method: Option<String>,
}

impl Default for PictureSettings {
    fn default() -> Self {
        Self { size: [1920, 1080], samples_side: None, kind: PictureKind::default(), layers: false, method: None }
    }
}

impl PictureSettings {
    /// Pixels of a picture's longest side.
    pub const MAX_SIDE: u32 = 16_384;
    /// The square of this is the most samples a pixel.
    pub const MAX_SAMPLES_SIDE: u32 = 8;

    /// Width and height, pixels.
    pub fn size(&self) -> [u32; 2] {
        self.size.map(|side| side.clamp(1, Self::MAX_SIDE))
    }

    /// Chooses another size.
    pub fn set_size(&mut self, size: [u32; 2]) {
        self.size = size;
    }

    /// Samples a pixel, as the side of their square; the method's if none is said.
    pub fn samples_side(&self) -> Option<u32> {
        self.samples_side.map(|side| side.clamp(1, Self::MAX_SAMPLES_SIDE))
    }

    /// Chooses other samples.
    pub fn set_samples_side(&mut self, side: Option<u32>) {
        self.samples_side = side;
    }
}
