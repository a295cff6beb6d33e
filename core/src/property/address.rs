//! What a value is called by, for as long as its thing is in the scene: `cloud/7/heading_deg`, `model/3/box/9/width/0`.
//!
//! An address is the owner's, and then the value's place in the file from there on. Things are named by their ids; keys
//! of tables and paths, and colour levels, have none and are counted from 0.

use super::described::Described;
use super::owner::Owner;
use super::row::{Property, Refusal, Row};
use super::setting::Value;
use crate::color::{Rgb, Rgba};
// With the types and ids that the rows of kinds name.
use crate::scene::*;
use std::fmt;
use std::str::FromStr;

/// Where a value is found.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Address {
    /// Whose it is.
    pub owner: Owner,
    /// What it is.
    pub property: &'static Property,
    /// Which of the property's parts.
    pub part: usize,
}

/// A text that is the address of nothing that could be in a scene.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("there is no property “{address}”; {hint}")]
pub struct NoSuchProperty {
    /// As it was written.
    pub address: String,
    /// What there is instead.
    pub hint: String,
}

/// The properties of a kind of owner.
#[derive(Debug, Clone, Copy)]
pub struct Table {
    /// Its address, with N in the place of ids and counts: `model/N/box/N`; empty for the scene itself.
    pub pattern: &'static str,
    /// In the order in which they are shown.
    pub properties: fn() -> Vec<&'static Property>,
    /// The owner of those ids and counts; none if one is too large.
    owner: fn([u64; 3]) -> Option<Owner>,
}

/// Of what is not in lists of the scene.
const OTHERS: &[Table] = &[
    table::<Scene>("", |_| Some(Owner::Scene)),
    table::<Site>("place", |_| Some(Owner::Site)),
    table::<Sun>("sun", |_| Some(Owner::Sun)),
    table::<Sky>("sky", |_| Some(Owner::Sky)),
    table::<Weather>("weather", |_| Some(Owner::Weather)),
    table::<DailyKey<Rgba>>("sky/ambient/N", |[i, ..]| Some(Owner::AmbientKey(i.try_into().ok()?))),
    table::<DailyKey<Rgb>>("sky/directional/N", |[i, ..]| Some(Owner::DirectionalKey(i.try_into().ok()?))),
    table::<Ground>("ground", |_| Some(Owner::Ground)),
    table::<ColorLevel>("model/N/color_levels/N", |[id, i, _]| Some(Owner::Level(ModelId(id), i.try_into().ok()?))),
    table::<ShadingGroup>("model/N/group/N", |[id, group, _]| {
        Some(Owner::Thing(Thing::Group(ModelId(id), GroupId(group))))
    }),
    table::<CloudBox>("model/N/box/N", |[id, each, _]| Some(Owner::Thing(Thing::Box(ModelId(id), BoxId(each))))),
    table::<SpriteEdit>("model/N/box/N/sprite/N", |[id, each, i]| {
        Some(Owner::Thing(Thing::Sprite(ModelId(id), BoxId(each), i.try_into().ok()?)))
    }),
    table::<PathKey>("path/N/key/N", |[id, i, _]| Some(Owner::Key(PathId(id), i.try_into().ok()?))),
];

macro_rules! listed {
    ($($(#[$doc:meta])* $Kind:ident: $Value:ident, $Id:ident, $list:ident, $word:literal, $title:literal;)*) => {
        const LISTED: &[Table] =
            &[$(table::<$Value>(concat!($word, "/N"), |[id, ..]| Some(Owner::Thing(Thing::$Kind($Id(id)))))),*];
    };
}
kinds!(listed);

/// All properties that there are, by kind of owner.
pub fn tables() -> impl Iterator<Item = &'static Table> {
    OTHERS.iter().chain(LISTED)
}

const fn table<T: Described>(pattern: &'static str, owner: fn([u64; 3]) -> Option<Owner>) -> Table {
    Table { pattern, properties: || T::rows().map(|row| &row.property).collect(), owner }
}

impl Table {
    /// The owner that `text` begins with, and what follows.
    pub(super) fn read<'a>(&self, text: &'a str) -> Option<(Owner, &'a str)> {
        let (mut ids, mut count, mut rest) = ([0; 3], 0, text);
        for wanted in self.pattern.split('/').filter(|each| !each.is_empty()) {
            let (segment, after) = rest.split_once('/')?;
            rest = after;
            if wanted != "N" && wanted != segment {
                return None;
            }
            if wanted == "N" {
                ids[count] = segment.parse().ok().filter(|id: &u64| id.to_string() == segment)?;
                count += 1;
            }
        }
        Some(((self.owner)(ids)?, rest))
    }
}

impl Address {
    /// The addresses of all parts of the property that `text` names; the one of a value that is called just that, if
    /// there is one.
    ///
    /// # Errors
    /// If it is the address of nothing that could be in a scene.
    pub fn all(text: &str) -> Result<Vec<Self>, NoSuchProperty> {
        let error = match text.parse() {
            Ok(one) => return Ok(vec![one]),
            Err(error) => error,
        };
        for (owner, rest, properties) in
            tables().filter_map(|table| table.read(text).map(|(owner, rest)| (owner, rest, (table.properties)())))
        {
            if let Some(property) = properties.into_iter().find(|property| property.address_part() == rest) {
                let parts = 0..property.parts.names().len();
                return Ok(parts.map(|part| Self { owner, property, part }).collect());
            }
        }
        Err(error)
    }

    /// The row of what it names, if that is a property of `T`'s.
    pub(super) fn row<T: Described>(&self) -> Option<&'static Row<T>> {
        T::rows().find(|row| row.property.is_the_same(self.property))
    }

    /// Sets what it names in `thing`, the owner.
    pub(crate) fn set_in<T: Described>(&self, thing: &mut T, value: &Value) -> Result<(), Refusal> {
        self.row().ok_or(Refusal::NotThere)?.set(thing, self.part, value)
    }
}

impl Property {
    /// Whether it stands at the same place in the same kind of thing.
    pub fn is_the_same(&self, other: &Self) -> bool {
        (self.path, self.parts) == (other.path, other.parts)
    }

    /// What it is called as a whole behind its owner's address.
    pub fn address_part(&self) -> String {
        self.path.replace('.', "/")
    }

    /// What the part is called behind its owner's address.
    fn name(&self, part: usize) -> String {
        let part = self.parts.names().get(part).copied().unwrap_or_default();
        let slash = if part.is_empty() { "" } else { "/" };
        format!("{}{slash}{part}", self.address_part())
    }

    /// Where the part stands in the file, within the thing at `thing`.
    pub(crate) fn place(&self, thing: fmt::Arguments<'_>, part: usize) -> String {
        let mut place = thing.to_string();
        if !place.is_empty() {
            place.push('.');
        }
        place.push_str(self.path);
        place.push_str(self.parts.places().get(part).copied().unwrap_or_default());
        place
    }
}

impl fmt::Display for Address {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let slash = if self.owner == Owner::Scene { "" } else { "/" };
        write!(f, "{}{slash}{}", self.owner, self.property.name(self.part))
    }
}

impl FromStr for Owner {
    type Err = NoSuchProperty;

    /// As it stands before the addresses of its properties: `cloud/7`.
    fn from_str(text: &str) -> Result<Self, NoSuchProperty> {
        let whole = format!("{text}/");
        let whole_of = |table: &Table| table.read(&whole).filter(|(_, rest)| rest.is_empty());
        let found = tables().filter(|table| !table.pattern.is_empty()).find_map(whole_of);
        found.map(|(owner, _)| owner).ok_or_else(|| {
            let owners: Vec<_> = tables().map(|table| table.pattern).filter(|p| !p.is_empty()).collect();
            NoSuchProperty {
                address: text.into(),
                hint: format!("things are {}, N their id or count", owners.join(", ")),
            }
        })
    }
}

impl FromStr for Address {
    type Err = NoSuchProperty;

    fn from_str(text: &str) -> Result<Self, NoSuchProperty> {
        let mut near = Vec::new();
        let read = |table: &Table| table.read(text).map(|(owner, rest)| (owner, rest, (table.properties)()));
        for (owner, rest, properties) in tables().filter_map(read) {
            for property in properties {
                for part in 0..property.parts.names().len() {
                    let name = property.name(part);
                    if name == rest {
                        return Ok(Self { owner, property, part });
                    }
                    near.push((strsim::jaro_winkler(&name, rest), Self { owner, property, part }));
                }
            }
        }
        let best = near.into_iter().max_by(|(a, _), (b, _)| a.total_cmp(b));
        let hint = match best {
            Some((score, address)) if score > 0.75 => format!("did you mean {address}?"),
            _ => {
                let owners: Vec<_> = tables().map(|table| table.pattern).filter(|p| !p.is_empty()).collect();
                format!("things are {}, N their id or count", owners.join(", "))
            }
        };
        Err(NoSuchProperty { address: text.into(), hint })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn owners_and_whole_properties_are_found_by_their_addresses() {
        for table in tables().filter(|table| !table.pattern.is_empty()) {
            let text = table.pattern.replace('N', "7");
            assert_eq!(text.parse::<Owner>().map(|owner| owner.to_string()), Ok(text.clone()));
            for property in (table.properties)() {
                let all = Address::all(&format!("{text}/{}", property.address_part())).expect("a property");
                // A group's `center` is a choice, and a point if the choice is one: its parts go by their own names.
                assert!([1, property.parts.names().len()].contains(&all.len()), "{text}");
                let first = Address::all(&all[0].to_string()).expect("a part");
                assert_eq!(first, all[..1], "{text}");
            }
        }
        assert!("cloud".parse::<Owner>().is_err() && "cloud/7/name".parse::<Owner>().is_err());
        assert!(Address::all("cloud/7/positio").is_err_and(|error| error.hint.contains("did you mean")));
    }
}
