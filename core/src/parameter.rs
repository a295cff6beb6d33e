//! One described number: name, unit, range, default and meaning, said once.
//!
//! The checks refuse what lies outside the range, the inspector shows label, unit, range and meaning. A new number
//! of the scene gets its row here, and both follow.

/// What a number of the scene means and may be.
#[derive(Debug, Clone, Copy)]
pub struct Parameter {
    /// As in the file, for messages.
    pub name: &'static str,
    /// As on screen.
    pub label: &'static str,
    /// Shown behind the value: "m", "°", "h", "" for none.
    pub unit: &'static str,
    /// Smallest value allowed.
    pub min: f64,
    /// Largest value allowed.
    pub max: f64,
    /// What a new scene has.
    pub default: f64,
    /// One sentence for the artist.
    pub doc: &'static str,
}

impl Parameter {
    /// Whether `value` is a number within the range.
    pub fn allows(&self, value: f64) -> bool {
        value >= self.min && value <= self.max
    }
}

macro_rules! parameters {
    ($($(#[$meta:meta])* $id:ident: $name:literal, $label:literal, $unit:literal, $min:literal ..= $max:literal, $default:literal, $doc:literal;)*) => {
        $(
            #[doc = $doc]
            pub const $id: Parameter =
                Parameter { name: $name, label: $label, unit: $unit, min: $min, max: $max, default: $default, doc: $doc };
        )*
        /// All of them, for manuals and tests.
        pub const ALL: &[Parameter] = &[$($id),*];
    };
}

// Lengths reach 50,000 km so that scenes may lie anywhere on a flat map of the Earth; sprites from 1 mm to 100 km.
parameters! {
    POSITION: "position", "Position", "m", -5e7 ..= 5e7, 0.0, "Where it stands: x east, y up, −z north.";
    BOX_SIZE: "size", "Size", "m", 0.0 ..= 1e6, 500.0, "The box's full extent along its own axes.";
    SPRITE_COUNT: "sprite_count", "Sprites", "", 0.0 ..= 1e6, 30.0, "How many sprites are tried in the box, before culling.";
    SPRITE_SIZE: "width", "Sprite size", "m", 0.001 ..= 1e5, 200.0, "Range of the sprites' width or height.";
    ROTATION_DEG: "rotation_deg", "Rotation", "°", -360.0 ..= 360.0, 0.0, "Range of the sprites' own turn, counter-clockwise as seen.";
    LUMPS: "lumps", "Lumps", "", 1.0 ..= 16.0, 1.0, "Into how many lumps, along each axis, the box's sprites are split for shading.";
    CULL_FRACTION: "cull_radius", "Cull radius", "", 0.0 ..= 10.0, 0.3333333333333333, "Sprites nearer than this share of the size to one already kept are dropped.";
    CULL_METRES: "cull_radius.metres", "Cull radius", "m", 0.0 ..= 1e5, 60.0, "Sprites nearer than this to one already kept are dropped.";
    SPRITE_PLACE: "moved", "Place in the box", "", -1000.0 ..= 1000.0, 0.0, "Where a hand-moved sprite lies: −½ to ½ is within the box.";
    C_MIN: "c_min", "Away from the sun", "", -4.0 ..= 4.0, 0.0, "Share of the directional light on the side away from the sun.";
    C_MED: "c_med", "Across", "", -4.0 ..= 4.0, 0.42, "Share of the directional light at right angles to the sun.";
    C_MAX: "c_max", "Towards the sun", "", -4.0 ..= 4.0, 1.0, "Share of the directional light on the side that faces the sun.";
    PULL: "center.pulled", "Pull to cloud", "", 0.0 ..= 1.0, 0.33, "How far the group's centre moves from its sprites' mean towards the cloud's centre.";
    LEVEL_HEIGHT: "height", "Height", "", 0.0 ..= 1.0, 0.5, "Height within the cloud, 0 at its bottom, 1 at its top.";
    COLOR: "color", "Colour", "", 0.0 ..= 1000.0, 1.0, "Linear light; above 1 is brighter than white.";
    ALPHA: "alpha", "Opacity", "", 0.0 ..= 1.0, 1.0, "Opacity, 0 clear to 1 solid.";
    CLOUD_SCALE: "scale", "Scale", "", 0.001 ..= 1000.0, 1.0, "Scales the whole cloud with its sprites.";
    HEADING_DEG: "heading_deg", "Heading", "°", -360.0 ..= 360.0, 0.0, "Clockwise from north, seen from above.";
    PITCH_DEG: "pitch_deg", "Pitch", "°", -90.0 ..= 90.0, 0.0, "Up is positive.";
    ROLL_DEG: "roll_deg", "Roll", "°", -360.0 ..= 360.0, 0.0, "Right wing down is positive.";
    FIELD_OF_VIEW_DEG: "field_of_view_deg", "Field of view", "°", 0.1 ..= 170.0, 50.0, "Vertical field of view.";
    TIME_OF_DAY_H: "time_of_day_h", "Time of day", "h", 0.0 ..= 23.999999999, 12.0, "Local civil time, 0 to 24, without 24 itself.";
    LATITUDE_DEG: "latitude_deg", "Latitude", "°", -90.0 ..= 90.0, 47.5, "North is positive.";
    LONGITUDE_DEG: "longitude_deg", "Longitude", "°", -180.0 ..= 180.0, -122.3, "East is positive.";
    UTC_OFFSET_H: "utc_offset_h", "UTC offset", "h", -14.0 ..= 14.0, -7.0, "Hours that local time is ahead of UTC.";
    ELEVATION_DEG: "elevation_deg", "Elevation", "°", -90.0 ..= 90.0, 45.0, "Height of the sun above the horizon.";
    TURBIDITY: "turbidity", "Turbidity", "", 1.0 ..= 10.0, 2.5, "How hazy the sky is: 2 very clear, 10 milky.";
    SKY_GAIN: "gain", "Sky gain", "", 0.0 ..= 100.0, 1.0, "Scales the sky so that it meets the clouds' colours.";
    HAZE_LENGTH_M: "haze_length_m", "Haze length", "m", 10.0 ..= 1e9, 26000.0, "Distance over which 63 % of a colour turns to the horizon's.";
    EXPOSURE_EV: "exposure_ev", "Exposure", "EV", -20.0 ..= 20.0, 0.0, "Each step doubles the light.";
    INSIDE_DENSITY: "inside_density", "Inside density", "", 0.0 ..= 4.0, 1.0, "How dense the air inside a cloud looks: 0 for none, 1 as dense as its sprites.";
    FORMATION_START_S: "formation.start_s", "Begins at", "s", 0.0 ..= 86400.0, 0.0, "When the cloud begins to change, counted from the start of play or flight.";
    FORMATION_CORE_S: "formation.core_s", "Core takes", "s", 0.0 ..= 86400.0, 20.0, "How long the cloud's core takes to form or to dissipate.";
    FORMATION_EDGES_S: "formation.edges_s", "Edges take", "s", 0.0 ..= 86400.0, 30.0, "How long the cloud's edges take to form or to dissipate.";
    FORMATION_THRESHOLD: "formation.threshold", "Edges from", "", 0.01 ..= 1.0, 0.5, "Opacity of the core at which the edges begin to form, or have gone.";
    KEY_TIME_S: "time_s", "Time", "s", 0.0 ..= 86400.0, 0.0, "When the flight passes the key. The first key's time is the flight's start.";
    LEG_SPEED_MPS: "speed_mps", "Speed to next key", "m/s", 0.01 ..= 1e5, 80.0, "Mean speed from the key to the next. Later keys move in time.";
    AIRCRAFT_AHEAD_S: "ahead_s", "Ahead of the camera", "s", -86400.0 ..= 86400.0, 4.0, "How far ahead on its path the aircraft flies: a camera on the same path follows it.";
    AIRCRAFT_SCALE: "scale", "Scale", "", 0.001 ..= 1000.0, 1.0, "Scales the aircraft's model.";
}
