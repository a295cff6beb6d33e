//! The way to one owner of a scene, to change it.

use super::described::Described;
use super::owner::Owner;
use crate::scene::{Scene, Thing, kinds};

/// What is to be done with an owner.
pub trait Change {
    /// To `thing`.
    fn thing<T: Described>(&mut self, thing: &mut T);
}

/// Does `change` to `owner` in `scene`, if it is there. A copy of the scene shares what is not changed.
pub fn change(scene: &mut Scene, owner: Owner, change: &mut impl Change) -> bool {
    macro_rules! reach {
        ($thing:expr) => {
            if let Some(thing) = $thing {
                change.thing(thing);
                return true;
            }
        };
    }
    match owner {
        Owner::Scene => reach!(Some(scene)),
        Owner::Site => reach!(Some(&mut scene.site)),
        Owner::Sun => reach!(Some(&mut scene.sun)),
        Owner::Sky => reach!(Some(&mut scene.sky)),
        Owner::Weather => reach!(Some(&mut scene.weather)),
        Owner::AmbientKey(i) => reach!(scene.sky.ambient.keys.get_mut(i)),
        Owner::DirectionalKey(i) => reach!(scene.sky.directional.keys.get_mut(i)),
        Owner::Ground => reach!(&mut scene.ground),
        Owner::Level(id, i) => reach!(scene.models.with_id_mut(id).and_then(|model| model.color_levels.get_mut(i))),
        Owner::Key(id, i) => reach!(scene.paths.with_id_mut(id).and_then(|path| path.keys.get_mut(i))),
        Owner::Thing(thing) => return change_thing(scene, thing, change),
    }
    false
}

macro_rules! things {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        fn change_thing(scene: &mut Scene, thing: Thing, change: &mut impl Change) -> bool {
            match thing {
                $(Thing::$Kind(id) => {
                    if let Some(thing) = scene.$list.with_id_mut(id) {
                        change.thing(thing);
                        return true;
                    }
                })*
                Thing::Box(of, id) => {
                    if let Some(each) = scene.models.with_id_mut(of).and_then(|model| model.boxes.with_id_mut(id)) {
                        change.thing(each);
                        return true;
                    }
                }
                Thing::Group(of, id) => {
                    if let Some(group) = scene.models.with_id_mut(of).and_then(|model| model.groups.with_id_mut(id)) {
                        change.thing(group);
                        return true;
                    }
                }
                Thing::Sprite(..) => {}
            }
            false
        }
    };
}
kinds!(things);
