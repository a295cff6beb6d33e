//! A row of the table: what a value is, and how it is read from a thing and set in it.

use super::Number;
use super::setting::{Choice, Kind, Parts, Value};

/// What can be said of a value without the thing that it belongs to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Property {
    /// Its place in the file, from the thing on: `heading_deg`, `formation.core_s`.
    pub path: &'static str,
    /// As on screen.
    pub label: &'static str,
    /// One sentence for the artist.
    pub doc: &'static str,
    /// What it is, with its unit and range.
    pub kind: Kind,
    /// Of what parts it consists.
    pub parts: Parts,
    /// What holds where it has no value of its own, for those that may have none.
    pub none: Option<&'static str>,
    /// Whether a track can move it: then nothing that is made on the edit clock depends on it.
    pub keyed: bool,
    /// Of numbers that come round: how far apart equal ones lie. A track's may be of any round.
    pub cycle: Option<f64>,
}

/// A property of things of type `T`.
#[derive(Debug)]
pub struct Row<T: 'static> {
    /// What it is.
    pub property: Property,
    pub(super) access: Access<T>,
}

/// How a value is reached. What is not there, such as when a cloud that does not form begins, is none.
#[derive(Debug)]
pub(super) enum Access<T: 'static> {
    /// Numbers as the file has them. Of a plain field, `within` compares all parts with the range at once.
    Numbers { get: fn(&T, usize) -> Option<f64>, set: fn(&mut T, usize, f64), within: Option<fn(&T) -> bool> },
    /// Anything else. What can't be set gives none.
    Value { get: fn(&T) -> Option<Value>, set: fn(&mut T, &Value) -> Option<()> },
}

/// Why a property was not set.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum Refusal {
    /// The thing, or this property of it, is not there now.
    #[error("it is not there")]
    NotThere,
    /// The value is of another kind.
    #[error("{value} is not {wanted}")]
    WrongKind {
        /// What was to be set.
        value: Value,
        /// What can be: "a number".
        wanted: &'static str,
    },
    /// The number is NaN, or out of range.
    #[error("{value} is outside {min} to {max}")]
    OutOfRange {
        /// What was to be set.
        value: f64,
        /// Smallest value allowed.
        min: f64,
        /// Largest value allowed.
        max: f64,
    },
}

impl<T> Row<T> {
    /// The part's value; none if it is not there.
    pub fn value(&self, thing: &T, part: usize) -> Option<Value> {
        match &self.access {
            _ if part >= self.property.parts.names().len() => None,
            Access::Numbers { get, .. } => get(thing, part).map(Value::Number),
            Access::Value { get, .. } => get(thing),
        }
    }

    /// Tells `out_of_range` the parts whose numbers, as the file has them, may not be.
    pub(crate) fn check(&self, thing: &T, mut out_of_range: impl FnMut(usize, &Number, f64)) {
        let Access::Numbers { get, within, .. } = &self.access else { return };
        if within.is_some_and(|within| within(thing)) {
            return;
        }
        let Some(number) = self.property.kind.number() else { return };
        for part in 0..self.property.parts.names().len() {
            let Some(value) = get(thing, part) else { return };
            if !number.allows(value) {
                out_of_range(part, number, value);
            }
        }
    }

    /// Gives the part another value.
    ///
    /// # Errors
    /// If it is not there, or the value is of another kind or out of range; the thing is then as before.
    pub fn set(&self, thing: &mut T, part: usize, value: &Value) -> Result<(), Refusal> {
        if self.value(thing, part).is_none() {
            return Err(Refusal::NotThere);
        }
        let wrong = || Refusal::WrongKind { value: value.clone(), wanted: self.property.kind.values() };
        let number = if let Some(range) = self.property.kind.number() {
            let Value::Number(number) = *value else { return Err(wrong()) };
            if !range.allows(number) {
                return Err(Refusal::OutOfRange { value: number, min: range.min, max: range.max });
            }
            if matches!(self.property.kind, Kind::Integer(_)) && number.fract() != 0.0 {
                return Err(wrong());
            }
            number
        } else {
            f64::NAN
        };
        match &self.access {
            Access::Numbers { set, .. } => set(thing, part, number),
            Access::Value { set, .. } => set(thing, value).ok_or_else(wrong)?,
        }
        Ok(())
    }

    /// Gives the part of a row of numbers another one, within its range, whether it has one or not.
    pub(crate) fn set_number(&self, thing: &mut T, part: usize, number: f64) {
        if let Access::Numbers { set, .. } = &self.access {
            set(thing, part, number);
        }
    }

    /// A row of numbers that are no plain field.
    pub(super) const fn numbers(
        path: &'static str,
        property: Property,
        get: fn(&T, usize) -> Option<f64>,
        set: fn(&mut T, usize, f64),
    ) -> Self {
        Self { property: property.at(path), access: Access::Numbers { get, set, within: None } }
    }

    /// A row of a plain field of numbers.
    pub(super) const fn field(
        path: &'static str,
        property: Property,
        get: fn(&T, usize) -> Option<f64>,
        set: fn(&mut T, usize, f64),
        within: fn(&T) -> bool,
    ) -> Self {
        Self { property: property.at(path), access: Access::Numbers { get, set, within: Some(within) } }
    }

    /// A row of a value that is no plain field.
    pub(super) const fn of(
        path: &'static str,
        property: Property,
        get: fn(&T) -> Option<Value>,
        set: fn(&mut T, &Value) -> Option<()>,
    ) -> Self {
        Self { property: property.at(path), access: Access::Value { get, set } }
    }
}

impl Property {
    const fn new(label: &'static str, doc: &'static str, kind: Kind, parts: Parts) -> Self {
        Self { path: "", label, doc, kind, parts, none: None, keyed: false, cycle: None }
    }

    /// The same at that place in the file.
    pub(super) const fn at(self, path: &'static str) -> Self {
        Self { path, ..self }
    }

    /// A track can move it.
    pub(super) const fn keyed(self) -> Self {
        Self { keyed: true, ..self }
    }

    /// Its numbers come round.
    pub(super) const fn cyclic(self, cycle: f64) -> Self {
        Self { cycle: Some(cycle), ..self }
    }

    /// It may have no value of its own; then holds what `none` says.
    pub(super) const fn or(self, none: &'static str) -> Self {
        Self { none: Some(none), ..self }
    }
}

/// Smallest and largest value allowed; none is, if it is no number.
pub(super) const fn range_of(property: &Property) -> [f64; 2] {
    match property.kind.number() {
        Some(number) => [number.min, number.max],
        None => [f64::NAN; 2],
    }
}

pub(super) const fn number(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Number(number), Parts::One)
}

pub(super) const fn angle(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Angle(number), Parts::One).cyclic(360.0)
}

pub(super) const fn integer(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Integer(number), Parts::One)
}

/// One whole number along each axis.
pub(super) const fn counts(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Integer(number), Parts::Counts)
}

/// A point or an extent.
pub(super) const fn vector(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Number(number), Parts::Axes)
}

/// Smallest and largest.
pub(super) const fn range(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Number(number), Parts::Ends)
}

/// Smallest and largest angle.
pub(super) const fn angles(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Angle(number), Parts::Ends)
}

pub(super) const fn color(number: Number) -> Property {
    Property::new(number.label, number.doc, Kind::Color(number), Parts::Channels)
}

pub(super) const fn seed(label: &'static str, doc: &'static str) -> Property {
    Property::new(label, doc, Kind::Seed, Parts::One)
}

pub(super) const fn flag(label: &'static str, doc: &'static str) -> Property {
    Property::new(label, doc, Kind::Flag, Parts::One)
}

pub(super) const fn text(label: &'static str, doc: &'static str) -> Property {
    Property::new(label, doc, Kind::Text, Parts::One)
}

pub(super) const fn choice(label: &'static str, doc: &'static str, choices: &'static [Choice]) -> Property {
    Property::new(label, doc, Kind::Choice(choices), Parts::One)
}

pub(super) const fn category() -> Property {
    Property::new("Category", "Which tiles its sprites show.", Kind::Category, Parts::One)
}

/// The id of a thing: `kind` says of which.
pub(super) const fn thing(label: &'static str, doc: &'static str, kind: Kind) -> Property {
    Property::new(label, doc, kind, Parts::One)
}

/// A row of numbers: `numbers!(field: property)`; `numbers!("path", field: property)` where the file calls it otherwise;
/// `numbers!(parent?.field: property)` and `numbers!(field?: property)` for what may be not there.
macro_rules! numbers {
    ($path:expr, $first:ident $(. $rest:ident)*: $property:expr) => {
        Row::field(
            $path,
            $property,
            |thing, part| Some(Numbers::number(&thing.$first$(.$rest)*, part)),
            |thing, part, number| Numbers::set_number(&mut thing.$first$(.$rest)*, part, number),
            |thing| Numbers::are_within(&thing.$first$(.$rest)*, const { range_of(&$property) }),
        )
    };
    ($first:ident $(. $rest:ident)*: $property:expr) => {
        numbers!(concat!(stringify!($first) $(, ".", stringify!($rest))*), $first$(.$rest)*: $property)
    };
    ($parent:ident?.$field:ident: $property:expr) => {
        Row::numbers(
            concat!(stringify!($parent), ".", stringify!($field)),
            $property,
            |thing, part| Some(Numbers::number(&thing.$parent.as_ref()?.$field, part)),
            |thing, part, number| {
                if let Some(parent) = &mut thing.$parent {
                    Numbers::set_number(&mut parent.$field, part, number);
                }
            },
        )
    };
    ($field:ident?: $property:expr) => {
        Row::numbers(
            stringify!($field),
            $property,
            |thing, part| Some(Numbers::number(thing.$field.as_ref()?, part)),
            |thing, part, number| {
                if let Some(field) = &mut thing.$field {
                    Numbers::set_number(field, part, number);
                }
            },
        )
    };
}

/// A row of anything else: `setting!(field: property)`.
macro_rules! setting {
    ($field:ident: $property:expr) => {
        Row::of(
            stringify!($field),
            $property,
            |thing| Some(Setting::value(&thing.$field)),
            |thing, value| {
                thing.$field = Setting::from_value(value)?;
                Some(())
            },
        )
    };
}

pub(super) use {numbers, setting};
