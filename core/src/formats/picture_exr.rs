//! A picture as the bytes of an OpenEXR file: linear light before exposure and tone curve, 16-bit floats; depth in 32.
//!
//! Layers are channels of one part, named by OpenEXR's custom (`sky.R`, `depth.Z`), so that a program that knows only
//! R, G, B and A shows the picture. They are listed in [`LAYERS`]; the picture is
//! ambient + directional + haze + (1 − alpha) · (sky + ground + models). The same picture gives the same bytes: what
//! is said about it stands in attributes of their own order.

use crate::camera::{NEAR_M, View};
use crate::color::Rgb;
use crate::image::{LayeredPixel, Layers, LinearPicture};
use exr::meta::attribute::EnvironmentMap;
use exr::prelude::{
    AnyChannel, AnyChannels, Blocks, Compression, Encoding, FlatSamples, Image, Layer, LayerAttributes, LineOrder,
    Text, Vec2, WritableImage, f16,
};
use rayon::prelude::*;
use std::io::Cursor;

/// What a file says about its picture.
#[derive(Debug, Clone, Copy)]
pub struct About<'a> {
    /// For a person: whose picture it is, and when.
    pub comment: &'a str,
    /// The eye.
    pub eye: Eye<'a>,
    /// Of a sequence.
    pub frames_a_second: Option<u32>,
}

/// Who sees a picture.
#[derive(Debug, Clone, Copy)]
pub enum Eye<'a> {
    /// A camera.
    Camera(&'a View),
    /// One that sees all directions, as OpenEXR's map of latitude and longitude.
    AllAround,
}

/// A channel of pixels of type `P`: its name, what it holds, and whether 16 bits are too few for that.
type Channel<P> = (&'static str, fn(&P) -> f32, bool);

/// Of a picture alone.
const PICTURE: [Channel<Rgb>; 4] =
    [("R", |p| p.r, false), ("G", |p| p.g, false), ("B", |p| p.b, false), ("A", |_| 1.0, false)];

/// Of a picture in layers: itself, and then they.
pub const LAYERS: [Channel<LayeredPixel>; 28] = [
    ("R", |p| p.composed().r, false),
    ("G", |p| p.composed().g, false),
    ("B", |p| p.composed().b, false),
    ("A", |_| 1.0, false),
    ("ambient.R", |p| p.ambient.r, false),
    ("ambient.G", |p| p.ambient.g, false),
    ("ambient.B", |p| p.ambient.b, false),
    ("directional.R", |p| p.directional.r, false),
    ("directional.G", |p| p.directional.g, false),
    ("directional.B", |p| p.directional.b, false),
    ("haze.R", |p| p.haze.r, false),
    ("haze.G", |p| p.haze.g, false),
    ("haze.B", |p| p.haze.b, false),
    ("alpha.A", |p| p.alpha, false),
    ("depth.Z", LayeredPixel::depth_m, true),
    ("motion.X", |p| p.motion_px()[0], false),
    ("motion.Y", |p| p.motion_px()[1], false),
    ("sky.R", |p| p.sky.r, false),
    ("sky.G", |p| p.sky.g, false),
    ("sky.B", |p| p.sky.b, false),
    ("ground.R", |p| p.ground.r, false),
    ("ground.G", |p| p.ground.g, false),
    ("ground.B", |p| p.ground.b, false),
    ("ground.A", |p| p.ground_share, false),
    ("models.R", |p| p.models.r, false),
    ("models.G", |p| p.models.g, false),
    ("models.B", |p| p.models.b, false),
    ("models.A", |p| p.models_share, false),
];

/// Pixels whose channels are told apart at once: they stay in a core's cache.
const AT_ONCE: usize = 4096;

/// A picture alone.
///
/// # Errors
/// If there is not enough room for the file.
pub fn picture(picture: &LinearPicture, about: &About<'_>) -> exr::error::Result<Vec<u8>> {
    file([picture.width, picture.height], &picture.pixels, &PICTURE, about, Compression::ZIP16)
}

/// A picture in layers.
///
/// # Errors
/// As [`picture`].
pub fn layers(layers: &Layers, about: &About<'_>) -> exr::error::Result<Vec<u8>> {
    // Twice as large as by ZIP16, in a third of the time: a frame is soon read, a flight long drawn.
    file([layers.width, layers.height], &layers.pixels, &LAYERS, about, Compression::RLE)
}

fn file<P: Sync>(
    size: [u32; 2],
    pixels: &[P],
    channels: &[Channel<P>],
    about: &About<'_>,
    compression: Compression,
) -> exr::error::Result<Vec<u8>> {
    let samples = channels.iter().zip(planes(pixels, channels));
    let list = samples.map(|((name, ..), samples)| AnyChannel::new(*name, samples)).collect();
    let encoding = Encoding { compression, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
    let size = Vec2(size[0] as usize, size[1] as usize);
    let image = Image::from_layer(Layer::new(size, about.attributes(), encoding, AnyChannels::sort(list)));
    let mut bytes = Cursor::new(Vec::new());
    image.write().to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}

/// The samples of each channel.
fn planes<P: Sync>(pixels: &[P], channels: &[Channel<P>]) -> Vec<FlatSamples> {
    let of_some = |some: &[P]| -> Vec<FlatSamples> {
        let plane = |(_, value, is_wide): &Channel<P>| match is_wide {
            true => FlatSamples::F32(some.iter().map(value).collect()),
            false => FlatSamples::F16(some.iter().map(|pixel| half(value(pixel))).collect()),
        };
        channels.iter().map(plane).collect()
    };
    let parts: Vec<Vec<FlatSamples>> = pixels.par_chunks(AT_ONCE).map(of_some).collect();
    let joined = |channel: usize| {
        let mut whole = match channels[channel].2 {
            true => FlatSamples::F32(Vec::with_capacity(pixels.len())),
            false => FlatSamples::F16(Vec::with_capacity(pixels.len())),
        };
        for part in &parts {
            match (&mut whole, &part[channel]) {
                (FlatSamples::F16(whole), FlatSamples::F16(part)) => whole.extend_from_slice(part),
                (FlatSamples::F32(whole), FlatSamples::F32(part)) => whole.extend_from_slice(part),
                _ => {}
            }
        }
        whole
    };
    (0..channels.len()).into_par_iter().map(joined).collect()
}

/// The nearest that 16 bits hold; what is too large is the largest.
fn half(value: f32) -> f16 {
    f16::from_f32(value.clamp(f16::MIN.to_f32(), f16::MAX.to_f32()))
}

impl About<'_> {
    fn attributes(&self) -> LayerAttributes {
        let text = |text: &str| Some(Text::from_slice_unchecked(text.as_bytes()));
        let about = LayerAttributes {
            comments: text(self.comment),
            software_name: text(concat!("Cloudwright ", env!("CARGO_PKG_VERSION"))),
            frames_per_second: self.frames_a_second.map(|count| (count as i32, 1)),
            ..LayerAttributes::default()
        };
        match self.eye {
            Eye::AllAround => LayerAttributes { environment_map: Some(EnvironmentMap::LatitudeLongitude), ..about },
            Eye::Camera(view) => {
                let half_width = view.tan_half_height * view.width as f32 / view.height as f32;
                let degrees = |tan: f32| 2.0 * libm::atanf(tan).to_degrees();
                LayerAttributes {
                    world_to_camera: Some(camera_from_world(view)),
                    horizontal_field_of_view: Some(degrees(half_width)),
                    vertical_field_of_view: Some(degrees(view.tan_half_height)),
                    near_clip_plane: Some(NEAR_M),
                    ..about
                }
            }
        }
    }
}

/// From metres in the world to metres before the camera, x to the right, y up, looking along −z. OpenEXR's points are
/// rows, and stand before the matrix.
fn camera_from_world(view: &View) -> [f32; 16] {
    let [x, y, z] = [view.right, view.up, -view.forward];
    let eye = |axis: glam::Vec3| (-view.eye.dot(axis.as_dvec3())) as f32;
    [[x.x, y.x, z.x, 0.0], [x.y, y.y, z.y, 0.0], [x.z, y.z, z.z, 0.0], [eye(x), eye(y), eye(z), 1.0]]
        .as_flattened()
        .try_into()
        .unwrap_or_default()
}

/// Whether `bytes` are such a file to its last byte, of that size, in layers or not.
pub fn is_whole(bytes: &[u8], size: [u32; 2], in_layers: bool) -> bool {
    let wanted = Vec2(size[0] as usize, size[1] as usize);
    // Before memory is taken for what a file claims to be.
    let Ok(meta) = exr::meta::MetaData::read_from_buffered(Cursor::new(bytes), true) else { return false };
    let count = if in_layers { LAYERS.len() } else { PICTURE.len() };
    let is_ours =
        |header: &exr::meta::header::Header| header.layer_size == wanted && header.channels.list.len() == count;
    if meta.headers.len() != 1 || !meta.headers.iter().all(is_ours) {
        return false;
    }
    use exr::prelude::{ReadChannels, ReadLayers, read};
    let reader = read().no_deep_data().largest_resolution_level().all_channels().all_layers().all_attributes();
    reader.from_buffered(Cursor::new(bytes)).is_ok()
}
