//! A list of things under ids of their own, whose copies share what is equal in them.
//!
//! It reads as a vector does, and is one in files. Each thing is held once for all copies of the list until one of them
//! changes it ([`Arc::make_mut`]): so a scene is copied for the price of a pointer a thing, at each step of a drag.

use super::HasId;
use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::fmt;
use std::ops::{Index, IndexMut};
use std::sync::Arc;

/// Things in an order of the artist's.
#[derive(Clone)]
pub struct List<T>(Vec<Arc<T>>);

/// Through a list, first to last, to change.
pub type IterMut<'a, T> = std::iter::Map<std::slice::IterMut<'a, Arc<T>>, fn(&'a mut Arc<T>) -> &'a mut T>;

/// Through a list, first to last.
pub type Iter<'a, T> = std::iter::Map<std::slice::Iter<'a, Arc<T>>, fn(&'a Arc<T>) -> &'a T>;

impl<T> List<T> {
    /// Of nothing.
    pub const fn new() -> Self {
        Self(Vec::new())
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// First to last.
    pub fn iter(&self) -> Iter<'_, T> {
        self.0.iter().map(|shared| shared)
    }

    /// The one at that position.
    pub fn get(&self, at: usize) -> Option<&T> {
        self.0.get(at).map(|shared| &**shared)
    }

    /// The first.
    pub fn first(&self) -> Option<&T> {
        self.get(0)
    }

    /// The last.
    pub fn last(&self) -> Option<&T> {
        self.0.last().map(|shared| &**shared)
    }

    /// As they are held: to be kept without a copy.
    pub fn as_slice(&self) -> &[Arc<T>] {
        &self.0
    }

    /// Adds one at the end.
    pub fn push(&mut self, value: T) {
        self.0.push(Arc::new(value));
    }

    /// Puts one at a position.
    ///
    /// # Panics
    /// If `at` lies beyond the end, as a vector does.
    pub fn insert(&mut self, at: usize, value: T) {
        self.0.insert(at, Arc::new(value));
    }

    /// Takes out all.
    pub fn clear(&mut self) {
        self.0.clear();
    }

    /// Takes out those from that position on.
    pub fn truncate(&mut self, len: usize) {
        self.0.truncate(len);
    }

    /// Takes out those for which `keep` says no.
    pub fn retain(&mut self, mut keep: impl FnMut(&T) -> bool) {
        self.0.retain(|shared| keep(shared));
    }
}

impl<T: Clone> List<T> {
    /// First to last, to change: copies those that another list shares.
    pub fn iter_mut(&mut self) -> IterMut<'_, T> {
        self.0.iter_mut().map(Arc::make_mut)
    }

    /// The one at that position, to change.
    pub fn get_mut(&mut self, at: usize) -> Option<&mut T> {
        self.0.get_mut(at).map(Arc::make_mut)
    }

    /// The last, to change.
    pub fn last_mut(&mut self) -> Option<&mut T> {
        self.0.last_mut().map(Arc::make_mut)
    }

    /// Takes out the one at a position.
    ///
    /// # Panics
    /// If there is none, as a vector does.
    pub fn remove(&mut self, at: usize) -> T {
        Arc::unwrap_or_clone(self.0.remove(at))
    }
}

impl<T: HasId> List<T> {
    /// Where the one of that id stands.
    pub fn position(&self, id: T::Id) -> Option<usize> {
        // Things mostly stand in the order in which they got their ids.
        let in_order = self.0.binary_search_by_key(&id, |value| value.id()).ok();
        in_order.or_else(|| self.0.iter().position(|value| value.id() == id))
    }

    /// The one of that id.
    pub fn with_id(&self, id: T::Id) -> Option<&T> {
        self.get(self.position(id)?)
    }

    /// The same, to change.
    pub fn with_id_mut(&mut self, id: T::Id) -> Option<&mut T> {
        self.get_mut(self.position(id)?)
    }
}

impl<T: PartialEq> List<T> {
    /// Whether it has one that is equal to `value`.
    pub fn contains(&self, value: &T) -> bool {
        self.iter().any(|each| each == value)
    }
}

impl<T> Default for List<T> {
    fn default() -> Self {
        Self::new()
    }
}

/// What two lists share is equal without a look at it.
impl<T: PartialEq> PartialEq for List<T> {
    fn eq(&self, other: &Self) -> bool {
        self.len() == other.len() && self.0.iter().zip(&other.0).all(|(a, b)| Arc::ptr_eq(a, b) || a == b)
    }
}

impl<T: fmt::Debug> fmt::Debug for List<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

impl<T> Index<usize> for List<T> {
    type Output = T;
    fn index(&self, at: usize) -> &T {
        &self.0[at]
    }
}

impl<T: Clone> IndexMut<usize> for List<T> {
    fn index_mut(&mut self, at: usize) -> &mut T {
        Arc::make_mut(&mut self.0[at])
    }
}

impl<T> From<Vec<T>> for List<T> {
    fn from(values: Vec<T>) -> Self {
        values.into_iter().collect()
    }
}

impl<T> FromIterator<T> for List<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        Self(values.into_iter().map(Arc::new).collect())
    }
}

impl<T> Extend<T> for List<T> {
    fn extend<I: IntoIterator<Item = T>>(&mut self, values: I) {
        self.0.extend(values.into_iter().map(Arc::new));
    }
}

impl<'a, T> IntoIterator for &'a List<T> {
    type Item = &'a T;
    type IntoIter = Iter<'a, T>;
    fn into_iter(self) -> Iter<'a, T> {
        self.iter()
    }
}

impl<'a, T: Clone> IntoIterator for &'a mut List<T> {
    type Item = &'a mut T;
    type IntoIter = IterMut<'a, T>;
    fn into_iter(self) -> IterMut<'a, T> {
        self.iter_mut()
    }
}

impl<T: Clone> IntoIterator for List<T> {
    type Item = T;
    type IntoIter = std::iter::Map<std::vec::IntoIter<Arc<T>>, fn(Arc<T>) -> T>;
    fn into_iter(self) -> Self::IntoIter {
        self.0.into_iter().map(Arc::unwrap_or_clone)
    }
}

impl<T: Serialize> Serialize for List<T> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self)
    }
}

impl<'de, T: Deserialize<'de>> Deserialize<'de> for List<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Vec::deserialize(deserializer).map(Self::from)
    }
}

impl<T: JsonSchema> JsonSchema for List<T> {
    fn inline_schema() -> bool {
        Vec::<T>::inline_schema()
    }

    fn schema_name() -> Cow<'static, str> {
        Vec::<T>::schema_name()
    }

    fn schema_id() -> Cow<'static, str> {
        Vec::<T>::schema_id()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        Vec::<T>::json_schema(generator)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_copy_shares_what_it_does_not_change() {
        let first: List<String> = ["a", "b", "c"].map(String::from).into_iter().collect();
        let mut second = first.clone();
        second[1].push('!');
        let same = |at: usize| std::ptr::eq(&raw const first[at], &raw const second[at]);
        assert_eq!([same(0), same(1), same(2)], [true, false, true]);
        assert_eq!(first.iter().map(String::as_str).collect::<Vec<_>>(), ["a", "b", "c"]);
        assert_ne!(first, second);
        second[1] = "b".into();
        assert_eq!(first, second, "equal, though not shared");
    }
}
