//! Kinds of things whose properties are in the table, and the way from a thing to what is in it.

use super::owner::Owner;
use super::row::Row;
use std::fmt::Arguments;

/// A kind of thing whose properties are in the table.
pub trait Described: Sized + 'static {
    /// Its rows, in the order in which they are shown; a heading may stand between two lists.
    const TABLES: &'static [&'static [Row<Self>]];

    /// All of its rows.
    fn rows() -> impl Iterator<Item = &'static Row<Self>> {
        Self::TABLES.iter().copied().flatten()
    }

    /// Enters what is in it and has properties of its own.
    fn enter_parts(&self, owner: Owner, place: Arguments<'_>, visitor: &mut impl Visitor) {
        let _ = (owner, place, visitor);
    }
}

/// Is shown one thing after the other.
pub trait Visitor {
    /// Whether to show `owner`, and what is in it.
    fn enters(&mut self, owner: Owner) -> bool {
        let _ = owner;
        true
    }

    /// `thing` has the properties of `owner`, and stands in the file at `place` (empty for the scene itself).
    fn thing<T: Described>(&mut self, owner: Owner, place: Arguments<'_>, thing: &T);
}

/// Shows `visitor` `thing` and what is in it, if it enters there.
pub(crate) fn enter<T: Described>(owner: Owner, place: Arguments<'_>, thing: &T, visitor: &mut impl Visitor) {
    if visitor.enters(owner) {
        visitor.thing(owner, place, thing);
        thing.enter_parts(owner, place, visitor);
    }
}
