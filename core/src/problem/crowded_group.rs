//! More than 30 sprites shaded as one lump look flat (W): mentioned, not refused.

use super::Problem;
use crate::scene::{CloudId, Scene};
use crate::sprites::PlacedCloud;
use std::collections::{BTreeMap, BTreeSet};

const CROWD: usize = 30;

pub(super) fn check(scene: &Scene, clouds: &[PlacedCloud], problems: &mut Vec<Problem>) {
    let placed_of: BTreeMap<CloudId, &PlacedCloud> = clouds.iter().map(|placed| (placed.id, placed)).collect();
    let mut told = BTreeSet::new();
    for (i, cloud) in scene.clouds.iter().enumerate() {
        // A model that is placed often is mentioned once.
        if !told.insert((cloud.model, cloud.seed)) {
            continue;
        }
        let Some(placed) = placed_of.get(&cloud.id) else { continue };
        for group in placed.groups.iter().filter(|group| group.sprite_count > CROWD) {
            problems.push(Problem::note(
                format!("clouds[{i}]"),
                format!("shading group {} has {} sprites", group.key, group.sprite_count),
                format!("up to {CROWD} read as one lump; split the box with “lumps”, or use more groups"),
            ));
        }
    }
}
