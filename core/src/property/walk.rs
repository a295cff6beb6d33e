//! The way through a scene from thing to thing, with each one's owner and place in the file.
//!
//! Places are put into words by whoever needs them: a drag walks at every step, and mostly finds nothing to say.

use super::described::{Described, Visitor, enter};
use super::{Address, Owner, Value};
use crate::scene::{Scene, Thing, kinds};
use std::fmt::Arguments;

/// Shows `visitor` all of `scene` that it enters, in the order of the file.
pub fn walk(scene: &Scene, visitor: &mut impl Visitor) {
    enter(Owner::Scene, format_args!(""), scene, visitor);
    enter(Owner::Site, format_args!("place"), &scene.site, visitor);
    enter(Owner::Sun, format_args!("sun"), &scene.sun, visitor);
    enter(Owner::Sky, format_args!("sky"), &scene.sky, visitor);
    enter(Owner::Weather, format_args!("weather"), &scene.weather, visitor);
    if let Some(ground) = &scene.ground {
        enter(Owner::Ground, format_args!("ground"), ground, visitor);
    }
    walk_lists(scene, visitor);
}

macro_rules! lists {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        fn walk_lists(scene: &Scene, visitor: &mut impl Visitor) {
            $(for (i, each) in scene.$list.iter().enumerate() {
                let place = format_args!("{}[{i}]", stringify!($list));
                enter(Owner::Thing(Thing::$Kind(each.id)), place, each, visitor);
            })*
        }
    };
}
kinds!(lists);

/// The value at `address`; none if it is not there now.
pub fn value(scene: &Scene, address: Address) -> Option<Value> {
    find(scene, address).map(|(value, _)| value)
}

/// Where in the file the value at `address` stands: `models[0].boxes[2].width[1]`.
pub fn place(scene: &Scene, address: Address) -> Option<String> {
    find(scene, address).map(|(_, place)| place)
}

fn find(scene: &Scene, address: Address) -> Option<(Value, String)> {
    let mut find = Find { address, found: None };
    walk(scene, &mut find);
    find.found
}

struct Find {
    address: Address,
    found: Option<(Value, String)>,
}

impl Visitor for Find {
    fn enters(&mut self, owner: Owner) -> bool {
        self.address.owner.is_within(owner)
    }

    fn thing<T: Described>(&mut self, owner: Owner, place: Arguments<'_>, thing: &T) {
        if owner == self.address.owner
            && self.found.is_none()
            && let Some(row) = self.address.row()
        {
            let value = row.value(thing, self.address.part);
            self.found = value.map(|value| (value, row.property.place(place, self.address.part)));
        }
    }
}

/// The addresses of all values of `scene` that are there now, in the order of the file.
pub fn addresses(scene: &Scene) -> Vec<Address> {
    let mut list = List(Vec::new());
    walk(scene, &mut list);
    list.0
}

struct List(Vec<Address>);

impl Visitor for List {
    fn thing<T: Described>(&mut self, owner: Owner, _: Arguments<'_>, thing: &T) {
        for row in T::rows() {
            let there = |part: &usize| row.value(thing, *part).is_some();
            let parts = (0..row.property.parts.names().len()).filter(there);
            self.0.extend(parts.map(|part| Address { owner, property: &row.property, part }));
        }
    }
}
