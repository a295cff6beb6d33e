//! From what a march found to bytes: the outline is feathered, openness becomes luminance,
//! and the clear texels are given the luminance of their neighbours.

use super::bleed::spread;
use super::blur::blur;
use super::noise::{clamp, mix, saturate, smoothstep};
use super::{TILE_SIZE, Texels};

/// Texels of alpha 0 around each tile, so that filters find nothing of a neighbour's.
const BORDER: usize = 2;

pub fn finish(tile: u32, texels: &Texels) -> Vec<u8> {
    let feather = feather_of(tile);
    let alpha = soften(&texels.alpha, feather);
    let luminance = tone(texels, tone_of(tile));
    let luminance = spread(&alpha, &luminance);
    let mut bytes = Vec::with_capacity(TILE_SIZE * TILE_SIZE * 4);
    for (&alpha, &luminance) in alpha.iter().zip(&luminance) {
        let grey = to_byte(luminance);
        bytes.extend_from_slice(&[grey, grey, grey, to_byte(alpha)]);
    }
    bytes
}

pub fn to_byte(value: f32) -> u8 {
    (saturate(value) * 255.0 + 0.5) as u8
}

/// How the openness of a tile becomes luminance.
#[derive(Clone, Copy)]
struct Tone {
    /// Grey of every thin edge and of the middle of the range: the same for all puffs, so that
    /// where they overlap no sprite is traced by a rim.
    middle: f32,
    darkest: f32,
    /// The span from crease to crown.
    contrast: f32,
}

fn tone_of(tile: u32) -> Tone {
    match tile {
        0..=2 => Tone { middle: 0.90, darkest: 0.8, contrast: 0.12 },
        // One tile makes whole rows of bases: what it shows, it shows again and again.
        3 => Tone { middle: 0.90, darkest: 0.7, contrast: 0.12 },
        4..=7 => Tone { middle: 0.90, darkest: 0.66, contrast: 0.22 },
        _ => Tone { middle: 0.90, darkest: 0.62, contrast: 0.25 },
    }
}

/// How many texels an outline takes to fade.
fn feather_of(tile: u32) -> usize {
    match tile {
        0..=2 => 0,
        3..=7 => 6,
        _ => 4,
    }
}

/// Thins what sticks out: the whole outline fades over the feather without losing its detail,
/// and nothing is left in the border.
fn soften(alpha: &[f32], feather: usize) -> Vec<f32> {
    let around = surroundings(alpha, feather);
    alpha
        .iter()
        .zip(&around)
        .enumerate()
        .map(|(texel, (&alpha, &around))| {
            let (column, row) = (texel % TILE_SIZE, texel / TILE_SIZE);
            let inset = column.min(row).min(TILE_SIZE - 1 - column).min(TILE_SIZE - 1 - row);
            let border = smoothstep(BORDER as f32 - 0.5, BORDER as f32 + 5.5, inset as f32);
            let thinned = if feather == 0 { 1.0 } else { mix(0.2, 0.99, smoothstep(0.05, 0.8, around)) };
            alpha * border * thinned
        })
        .collect()
}

/// The mean alpha around each texel.
fn surroundings(alpha: &[f32], radius: usize) -> Vec<f32> {
    blur(&vec![1.0; alpha.len()], alpha, radius)
}

/// Keeps of the openness what is neither speckle nor the roundness of the whole tile: the latter
/// would make each sprite a dark disc with a bright rim, and giving a cloud its form is the task
/// of the shading groups. Then stretches it, and draws thin edges to the middle grey.
fn tone(texels: &Texels, tone: Tone) -> Vec<f32> {
    let fine = blur(&texels.alpha, &texels.openness, 2);
    let broad = blur(&texels.alpha, &texels.openness, 15);
    let relief: Vec<f32> = fine.iter().zip(&broad).map(|(&f, &b)| f - 0.7 * b).collect();
    let recess = recess(texels);
    let around = surroundings(&texels.alpha, 4);
    let peak = around.iter().copied().fold(1e-3, f32::max);
    let mut solid: Vec<f32> =
        around.iter().zip(&relief).filter(|&(&around, _)| around > 0.8 * peak).map(|(_, &value)| value).collect();
    solid.sort_by(f32::total_cmp);
    let at = |hundredths: usize| {
        let index = solid.len() * hundredths / 100;
        solid.get(index).copied().unwrap_or(0.0)
    };
    let (median, range) = (at(50), (at(97) - at(3)).max(1e-3));
    around
        .iter()
        .zip(relief.iter().zip(&recess))
        .map(|(&around, (&value, &recess))| {
            let inside = smoothstep(0.45, 0.97, around / peak);
            let lift = ((value - median) / range + RECESS_SHARE * recess) * inside;
            // Crowns are broad and alike, creases narrow and deep; neither is cut off flat.
            let shown = if lift > 0.0 { lift / (1.0 + 1.6 * lift) } else { lift / (1.0 - 0.3 * lift) };
            clamp(tone.middle + tone.contrast * shown, tone.darkest, 1.0)
        })
        .collect()
}

/// How much the steps in depth count beside openness.
const RECESS_SHARE: f32 = 2.8;

/// Where a lobe passes before another, the one behind darkens along the edge: T. Luft et al.,
/// *Image Enhancement by Unsharp Masking the Depth Buffer*, SIGGRAPH 2006. Negative where recessed.
fn recess(texels: &Texels) -> Vec<f32> {
    let near = blur(&texels.alpha, &texels.nearness, 2);
    let around = blur(&texels.alpha, &texels.nearness, 6);
    near.iter().zip(&around).map(|(&near, &around)| clamp(near - around, -0.15, 0.06)).collect()
}
