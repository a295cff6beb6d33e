//! A range's first number is its smaller one: a reversed range is mostly a slip of the pen.

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
    let ranges = [("width", cloud_box.width), ("height", cloud_box.height), ("rotation_deg", cloud_box.rotation_deg)];
    for (name, [from, to]) in ranges {
        if from > to {
            problems.push(Problem::error(
                format!("{place}.{name}"),
                format!("the range runs backwards, from {from} to {to}"),
                "write the smaller number first",
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};

    #[test]
    fn refuses() {
        let mut scene = sound_scene();
        scene.models[0].boxes[0].height = [9.0, 3.0];
        assert_found(&scene, "models[0].boxes[0].height", "backwards");
    }
}
