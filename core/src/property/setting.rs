//! Kinds of values, and how the scene's own types are read and set as one of them.

use super::Number;
use crate::color::Rgb;
use crate::scene::{Category, Date, FolderId, GroupId, ModelId, PathId};
use glam::DVec3;
use std::fmt;

/// One value, whatever it is kept as.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// None of its own.
    None,
    /// Yes or no.
    Flag(bool),
    /// A number in the property's unit.
    Number(f64),
    /// A seed, or the id of a thing.
    Whole(u64),
    /// Words, or the name of a choice.
    Text(String),
}

/// What a property is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// Any number within a range.
    Number(Number),
    /// Degrees, of which 360 are a full turn.
    Angle(Number),
    /// A whole number within a range.
    Integer(Number),
    /// Linear light; its channels are the property's parts.
    Color(Number),
    /// Any whole number: another one rolls the dice anew.
    Seed,
    /// Yes or no.
    Flag,
    /// Words.
    Text,
    /// One of a few.
    Choice(&'static [Choice]),
    /// A category of cloud.
    Category,
    /// The id of a cloud model.
    Model,
    /// The id of a folder.
    Folder,
    /// The id of a shading group of the same model.
    Group,
    /// The id of a camera path.
    Path,
}

/// One of a few.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Choice {
    /// As in the file.
    pub name: &'static str,
    /// As on screen.
    pub label: &'static str,
}

/// The parts of a property that are set one by one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parts {
    /// It is one.
    One,
    /// Along x, y and z.
    Axes,
    /// Along the three axes, counted.
    Counts,
    /// Smallest and largest. One pushes the other along, so that they never cross.
    Ends,
    /// Red, green and blue.
    Channels,
}

impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::None => write!(f, "none"),
            Self::Flag(true) => write!(f, "yes"),
            Self::Flag(false) => write!(f, "no"),
            Self::Number(number) => number.fmt(f),
            Self::Whole(number) => number.fmt(f),
            Self::Text(text) => write!(f, "“{text}”"),
        }
    }
}

impl Kind {
    /// What values it has, in words.
    pub const fn values(&self) -> &'static str {
        match self {
            Self::Number(_) | Self::Angle(_) | Self::Color(_) => "a number",
            Self::Integer(_) | Self::Seed => "a whole number",
            Self::Flag => "yes or no",
            Self::Text => "text that is allowed here",
            Self::Choice(_) => "one of the names to choose from",
            Self::Category => "a category of cloud",
            Self::Model => "the id of a cloud model",
            Self::Folder => "the id of a folder",
            Self::Group => "the id of a shading group",
            Self::Path => "the id of a camera path",
        }
    }

    /// What its number means and may be, if it is one.
    pub const fn number(&self) -> Option<&Number> {
        match self {
            Self::Number(number) | Self::Angle(number) | Self::Integer(number) | Self::Color(number) => Some(number),
            _ => None,
        }
    }
}

impl Parts {
    /// In addresses.
    pub const fn names(self) -> &'static [&'static str] {
        match self {
            Self::One => &[""],
            Self::Axes => &["x", "y", "z"],
            Self::Counts => &["0", "1", "2"],
            Self::Ends => &["0", "1"],
            Self::Channels => &["r", "g", "b"],
        }
    }

    /// On the screen.
    pub const fn labels(self) -> &'static [&'static str] {
        match self {
            Self::Counts => Self::Axes.names(),
            Self::Ends => &["from", "to"],
            _ => self.names(),
        }
    }

    /// Behind the property's place in the file.
    pub const fn places(self) -> &'static [&'static str] {
        match self {
            Self::One => &[""],
            Self::Axes => &[".x", ".y", ".z"],
            Self::Counts => &["[0]", "[1]", "[2]"],
            Self::Ends => &["[0]", "[1]"],
            Self::Channels => &[".r", ".g", ".b"],
        }
    }
}

/// What is kept as one or more numbers.
pub(super) trait Numbers {
    fn number(&self, part: usize) -> f64;
    /// `number` is within the range of the property.
    fn set_number(&mut self, part: usize, number: f64);
    /// Whether all of its numbers are within that range.
    fn are_within(&self, range: [f64; 2]) -> bool;
}

macro_rules! one_number {
    ($($kind:ty)*) => {$(
        impl Numbers for $kind {
            fn number(&self, _: usize) -> f64 {
                f64::from(*self)
            }
            fn set_number(&mut self, _: usize, number: f64) {
                *self = number as Self;
            }
            fn are_within(&self, range: [f64; 2]) -> bool {
                is_within(self.number(0), range)
            }
        }
    )*};
}
one_number!(f64 f32 u32);

impl Numbers for [u32; 3] {
    fn number(&self, part: usize) -> f64 {
        f64::from(self[part])
    }
    fn set_number(&mut self, part: usize, number: f64) {
        self[part] = number as u32;
    }
    fn are_within(&self, range: [f64; 2]) -> bool {
        self.iter().all(|number| is_within((*number).into(), range))
    }
}

impl Numbers for [f64; 2] {
    fn number(&self, part: usize) -> f64 {
        self[part]
    }
    fn set_number(&mut self, part: usize, number: f64) {
        self[part] = number;
        let other = &mut self[1 - part];
        *other = if part == 0 { other.max(number) } else { other.min(number) };
    }
    fn are_within(&self, range: [f64; 2]) -> bool {
        self.iter().all(|number| is_within(*number, range))
    }
}

impl Numbers for DVec3 {
    fn number(&self, part: usize) -> f64 {
        self[part]
    }
    fn set_number(&mut self, part: usize, number: f64) {
        self[part] = number;
    }
    fn are_within(&self, range: [f64; 2]) -> bool {
        self.to_array().into_iter().all(|number| is_within(number, range))
    }
}

impl Numbers for Rgb {
    fn number(&self, part: usize) -> f64 {
        f64::from(self.to_array()[part])
    }
    fn set_number(&mut self, part: usize, number: f64) {
        let mut channels = self.to_array();
        channels[part] = number as f32;
        let [r, g, b] = channels;
        *self = Self::new(r, g, b);
    }
    fn are_within(&self, range: [f64; 2]) -> bool {
        self.to_array().into_iter().all(|number| is_within(number.into(), range))
    }
}

const fn is_within(number: f64, [min, max]: [f64; 2]) -> bool {
    number >= min && number <= max
}

/// What is kept as something else than numbers.
pub(super) trait Setting: Sized {
    fn value(&self) -> Value;
    /// None if the value is of another kind.
    fn from_value(value: &Value) -> Option<Self>;
}

macro_rules! settings {
    ($($type:ty: $variant:ident, $get:expr, $set:expr;)*) => {$(
        impl Setting for $type {
            fn value(&self) -> Value {
                Value::$variant($get(self))
            }
            fn from_value(value: &Value) -> Option<Self> {
                if let Value::$variant(value) = value { $set(value) } else { None }
            }
        }
    )*};
}
settings! {
    bool: Flag, |flag: &Self| *flag, |flag: &bool| Some(*flag);
    u64: Whole, |seed: &Self| *seed, |seed: &u64| Some(*seed);
    String: Text, Self::clone, |text: &Self| Some(text.clone());
    ModelId: Whole, |id: &Self| id.0, |id: &u64| Some(Self(*id));
    FolderId: Whole, |id: &Self| id.0, |id: &u64| Some(Self(*id));
    GroupId: Whole, |id: &Self| id.0, |id: &u64| Some(Self(*id));
    PathId: Whole, |id: &Self| id.0, |id: &u64| Some(Self(*id));
    Date: Text, Self::to_string, |text: &String| text.parse().ok();
    Category: Text, |category: &Self| category.name().into(), |name: &String| Self::ALL.into_iter().find(|each| each.name() == name);
}

impl<T: Setting> Setting for Option<T> {
    fn value(&self) -> Value {
        self.as_ref().map_or(Value::None, Setting::value)
    }
    fn from_value(value: &Value) -> Option<Self> {
        if *value == Value::None { Some(None) } else { T::from_value(value).map(Some) }
    }
}
