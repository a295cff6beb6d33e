//! A track: keys that move one property of the scene over its clock.
//!
//! A track names the property by its address, so that anything in the table of properties that says it can be keyed can
//! be. What it makes of the scene at a time follows from its keys alone (`crate::weather`); what the scene itself says
//! of that property does not count meanwhile.

use super::{HasId, InScene, TrackId};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Keys of one property.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Track {
    /// Its id.
    pub id: TrackId,
    /// The property that it moves, by its address: `cloud/7/opacity`, `sky/exposure_ev`.
    pub property: String,
    /// What holds before the first key.
    #[serde(default, skip_serializing_if = "Beyond::is_hold")]
    pub before: Beyond,
    /// What holds after the last key.
    #[serde(default, skip_serializing_if = "Beyond::is_hold")]
    pub after: Beyond,
    /// At least one, in rising order of time, no two at one time (the checks see to it).
    pub keys: Vec<TrackKey>,
}

/// What a track does before its first key or after its last.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Beyond {
    /// It stays at that key's value.
    #[default]
    Hold,
    /// It begins anew: the last key's time is the first one's again.
    Repeat,
    /// It runs back and forth.
    Swing,
}

impl Beyond {
    fn is_hold(&self) -> bool {
        *self == Self::Hold
    }
}

/// A value at a time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrackKey {
    /// Seconds of the scene's clock.
    pub time_s: f64,
    /// The property's value there.
    pub value: KeyValue,
    /// How it goes on to the next key.
    #[serde(default, skip_serializing_if = "Leaves::is_smooth")]
    pub leaves: Leaves,
    /// Of angles: how many whole turns clockwise lie on the way to the next key, beside the difference of the two
    /// values. None: the shorter way.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub turns: Option<i32>,
    /// The curve's slopes as it arrives and as it leaves, a second, in place of what `smooth` makes of its neighbours:
    /// one number for each of the value's.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub handles: Option<Handles>,
}

/// How a key goes on to the next.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Leaves {
    /// It stays, and jumps at the next key.
    Step,
    /// Straight.
    Linear,
    /// A cubic that never overshoots (Fritsch and Carlson 1980), unless handles have it do so.
    #[default]
    Smooth,
}

impl Leaves {
    fn is_smooth(&self) -> bool {
        *self == Self::Smooth
    }
}

/// Slopes at a key, in the property's unit a second.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Handles {
    /// Before the key.
    pub arrives: KeyValue,
    /// After it.
    pub leaves: KeyValue,
}

/// One number, or one for each of a property's parts: along x, y and z, or red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum KeyValue {
    /// Of a property of one part.
    One(f64),
    /// Of a property of three.
    Three([f64; 3]),
}

impl KeyValue {
    /// Its numbers.
    pub fn parts(&self) -> &[f64] {
        match self {
            Self::One(number) => std::slice::from_ref(number),
            Self::Three(numbers) => numbers,
        }
    }

    /// The same, to change.
    pub fn parts_mut(&mut self) -> &mut [f64] {
        match self {
            Self::One(number) => std::slice::from_mut(number),
            Self::Three(numbers) => numbers,
        }
    }
}

impl TrackKey {
    /// A smooth key.
    pub fn new(time_s: f64, value: KeyValue) -> Self {
        Self { time_s, value, leaves: Leaves::Smooth, turns: None, handles: None }
    }
}

impl Track {
    /// One that holds beyond its `keys`.
    pub fn new(id: TrackId, property: impl Into<String>, keys: Vec<TrackKey>) -> Self {
        Self { id, property: property.into(), before: Beyond::Hold, after: Beyond::Hold, keys }
    }
}

impl HasId for Track {
    type Id = TrackId;
    fn id(&self) -> TrackId {
        self.id
    }
}

impl InScene for Track {
    /// The property's address.
    fn name(&self) -> &str {
        &self.property
    }

    fn name_mut(&mut self) -> &mut String {
        &mut self.property
    }
}
