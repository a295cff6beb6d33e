//! How a shading group takes the sun: one that several boxes share, or a box's own.

use super::row::{Row, flag, number, range_of, vector};
use super::setting::{Numbers, Setting, Value};
use super::{C_MAX, C_MED, C_MIN, Number, POSITION};
use crate::scene::{CloudBox, GroupCenter, GroupLight, ShadingGroup};
use glam::DVec3;

const PULLED: Number = Number::new(
    "Pull to cloud",
    &(0.0..=1.0),
    "",
    "How far the group's centre moves from its sprites' mean towards the cloud's centre.",
);

/// One of the three shares.
macro_rules! share {
    ($field:ident: $number:expr) => {
        Row::field(
            concat!("light.", stringify!($field)),
            number($number).keyed(),
            |thing, _| Some(thing.light().$field),
            |thing, _, share| thing.light_mut().$field = share,
            |thing| Numbers::are_within(&thing.light().$field, const { range_of(&number($number)) }),
        )
    };
}

/// Has a light of its own.
pub trait HasLight: Sized + 'static {
    /// The light.
    fn light(&self) -> &GroupLight;
    /// The light, to change it.
    fn light_mut(&mut self) -> &mut GroupLight;

    /// The light's properties.
    const LIGHT: &'static [Row<Self>] = &[
        share!(c_max: C_MAX),
        share!(c_med: C_MED),
        share!(c_min: C_MIN),
        Row::of(
            "light.center.at",
            flag("Centre by hand", "The point that the group's sides are seen from stays where it is put."),
            |thing| Some(Value::Flag(matches!(thing.light().center, GroupCenter::At(_)))),
            |thing, value| {
                let center = &mut thing.light_mut().center;
                match (bool::from_value(value)?, *center) {
                    (true, GroupCenter::Mean | GroupCenter::Pulled(_)) => *center = GroupCenter::At(DVec3::ZERO),
                    (false, GroupCenter::At(_)) => *center = GroupCenter::Mean,
                    _ => {}
                }
                Some(())
            },
        ),
        Row::numbers(
            "light.center.at",
            vector(POSITION.called("Group centre")),
            |thing, axis| if let GroupCenter::At(point) = thing.light().center { Some(point[axis]) } else { None },
            |thing, axis, number| {
                if let GroupCenter::At(point) = &mut thing.light_mut().center {
                    point[axis] = number;
                }
            },
        ),
        Row::numbers(
            "light.center.pulled",
            number(PULLED),
            |thing, _| match thing.light().center {
                GroupCenter::Mean => Some(0.0),
                GroupCenter::Pulled(share) => Some(share),
                GroupCenter::At(_) => None,
            },
            |thing, _, share| {
                let center = if share == 0.0 { GroupCenter::Mean } else { GroupCenter::Pulled(share) };
                thing.light_mut().center = center;
            },
        ),
    ];
}

impl HasLight for CloudBox {
    fn light(&self) -> &GroupLight {
        &self.light
    }
    fn light_mut(&mut self) -> &mut GroupLight {
        &mut self.light
    }
}

impl HasLight for ShadingGroup {
    fn light(&self) -> &GroupLight {
        &self.light
    }
    fn light_mut(&mut self) -> &mut GroupLight {
        &mut self.light
    }
}
