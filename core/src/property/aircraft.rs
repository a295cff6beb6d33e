//! Aircraft on their paths.

use super::described::Described;
use super::row::{Row, number, numbers, range_of, setting, text, thing};
use super::setting::{Kind, Numbers, Setting};
use super::{AIRCRAFT_AHEAD_S, MODEL_SCALE};
use crate::scene::Aircraft;

impl Described for Aircraft {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        setting!(path: thing("Path", "Along which path it flies.", Kind::Path)),
        numbers!(ahead_s: number(AIRCRAFT_AHEAD_S).keyed()),
        numbers!(scale: number(MODEL_SCALE).keyed()),
    ]];
}
