//! A box's turn is a unit quaternion: another one would shear or scale the box, or make nothing of it.

use super::Problem;
use super::scope::Scope;
use crate::scene::CloudBox;
use std::fmt::Arguments;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    for (i, model) in scope.models() {
        for (j, cloud_box) in model.boxes.iter().enumerate() {
            check_box(format_args!("models[{i}].boxes[{j}]"), cloud_box, problems);
        }
    }
}

pub(super) fn check_box(place: Arguments<'_>, cloud_box: &CloudBox, problems: &mut Vec<Problem>) {
    let turn = cloud_box.orientation;
    if (turn.length() - 1.0).abs() > 1e-6 || !turn.is_finite() {
        let [x, y, z, w] = turn.to_array();
        problems.push(Problem::error(
            format!("{place}.orientation"),
            format!("[{x}, {y}, {z}, {w}] is no rotation"),
            "a unit quaternion x, y, z, w; [0, 0, 0, 1] for none",
        ));
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn refuses() {
        for factor in [2.0, 0.0, f64::NAN] {
            let mut scene = sound_scene();
            scene.models[0].boxes[0].orientation *= factor;
            assert_found(&scene, "models[0].boxes[0].orientation", "no rotation");
        }
    }
}
