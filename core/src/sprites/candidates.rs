//! The sprites that are tried: uniform in each box, every number keyed by (seed, box, index).

use crate::random::{draw, unit};
use crate::scene::{BoxId, CloudBox, CloudModel, CullRadius, GroupId, SpriteEdit};
use crate::watch::Watch;
use glam::DVec3;
use rustc_hash::FxHashMap;

/// A sprite in its model's space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Candidate {
    /// Its box.
    pub box_id: BoxId,
    /// Its number within the box; part of its random numbers' key.
    pub index: u32,
    /// Centre, metres in the model's space.
    pub position: DVec3,
    /// Metres.
    pub width: f64,
    /// Metres.
    pub height: f64,
    /// Radians, counter-clockwise as seen.
    pub rotation: f64,
    /// 0 to 15, row by row.
    pub tile: u8,
    /// Moved by hand: comes first in the cull and is never dropped.
    pub moved: bool,
    /// The group that the artist put it or its box into.
    pub group: Option<GroupId>,
    /// Which of its box's lumps it lies in; 0 for a box of one lump.
    pub lump: u32,
}

impl Candidate {
    /// Half the longer side (MODEL §2's sprite radius), metres.
    pub fn radius(&self) -> f64 {
        self.width.max(self.height) * 0.5
    }
}

/// All candidates of a model, box by box in order of index, those dropped by hand left out.
pub fn candidates(model: &CloudModel, seed: u64) -> Vec<Candidate> {
    candidates_watched(model, seed, &Watch::default())
}

pub(super) fn candidates_watched(model: &CloudModel, seed: u64, watch: &Watch) -> Vec<Candidate> {
    let mut all = Vec::with_capacity(model.boxes.iter().map(|b| b.sprite_count as usize).sum());
    for cloud_box in &model.boxes {
        let weights = cloud_box.category.unwrap_or(model.category).tile_weights();
        let edits: FxHashMap<u32, &SpriteEdit> = cloud_box.sprite_edits.iter().map(|edit| (edit.index, edit)).collect();
        all.extend(watch.along(super::DRAWING, 0..cloud_box.sprite_count).filter_map(|index| {
            let edit = if edits.is_empty() { None } else { edits.get(&index).copied() };
            (!edit.is_some_and(|e| e.dropped)).then(|| candidate(cloud_box, seed, index, &weights, edit))
        }));
    }
    all
}

/// The middle of the box around their centres, metres in the model's space.
pub(super) fn middle(candidates: &[Candidate]) -> DVec3 {
    let ends =
        candidates.iter().map(|c| (c.position, c.position)).reduce(|(low, high), (p, _)| (low.min(p), high.max(p)));
    ends.map_or(DVec3::ZERO, |(low, high)| (low + high) * 0.5)
}

fn candidate(cloud_box: &CloudBox, seed: u64, index: u32, weights: &[u32; 16], edit: Option<&SpriteEdit>) -> Candidate {
    let (seed, key) = cloud_box.random_key(seed);
    let [x, y, z, size] = draw(seed, key, index, 0);
    let [turn, tile, _, _] = draw(seed, key, index, 1);
    let moved = edit.and_then(|e| e.moved);
    let in_box = moved.unwrap_or(DVec3::new(unit(x) - 0.5, unit(y) - 0.5, unit(z) - 0.5));
    let within = |range: [f64; 2], bits: u32| range[0] + (range[1] - range[0]) * unit(bits);
    Candidate {
        box_id: cloud_box.id,
        index,
        position: cloud_box.center + cloud_box.orientation * (cloud_box.size * in_box),
        width: edit.and_then(|e| e.width).unwrap_or_else(|| within(cloud_box.width, size)),
        height: edit.and_then(|e| e.height).unwrap_or_else(|| within(cloud_box.height, size)),
        rotation: edit
            .and_then(|e| e.rotation_deg)
            .unwrap_or_else(|| within(cloud_box.rotation_deg, turn))
            .to_radians(),
        tile: edit.and_then(|e| e.tile).map_or_else(|| choose_tile(weights, tile), |tile| tile.min(15) as u8),
        moved: moved.is_some(),
        group: edit.and_then(|e| e.group).or(cloud_box.group),
        lump: lump(in_box, cloud_box.lumps),
    }
}

/// The tile under `bits` when the sixteen weights are laid end to end over the 32-bit numbers.
fn choose_tile(weights: &[u32; 16], bits: u32) -> u8 {
    let total: u64 = weights.iter().copied().map(u64::from).sum();
    let mut point = (u64::from(bits) * total) >> 32;
    for (tile, &weight) in weights.iter().enumerate() {
        if point < u64::from(weight) {
            return tile as u8;
        }
        point -= u64::from(weight);
    }
    15
}

fn lump(in_box: DVec3, lumps: [u32; 3]) -> u32 {
    let along =
        |coordinate: f64, count: u32| (((coordinate + 0.5) * f64::from(count)) as u32).min(count.saturating_sub(1));
    let [nx, ny, nz] = lumps;
    (along(in_box.y, ny) * nz + along(in_box.z, nz)) * nx + along(in_box.x, nx)
}

/// Each candidate's own cull radius, metres in the model's space.
///
/// The cloud's height, where the radius is a share of it, is that of the candidates' spheres: the kept ones are not
/// known yet.
pub fn cull_radii(cull_radius: CullRadius, candidates: &[Candidate]) -> Vec<f64> {
    match cull_radius {
        CullRadius::Metres(metres) => vec![metres; candidates.len()],
        CullRadius::SpriteFraction(share) => candidates.iter().map(|c| share * c.width.min(c.height)).collect(),
        CullRadius::CloudHeightFraction(share) => {
            let bottom = candidates.iter().map(|c| c.position.y - c.radius()).fold(f64::INFINITY, f64::min);
            let top = candidates.iter().map(|c| c.position.y + c.radius()).fold(f64::NEG_INFINITY, f64::max);
            vec![share * (top - bottom).max(0.0); candidates.len()]
        }
    }
}
