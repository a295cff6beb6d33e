//! Ids: one counter for the whole scene, a type for each kind of thing, never given twice within one history of edits.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::fmt;

/// The next id to give. Part of the document, so that undo brings it back too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct IdCounter(pub u64);

impl Default for IdCounter {
    fn default() -> Self {
        Self(1)
    }
}

impl IdCounter {
    fn take(&mut self) -> u64 {
        let id = self.0;
        self.0 = self.0.saturating_add(1);
        id
    }
}

/// A thing that stands in one of the scene's lists under an id of its own.
pub trait HasId: Clone + PartialEq {
    /// Its kind of id.
    type Id: Copy + Eq + Ord + fmt::Debug + fmt::Display + Into<u64>;
    /// Its id.
    fn id(&self) -> Self::Id;
}

macro_rules! ids {
    ($($(#[$meta:meta])* $name:ident;)*) => {$(
        $(#[$meta])*
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
        #[serde(transparent)]
        pub struct $name(pub u64);

        impl $name {
            /// The next free id.
            pub fn new(counter: &mut IdCounter) -> Self {
                Self(counter.take())
            }
        }

        impl From<$name> for u64 {
            fn from(id: $name) -> Self {
                id.0
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                self.0.fmt(f)
            }
        }
    )*};
}
ids! {
    /// A box within a model.
    BoxId;
    /// A shading group that several boxes of a model share.
    GroupId;
}

macro_rules! ids_of_kinds {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        ids! { $($(#[$doc])* $Id;)* }
    };
}
super::kinds!(ids_of_kinds);
