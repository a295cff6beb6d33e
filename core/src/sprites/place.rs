//! A cloud's copy of its model's sprites, in the world.
//!
//! Positions are kept in f32 relative to the cloud's own f64 position: a cloud 1,000 km from the origin is as sharp as
//! one at the origin.

use super::candidates::middle;
use super::stir::{Stir, Stirs, Within};
use super::{Bake, Candidate, Casts, CastsOnce, Merging, PopulatedModel, Sprite, Sprites};
use crate::baked::Baked;
use crate::scene::{
    BoxId, Category, Cloud, CloudId, CloudModel, ColorLevels, GroupCenter, GroupId, GroupLight, level_color,
};
use crate::watch::Watch;
use glam::{DQuat, DVec3, Vec3};
use rustc_hash::{FxHashMap, FxHashSet};
use std::fmt;
use std::sync::Arc;

/// What makes sprites a group.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum GroupKey {
    /// A named group of the model's.
    Named(GroupId),
    /// A lump of a box of one or more.
    Lump(BoxId, u32),
}

impl fmt::Display for GroupKey {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Named(id) => write!(f, "group-{id}"),
            Self::Lump(id, lump) => write!(f, "box-{id}.{lump}"),
        }
    }
}

/// A shading group with its centre.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Group {
    /// Which group.
    pub key: GroupKey,
    /// Metres, relative to the cloud's `origin`.
    pub center: Vec3,
    /// Share of the directional light away from the sun, across, and towards it.
    pub c: [f32; 3],
    /// How many sprites it has.
    pub sprite_count: usize,
}

/// How a model is lit besides by its groups, 0 to 1 each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SoftLight {
    /// The share of the sun's light that goes by how much cloud it comes through.
    pub self_shadow: f32,
    /// How much the sun shines through thin cloud before it.
    pub halo: f32,
}

impl SoftLight {
    /// As `model` has it.
    pub fn of(model: &CloudModel) -> Self {
        Self { self_shadow: model.self_shadow as f32, halo: model.halo as f32 }
    }

    /// Whether there is none of it.
    pub fn is_none(self) -> bool {
        self.self_shadow <= 0.0 && self.halo <= 0.0
    }
}

/// A cloud ready to be drawn. Copies share their sprites and groups.
#[derive(Debug, Clone, PartialEq)]
pub struct PlacedCloud {
    /// Its id.
    pub id: CloudId,
    /// For people.
    pub name: String,
    /// Its model's category.
    pub category: Category,
    /// Where its sprites' positions count from, metres in the world: amid them.
    pub origin: DVec3,
    /// What was tried, before culling.
    pub candidate_count: usize,
    /// In the order of boxes and indices.
    pub sprites: Sprites,
    /// Which of them its merged sprites stand for.
    pub merging: Arc<Merging>,
    /// In the order of their first sprite.
    pub groups: Arc<[Group]>,
    /// Centre of the bounding box of the sprites' centres, relative to `origin`, metres.
    pub center: Vec3,
    /// Half that box's diagonal, metres.
    pub radius: f32,
    /// Radius of a sphere around `center` that holds every quad, metres.
    pub reach: f32,
    /// The largest radius of a sprite, metres.
    pub largest: f32,
    /// Lowest y of the sprites' spheres, relative to `origin`, metres.
    pub bottom: f32,
    /// Highest y of the sprites' spheres, relative to `origin`, metres.
    pub top: f32,
    /// Ambient light over the height.
    pub color_levels: ColorLevels,
    /// What was placed.
    pub cloud: Arc<Cloud>,
    /// The seed under which its sprites were strewn.
    pub seed: u64,
    /// How it is lit besides by its groups.
    pub soft_light: SoftLight,
    /// Sine and cosine of the turn about the vertical from its model's space.
    pub heading: [f32; 2],
    /// What is baked of its model, if that is lit so.
    pub(crate) bake: Option<Bake>,
    /// What the air makes of its sprites, made when first asked for.
    pub(crate) stirs: Stirs,
    /// What it casts shadows with, made when first asked for.
    pub(crate) casts: CastsOnce,
}

impl PlacedCloud {
    /// How far a point is from the centre, in radii; 0 in a cloud without extent.
    pub fn radii_of(&self, point: Vec3) -> f32 {
        if self.radius > 0.0 { point.distance(self.center) / self.radius } else { 0.0 }
    }

    /// The light that is left of the sun's at its sprites, as far as it is known; none if the cloud is not lit by it.
    pub fn baked(&self) -> Option<&Baked> {
        self.bake.as_ref()?.known()
    }

    /// What it casts shadows with.
    pub fn casts(&self) -> &Casts {
        let opacity =
            |sprite: &Sprite| level_color(&self.color_levels, self.height_of(sprite.position.y)).a.clamp(0.0, 1.0);
        self.casts.get_or_make(|| Casts::new(&self.sprites, opacity))
    }

    /// What the air makes of each sprite, in their order; of a merged one, what it makes of the foremost it stands for.
    pub fn stirs(&self) -> &[Stir] {
        self.stirs.get_or_make(|| {
            let (low, high) = bounds(self.sprites.iter().map(|sprite| sprite.position));
            let half = ((high - low) * 0.5).max(Vec3::splat(1e-3));
            let of = |sprite: &Sprite| {
                let off = sprite.position - self.center;
                Within {
                    box_id: sprite.box_id,
                    index: sprite.index,
                    tile: sprite.tile,
                    squareness: sprite.width.min(sprite.height) / sprite.width.max(sprite.height),
                    radii: self.radii_of(sprite.position),
                    from_base: Vec3::new(off.x / half.x, 0.5 + 0.5 * off.y / half.y, off.z / half.z),
                    from_center: off / self.radius.max(1e-3),
                }
            };
            let own = Stir::of_cloud(self.sprites.iter().map(of), self.seed);
            let merged = self.merging.merged.iter().filter_map(|merged| own.get(merged.foremost as usize));
            own.iter().chain(merged).copied().collect()
        })
    }

    /// Height of a point within the cloud, 0 at its bottom, 1 at its top, clamped; 0 in a cloud without height.
    pub fn height_of(&self, y: f32) -> f32 {
        let extent = self.top - self.bottom;
        if extent > 0.0 { ((y - self.bottom) / extent).clamp(0.0, 1.0) } else { 0.0 }
    }
}

/// Puts `populated`, which comes from `model`, where `cloud` stands.
///
/// With a ground (its world altitude in metres), sprites whose quads would cut it are lifted until they stand on it;
/// hand-moved ones stay where they are.
pub fn place(
    cloud: &Arc<Cloud>,
    model: &CloudModel,
    populated: &PopulatedModel,
    ground_altitude_m: Option<f64>,
) -> PlacedCloud {
    place_watched(cloud, model, populated, ground_altitude_m, &Watch::default())
}

/// The same under a watch; some sprites are missing if that is cancelled.
pub(crate) fn place_watched(
    cloud: &Arc<Cloud>,
    model: &CloudModel,
    populated: &PopulatedModel,
    ground_altitude_m: Option<f64>,
    watch: &Watch,
) -> PlacedCloud {
    let space = Space::of(cloud, populated);
    let lowest = ground_altitude_m.map(|altitude| (altitude - space.origin.y) as f32);

    let named_groups: FxHashSet<GroupId> = model.groups.iter().map(|group| group.id).collect();
    let mut group_of_key: FxHashMap<GroupKey, u32> = FxHashMap::default();
    let mut keys: Vec<GroupKey> = Vec::new();
    let merged = populated.merging.merged.iter().map(|merged| &merged.sprite);
    let all: Arc<[Sprite]> = watch
        .along(super::PLACING, &populated.sprites)
        .chain(merged)
        .zip(0..)
        .map(|(candidate, at)| {
            let key = key_of(candidate, &named_groups);
            let group = *group_of_key.entry(key).or_insert_with(|| {
                keys.push(key);
                (keys.len() - 1) as u32
            });
            let mut sprite = Sprite {
                position: space.in_world(candidate.position).as_vec3(),
                width: (candidate.width * cloud.scale) as f32,
                height: (candidate.height * cloud.scale) as f32,
                rotation: candidate.rotation as f32,
                tile: candidate.tile,
                group,
                box_id: candidate.box_id,
                index: candidate.index,
            };
            if let Some(lowest) = lowest.filter(|_| !candidate.moved) {
                sprite.position.y = sprite.position.y.max(lowest + below(&sprite, at < populated.sprites.len()));
            }
            sprite
        })
        .collect();
    let sprites = Sprites::with_merged(all, populated.sprites.len());

    let (low, high) = bounds(sprites.iter().map(|s| s.position));
    let center = (low + high) * 0.5;
    let radius = (high - low).length() * 0.5;
    let groups = groups(&keys, &sprites, model, center, &space);
    PlacedCloud {
        id: cloud.id,
        name: cloud.name.clone(),
        category: model.category,
        origin: space.origin,
        candidate_count: populated.candidate_count,
        bottom: sprites.iter().map(|s| s.position.y - s.radius()).reduce(f32::min).unwrap_or(0.0),
        top: sprites.iter().map(|s| s.position.y + s.radius()).reduce(f32::max).unwrap_or(0.0),
        radius,
        largest: sprites.iter().map(Sprite::radius).fold(0.0, f32::max),
        reach: radius + sprites.iter().map(Sprite::reach).fold(0.0, f32::max),
        center,
        groups,
        sprites,
        merging: Arc::clone(&populated.merging),
        color_levels: model.color_levels,
        cloud: Arc::clone(cloud),
        seed: cloud.seed.unwrap_or(model.seed),
        soft_light: SoftLight::of(model),
        heading: space.sin_cos(),
        bake: None,
        stirs: Stirs::default(),
        casts: CastsOnce::default(),
    }
}

/// What `placed` becomes with the place, light, colours, name and formation that `cloud` and `model` have now, of which the
/// first two cost something if they are others than before. The sprites stay, so they must be those that `cloud` would be
/// given; [`stand_alike`] tells.
pub(crate) fn dress(
    placed: &PlacedCloud,
    cloud: &Arc<Cloud>,
    (model, populated): (&CloudModel, &PopulatedModel),
    [keeps_place, keeps_light]: [bool; 2],
) -> PlacedCloud {
    let space = || Space::of(cloud, populated);
    let groups = if keeps_light {
        Arc::clone(&placed.groups)
    } else {
        let keys: Vec<GroupKey> = placed.groups.iter().map(|group| group.key).collect();
        groups(&keys, &placed.sprites, model, placed.center, &space())
    };
    PlacedCloud {
        origin: if keeps_place { placed.origin } else { space().origin },
        groups,
        name: cloud.name.clone(),
        color_levels: model.color_levels,
        soft_light: SoftLight::of(model),
        cloud: Arc::clone(cloud),
        casts: if model.color_levels == placed.color_levels { placed.casts.clone() } else { CastsOnce::default() },
        ..placed.clone()
    }
}

/// How far above a ground a sprite stands at least, metres. A merged one, which is seen from afar, may be wide and is not
/// turned on end.
fn below(sprite: &Sprite, is_own: bool) -> f32 {
    if is_own { sprite.reach() } else { 0.5 * sprite.height }
}

/// Whether `placed`, which stands as `before` did on a ground, would be given the same sprites as `after`, which differs
/// from that in its place alone: at one height above the ground it is, and wherever the ground lifts none of them.
pub(crate) fn stand_alike(
    placed: &PlacedCloud,
    (before, ground_before_m): (&Cloud, Option<f64>),
    (after, ground_after_m): (&Cloud, Option<f64>),
) -> bool {
    // What comes as near as this to the ground counts as lifted: sums are rounded.
    const NEAR_M: f64 = 0.1;
    if (before.position.y, ground_before_m) == (after.position.y, ground_after_m) {
        return true;
    }
    let bottom = |(sprite, at): (&Sprite, usize)| sprite.position.y - below(sprite, at < placed.sprites.len());
    let lowest = placed.sprites.all().iter().zip(0..).map(bottom).fold(f32::MAX, f32::min);
    let hovers = |origin_y: f64, ground_m: Option<f64>| {
        ground_m.is_none_or(|ground_m| ground_m - origin_y < f64::from(lowest) - NEAR_M)
    };
    hovers(placed.origin.y, ground_before_m)
        && hovers(placed.origin.y + (after.position.y - before.position.y), ground_after_m)
}

/// From a model's space to a cloud's: along the world's axes, from the middle of the sprites, wherever in its model the
/// artist built them.
struct Space {
    turn: DQuat,
    scale: f64,
    middle: DVec3,
    /// Where that middle lies in the world.
    origin: DVec3,
}

impl Space {
    fn of(cloud: &Cloud, populated: &PopulatedModel) -> Self {
        let (turn, scale) = (heading_turn(cloud.heading_deg), cloud.scale);
        let middle = middle(&populated.sprites);
        Self { turn, scale, middle, origin: cloud.position + turn * (middle * scale) }
    }

    fn sin_cos(&self) -> [f32; 2] {
        let east = self.turn * DVec3::X;
        [-east.z as f32, east.x as f32]
    }

    fn in_world(&self, point: DVec3) -> DVec3 {
        self.turn * ((point - self.middle) * self.scale)
    }
}

/// Clockwise from north as seen from above is a negative turn about +y.
pub(crate) fn heading_turn(heading_deg: f64) -> DQuat {
    let half = -heading_deg.to_radians() * 0.5;
    DQuat::from_xyzw(0.0, libm::sin(half), 0.0, libm::cos(half))
}

fn key_of(candidate: &Candidate, named_groups: &FxHashSet<GroupId>) -> GroupKey {
    match candidate.group.filter(|id| named_groups.contains(id)) {
        Some(id) => GroupKey::Named(id),
        None => GroupKey::Lump(candidate.box_id, candidate.lump),
    }
}

fn bounds(points: impl Iterator<Item = Vec3>) -> (Vec3, Vec3) {
    points.map(|p| (p, p)).reduce(|(low, high), (p, _)| (low.min(p), high.max(p))).unwrap_or_default()
}

fn groups(
    keys: &[GroupKey],
    sprites: &[Sprite],
    model: &CloudModel,
    cloud_center: Vec3,
    space: &Space,
) -> Arc<[Group]> {
    let mut sums = vec![(DVec3::ZERO, 0_usize); keys.len()];
    for sprite in sprites {
        let (sum, count) = &mut sums[sprite.group as usize];
        *sum += sprite.position.as_dvec3();
        *count += 1;
    }
    let named: FxHashMap<GroupId, GroupLight> = model.groups.iter().map(|group| (group.id, group.light)).collect();
    let own: FxHashMap<BoxId, GroupLight> = model.boxes.iter().map(|each| (each.id, each.light)).collect();
    let light_of = |key: GroupKey| -> GroupLight {
        match key {
            GroupKey::Named(id) => named.get(&id),
            GroupKey::Lump(id, _) => own.get(&id),
        }
        .copied()
        .unwrap_or_default()
    };
    keys.iter()
        .zip(sums)
        .map(|(&key, (sum, sprite_count))| {
            let light = light_of(key);
            let mean = (sum / sprite_count as f64).as_vec3();
            let center = match light.center {
                GroupCenter::Mean => mean,
                GroupCenter::Pulled(share) => mean.lerp(cloud_center, share as f32),
                GroupCenter::At(point) => space.in_world(point).as_vec3(),
            };
            Group { key, center, c: [light.c_min, light.c_med, light.c_max].map(|c| c as f32), sprite_count }
        })
        .collect()
}
