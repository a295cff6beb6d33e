//! A bound on what one scene may ask for: memory must not depend on a slip of the pen.

use super::Problem;
use super::scope::Scope;
use crate::scene::{CloudModel, ModelId};
use std::collections::BTreeMap;

/// Sprites tried in all clouds together: some 2 GB at the worst, with all of them on the screen.
pub const MAX_SPRITES_TRIED: u64 = 4_000_000;

pub(super) fn check(Scope { scene, change }: Scope<'_>, problems: &mut Vec<Problem>) {
    if !change.touches_models() && !change.touches_clouds() {
        return;
    }
    let of_model = |model: &CloudModel| model.boxes.iter().map(|b| u64::from(b.sprite_count)).sum::<u64>();
    let counts: BTreeMap<ModelId, u64> = scene.models.iter().map(|model| (model.id, of_model(model))).collect();
    let tried: u64 =
        scene.clouds.iter().filter_map(|cloud| counts.get(&cloud.model)).copied().fold(0, u64::saturating_add);
    if tried > MAX_SPRITES_TRIED {
        problems.push(Problem::error(
            "clouds",
            format!("the clouds together ask for {tried} sprites"),
            format!("stay within {MAX_SPRITES_TRIED}: lower sprite_count in the boxes, or place fewer clouds"),
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn refuses() {
        let mut scene = sound_scene();
        scene.models[0].boxes[0].sprite_count = 1_000_000;
        for i in 0..5 {
            let mut cloud = scene.clouds[0].clone();
            cloud.id.0 = 100 + i;
            scene.clouds.push(cloud);
        }
        assert_found(&scene, "clouds", "6000000 sprites");
    }
}
