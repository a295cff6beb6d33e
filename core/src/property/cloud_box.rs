//! Boxes and the sprites in them that were changed by hand.

use super::described::{Described, Visitor, enter};
use super::light::HasLight;
use super::owner::Owner;
use super::row::{
    Row, angle, angles, category, counts, flag, integer, number, numbers, range, range_of, seed, setting, text, thing,
    vector,
};
use super::setting::{Kind, Numbers, Setting, Value};
use super::{BOX_SIZE, HEADING_DEG, Number, PITCH_DEG, POSITION, ROLL_DEG, SPRITE_PLACE, SPRITE_SIZE};
use crate::scene::{CloudBox, SpriteEdit, Thing};
use glam::{DQuat, EulerRot};
use std::fmt::Arguments;

const SPRITE_COUNT: Number =
    Number::new("Sprites", &(0.0..=1e6), "", "How many sprites are tried in the box, before culling.");
const ROTATION_DEG: Number =
    Number::new("Rotation", &(-360.0..=360.0), "°", "Range of the sprites' own turn, counter-clockwise as seen.");
const TILE: Number = Number::new("Tile", &(0.0..=15.0), "", "Which tile of the sheet it shows, row by row.");
const LUMPS: Number = Number::new(
    "Lumps",
    &(1.0..=16.0),
    "",
    "Into how many lumps, along each axis, the box's sprites are split for shading.",
);

/// Where a box lies, how large it is, and how it is turned.
pub const PLACE: &[Row<CloudBox>] = &[
    setting!(name: text("Name", "For people.")),
    numbers!(center: vector(POSITION.called("Centre"))),
    numbers!(size: vector(BOX_SIZE)),
    turn::<0>("orientation.heading_deg", HEADING_DEG.called("Turn")),
    turn::<1>("orientation.pitch_deg", PITCH_DEG.called("Tilt")),
    turn::<2>("orientation.roll_deg", ROLL_DEG.called("Bank")),
];

/// What a box is filled with.
pub const SPRITES: &[Row<CloudBox>] = &[
    numbers!(sprite_count: integer(SPRITE_COUNT)),
    numbers!(width: range(SPRITE_SIZE.called("Width"))),
    numbers!(height: range(SPRITE_SIZE.called("Height"))),
    numbers!(rotation_deg: angles(ROTATION_DEG)),
    setting!(category: category().or("the model's")),
    setting!(key: seed("Key", "Another number strews this box's sprites anew, and no other's.").or("the box's id")),
];

/// How a box's sprites fall into groups.
pub const SHADING: &[Row<CloudBox>] = &[
    setting!(group: thing("Group", "Sprites of one group take the sun as one lump.", Kind::Group).or("its own")),
    numbers!(lumps: counts(LUMPS)),
];

/// Where a box comes from, if it has been joined from another cloud.
const ORIGIN: &[Row<CloudBox>] =
    &[setting!(seed: seed("Seed", "Stands for the cloud's seed, in a box from another cloud.").or("the cloud's"))];

impl Described for CloudBox {
    const TABLES: &'static [&'static [Row<Self>]] = &[PLACE, SPRITES, SHADING, Self::LIGHT, ORIGIN];

    fn enter_parts(&self, owner: Owner, place: Arguments<'_>, visitor: &mut impl Visitor) {
        let Owner::Thing(Thing::Box(model, id)) = owner else { return };
        for (i, edit) in self.sprite_edits.iter().enumerate() {
            let owner = Owner::Thing(Thing::Sprite(model, id, edit.index));
            enter(owner, format_args!("{place}.sprite_edits[{i}]"), edit, visitor);
        }
    }
}

impl Described for SpriteEdit {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(moved?: vector(SPRITE_PLACE)),
        numbers!(width?: number(SPRITE_SIZE.called("Width"))),
        numbers!(height?: number(SPRITE_SIZE.called("Height"))),
        numbers!(rotation_deg?: angle(ROTATION_DEG)),
        numbers!(tile?: integer(TILE)),
        setting!(dropped: flag("Taken out", "Whether the sprite was taken out by hand.")),
        setting!(group: thing("Group", "The group that the sprite was put into by hand.", Kind::Group).or("its box's")),
    ]];
}

/// Heading, pitch or roll of a box. The file keeps the quaternion, which has a check of its own: so these are no numbers
/// of the file.
const fn turn<const ANGLE: usize>(path: &'static str, degrees: Number) -> Row<CloudBox> {
    Row::of(
        path,
        if ANGLE == 1 { number(degrees) } else { angle(degrees) },
        |each| Some(Value::Number(angles_deg(each.orientation)[ANGLE])),
        |each, value| {
            let Value::Number(number) = *value else { return None };
            let mut angles = angles_deg(each.orientation);
            if angles[ANGLE] != number {
                angles[ANGLE] = number;
                let [heading, pitch, roll] = angles.map(f64::to_radians);
                each.orientation = DQuat::from_euler(EulerRot::YXZ, -heading, pitch, -roll).normalize();
            }
            Some(())
        },
    )
}

/// Heading, pitch and roll.
fn angles_deg(orientation: DQuat) -> [f64; 3] {
    let (heading, pitch, roll) = orientation.to_euler(EulerRot::YXZ);
    // Adding 0 turns −0 into 0.
    [-heading, pitch, -roll].map(|angle| angle.to_degrees() + 0.0)
}
