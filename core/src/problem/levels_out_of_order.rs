//! Colour levels stand lowest first; two at one height are a step and allowed.

use super::Problem;
use super::scope::Scope;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    for (i, model) in scope.models() {
        for (j, pair) in model.color_levels.windows(2).enumerate() {
            let (below, height) = (pair[0].height, pair[1].height);
            if height < below {
                problems.push(Problem::error(
                    format!("models[{i}].color_levels[{}].height", j + 1),
                    format!("{height} lies below the level before it, at {below}"),
                    "put the levels in rising order of their heights",
                ));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn refuses() {
        let mut scene = sound_scene();
        scene.models[0].color_levels[2].height = 0.01;
        assert_found(&scene, "models[0].color_levels[2].height", "below");
    }
}
