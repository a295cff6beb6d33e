//! Cloud models with their colour levels and shading groups.

use super::described::{Described, Visitor, enter};
use super::light::HasLight;
use super::owner::Owner;
use super::row::{Row, category, choice, color, number, numbers, range_of, seed, setting, text};
use super::setting::{Choice, Numbers, Setting, Value};
use super::{ALPHA, COLOR, LEVEL_HEIGHT, Number};
use crate::scene::{CloudModel, ColorLevel, CullRadius, ShadingGroup, Thing};
use std::fmt::Arguments;

const SPRITE_FRACTION: &str = "sprite_fraction";
const CLOUD_HEIGHT_FRACTION: &str = "cloud_height_fraction";
const METRES: &str = "metres";
const CULL_KINDS: &[Choice] = &[
    Choice { name: SPRITE_FRACTION, label: "share of the sprite's size" },
    Choice { name: CLOUD_HEIGHT_FRACTION, label: "share of the cloud's height" },
    Choice { name: METRES, label: "metres" },
];

const SELF_SHADOW: Number = Number::new(
    "Self-shadow",
    &(0.0..=1.0),
    "",
    "How much of the sun's light goes by the cloud that it comes through: 0 leaves all to the shading groups.",
);
const HALO: Number =
    Number::new("Halo", &(0.0..=1.0), "", "How much the sun shines through the thin cloud before it: silver linings.");

const CULL_FRACTION: Number = Number::new(
    "Cull radius",
    &(0.0..=10.0),
    "",
    "Sprites nearer than this share of the size to one already kept are dropped.",
);
const CULL_METRES: Number =
    Number::new("Cull radius", &(0.0..=1e5), "m", "Sprites nearer than this to one already kept are dropped.");

impl Described for CloudModel {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        setting!(name: text("Name", "For people.")),
        setting!(category: category()),
        Row::of(
            "cull_radius",
            choice("Cull by", "What the cull radius is measured in.", CULL_KINDS),
            |model| Some(Value::Text(cull_kind(model.cull_radius).into())),
            |model, value| {
                let kind = String::from_value(value)?;
                if kind != cull_kind(model.cull_radius) {
                    model.cull_radius = usual_cull_radius(&kind)?;
                }
                Some(())
            },
        ),
        Row::numbers(
            "cull_radius.sprite_fraction",
            number(CULL_FRACTION),
            |model, _| if let CullRadius::SpriteFraction(share) = model.cull_radius { Some(share) } else { None },
            |model, _, share| model.cull_radius = CullRadius::SpriteFraction(share),
        ),
        Row::numbers(
            "cull_radius.cloud_height_fraction",
            number(CULL_FRACTION),
            |model, _| if let CullRadius::CloudHeightFraction(share) = model.cull_radius { Some(share) } else { None },
            |model, _, share| model.cull_radius = CullRadius::CloudHeightFraction(share),
        ),
        Row::numbers(
            "cull_radius.metres",
            number(CULL_METRES),
            |model, _| if let CullRadius::Metres(metres) = model.cull_radius { Some(metres) } else { None },
            |model, _, metres| model.cull_radius = CullRadius::Metres(metres),
        ),
        numbers!(self_shadow: number(SELF_SHADOW)),
        numbers!(halo: number(HALO)),
        setting!(seed: seed("Seed", "Another number strews the sprites anew.")),
    ]];

    fn enter_parts(&self, _: Owner, place: Arguments<'_>, visitor: &mut impl Visitor) {
        for (i, level) in self.color_levels.iter().enumerate() {
            enter(Owner::Level(self.id, i), format_args!("{place}.color_levels[{i}]"), level, visitor);
        }
        for (i, group) in self.groups.iter().enumerate() {
            let owner = Owner::Thing(Thing::Group(self.id, group.id));
            enter(owner, format_args!("{place}.groups[{i}]"), group, visitor);
        }
        for (i, each) in self.boxes.iter().enumerate() {
            let owner = Owner::Thing(Thing::Box(self.id, each.id));
            enter(owner, format_args!("{place}.boxes[{i}]"), each, visitor);
        }
    }
}

const fn cull_kind(radius: CullRadius) -> &'static str {
    match radius {
        CullRadius::SpriteFraction(_) => SPRITE_FRACTION,
        CullRadius::CloudHeightFraction(_) => CLOUD_HEIGHT_FRACTION,
        CullRadius::Metres(_) => METRES,
    }
}

/// What a radius of that kind begins with.
fn usual_cull_radius(kind: &str) -> Option<CullRadius> {
    match kind {
        SPRITE_FRACTION => Some(CullRadius::SpriteFraction(1.0 / 3.0)),
        CLOUD_HEIGHT_FRACTION => Some(CullRadius::CloudHeightFraction(1.0 / 3.0)),
        METRES => Some(CullRadius::Metres(60.0)),
        _ => None,
    }
}

impl Described for ColorLevel {
    const TABLES: &'static [&'static [Row<Self>]] = &[&[
        numbers!(height: number(LEVEL_HEIGHT).keyed()),
        numbers!("color", color.rgb: color(COLOR).keyed()),
        numbers!(color.a: number(ALPHA).keyed()),
    ]];
}

/// What a shading group is called.
pub const NAME: &[Row<ShadingGroup>] = &[setting!(name: text("Name", "For people."))];

impl Described for ShadingGroup {
    const TABLES: &'static [&'static [Row<Self>]] = &[NAME, Self::LIGHT];
}
