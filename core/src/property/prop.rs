//! Models that stand.

use super::described::Described;
use super::row::{Row, angle, number, numbers, range_of, setting, text, vector};
use super::setting::{Numbers, Setting};
use super::{HEADING_DEG, MODEL_SCALE, PITCH_DEG, POSITION, ROLL_DEG};
use crate::scene::Prop;

impl Described for Prop {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        numbers!(position: vector(POSITION).keyed()),
        numbers!(heading_deg: angle(HEADING_DEG).keyed()),
        numbers!(pitch_deg: number(PITCH_DEG).keyed()),
        numbers!(roll_deg: angle(ROLL_DEG).keyed()),
        numbers!(scale: number(MODEL_SCALE).keyed()),
    ]];
}
