//! Saved cameras.

use super::described::Described;
use super::row::{Row, angle, number, numbers, range_of, setting, text, vector};
use super::setting::{Numbers, Setting};
use super::{FIELD_OF_VIEW_DEG, HEADING_DEG, PITCH_DEG, POSITION, ROLL_DEG};
use crate::scene::Camera;

impl Described for Camera {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "What the command line calls it.")),
        numbers!(position: vector(POSITION).keyed()),
        numbers!(heading_deg: angle(HEADING_DEG).keyed()),
        numbers!(pitch_deg: number(PITCH_DEG).keyed()),
        numbers!(roll_deg: angle(ROLL_DEG).keyed()),
        numbers!(field_of_view_deg: number(FIELD_OF_VIEW_DEG).keyed()),
    ]];
}
