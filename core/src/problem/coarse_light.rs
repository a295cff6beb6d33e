//! Very many sprites of one model that shade each other do so from fewer directions: mentioned, not refused.

use super::Problem;
use crate::baked::MANY;
use crate::scene::Scene;
use crate::sprites::{PlacedCloud, SoftLight};

pub(super) fn check(scene: &Scene, clouds: &[PlacedCloud], problems: &mut Vec<Problem>) {
    for (i, model) in scene.models.iter().enumerate().filter(|(_, model)| !SoftLight::of(model).is_none()) {
        let of_model = clouds.iter().filter(|placed| placed.cloud.model == model.id);
        let most = of_model.map(|placed| placed.sprites.len()).max().unwrap_or(0);
        if most > MANY {
            problems.push(Problem::note(
                format!("models[{i}].self_shadow"),
                format!("{most} sprites take the light of five directions, and one for each whole sprite"),
                format!("up to {MANY} take it finely; use fewer, larger sprites, or set self_shadow and halo to 0"),
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{check_with_sprites, sound_scene};
    use super::*;
    use crate::derived::Derived;
    use crate::scene::CullRadius;

    #[test]
    fn mentions() {
        let mut scene = sound_scene();
        scene.clouds.truncate(1);
        scene.models[0].boxes[0].sprite_count = MANY as u32 + 1;
        scene.models[0].cull_radius = CullRadius::Metres(0.0);
        let found = |scene: &Scene| {
            let problems = check_with_sprites(scene, Derived::new(scene).clouds());
            problems.iter().any(|problem| problem.place == "models[0].self_shadow")
        };
        assert!(!found(&scene));
        scene.models[0].self_shadow = 0.5;
        assert!(found(&scene));
    }
}
