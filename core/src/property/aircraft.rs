//! Aircraft on their paths.

use super::described::Described;
use super::row::{Row, number, numbers, range_of, setting, text, thing};
use super::setting::{Kind, Numbers, Setting};
use super::{AIRCRAFT_AHEAD_S, Number};
use crate::scene::Aircraft;

const SCALE: Number = Number::new("Scale", &(0.001..=1000.0), "", "Scales the aircraft's model.");

impl Described for Aircraft {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        setting!(path: thing("Path", "Along which path it flies.", Kind::Path)),
        numbers!(ahead_s: number(AIRCRAFT_AHEAD_S).keyed()),
        numbers!(scale: number(SCALE).keyed()),
    ]];
}
