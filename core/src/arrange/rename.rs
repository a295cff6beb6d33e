//! Other names for things, one or many at once.
//!
//! Of many, the names come from a pattern: `#` stands for a running number, `##` for one of at least two figures, and `*`
//! for the old name. A pattern without `#` has the number behind it, so that no two are alike.

use super::{Arrangement, Plan};
use crate::document::{Edit, ListEdit};
use crate::scene::{InScene, Scene, Thing};

/// Calls `thing` so. Nothing if it is called so already, or has no name.
pub fn one(scene: &Scene, thing: Thing, name: &str) -> Arrangement {
    all(scene, [(thing, name.into())])
}

/// Calls `things` by the pattern, in their order, counting from `first`.
pub fn many(scene: &Scene, things: &[Thing], pattern: &str, first: u64) -> Arrangement {
    let old = things.iter().filter_map(|thing| Some((*thing, name_of(scene, *thing)?)));
    let new = old.zip(first..).map(|((thing, old), number)| (thing, by_pattern(pattern, old, number)));
    all(scene, new.collect::<Vec<_>>())
}

/// What a thing is called; none if it is not there, or has no name.
pub fn name_of(scene: &Scene, thing: Thing) -> Option<&str> {
    match thing {
        Thing::Box(model, id) => Some(scene.model(model)?.boxes.with_id(id)?.name.as_str()),
        Thing::Group(model, id) => Some(scene.model(model)?.groups.with_id(id)?.name.as_str()),
        // A track is called by what it moves.
        Thing::Sprite(..) | Thing::Track(_) => None,
        listed => listed.listed(scene).map(InScene::name),
    }
}

/// A name by the pattern.
pub fn by_pattern(pattern: &str, old: &str, number: u64) -> String {
    let mut name = String::new();
    let mut rest = pattern;
    while let Some(next) = rest.chars().next() {
        match next {
            '#' => {
                let after = rest.trim_start_matches('#');
                let width = rest.len() - after.len();
                name += &format!("{number:0width$}");
                rest = after;
                continue;
            }
            '*' => name += old,
            other => name.push(other),
        }
        rest = &rest[next.len_utf8()..];
    }
    if pattern.contains('#') { name } else { format!("{name} {number}").trim_start().into() }
}

fn all(scene: &Scene, names: impl IntoIterator<Item = (Thing, String)>) -> Arrangement {
    let mut plan = Plan::new(scene);
    for (thing, name) in names {
        if name_of(scene, thing).is_none_or(|old| old == name) {
            continue;
        }
        plan.edits.extend(renamed(scene, thing, name));
        plan.made.push(thing);
    }
    plan.done()
}

fn renamed(scene: &Scene, thing: Thing, name: String) -> Option<Edit> {
    Some(match thing {
        Thing::Box(model, id) => {
            let mut value = scene.model(model)?.boxes.with_id(id)?.clone();
            value.name = name;
            Edit::Box(model, ListEdit::Replace(value))
        }
        Thing::Group(model, id) => {
            let mut value = scene.model(model)?.groups.with_id(id)?.clone();
            value.name = name;
            Edit::Group(model, ListEdit::Replace(value))
        }
        listed => {
            let mut edit = Edit::replacing(scene, listed)?;
            *edit.value_mut()?.name_mut() = name;
            edit
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, two_clouds};
    use super::*;

    #[test]
    fn patterns() {
        for (pattern, number, name) in [
            ("heap #", 7, "heap 7"),
            ("heap ###", 7, "heap 007"),
            ("#", 1234, "1234"),
            ("*-##", 7, "old-07"),
            ("heap", 7, "heap 7"),
            ("*", 7, "old 7"),
            ("", 7, "7"),
            ("##ü#*", 7, "07ü7old"),
        ] {
            assert_eq!(by_pattern(pattern, "old", number), name, "{pattern}");
        }
    }

    #[test]
    fn all_kinds_that_have_names_are_renamed() {
        let scene = two_clouds();
        let model = &scene.models[0];
        let things = [
            Thing::Cloud(scene.clouds[1].id),
            Thing::Model(model.id),
            Thing::Box(model.id, model.boxes[0].id),
            Thing::Group(model.id, model.groups[0].id),
            Thing::Sprite(model.id, model.boxes[0].id, 3),
            Thing::Cloud(scene.clouds[0].id),
        ];
        let arrangement = many(&scene, &things, "x #", 1);
        let after = applied(&scene, &arrangement);
        assert_eq!(arrangement.made.len(), 5, "sprites have no names, and no number");
        let names = [0, 1, 2, 3, 5].map(|at| name_of(&after, things[at]).expect("a name"));
        assert_eq!(names, ["x 1", "x 2", "x 3", "x 4", "x 5"]);
        assert_eq!(one(&scene, things[1], &model.name), Arrangement::default(), "it is called so");
    }
}
