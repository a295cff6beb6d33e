//! Every number must be one, and within the range of its property.
//!
//! NaN and infinities would spread through every sum; numbers beyond the ranges would overflow f32 or ask for more
//! memory than there is. Places are put into words only where something is wrong: a drag asks at every step.

use super::Problem;
use super::scope::Scope;
use crate::change::Change;
use crate::property::{Described, Number, Owner, Visitor, enter, walk};
use crate::scene::Scene;
use std::fmt::Arguments;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    walk(scope.scene, &mut Check { scope, problems });
}

/// Of `thing` by itself, and of what is in it.
pub(super) fn check_new<T: Described>(owner: Owner, place: &str, thing: &T, problems: &mut Vec<Problem>) {
    let (scene, change) = (Scene::default(), Change::everything());
    let scope = Scope { scene: &scene, change: &change };
    enter(owner, format_args!("{place}"), thing, &mut Check { scope, problems });
}

struct Check<'a> {
    scope: Scope<'a>,
    problems: &'a mut Vec<Problem>,
}

impl Visitor for Check<'_> {
    fn enters(&mut self, owner: Owner) -> bool {
        self.scope.has(owner)
    }

    fn thing<T: Described>(&mut self, _: Owner, place: Arguments<'_>, thing: &T) {
        // Two loops cost less than one through both.
        for rows in T::TABLES {
            for row in *rows {
                row.check(thing, |part, number, value| {
                    self.problems.push(fault(row.property.place(place, part), number, value));
                });
            }
        }
    }
}

fn fault(place: String, number: &Number, value: f64) -> Problem {
    let Number { min, max, unit, doc, .. } = number;
    let space = if unit.is_empty() { "" } else { " " };
    Problem::error(place, format!("{value} is out of range"), format!("use {min} to {max}{space}{unit}. {doc}"))
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, scene_with_flight};
    use crate::scene::{Formation, Scene};

    #[test]
    fn refuses() {
        type Break = fn(&mut Scene);
        let cases: [(Break, &str); 11] = [
            (|s| s.time_of_day_h = 24.0, "time_of_day_h"),
            (|s| s.clouds[0].position.y = f64::INFINITY, "clouds[0].position.y"),
            (|s| s.models[0].boxes[0].width[1] = -1.0, "models[0].boxes[0].width[1]"),
            (|s| s.models[0].color_levels[2].color.rgb.g = f32::NAN, "models[0].color_levels[2].color.g"),
            (|s| s.models[0].boxes[0].sprite_count = 1_000_000_000, "models[0].boxes[0].sprite_count"),
            (|s| s.sky.inside_density = -0.1, "sky.inside_density"),
            (
                |s| s.clouds[0].formation = Some(Formation { threshold: 0.0, ..Formation::default() }),
                "clouds[0].formation.threshold",
            ),
            (
                |s| s.clouds[0].formation = Some(Formation { core_s: f64::NAN, ..Formation::default() }),
                "clouds[0].formation.core_s",
            ),
            (|s| s.paths[0].keys[1].position.z = 1e9, "paths[0].keys[1].position.z"),
            (|s| s.paths[0].keys[1].time_s = 1e5, "paths[0].keys[1].time_s"),
            (|s| s.aircraft[0].scale = 0.0, "aircraft[0].scale"),
        ];
        for (break_it, place) in cases {
            let mut scene = scene_with_flight();
            break_it(&mut scene);
            assert_found(&scene, place, "");
        }
    }
}
