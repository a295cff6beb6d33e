//! What a number means and may be: label, unit, range and a sentence for the artist.
//!
//! A number of the scene has its words in its row of the table beside this file; those here are shared by several rows,
//! or by rows and tools.

use std::ops::RangeInclusive;

/// What a number means and may be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Number {
    /// As on screen.
    pub label: &'static str,
    /// Shown behind the value: "m", "°", "h", "" for none.
    pub unit: &'static str,
    /// Smallest value allowed.
    pub min: f64,
    /// Largest value allowed.
    pub max: f64,
    /// One sentence for the artist.
    pub doc: &'static str,
}

impl Number {
    /// A number within `range`, in `unit`.
    pub const fn new(label: &'static str, range: &RangeInclusive<f64>, unit: &'static str, doc: &'static str) -> Self {
        Self { label, unit, min: *range.start(), max: *range.end(), doc }
    }

    /// The same under another label.
    pub const fn called(self, label: &'static str) -> Self {
        Self { label, ..self }
    }

    /// Whether `value` is a number within the range.
    pub fn allows(&self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }
}

macro_rules! numbers {
    ($($id:ident: $label:literal, $range:expr, $unit:literal, $doc:literal;)*) => {$(
        #[doc = $doc]
        pub const $id: Number = Number::new($label, &$range, $unit, $doc);
    )*};
}

// Lengths reach 50,000 km so that scenes may lie anywhere on a flat map of the Earth; sprites from 1 mm to 100 km.
numbers! {
    POSITION: "Position", -5e7..=5e7, "m", "Where it stands: x east, y up, −z north.";
    HEADING_DEG: "Heading", -360.0..=360.0, "°", "Clockwise from north, seen from above.";
    PITCH_DEG: "Pitch", -90.0..=90.0, "°", "Up is positive.";
    ROLL_DEG: "Roll", -360.0..=360.0, "°", "Right wing down is positive.";
    FIELD_OF_VIEW_DEG: "Field of view", 0.1..=170.0, "°", "Vertical field of view.";
    TIME_OF_DAY_H: "Time of day", 0.0..=23.999999999, "h", "Local civil time, 0 to 24, without 24 itself.";
    COLOR: "Colour", 0.0..=1000.0, "", "Linear light; above 1 is brighter than white.";
    ALPHA: "Opacity", 0.0..=1.0, "", "Opacity, 0 clear to 1 solid.";
    CLOUD_SCALE: "Scale", 0.001..=1000.0, "", "Scales the whole cloud with its sprites.";
    MODEL_SCALE: "Scale", 0.001..=1000.0, "", "Scales the model.";
    BOX_SIZE: "Size", 0.0..=1e6, "m", "The box's full extent along its own axes.";
    SPRITE_SIZE: "Sprite size", 0.001..=1e5, "m", "Range of the sprites' width or height.";
    SPRITE_PLACE: "Place in the box", -1000.0..=1000.0, "", "Where a hand-moved sprite lies: −½ to ½ is within the box.";
    LEVEL_HEIGHT: "Height", 0.0..=1.0, "", "Height within the cloud, 0 at its bottom, 1 at its top.";
    C_MIN: "Away from the sun", -4.0..=4.0, "", "Share of the directional light on the side away from the sun.";
    C_MED: "Across", -4.0..=4.0, "", "Share of the directional light at right angles to the sun.";
    C_MAX: "Towards the sun", -4.0..=4.0, "", "Share of the directional light on the side that faces the sun.";
    KEY_TIME_S: "Time", 0.0..=86400.0, "s", "When the flight passes the key. The first key's time is the flight's start.";
    LEG_SPEED_MPS: "Speed to next key", 0.01..=1e5, "m/s", "Mean speed from the key to the next. Later keys move in time.";
    AIRCRAFT_AHEAD_S: "Ahead of the camera", -86400.0..=86400.0, "s", "How far ahead on its path the aircraft flies: a camera on the same path follows it.";
}
