//! What is fitted of a model: a brightness for each colour level, three shares at its bottom and its top, the self-shadow.
//!
//! Shares change evenly over the height, so lower groups may get less, as an artist would have it; each box's or group's
//! stand where its sprites do on average. Levels keep their hues, heights and opacities: only their brightness is set.

use crate::color::Rgb;
use crate::property::C_MAX;
use crate::scene::{CloudModel, ColorLevels, GroupLight};
use crate::sprites::{Group, GroupKey, PlacedCloud};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The light of a model, as far as it is fitted.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Values {
    /// Luminance of each colour level.
    pub levels: [f32; 5],
    /// Cmin, Cmed and Cmax at the bottom and at the top of the cloud.
    pub shares: [[f32; 3]; 2],
    /// 0 to 1.
    pub self_shadow: f32,
}

/// What takes the sun by shares of its own: a named group, or a box by the key of its first lump.
type Owner = GroupKey;

fn owner(key: GroupKey) -> Owner {
    match key {
        GroupKey::Lump(id, _) => GroupKey::Lump(id, 0),
        named @ GroupKey::Named(_) => named,
    }
}

/// How high each owner's sprites stand on average: 0 at the cloud's bottom, 1 at its top.
#[derive(Debug)]
pub(super) struct Heights(FxHashMap<Owner, f32>);

impl Heights {
    pub(super) fn of(cloud: &PlacedCloud) -> Self {
        let mut sums: FxHashMap<Owner, (f64, u32)> = FxHashMap::default();
        for sprite in cloud.sprites.iter() {
            let sum = sums.entry(owner(cloud.groups[sprite.group as usize].key)).or_default();
            *sum = (sum.0 + f64::from(cloud.height_of(sprite.position.y)), sum.1 + 1);
        }
        Self(sums.into_iter().map(|(owner, (sum, count))| (owner, (sum / f64::from(count)) as f32)).collect())
    }

    fn of_owner(&self, key: GroupKey) -> Option<f32> {
        self.0.get(&owner(key)).copied()
    }
}

impl Values {
    /// As `model`, of which `cloud` is placed, has them now: of all shares, the straight line over the height that is nearest
    /// to them, group by group as many sprites count.
    pub(super) fn now(model: &CloudModel, cloud: &PlacedCloud, heights: &Heights) -> Self {
        let mut sums = [0.0_f64; 3];
        let mut by_share = [[0.0_f64; 2]; 3];
        for group in cloud.groups.iter() {
            let Some(height) = heights.of_owner(group.key).map(f64::from) else { continue };
            let weight = group.sprite_count as f64;
            for (sum, power) in sums.iter_mut().zip([1.0, height, height * height]) {
                *sum += weight * power;
            }
            for ([flat, steep], share) in by_share.iter_mut().zip(group.c.map(f64::from)) {
                *flat += weight * share;
                *steep += weight * height * share;
            }
        }
        let [count, first, second] = sums;
        let spread = count * second - first * first;
        let line = |[flat, steep]: [f64; 2]| {
            // All at one height: the same share everywhere.
            let slope = if spread > 1e-6 * count * count { (count * steep - first * flat) / spread } else { 0.0 };
            let bottom = if count > 0.0 { (flat - slope * first) / count } else { 0.0 };
            [bottom as f32, (bottom + slope) as f32]
        };
        let lines = by_share.map(line);
        Self {
            levels: Self::levels_of(model),
            shares: [0, 1].map(|end| lines.map(|line| line[end])),
            self_shadow: model.self_shadow as f32,
        }
    }

    /// Luminance of each of a model's colour levels.
    pub(super) fn levels_of(model: &CloudModel) -> [f32; 5] {
        model.color_levels.map(|level| level.color.rgb.luminance())
    }

    /// `levels` as bright as these, in white.
    pub(super) fn grey(&self, mut levels: ColorLevels) -> ColorLevels {
        levels.iter_mut().zip(self.levels).for_each(|(level, bright)| level.color.rgb = Rgb::grey(bright));
        levels
    }

    /// The three shares at a height from 0 to 1.
    fn shares_at(&self, height: f32) -> [f32; 3] {
        let [bottom, top] = self.shares;
        std::array::from_fn(|share| bottom[share] + (top[share] - bottom[share]) * height)
    }

    /// The groups of `cloud` with these shares.
    pub(super) fn groups(&self, cloud: &PlacedCloud, heights: &Heights) -> Arc<[Group]> {
        let with_shares = |group: &Group| Group {
            c: heights.of_owner(group.key).map_or(group.c, |height| self.shares_at(height)),
            ..*group
        };
        cloud.groups.iter().map(with_shares).collect()
    }

    /// `levels` as bright as these: in the hues that they have, where they have one.
    pub(super) fn color_levels(&self, mut levels: ColorLevels) -> ColorLevels {
        for (level, bright) in levels.iter_mut().zip(self.levels) {
            let now = level.color.rgb.luminance();
            level.color.rgb = if now > 1e-6 { level.color.rgb * (bright / now) } else { Rgb::grey(bright) };
        }
        levels
    }

    /// Has `model` have these, as far as they are `free`, in thousandths. Shares of what shows no sprites stay.
    pub(super) fn write(&self, model: &mut CloudModel, heights: &Heights, free: Free) {
        if free.levels {
            model.color_levels = self.color_levels(model.color_levels);
            for level in &mut model.color_levels {
                let [r, g, b] = level.color.rgb.to_array().map(|channel| (channel * 1000.0).round() / 1000.0);
                level.color.rgb = Rgb::new(r, g, b);
            }
        }
        if free.shares {
            for at in 0..model.boxes.len() {
                let key = GroupKey::Lump(model.boxes[at].id, 0);
                if let Some(height) = heights.of_owner(key) {
                    self.write_shares(&mut model.boxes[at].light, height);
                }
            }
            for at in 0..model.groups.len() {
                if let Some(height) = heights.of_owner(GroupKey::Named(model.groups[at].id)) {
                    self.write_shares(&mut model.groups[at].light, height);
                }
            }
        }
        if free.self_shadow {
            model.self_shadow = thousandths(self.self_shadow).clamp(0.0, 1.0);
        }
    }

    fn write_shares(&self, light: &mut GroupLight, height: f32) {
        let [c_min, c_med, c_max] = self.shares_at(height).map(|share| thousandths(share).clamp(C_MAX.min, C_MAX.max));
        *light = GroupLight { c_min, c_med, c_max, ..*light };
    }
}

fn thousandths(value: f32) -> f64 {
    (f64::from(value) * 1000.0).round() / 1000.0
}

/// Which values are fitted; the others stay as the artist set them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Free {
    /// The brightness of the colour levels.
    pub levels: bool,
    /// Cmin, Cmed and Cmax.
    pub shares: bool,
    /// The self-shadow.
    pub self_shadow: bool,
}

impl Free {
    /// All of them.
    pub const ALL: Self = Self { levels: true, shares: true, self_shadow: true };

    /// Whether none is.
    pub fn is_none(self) -> bool {
        !(self.levels || self.shares || self.self_shadow)
    }
}
