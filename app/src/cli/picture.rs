//! What a picture is written as, and what is in it: of `render` and `fly`.

use super::counted;
use super::failure::Failure;
use super::painter::{Painter, PainterArguments};
use crate::{picture_hdr, picture_png};
use cloudwright_core::formats::picture_exr::{self, About, Eye};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::raster::develop;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::rules::Rasterizer;
use cloudwright_core::watch::Watch;
use std::path::Path;

/// Samples of one picture held in memory at once: 4K with 16 samples a pixel fits, some 4 GB at the most.
const MAX_SAMPLES: u64 = 1 << 27;
/// A sample in layers takes as much memory as so many without.
pub(super) const IN_LAYERS: u64 = 6;

/// A kind of file.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Kind {
    /// As a display shows it, 8 bits
    Png,
    /// OpenEXR: linear light before the tone curve, 16-bit floats
    Exr,
    /// Radiance HDR: linear light before the tone curve, as engines take skies
    Hdr,
}

impl Kind {
    /// The one that the ending of `output` says.
    pub(super) fn of(output: &Path) -> Result<Self, Failure> {
        let ending = output.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        [Self::Png, Self::Exr, Self::Hdr].into_iter().find(|kind| kind.ending() == ending).ok_or_else(|| {
            let what = format!("--output {}: a picture is written as PNG, OpenEXR or Radiance HDR", output.display());
            Failure::argument(what, "end its name in .png, .exr or .hdr")
        })
    }

    pub(super) fn ending(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Exr => "exr",
            Self::Hdr => "hdr",
        }
    }

    /// That it can hold layers, and that what `painter` asks for draws them; what is to draw them then.
    pub(super) fn layered(self, painter: &PainterArguments) -> Result<PainterArguments, Failure> {
        if self != Self::Exr {
            let what = format!("--layers: a .{} file has none", self.ending());
            return Err(Failure::argument(what, "write OpenEXR: a name in .exr, or fly --format exr"));
        }
        let painter = painter.in_software("--layers")?;
        if matches!(painter.rules()?.rasterizer, Rasterizer::Fast { .. }) {
            return Ok(painter);
        }
        Err(Failure::argument("--layers: this method keeps none", "leave --truth or --method out"))
    }

    /// Draws `frame`; in layers with the motion until `later`, if that is given.
    pub(super) fn draw(
        self,
        painter: &mut Painter,
        (frame, later): (Frame<'_>, Option<&Later<'_>>),
        about: &Said,
        watch: &Watch,
    ) -> Result<Vec<u8>, Failure> {
        let view = frame.view;
        let said = About { comment: &about.comment, eye: Eye::Camera(&view), frames_a_second: about.frames_a_second };
        match (self, later) {
            (Self::Png, _) => picture_png::encode(&painter.picture(frame, watch)?).map_err(too_large),
            (Self::Exr, Some(later)) => match painter.layers(frame, later)? {
                Some(layers) => picture_exr::layers(&layers, &said).map_err(too_large),
                None => Err(Failure::could_not("these rules keep no layers", "report this")),
            },
            (Self::Exr, None) => picture_exr::picture(&painter.linear(frame, watch)?, &said).map_err(too_large),
            (Self::Hdr, _) => picture_hdr::encode(&painter.linear(frame, watch)?).map_err(too_large),
        }
    }

    /// The file of a `picture` that no single camera sees, by the `exposure` of its scene.
    pub(super) fn pack(self, picture: &LinearPicture, exposure: f32, about: &About<'_>) -> Result<Vec<u8>, Failure> {
        match self {
            Self::Png => picture_png::encode(&develop(picture, exposure)).map_err(too_large),
            Self::Exr => picture_exr::picture(picture, about).map_err(too_large),
            Self::Hdr => picture_hdr::encode(picture).map_err(too_large),
        }
    }
}

/// What a file may say of its picture, for a person.
pub(super) struct Said {
    pub(super) comment: String,
    pub(super) frames_a_second: Option<u32>,
}

impl Said {
    /// Of a picture of `scene` from `camera`, `clock_s` into the scene.
    pub(super) fn new(scene: &str, camera: &str, clock_s: f64, frame: &Frame<'_>) -> Self {
        let minutes = (frame.now.light.time_h.rem_euclid(24.0) * 60.0).round() as u32 % 1440;
        let (hour, minute) = (minutes / 60, minutes % 60);
        let comment = format!(
            "scene: {scene}; camera: {camera}; clock: {clock_s} s; time of day: {hour:02}:{minute:02}; linear light \
             before exposure, which is {}; worldToCamera looks along -z",
            frame.now.exposure
        );
        Self { comment, frames_a_second: None }
    }
}

fn too_large(error: impl std::fmt::Display) -> Failure {
    Failure::could_not(format!("the picture can't be packed: {error}"), "try a smaller --size")
}

/// That the samples of one picture fit into memory, of which each takes as much as `weight` samples of an ordinary one.
pub(super) fn check_memory([width, height]: [u32; 2], side: u32, weight: u64) -> Result<(), Failure> {
    let samples = u64::from(width) * u64::from(height) * u64::from(side * side);
    let most = MAX_SAMPLES / weight;
    if samples <= most {
        return Ok(());
    }
    Err(Failure::argument(
        format!(
            "--size {width}x{height} with {} a pixel is {} million samples",
            counted((side * side) as usize, "sample", "samples"),
            samples / 1_000_000
        ),
        format!("stay within {} million: lower --size or --samples", most / 1_000_000),
    ))
}
