//! Tints of shading groups: the same in the list, on boxes and on sprites. Those of folders are chosen by hand.
//!
//! A tint belongs to an id, so a group keeps it whatever comes and goes beside it. Hues step by the golden angle, which
//! sets ids that follow one another far apart; three lightnesses tell those apart whose hues come near. The circle is
//! OKLCH's (Ottosson 2020), so that no tint is louder than the rest, on the dark panel and on the light one.

use super::mix;
use cloudwright_core::color::srgb_from_linear;
use cloudwright_core::scene::Folder;
use cloudwright_core::sprites::{GroupKey, PlacedCloud};
use egui::Color32;
use std::f32::consts::TAU;

const CHROMA: f32 = 0.125;
const LIGHTNESSES: [f32; 3] = [0.74, 0.64, 0.82];
const GOLDEN_TURN: f64 = 0.618_033_988_749_894_9;

/// The tint of the group or box with that id.
pub(crate) fn group_tint(id: u64) -> Color32 {
    let hue = (id as f64 * GOLDEN_TURN).fract() as f32 * TAU;
    from_oklch(LIGHTNESSES[(id % 3) as usize], CHROMA, hue)
}

/// A group's tint. The lumps of one box have the box's, every other one a shade darker.
pub(crate) fn tint_of(key: GroupKey) -> Color32 {
    match key {
        GroupKey::Named(id) => group_tint(id.0),
        GroupKey::Lump(id, lump) if lump % 2 == 1 => mix(group_tint(id.0), Color32::BLACK, 0.25),
        GroupKey::Lump(id, _) => group_tint(id.0),
    }
}

/// What a folder's clouds are marked with.
pub(crate) fn of_folder(folder: &Folder) -> Color32 {
    let [r, g, b] =
        folder.color.to_array().map(|linear| (srgb_from_linear(linear.clamp(0.0, 1.0)) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

/// The tints of a cloud's groups, in their order: a sprite's is `tints(cloud)[sprite.group as usize]`.
pub(crate) fn tints(placed: &PlacedCloud) -> Vec<Color32> {
    placed.groups.iter().map(|group| tint_of(group.key)).collect()
}

fn from_oklch(lightness: f32, chroma: f32, hue: f32) -> Color32 {
    let (a, b) = (chroma * hue.cos(), chroma * hue.sin());
    let l = (lightness + 0.396_337_78 * a + 0.215_803_76 * b).powi(3);
    let m = (lightness - 0.105_561_346 * a - 0.063_854_17 * b).powi(3);
    let s = (lightness - 0.089_484_18 * a - 1.291_485_5 * b).powi(3);
    let [r, g, b] = [
        4.076_741_7 * l - 3.307_711_6 * m + 0.230_969_94 * s,
        -1.268_438 * l + 2.609_757_4 * m - 0.341_319_38 * s,
        -0.004_196_086_3 * l - 0.703_418_6 * m + 1.707_614_7 * s,
    ]
    .map(|linear| (srgb_from_linear(linear.clamp(0.0, 1.0)) * 255.0).round() as u8);
    Color32::from_rgb(r, g, b)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::{BoxId, GroupId};

    #[test]
    fn neighbours_differ_and_lumps_are_of_one_kind() {
        let distance = |a: Color32, b: Color32| (0..3).map(|i| u32::from(a[i].abs_diff(b[i]))).sum::<u32>();
        for id in 0..60 {
            for other in id + 1..id + 12 {
                assert!(distance(group_tint(id), group_tint(other)) > 24, "{id} and {other}");
            }
        }
        let (named, lump) = (GroupKey::Named(GroupId(7)), |lump| GroupKey::Lump(BoxId(7), lump));
        assert_eq!(tint_of(named), tint_of(lump(0)));
        assert_eq!(tint_of(lump(0)), tint_of(lump(2)));
        assert_ne!(tint_of(lump(0)), tint_of(lump(1)));
    }
}
