//! How densely a box is filled with sprites, and how large they are for it: what stays when the box is resized.
//!
//! A cube of any size is filled by thirty sprites of a third to a half of its side; what is flat or long by more of the
//! size that a cube of its volume would have, up to the hundred that a box usually has at most (Wang 2004, section 3.1),
//! and by larger ones where those would leave gaps. Density and sprite size are measured against that.

use crate::property::{BOX_SIZE, SPRITE_SIZE};
use crate::scene::CloudBox;
use glam::DVec3;

/// So many sprites in a cube; more in what is flat or long, up to what a box usually has at the most (W).
const SPRITES: [f64; 2] = [30.0, 100.0];
/// So many sprites read as one lump (W).
const LUMP: u32 = 30;
/// Range of the sprites' sides, of the cell that each has.
const SPRITE_SHARE: [f64; 2] = [0.3, 0.5];
/// No box is asked for more sprites by its density.
const MOST_SPRITES: f64 = 1e5;

/// The box with the sprites that fill it.
pub fn filled(each: &CloudBox) -> CloudBox {
    let cell_m = cell(each.size);
    let side = SPRITE_SHARE.map(|share| sprite_side(cell_m * share));
    let sprite_count = usual_count(each.size).round() as u32;
    CloudBox { sprite_count, width: side, height: side, lumps: lumps(each.size, sprite_count), ..each.clone() }
}

/// How many times as many sprites the box has as one that is filled.
pub fn density(each: &CloudBox) -> f64 {
    f64::from(each.sprite_count) / usual_count(each.size)
}

/// How many times as large its sprites are as those of a box that is filled.
pub fn sprite_size(each: &CloudBox) -> f64 {
    let mean = (each.width[0] + each.width[1] + each.height[0] + each.height[1]) / 4.0;
    mean / (cell(each.size) * (SPRITE_SHARE[0] + SPRITE_SHARE[1]) / 2.0)
}

/// The box with as many times the usual sprites.
pub fn with_density(each: &CloudBox, density: f64) -> CloudBox {
    let sprite_count = (usual_count(each.size) * density).round().clamp(0.0, MOST_SPRITES) as u32;
    with_count(each, each.size, sprite_count)
}

/// The box with sprites so many times as large as usual; their proportions stay.
pub fn with_sprite_size(each: &CloudBox, size: f64) -> CloudBox {
    let by = size / sprite_size(each);
    if by.is_finite() && by > 0.0 { grown(each, by) } else { each.clone() }
}

/// The box in another size, as densely filled as before, with sprites as large for it. A box that keeps its size, or has
/// none, is left alone.
pub fn resized(each: &CloudBox, size: DVec3) -> CloudBox {
    let resized = CloudBox { size, ..each.clone() };
    let by = cell(size) / cell(each.size);
    if size == each.size || !(by.is_finite() && by > 0.0) {
        return resized;
    }
    let density = density(each);
    let sprite_count = (usual_count(size) * density).round().clamp(f64::from(each.sprite_count.min(1)), MOST_SPRITES);
    with_count(&grown(&resized, by), each.size, sprite_count as u32)
}

/// Another number of sprites; lumps that were the usual ones of a box of `old_size` stay so.
fn with_count(each: &CloudBox, old_size: DVec3, sprite_count: u32) -> CloudBox {
    let usual = each.lumps == lumps(old_size, each.sprite_count);
    let lumps = if usual { lumps(each.size, sprite_count) } else { each.lumps };
    CloudBox { sprite_count, lumps, ..each.clone() }
}

fn grown(each: &CloudBox, by: f64) -> CloudBox {
    let sides = |sides: [f64; 2]| sides.map(|side| sprite_side(side * by));
    CloudBox { width: sides(each.width), height: sides(each.height), ..each.clone() }
}

/// Within the range that sprites have; short, unless it is tiny.
fn sprite_side(side: f64) -> f64 {
    let side = side.clamp(SPRITE_SIZE.min, SPRITE_SIZE.max);
    if side > 10.0 { (side * 10.0).round() / 10.0 } else { side }
}

/// How many sprites fill a box of that size.
fn usual_count(size: DVec3) -> f64 {
    let sides = sorted(size);
    let cube = volume(sides).cbrt();
    let spread: f64 = sides.map(|side| (side / cube).max(1.0)).into_iter().product();
    (SPRITES[0] * spread).clamp(SPRITES[0], SPRITES[1])
}

/// The side of what a sprite has for itself, metres: that of a cube of the box's volume; more where the most sprites would
/// leave gaps, over its largest face or along its longest side.
fn cell(size: DVec3) -> f64 {
    let sides = sorted(size);
    let [_, middle, long] = sides;
    volume(sides).cbrt().max((middle * long).sqrt() * 0.4).max(long * 0.125)
}

fn volume([short, middle, long]: [f64; 3]) -> f64 {
    short * middle * long
}

fn sorted(size: DVec3) -> [f64; 3] {
    let mut sides = size.to_array().map(|side| side.abs().clamp(BOX_SIZE.min.max(1e-9), BOX_SIZE.max));
    sides.sort_by(f64::total_cmp);
    sides
}

/// Into how many lumps of at most some thirty sprites a box falls, the longest pieces halved first.
fn lumps(size: DVec3, sprite_count: u32) -> [u32; 3] {
    const MOST: u32 = 16;
    let mut lumps = [1; 3];
    while lumps.iter().product::<u32>() * LUMP < sprite_count {
        let length = |axis: &usize| size[*axis] / f64::from(lumps[*axis]);
        let may_be_halved = (0..3).filter(|axis| lumps[*axis] < MOST);
        let Some(longest) = may_be_halved.max_by(|a, b| length(a).total_cmp(&length(b))) else { break };
        lumps[longest] += 1;
    }
    lumps
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::BoxId;

    fn filled_of(size: DVec3) -> CloudBox {
        filled(&CloudBox { size, ..CloudBox::new(BoxId(1), DVec3::ZERO) })
    }

    #[test]
    fn flat_boxes_get_more_sprites_than_cubes() {
        let cube = filled_of(DVec3::splat(500.0));
        assert_eq!((cube.sprite_count, cube.width), (30, [150.0, 250.0]), "as an added box has it");
        let flat = filled_of(DVec3::new(4000.0, 100.0, 4000.0));
        assert_eq!((flat.sprite_count, flat.lumps), (100, [2, 1, 2]));
        let wall = filled_of(DVec3::new(377.0, 232.0, 1.0));
        assert!(wall.width[0] > 30.0, "no dust: {:?}", wall.width);
        assert!(filled_of(DVec3::splat(1e-9)).width[0] >= SPRITE_SIZE.min);
    }

    #[test]
    fn a_filled_box_stays_filled_in_any_size_and_comes_back() {
        let start = filled_of(DVec3::splat(500.0));
        for size in [DVec3::new(5000.0, 500.0, 500.0), DVec3::new(500.0, 2500.0, 500.0), DVec3::new(40.0, 900.0, 7e4)] {
            let other = resized(&start, size);
            let wanted = filled_of(size);
            assert_eq!((other.sprite_count, other.lumps), (wanted.sprite_count, wanted.lumps), "{size}");
            assert!((other.width[1] - wanted.width[1]).abs() <= 0.1 + 1e-3 * wanted.width[1], "{size}");
            // Of the sprite's area along the box's largest face, so many times that: no gaps.
            let [_, middle, long] = sorted(size);
            let mean = (other.width[0] + other.width[1]) / 2.0;
            assert!(f64::from(other.sprite_count) * mean * mean > 0.9 * middle * long, "{size}");
            let back = resized(&other, start.size);
            assert_eq!((back.sprite_count, back.lumps), (start.sprite_count, start.lumps));
            assert!((back.width[1] - start.width[1]).abs() <= 0.5, "{:?}", back.width);
        }
        assert_eq!(resized(&start, start.size), start);
    }

    #[test]
    fn density_and_sprite_size_are_what_was_set() {
        let start = filled_of(DVec3::new(900.0, 300.0, 700.0));
        assert!((density(&start) - 1.0).abs() < 0.02 && (sprite_size(&start) - 1.0).abs() < 1e-3);
        let dense = with_density(&start, 3.0);
        assert!((density(&dense) - 3.0).abs() < 0.02 && dense.width == start.width);
        assert!(dense.lumps.iter().product::<u32>() * LUMP >= dense.sprite_count, "{:?}", dense.lumps);
        let large = with_sprite_size(&start, 1.5);
        assert!((sprite_size(&large) - 1.5).abs() < 1e-3 && large.sprite_count == start.sprite_count);
        let own_lumps = CloudBox { lumps: [5, 1, 1], ..start.clone() };
        assert_eq!(with_density(&own_lumps, 3.0).lumps, [5, 1, 1], "lumps set by hand stay");
        // No answer is out of range, whatever is asked.
        for odd in [0.0, -1.0, 1e300, f64::NAN, f64::INFINITY] {
            for each in [with_density(&start, odd), with_sprite_size(&start, odd), resized(&start, DVec3::splat(odd))] {
                assert!(each.width.iter().chain(&each.height).all(|side| SPRITE_SIZE.allows(*side)), "{odd}");
                assert!(f64::from(each.sprite_count) <= MOST_SPRITES);
            }
        }
    }
}
