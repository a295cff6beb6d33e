//! A model of sprites that all stand where a file has them.
//!
//! Sprites of one box number share a box, as its hand-placed ones, each with its own size, turn and tile. Where a sprite's
//! size or turn is a range, it shares a box with those of the same ranges, from which one is drawn. Nothing is culled.

use crate::property::{Number, SPRITE_SIZE};
use crate::scene::{
    BoxId, Category, CloudBox, CloudModel, ColorLevels, CullRadius, GroupId, GroupLight, IdCounter, ModelId,
    ShadingGroup, SpriteEdit,
};
use glam::DVec3;
use rustc_hash::FxHashMap;

/// What a sprite's sides may be.
pub(super) const SIZE_M: Number = SPRITE_SIZE;

/// No box is smaller: a place in it is a share of its size.
const LEAST_BOX_M: f64 = 1.0;
/// More sprites in one lump look flat (W).
const CROWD: f64 = 30.0;
const MOST_LUMPS: f64 = 16.0;

/// A sprite as a file has it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HandSprite {
    /// Metres in the model's space.
    pub(super) position: DVec3,
    /// From, to, metres.
    pub(super) width: [f64; 2],
    /// From, to, metres.
    pub(super) height: [f64; 2],
    /// From, to.
    pub(super) rotation_deg: [f64; 2],
    /// 0 to 15, row by row.
    pub(super) tile: u8,
    /// Sprites of one number share a box.
    pub(super) box_number: i64,
    /// Sprites of one number share a shading group; none: they fall into lumps of their box.
    pub(super) group: Option<i64>,
}

/// What a model is made of.
#[derive(Debug)]
pub(super) struct Hand<'a> {
    /// For people.
    pub(super) name: &'a str,
    /// At least one.
    pub(super) sprites: &'a [HandSprite],
    /// Ambient light over the height.
    pub(super) color_levels: ColorLevels,
}

/// A box number, and the ranges if there are any.
type Key = (i64, Option<[u64; 6]>);

impl HandSprite {
    fn spans(&self) -> [[f64; 2]; 3] {
        [self.width, self.height, self.rotation_deg]
    }

    fn key(&self) -> Key {
        let is_one = self.spans().iter().all(|[from, to]| from == to);
        let [[a, b], [c, d], [e, f]] = self.spans();
        (self.box_number, (!is_one).then(|| [a, b, c, d, e, f].map(f64::to_bits)))
    }
}

impl Hand<'_> {
    /// The model, whose ids count from 1.
    pub(super) fn model(&self) -> CloudModel {
        let mut ids = IdCounter::default();
        let id = ModelId::new(&mut ids);
        let mut model = CloudModel::new(id, self.name, Category::CumulusCongestus);
        model.cull_radius = CullRadius::Metres(0.0);
        model.color_levels = self.color_levels;
        let mut groups: FxHashMap<i64, GroupId> = FxHashMap::default();
        let mut order: FxHashMap<Key, usize> = FxHashMap::default();
        let mut boxes: Vec<Vec<&HandSprite>> = Vec::new();
        for sprite in self.sprites {
            if let Some(number) = sprite.group {
                groups.entry(number).or_insert_with(|| {
                    let id = GroupId::new(&mut ids);
                    let name = format!("shading {number}");
                    model.groups.push(ShadingGroup { id, name, light: GroupLight::default() });
                    id
                });
            }
            let at = *order.entry(sprite.key()).or_insert_with(|| {
                boxes.push(Vec::new());
                boxes.len() - 1
            });
            boxes[at].push(sprite);
        }
        model.boxes = boxes.iter().map(|sprites| cloud_box(BoxId::new(&mut ids), sprites, &groups)).collect();
        model
    }
}

fn cloud_box(id: BoxId, sprites: &[&HandSprite], groups: &FxHashMap<i64, GroupId>) -> CloudBox {
    let places = || sprites.iter().map(|sprite| sprite.position);
    let low = places().fold(DVec3::INFINITY, DVec3::min);
    let high = places().fold(DVec3::NEG_INFINITY, DVec3::max);
    let size = (high - low).max(DVec3::splat(LEAST_BOX_M));
    let center = 0.5 * (low + high);
    let span = |of: fn(&HandSprite) -> [f64; 2]| {
        let spans = sprites.iter().map(|sprite| of(sprite));
        spans.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], [a, b]| [from.min(a), to.max(b)])
    };
    let (number, ranges) = sprites.first().map_or((0, None), |sprite| sprite.key());
    let first_group = sprites.first().and_then(|sprite| sprite.group);
    let shared = first_group.filter(|_| sprites.iter().all(|sprite| sprite.group == first_group));
    let group_of = |number: Option<i64>| number.and_then(|number| groups.get(&number).copied());
    let edit = |(index, sprite): (usize, &&HandSprite)| SpriteEdit {
        moved: Some((sprite.position - center) / size),
        width: ranges.is_none().then_some(sprite.width[0]),
        height: ranges.is_none().then_some(sprite.height[0]),
        rotation_deg: ranges.is_none().then_some(sprite.rotation_deg[0]),
        tile: Some(sprite.tile.into()),
        group: if shared.is_some() { None } else { group_of(sprite.group) },
        ..SpriteEdit::new(index as u32)
    };
    let mut new = CloudBox::new(id, center);
    new.name = format!("box {number}");
    new.size = size;
    new.sprite_count = sprites.len() as u32;
    new.width = span(|sprite| sprite.width);
    new.height = span(|sprite| sprite.height);
    new.rotation_deg = span(|sprite| sprite.rotation_deg);
    new.group = group_of(shared);
    if first_group.is_none() {
        new.lumps = lumps(size, sprites.len());
    }
    new.sprite_edits = sprites.iter().enumerate().map(edit).collect();
    new
}

/// Nearly cubes with about as many sprites as make a lump.
fn lumps(size: DVec3, count: usize) -> [u32; 3] {
    let side = libm::cbrt(size.element_product() * CROWD / (count.max(1) as f64));
    size.to_array().map(|extent| (extent / side).round().clamp(1.0, MOST_LUMPS) as u32)
}
