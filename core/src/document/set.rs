//! The edit that sets one property, by its address.

use super::{Edit, EditError, ListEdit};
use crate::property::{Address, Described, Owner, Refusal, Value};
// With the types that the rows of kinds name.
use crate::scene::*;

impl Edit {
    /// Gives the value at `address` another value.
    ///
    /// # Errors
    /// If it is not in the scene now, or `value` is of another kind or out of range.
    pub fn set(scene: &Scene, address: Address, value: &Value) -> Result<Self, EditError> {
        let set = Set { address, value };
        Ok(match address.owner {
            Owner::Scene => {
                let (name, time_of_day_h) = (scene.name.clone(), scene.time_of_day_h);
                let changed = set.whole(Some(&Scene { name, time_of_day_h, ..Scene::default() }))?;
                if changed.name == scene.name {
                    Self::TimeOfDay(changed.time_of_day_h)
                } else {
                    Self::Name(changed.name)
                }
            }
            Owner::Site => Self::Site(set.whole(Some(&scene.site))?),
            Owner::Sun => Self::Sun(set.whole(Some(&scene.sun))?),
            Owner::Sky => Self::Sky(set.whole(Some(&scene.sky))?),
            Owner::AmbientKey(i) => Self::Sky(set.part(Some(&scene.sky), |sky| sky.ambient.keys.get_mut(i))?),
            Owner::DirectionalKey(i) => Self::Sky(set.part(Some(&scene.sky), |sky| sky.directional.keys.get_mut(i))?),
            Owner::Weather => Self::Weather(set.whole(Some(&scene.weather))?),
            Owner::Ground => Self::Ground(Some(set.whole(scene.ground.as_ref())?)),
            Owner::Level(id, i) => {
                let model = set.part(scene.model(id), |model| model.color_levels.get_mut(i))?;
                Self::Model(ListEdit::Replace(model))
            }
            Owner::Thing(thing) => return set.thing(scene, thing),
            Owner::Key(id, i) => Self::Path(ListEdit::Replace(set.part(scene.path(id), |path| path.keys.get_mut(i))?)),
        })
    }
}

/// Something to be done for each kind of thing, whose values are in the table and can be set.
pub trait ForEditable {
    /// For the kind `T`.
    fn kind<T>(&mut self)
    where
        T: Listed + Described,
        Edit: From<ListEdit<T>>;
}

struct Set<'a> {
    address: Address,
    value: &'a Value,
}

impl Set<'_> {
    /// `thing` with the value set.
    fn whole<T: Described + Clone>(&self, thing: Option<&T>) -> Result<T, EditError> {
        self.part(thing, |thing| Some(thing))
    }

    /// `whole` with the value set in a part of it.
    fn part<W: Clone, T: Described>(
        &self,
        whole: Option<&W>,
        part: impl FnOnce(&mut W) -> Option<&mut T>,
    ) -> Result<W, EditError> {
        let refused = |refusal| EditError::Refused { address: self.address, refusal };
        let mut whole = whole.cloned().ok_or_else(|| refused(Refusal::NotThere))?;
        let thing = part(&mut whole).ok_or_else(|| refused(Refusal::NotThere))?;
        self.address.set_in(thing, self.value).map_err(refused)?;
        Ok(whole)
    }
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        impl Set<'_> {
            fn thing(&self, scene: &Scene, thing: Thing) -> Result<Edit, EditError> {
                let boxes = |model| scene.model(model).map(|model| &model.boxes);
                Ok(match thing {
                    $(Thing::$Kind(id) => Edit::$Kind(ListEdit::Replace(self.whole(scene.$list.with_id(id))?)),)*
                    Thing::Group(model, id) => {
                        let group = scene.model(model).and_then(|model| model.groups.with_id(id));
                        Edit::Group(model, ListEdit::Replace(self.whole(group)?))
                    }
                    Thing::Box(model, id) => {
                        let each = boxes(model).and_then(|boxes| boxes.with_id(id));
                        Edit::Box(model, ListEdit::Replace(self.whole(each)?))
                    }
                    Thing::Sprite(model, id, index) => {
                        let each = boxes(model).and_then(|boxes| boxes.with_id(id));
                        let edited = self.part(each, |each| each.sprite_edits.iter_mut().find(|edit| edit.index == index))?;
                        Edit::Box(model, ListEdit::Replace(edited))
                    }
                })
            }
        }

        $(impl From<ListEdit<$Value>> for Edit {
            fn from(edit: ListEdit<$Value>) -> Self {
                Self::$Kind(edit)
            }
        })*

        /// Does it for each kind, in the order of the rows.
        pub fn for_each_editable(action: &mut impl ForEditable) {
            $(action.kind::<$Value>();)*
        }
    };
}
kinds!(lists);
