//! A table over the day has at least one key, its hours rise, and no two keys share an hour: which of two values
//! holds there could not be said.

use super::Problem;
use super::scope::Scope;
use crate::scene::DailyTable;

pub(super) fn check(Scope { scene, change }: Scope<'_>, problems: &mut Vec<Problem>) {
    if change.touches_head() {
        check_table("sky.ambient", &scene.sky.ambient, problems);
        check_table("sky.directional", &scene.sky.directional, problems);
    }
}

fn check_table<T>(place: &str, table: &DailyTable<T>, problems: &mut Vec<Problem>) {
    if table.keys.is_empty() {
        problems.push(Problem::error(place, "the table is empty", "give it at least one key; one key holds all day"));
    }
    for (i, pair) in table.keys.windows(2).enumerate() {
        let (before, hour) = (pair[0].hour, pair[1].hour);
        if hour == before {
            problems.push(Problem::error(
                format!("{place}[{}].hour", i + 1),
                format!("two keys stand at {hour} h"),
                "take one away, or move it by a minute (0.0167 h)",
            ));
        } else if hour < before {
            problems.push(Problem::error(
                format!("{place}[{}].hour", i + 1),
                format!("{hour} h comes after {before} h"),
                "put the keys in rising order of their hours",
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
        scene.sky.ambient.keys.clear();
        scene.sky.directional.keys[1].hour = scene.sky.directional.keys[0].hour;
        scene.sky.directional.keys[3].hour = 0.5;
        assert_found(&scene, "sky.ambient", "empty");
        assert_found(&scene, "sky.directional[1].hour", "two keys");
        assert_found(&scene, "sky.directional[3].hour", "comes after");
    }
}
