//! What of the clouds a view's memory is about: which there are, where each stands, and its sprites.
//!
//! Colours, light and names are left out, so that a renamed or recoloured cloud is the same to whoever flies past it.
//! Sprites are told apart by where they are kept, and kept for as long as anyone remembers them.

use super::{PlacedCloud, Sprites};
use crate::scene::CloudId;
use glam::DVec3;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// The shapes of one state of the clouds; equal to its copies alone.
#[derive(Debug, Clone)]
pub struct Shapes(Arc<[Shape]>);

#[derive(Debug)]
struct Shape {
    id: CloudId,
    origin: DVec3,
    sprites: Sprites,
}

impl PartialEq for Shapes {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// Which of a state's clouds were in an earlier one, with the same sprites, and where in its list.
#[derive(Debug)]
pub(crate) enum Known {
    /// All, and no others, in the same order.
    All,
    /// By their index now.
    Some(Vec<Option<u32>>),
    /// There was no earlier state.
    None,
}

impl Shapes {
    pub(crate) fn of(clouds: &[PlacedCloud]) -> Self {
        let shape = |cloud: &PlacedCloud| Shape { id: cloud.id, origin: cloud.origin, sprites: cloud.sprites.clone() };
        Self(clouds.iter().map(shape).collect())
    }

    /// The same shapes if they are those of `clouds`, else those.
    pub(crate) fn or_of(&self, clouds: &[PlacedCloud]) -> Self {
        let are_same = self.0.len() == clouds.len()
            && self.0.iter().zip(clouds).all(|(shape, cloud)| {
                shape.id == cloud.id && shape.origin == cloud.origin && shape.sprites.are(&cloud.sprites)
            });
        if are_same { self.clone() } else { Self::of(clouds) }
    }

    /// Which of these clouds were in `before`. One that has been moved was.
    pub(crate) fn known_from(&self, before: Option<&Self>) -> Known {
        let Some(before) = before else { return Known::None };
        if self == before {
            return Known::All;
        }
        let old: FxHashMap<CloudId, (u32, &Shape)> =
            (0..).zip(&*before.0).map(|(index, shape)| (shape.id, (index, shape))).collect();
        let index = |shape: &Shape| {
            let (index, old) = old.get(&shape.id)?;
            old.sprites.are(&shape.sprites).then_some(*index)
        };
        Known::Some(self.0.iter().map(index).collect())
    }
}

impl Known {
    /// Where the cloud of that index was; none if it was not, or had other sprites.
    pub(crate) fn index(&self, now: u32) -> Option<u32> {
        match self {
            Self::All => Some(now),
            Self::Some(before) => before.get(now as usize).copied().flatten(),
            Self::None => None,
        }
    }
}
