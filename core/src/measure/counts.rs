//! What drawing a frame takes, counted: figures that don't depend on the machine, nor on who else keeps it busy.

use super::overdraw::overdraw_map;
use crate::baked::WORDS;
use crate::frame::Frame;
use crate::sprites::PlacedCloud;
use std::sync::Arc;

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
    /// Bytes that a GPU is sent once for the clouds, before the first frame; after an edit it is [`bytes_of_change`].
    pub bytes_of_clouds: u64,
    /// Distances sorted for the draw list.
    pub keys_sorted: u64,
}

// What the GPU renderer sends, bytes; a test holds these against its own structs.
/// For each frame: a sprite's place in the order, three numbers, …
const SPRITE_IN_ORDER_BYTES: u64 = 12;
/// … how one near the eye faces it, …
const POSE_BYTES: u64 = 32;
/// … and where a cloud is from the eye, how it is turned and how far it has formed.
const MOMENT_BYTES: u64 = 96;
/// What other clouds take of the light over one, a node; it is sent when light or clouds have moved.
const SHADE_BYTES: u64 = 16;
/// For each state of the clouds: the light that is baked of a sprite of a model, …
const BAKED_BYTES: u64 = 64;
/// … which of a cloud's sprites cast a shadow on the ground, if any does, …
const CASTER_BYTES: u64 = 12;
/// … a sprite, …
const SPRITE_BYTES: u64 = 32;
/// … what the air makes of it, if there is weather, …
const STIR_BYTES: u64 = 16;
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
        Self {
            sprites,
            corners_shaded: 4 * sprites,
            fragments: overdraw.values.iter().map(|count| *count as u64).sum(),
            overdraw_mean: overdraw.mean(),
            overdraw_p99: overdraw.percentile(0.99),
            bytes_uploaded: sprites * SPRITE_IN_ORDER_BYTES
                + frame.list.poses.len() as u64 * POSE_BYTES
                + clouds * MOMENT_BYTES
                + bytes_of_shades(frame),
            bytes_of_clouds: bytes_of_change(&[], frame.clouds)
                + bytes_of_stirs(frame)
                + bytes_of_baked(frame)
                + bytes_of_casters(frame),
            keys_sorted: sprites,
        }
    }
}

/// Bytes that a GPU is sent when the clouds that it has, `before`, have become `after`, if its tables still hold them: of
/// each cloud what is another than what stood in its place. Of clouds that are lit by their groups alone.
pub fn bytes_of_change(before: &[PlacedCloud], after: &[PlacedCloud]) -> u64 {
    let mut bytes = 0;
    // Of the clouds so far, then and now: a sprite stands at its number among all, and names its group by the group's.
    let (mut sprites, mut groups) = ([0; 2], [0; 2]);
    let mut before = before.iter();
    for now in after {
        let then = before.next();
        let is_known = |same: fn(&PlacedCloud, &PlacedCloud) -> bool| then.is_some_and(|then| same(then, now));
        let sprites_known = is_known(|a, b| a.sprites.are(&b.sprites)) && sprites[0] == sprites[1];
        let groups_known = is_known(|a, b| Arc::ptr_eq(&a.groups, &b.groups));
        let (sprite_count, group_count) = (now.sprites.all().len() as u64, now.groups.len() as u64);
        if groups[0] != groups[1] || !sprites_known {
            bytes += sprite_count * SPRITE_BYTES;
        }
        if groups[0] != groups[1] || !groups_known {
            bytes += group_count * GROUP_BYTES;
        }
        if !is_known(looks_alike) {
            bytes += CLOUD_BYTES;
        }
        let [sprites_then, groups_then] =
            then.map_or([0; 2], |then| [then.sprites.all().len() as u64, then.groups.len() as u64]);
        sprites = [sprites[0] + sprites_then, sprites[1] + sprite_count];
        groups = [groups[0] + groups_then, groups[1] + group_count];
    }
    bytes
}

/// Whether what a GPU keeps of a cloud itself is the same.
fn looks_alike(a: &PlacedCloud, b: &PlacedCloud) -> bool {
    let extent = |cloud: &PlacedCloud| (cloud.center, cloud.radius, cloud.bottom, cloud.top);
    extent(a) == extent(b) && a.color_levels == b.color_levels
}

/// Of the light that is baked, of each model once.
fn bytes_of_baked(frame: &Frame<'_>) -> u64 {
    let mut known: Vec<_> = frame.now.clouds.iter().filter_map(|cloud| Some(cloud.baked?.words())).collect();
    known.sort_unstable_by_key(|words| words.as_ptr());
    known.dedup_by_key(|words| words.as_ptr());
    known.iter().map(|words| (words.len() / WORDS) as u64 * BAKED_BYTES).sum()
}

/// Of what clouds take of the light over others.
fn bytes_of_shades(frame: &Frame<'_>) -> u64 {
    let shades = frame.now.clouds.iter().filter_map(|cloud| cloud.shade.as_ref());
    shades.map(|shade| shade.nodes.len() as u64 * SHADE_BYTES).sum()
}

/// Of the sprites that cast a shadow on the ground; nothing without one.
fn bytes_of_casters(frame: &Frame<'_>) -> u64 {
    let falls = frame.background.ground.is_some() && frame.now.shadows.is_some_and(|shadows| shadows.plane.is_some());
    if falls { frame.clouds.iter().map(|cloud| cloud.sprites.len() as u64).sum::<u64>() * CASTER_BYTES } else { 0 }
}

fn sprites_of(clouds: &[PlacedCloud]) -> u64 {
    clouds.iter().map(|cloud| cloud.sprites.all().len() as u64).sum()
}

/// Of what the air makes of each sprite; nothing of a scene without weather.
fn bytes_of_stirs(frame: &Frame<'_>) -> u64 {
    if frame.now.air().is_some() { sprites_of(frame.clouds) * STIR_BYTES } else { 0 }
}
