//! What a picture is written as, and what is in it.

use super::{NoPicture, Painter};
use crate::picture_kind::PictureKind;
use crate::{picture_hdr, picture_png};
use cloudwright_core::formats::picture_exr::{self, About, Eye};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::raster::develop;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::watch::Watch;
use std::path::Path;

/// The kind that the ending of `file` says.
pub(crate) fn kind_of(file: &Path) -> Option<PictureKind> {
    let ending = file.extension().unwrap_or_default().to_string_lossy().to_lowercase();
    PictureKind::ALL.into_iter().find(|kind| kind.ending() == ending)
}

/// The file of `frame` as `kind`; in layers with the motion until `later`, if that is given.
pub(crate) fn draw(
    kind: PictureKind,
    painter: &mut Painter<'_>,
    (frame, later): (Frame<'_>, Option<&Later<'_>>),
    about: &Said,
    watch: &Watch,
) -> Result<Vec<u8>, NoPicture> {
    let view = frame.view;
    let said = About { comment: &about.comment, eye: Eye::Camera(&view), frames_a_second: about.frames_a_second };
    match (kind, later) {
        (PictureKind::Png, _) => picture_png::encode(&painter.picture(frame, watch)?).map_err(too_large),
        (PictureKind::Exr, Some(later)) => {
            let layers = painter.layers(frame, later)?.ok_or(NoPicture::NoLayers)?;
            picture_exr::layers(&layers, &said).map_err(too_large)
        }
        (PictureKind::Exr, None) => picture_exr::picture(&painter.linear(frame, watch)?, &said).map_err(too_large),
        (PictureKind::Hdr, _) => picture_hdr::encode(&painter.linear(frame, watch)?).map_err(too_large),
    }
}

/// The file of a `picture` that no single camera sees, by the `exposure` of its scene.
pub(crate) fn pack(
    kind: PictureKind,
    picture: &LinearPicture,
    exposure: f32,
    about: &About<'_>,
) -> Result<Vec<u8>, NoPicture> {
    match kind {
        PictureKind::Png => picture_png::encode(&develop(picture, exposure)).map_err(too_large),
        PictureKind::Exr => picture_exr::picture(picture, about).map_err(too_large),
        PictureKind::Hdr => picture_hdr::encode(picture).map_err(too_large),
    }
}

/// What a file may say of its picture, for a person.
pub(crate) struct Said {
    pub(crate) comment: String,
    pub(crate) frames_a_second: Option<u32>,
}

impl Said {
    /// Of a picture of `scene` from `camera`, `clock_s` into the scene.
    pub(crate) fn new(scene: &str, camera: &str, clock_s: f64, frame: &Frame<'_>) -> Self {
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

fn too_large(error: impl std::fmt::Display) -> NoPicture {
    NoPicture::TooLarge(error.to_string())
}
