//! What a picture is written as.

use serde::{Deserialize, Serialize};

/// A kind of file.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, clap::ValueEnum, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PictureKind {
    /// As a display shows it, 8 bits
    #[default]
    Png,
    /// OpenEXR: linear light before the tone curve, 16-bit floats
    Exr,
    /// Radiance HDR: linear light before the tone curve, as engines take skies
    Hdr,
}

impl PictureKind {
    /// All.
    pub const ALL: [Self; 3] = [Self::Png, Self::Exr, Self::Hdr];

    /// Of file names, without the point.
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// As a user knows it.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Png => "PNG",
            Self::Exr => "OpenEXR",
            Self::Hdr => "Radiance HDR",
        }
    }
}
