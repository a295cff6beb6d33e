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

/// What becomes of a film's frames that lie there already, by their names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum There {
    /// Nothing is drawn.
    #[default]
    Refuse,
    /// Those that are whole and of the size are kept, whatever they show.
    Keep,
    /// They are drawn anew.
    Replace,
}

/// Of a film: a flight, or weather from a camera.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct FilmSettings {
    /// Of each frame.
    pub frame: PictureSettings,
    frames_a_second: u32,
    /// Whether the frames become a video, .mp4.
    pub video: bool,
    /// Whether sprites that come before others are faded over, in place of being sorted anew for each frame.
    pub crossfade: bool,
    /// What becomes of frames that lie there.
    pub there: There,
}

impl Default for FilmSettings {
    fn default() -> Self {
        Self {
            frame: PictureSettings { size: [1280, 720], ..PictureSettings::default() },
            frames_a_second: 30,
            video: true,
            crossfade: false,
            there: There::default(),
        }
    }
}

impl FilmSettings {
    /// Frames a second, at the most.
    pub const MAX_FRAMES_A_SECOND: u32 = 240;

    /// Frames a second.
    pub fn frames_a_second(&self) -> u32 {
        self.frames_a_second.clamp(1, Self::MAX_FRAMES_A_SECOND)
    }

    /// Chooses another rate.
    pub fn set_frames_a_second(&mut self, frames: u32) {
        self.frames_a_second = frames;
    }
}
