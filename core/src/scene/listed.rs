//! Access to the scene's lists by kind.

// The types and ids that the rows name, with the rest of the room.
use super::*;

/// A kind of thing that stands in a list of the scene.
pub trait Listed: HasId + InScene + 'static {
    /// What one is called: "model".
    const WORD: &'static str;
    /// The same as a headline: "Cloud model".
    const TITLE: &'static str;
    /// The list's name in files: "models".
    const LIST: &'static str;
    /// What the history calls a change of its values: "Change model".
    const CHANGE: &'static str;

    /// All of them.
    fn list(scene: &Scene) -> &List<Self>;

    /// The one of that id, as something to choose.
    fn thing(id: Self::Id) -> Thing;

    /// The id of `thing`, if it is of this kind.
    fn id_of(thing: Thing) -> Option<Self::Id>;
}

/// Something to be done for each kind.
pub trait ForKind {
    /// For the kind `T`.
    fn kind<T: Listed>(&mut self);
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        $(impl Listed for $Value {
            const WORD: &'static str = $word;
            const TITLE: &'static str = $title;
            const LIST: &'static str = stringify!($list);
            const CHANGE: &'static str = concat!("Change ", $word);

            fn list(scene: &Scene) -> &List<Self> {
                &scene.$list
            }

            fn thing(id: $Id) -> Thing {
                Thing::$Kind(id)
            }

            fn id_of(thing: Thing) -> Option<$Id> {
                if let Thing::$Kind(id) = thing { Some(id) } else { None }
            }
        })*

        /// Does it for each kind, in the order of the rows.
        pub fn for_each_kind(action: &mut impl ForKind) {
            $(action.kind::<$Value>();)*
        }

        impl Thing {
            /// What it says of itself, if it is there and in a list of the scene.
            pub fn listed(self, scene: &Scene) -> Option<&dyn InScene> {
                match self {
                    $(Self::$Kind(id) => scene.$list.with_id(id).map(|value| value as _),)*
                    Self::Box(..) | Self::Group(..) | Self::Sprite(..) => None,
                }
            }

            /// Its id, and all of its kind that the scene has, with their list's name in files; none for parts of models.
            pub(crate) fn among(self, scene: &Scene) -> Option<(u64, &'static str, Vec<u64>)> {
                match self {
                    $(Self::$Kind(id) => {
                        Some((id.into(), stringify!($list), scene.$list.iter().map(|value| value.id.into()).collect()))
                    })*
                    Self::Box(..) | Self::Group(..) | Self::Sprite(..) => None,
                }
            }

        }
    };
}
kinds!(lists);

impl Thing {
    /// Whether the scene has it.
    pub fn is_in(self, scene: &Scene) -> bool {
        match self {
            Self::Box(model, id) => scene.model(model).is_some_and(|model| model.boxes.with_id(id).is_some()),
            Self::Sprite(model, id, index) => {
                let found = scene.model(model).and_then(|model| model.boxes.with_id(id));
                found.is_some_and(|each| index < each.sprite_count)
            }
            Self::Group(model, id) => scene.model(model).is_some_and(|model| model.groups.with_id(id).is_some()),
            listed => listed.listed(scene).is_some(),
        }
    }

    /// The model that it is, belongs to or hangs on; none for what is no part of clouds.
    pub fn model(self, scene: &Scene) -> Option<ModelId> {
        match self {
            Self::Model(id) | Self::Box(id, _) | Self::Sprite(id, ..) | Self::Group(id, _) => Some(id),
            listed => match listed.listed(scene)?.hangs_on()? {
                (_, Self::Model(id)) => Some(id),
                _ => None,
            },
        }
    }
}
