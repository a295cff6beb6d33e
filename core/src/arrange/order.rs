//! Another order of a list: things taken out of it and put before another one of it, or at its end.

use super::{Arrangement, Plan};
use crate::document::{Edit, ListEdit};
// The types that the rows name.
use crate::scene::*;
use std::collections::BTreeSet;

/// Puts those of `things` that are of the kind of the last of them, and for boxes of its model, before `before`; at the end
/// if that is none or not among its kind. They keep their order among themselves. Nothing if they stand there already.
pub fn moved(scene: &Scene, things: &[Thing], before: Option<Thing>) -> Arrangement {
    let plan = Plan::new(scene);
    let (Some(last), chosen) = (things.last(), things.iter().copied().collect::<BTreeSet<_>>()) else {
        return plan.done();
    };
    let list = list_of(scene, *last);
    let (moving, staying): (Vec<Thing>, Vec<Thing>) = list.iter().partition(|thing| chosen.contains(thing));
    // Dropped on one that moves too, they come before the next that stays.
    let from = before.and_then(|before| list.iter().position(|thing| *thing == before)).unwrap_or(list.len());
    let before = list.iter().skip(from).find(|thing| !chosen.contains(thing));
    let at = before.and_then(|before| staying.iter().position(|thing| thing == before)).unwrap_or(staying.len());
    let mut wanted = staying;
    wanted.splice(at..at, moving.iter().copied());
    if wanted == list {
        return plan.done();
    }
    let mut plan = plan;
    plan.edits.extend(moving.iter().filter_map(|thing| Edit::removing(*thing)));
    plan.edits.extend(moving.iter().enumerate().filter_map(|(index, thing)| put(scene, *thing, at + index)));
    plan.made = moving;
    plan.done()
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        /// All of the list that `thing` stands in.
        pub fn list_of(scene: &Scene, thing: Thing) -> Vec<Thing> {
            match thing {
                $(Thing::$Kind(_) => scene.$list.iter().map(|value| Thing::$Kind(value.id)).collect(),)*
                Thing::Box(id, _) => {
                    let boxes = scene.model(id).map(|model| &model.boxes).into_iter().flatten();
                    boxes.map(|each| Thing::Box(id, each.id)).collect()
                }
                Thing::Group(id, _) => {
                    let groups = scene.model(id).map(|model| &model.groups).into_iter().flatten();
                    groups.map(|group| Thing::Group(id, group.id)).collect()
                }
                Thing::Sprite(..) => Vec::new(),
            }
        }

        /// Puts `thing` as it is at that position.
        fn put(scene: &Scene, thing: Thing, at: usize) -> Option<Edit> {
            Some(match thing {
                $(Thing::$Kind(id) => Edit::$Kind(ListEdit::Insert { at, value: scene.$list.with_id(id)?.clone() }),)*
                Thing::Box(model, id) => {
                    let value = scene.model(model)?.boxes.with_id(id)?.clone();
                    Edit::Box(model, ListEdit::Insert { at, value })
                }
                Thing::Group(model, id) => {
                    let value = scene.model(model)?.groups.with_id(id)?.clone();
                    Edit::Group(model, ListEdit::Insert { at, value })
                }
                Thing::Sprite(..) => return None,
            })
        }
    };
}
kinds!(lists);

#[cfg(test)]
mod tests {
    use super::super::duplicate::{self, Copy};
    use super::super::test_scenes::{applied, two_clouds};
    use super::*;
    use glam::DVec3;

    #[test]
    fn things_come_before_another_in_their_order() {
        let scene = two_clouds();
        let ids: Vec<CloudId> = scene.clouds.iter().map(|cloud| cloud.id).collect();
        let scene = applied(&scene, &duplicate::clouds(&scene, &ids, DVec3::X * 9000.0, Copy::Linked));
        let all: Vec<Thing> = scene.clouds.iter().map(|cloud| Thing::Cloud(cloud.id)).collect();
        // Which move, before which, and what comes of it.
        let cases: [(&[usize], Option<usize>, [usize; 4]); 6] = [
            (&[3], Some(0), [3, 0, 1, 2]),
            (&[2, 0], None, [1, 3, 0, 2]),
            (&[0], Some(2), [1, 0, 2, 3]),
            (&[1, 2], Some(2), [0, 1, 2, 3]),
            (&[0, 2], Some(2), [1, 0, 2, 3]),
            (&[3], None, [0, 1, 2, 3]),
        ];
        for (moving, before, wanted) in cases {
            let moving: Vec<Thing> = moving.iter().map(|at| all[*at]).collect();
            let after = applied(&scene, &moved(&scene, &moving, before.map(|at| all[at])));
            let got = list_of(&after, all[0]);
            assert_eq!(got, wanted.map(|at| all[at]), "{moving:?} before {before:?}");
        }
        let model = &scene.models[0];
        let boxes = list_of(&scene, Thing::Box(model.id, BoxId(0)));
        let after = applied(&scene, &moved(&scene, &[all[0], boxes[2]], Some(boxes[0])));
        assert_eq!(after.models[0].boxes[0].id, model.boxes[2].id);
        assert_eq!(list_of(&after, all[0]), all, "things of other kinds stay");
        assert_eq!(moved(&scene, &[], None), Arrangement::default());
    }
}
