//! Camera paths and their keys.

use super::described::{Described, Visitor, enter};
use super::owner::Owner;
use super::row::{Row, angle, number, numbers, range_of, setting, text, vector};
use super::setting::{Numbers, Setting};
use super::{FIELD_OF_VIEW_DEG, HEADING_DEG, KEY_TIME_S, PITCH_DEG, POSITION, ROLL_DEG};
use crate::scene::{CameraPath, PathKey};
use std::fmt::Arguments;

impl Described for CameraPath {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "What the command line calls it.")),
        numbers!(field_of_view_deg: number(FIELD_OF_VIEW_DEG)),
    ]];

    fn enter_parts(&self, _: Owner, place: Arguments<'_>, visitor: &mut impl Visitor) {
        for (i, key) in self.keys.iter().enumerate() {
            enter(Owner::Key(self.id, i), format_args!("{place}.keys[{i}]"), key, visitor);
        }
    }
}

impl Described for PathKey {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(time_s: number(KEY_TIME_S)),
        numbers!(position: vector(POSITION)),
        numbers!(heading_deg: angle(HEADING_DEG)),
        numbers!(pitch_deg: number(PITCH_DEG)),
        numbers!(roll_deg: angle(ROLL_DEG)),
    ]];
}
