//! Where a cloud's model lies in the world: the one mapping that joining, splitting and moving sprites share.

use crate::scene::{Cloud, GroupCenter, GroupLight};
use crate::sprites::heading_turn;
use glam::{DQuat, DVec3};

/// The space of a cloud's model: uniform scale, then a turn about the world's up, then a shift.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ModelSpace {
    /// Where its origin lies, metres in the world.
    pub origin: DVec3,
    /// From its axes to the world's.
    pub turn: DQuat,
    /// Metres in the world for one of its metres.
    pub scale: f64,
}

impl ModelSpace {
    /// That of `cloud`.
    pub fn of(cloud: &Cloud) -> Self {
        Self { origin: cloud.position, turn: heading_turn(cloud.heading_deg), scale: cloud.scale }
    }

    /// The world's place of a point of the model.
    pub fn to_world(&self, point: DVec3) -> DVec3 {
        self.origin + self.turn * (point * self.scale)
    }

    /// The model's point at a place in the world. No number where the scale is 0.
    pub fn from_world(&self, point: DVec3) -> DVec3 {
        self.turn.conjugate() * (point - self.origin) / self.scale
    }

    /// A group's light whose centre, if put by hand, stays where it is in the world when the group comes from `other`.
    pub(super) fn light_from(&self, other: &Self, light: GroupLight) -> GroupLight {
        let center = match light.center {
            GroupCenter::At(point) => GroupCenter::At(self.from_world(other.to_world(point))),
            center => center,
        };
        GroupLight { center, ..light }
    }
}
