//! What a picture would lose with each of its sprites.
//!
//! A fragment of premultiplied colour c and opacity α, with transmittance T before it and colour b behind it, adds
//! T·(c − α·b) to its pixel. Summed over a sprite's pixels that is the picture's change if this sprite alone is gone:
//! exact for one sprite drawn in sorted order, a first guess for many at once.
//!
//! A sprite that is gone also moves the centre of its shading group, and with it the light on all others. That part is
//! a guess from the start: it only says in which order sprites are tried.

use crate::color::{Premultiplied, Rgb};
use crate::draw_list::DrawSprite;
use crate::frame::Frame;
use crate::raster::bins::map_tiles;
use crate::raster::{ScreenSprite, prepare};
use crate::sky::Background;
use rustc_hash::FxHashMap;

/// Less than this gets through to what is behind: it shows nothing there.
const OPAQUE: f32 = 1e-4;

/// A group's light changes by this share of itself if its centre moves by a sprite's whole distance: tried on an overcast
/// sky and on single clouds, where none and 1 leave more sprites.
const MOVED: f32 = 0.2;

/// Of each sprite in the frame's list: the mean over all pixels of what the largest channel changes by without it, in
/// exposed linear light, what it does to its group's light included.
pub(super) fn losses(frame: &Frame<'_>) -> Vec<f32> {
    let own = added(frame);
    let sprite_of = |drawn: &DrawSprite| &frame.clouds[drawn.cloud as usize].sprites.all()[drawn.sprite as usize];
    let mut of_group: FxHashMap<(u32, u32), f32> = FxHashMap::default();
    for (drawn, loss) in frame.list.sprites.iter().zip(&own) {
        *of_group.entry((drawn.cloud, sprite_of(drawn).group)).or_default() += loss;
    }
    let with_group = |(drawn, loss): (&DrawSprite, f32)| {
        let sprite = sprite_of(drawn);
        let group = &frame.clouds[drawn.cloud as usize].groups[sprite.group as usize];
        let away = sprite.position.distance(group.center);
        let moved = away / (away + sprite.radius()) / (group.sprite_count as f32 - 1.0).max(1.0);
        loss + MOVED * moved * of_group[&(drawn.cloud, sprite.group)]
    };
    frame.list.sprites.iter().zip(own).map(with_group).collect()
}

/// What each sprite adds to the picture.
fn added(frame: &Frame<'_>) -> Vec<f32> {
    let (width, height) = (frame.view.width, frame.view.height);
    let (sprites, behind) = (prepare(frame), frame.behind());
    let tiles = map_tiles(&sprites, width, height, |rect, members| {
        let mut sums = vec![0.0; members.len()];
        let mut shown = Vec::new();
        for i in 0..rect.width * rect.height {
            let at = [rect.left + i % rect.width, rect.top + i / rect.width].map(|pixel| pixel as f32 + 0.5);
            add_pixel((frame, &behind), &sprites, (members, &mut sums), at, &mut shown);
        }
        members.iter().copied().zip(sums).collect()
    });
    let mut losses = vec![0.0; sprites.len()];
    for (sprite, sum) in tiles.into_iter().flat_map(|(_, sums)| sums) {
        losses[sprite as usize] += sum;
    }
    let scale = frame.now.exposure / (width as f32 * height as f32);
    losses.into_iter().map(|loss| loss * scale).collect()
}

/// What a sprite shows at a pixel.
struct Shown {
    /// Which of the tile's members.
    member: usize,
    fragment: Premultiplied,
    /// Transmittance of all that stands before it, the veil apart.
    before: f32,
}

/// Adds a pixel's changes to the `sums` of the tile's `members`, which stand nearest first.
fn add_pixel(
    (frame, behind): (&Frame<'_>, &Background),
    sprites: &[ScreenSprite],
    (members, sums): (&[u32], &mut [f32]),
    [x, y]: [f32; 2],
    shown: &mut Vec<Shown>,
) {
    shown.clear();
    let (mut through, mut before) = (1.0 - frame.veil.a, 1.0);
    for (member, &sprite) in members.iter().enumerate() {
        if through < OPAQUE {
            break;
        }
        let sprite = &sprites[sprite as usize];
        if let Some((fragment, _)) = sprite.fragment(frame.atlas, x, y, |_| sprite.mip) {
            shown.push(Shown { member, fragment, before });
            through *= 1.0 - fragment.a;
            before *= 1.0 - fragment.a;
        }
    }
    if shown.is_empty() {
        return;
    }
    let mut behind = behind.color(frame.view.ray(x, y), frame.view.pixel());
    for Shown { member, fragment, before } in shown.iter().rev() {
        let added = Rgb::new(fragment.r, fragment.g, fragment.b) + behind * -fragment.a;
        sums[*member] += before * (1.0 - frame.veil.a) * added.to_array().map(f32::abs).into_iter().fold(0.0, f32::max);
        behind = behind + added;
    }
}
