//! What drawing a frame takes, counted: figures that don't depend on the machine, nor on who else keeps it busy.

use super::overdraw::overdraw_map;
use crate::frame::Frame;

/// What a renderer does for a frame, sprites all drawn to the last.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Counts {
    /// Sprites in the draw list.
    pub sprites: u64,
    /// Corners turned to the eye and lit: four a sprite.
    pub corners_shaded: u64,
    /// Fragments blended: pixels whose centres lie in a sprite's quad, clear texels included.
    pub fragments: u64,
    /// How often a pixel of the picture is blended over, on average.
    pub overdraw_mean: f64,
    /// How often a pixel is blended over at most, but for 1 % of them.
    pub overdraw_p99: f32,
    /// Bytes that a GPU is sent for this frame if it has the clouds already.
    pub bytes_uploaded: u64,
    /// Bytes that a GPU is sent once for the clouds, before the first frame and after each edit.
    pub bytes_of_clouds: u64,
    /// Distances sorted for the draw list.
    pub keys_sorted: u64,
}

// What the GPU renderer sends, bytes; a test holds these against its own structs.
/// For each frame: a sprite's place in the order, three numbers, …
const SPRITE_IN_ORDER_BYTES: u64 = 12;
/// … how one near the eye faces it, …
const POSE_BYTES: u64 = 32;
/// … and where a cloud is from the eye and how far it has formed.
const MOMENT_BYTES: u64 = 32;
/// For each state of the clouds: a sprite, …
const SPRITE_BYTES: u64 = 32;
/// … a shading group, …
const GROUP_BYTES: u64 = 32;
/// … and a cloud with its colour levels.
const CLOUD_BYTES: u64 = 128;

impl Counts {
    /// Counts what drawing `frame` takes, an order that fades out included.
    pub fn of(frame: &Frame<'_>) -> Self {
        let mut overdraw = overdraw_map(frame);
        let mut sprites = frame.list.sprites.len() as u64;
        if let Some((older, _)) = frame.older() {
            sprites += older.list.sprites.len() as u64;
            overdraw.values.iter_mut().zip(overdraw_map(&older).values).for_each(|(sum, more)| *sum += more);
        }
        let clouds = frame.clouds.len() as u64;
        let of_clouds = frame.clouds.iter().map(|cloud| {
            cloud.sprites.len() as u64 * SPRITE_BYTES + cloud.groups.len() as u64 * GROUP_BYTES + CLOUD_BYTES
        });
        Self {
            sprites,
            corners_shaded: 4 * sprites,
            fragments: overdraw.values.iter().map(|count| *count as u64).sum(),
            overdraw_mean: overdraw.mean(),
            overdraw_p99: overdraw.percentile(0.99),
            bytes_uploaded: sprites * SPRITE_IN_ORDER_BYTES
                + frame.list.poses.len() as u64 * POSE_BYTES
                + clouds * MOMENT_BYTES,
            bytes_of_clouds: of_clouds.sum(),
            keys_sorted: sprites,
        }
    }
}
