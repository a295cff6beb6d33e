//! A cloud at a moment: what of it the clock moves.
//!
//! A placed cloud is at rest. What the clock makes of it, however it does, is said here for the whole cloud: where it has
//! been carried, how it is turned, scaled and grown, how far it has formed, and what air it is in. What a sprite is now
//! follows ([`CloudNow::sprite_now`]); what turns, fades, sorts or bounds sprites goes by that. Their light goes by where
//! they are at rest, so that what moves doesn't flicker (MODEL §9). The twin in WGSL is
//! render/src/pass/sprites/sprites.wgsl.

use super::{AirNow, Formed, Shade};
use crate::baked::Baked;
use crate::scene::{ColorLevels, level_color};
use crate::sprites::{Group, PlacedCloud, Sprite, Stir};
use glam::{DVec3, Vec3};
use std::sync::Arc;

/// How far a cloud's edges can be carried, in its radius.
pub const REACH: f32 = 0.5;

/// A cloud at one moment.
#[derive(Debug, Clone)]
pub struct CloudNow<'a> {
    /// The cloud at rest.
    pub placed: &'a PlacedCloud,
    /// How far it has formed.
    pub formed: Formed,
    /// How far it has been carried from where it is placed, metres along the world's axes.
    pub displacement: DVec3,
    /// How it is turned about its origin since it was placed.
    pub turn: Turn,
    /// How much larger it is than as it is placed, its sprites with it.
    pub scale: f32,
    /// What heights above its bottom are multiplied with: 1 as it is placed. Sprites keep their size.
    pub growth: f32,
    /// A factor of its sprites' alpha, 0 to 1.
    pub opacity: f32,
    /// Colours and light of its own, if those are not as it was placed.
    pub look: Option<Arc<Look>>,
    /// The air that moves its sprites one by one, if it does.
    pub air: Option<InAir<'a>>,
    /// The light that is left at its sprites, as far as it is baked; none if the cloud is not lit by it.
    pub baked: Option<&'a Baked>,
    /// What other clouds leave of the directional light, if any takes some.
    pub shade: Option<Shade>,
    /// Whether someone looks who has hidden it: then it casts no shadow.
    pub is_hidden: bool,
}

/// What a cloud looks like.
#[derive(Debug, Clone, PartialEq)]
pub struct Look {
    /// Ambient light over the height.
    pub color_levels: ColorLevels,
    /// Shading groups, in the placed cloud's order.
    pub groups: Arc<[Group]>,
}

/// The air that a cloud is in.
#[derive(Debug, Clone, Copy)]
pub struct InAir<'a> {
    /// The air.
    pub air: AirNow,
    /// What it makes of each of the cloud's sprites.
    pub stirs: &'a [Stir],
    /// How far the cloud's edges can be carried, metres.
    pub reach_m: f32,
}

/// A turn about the vertical, counter-clockwise as seen from above; none for a cloud that has not been turned, so that
/// every bit of it stays.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turn(Option<[f32; 2]>);

impl Turn {
    /// As it was placed.
    pub const NONE: Self = Self(None);

    /// By that sine and cosine.
    pub fn by(sin: f32, cos: f32) -> Self {
        Self(Some([sin, cos]))
    }

    /// Sine and cosine.
    pub fn sin_cos(self) -> [f32; 2] {
        self.0.unwrap_or([0.0, 1.0])
    }

    /// `v` turned.
    #[inline]
    fn turned(self, v: Vec3) -> Vec3 {
        let Some([sin, cos]) = self.0 else { return v };
        Vec3::new(cos * v.x + sin * v.z, v.y, cos * v.z - sin * v.x)
    }

    /// `v` turned back.
    #[inline]
    fn turned_back(self, v: Vec3) -> Vec3 {
        let Some([sin, cos]) = self.0 else { return v };
        Vec3::new(cos * v.x - sin * v.z, v.y, sin * v.x + cos * v.z)
    }
}

impl<'a> CloudNow<'a> {
    /// The whole cloud as it is placed.
    pub fn at_rest(placed: &'a PlacedCloud) -> Self {
        Self {
            placed,
            formed: Formed::WHOLE,
            displacement: DVec3::ZERO,
            turn: Turn::NONE,
            scale: 1.0,
            growth: 1.0,
            opacity: 1.0,
            look: None,
            air: None,
            baked: placed.baked(),
            shade: None,
            is_hidden: false,
        }
    }

    /// Where its origin is, metres in the world.
    pub fn origin(&self) -> DVec3 {
        self.placed.origin + self.displacement
    }

    /// Where its origin lies from `eye`, metres. The subtraction is in f64, so it is exact far from the world's origin.
    pub fn from_eye(&self, eye: DVec3) -> Vec3 {
        (self.origin() - eye).as_vec3()
    }

    /// Ambient light over the height.
    pub fn color_levels(&self) -> &ColorLevels {
        self.look.as_ref().map_or(&self.placed.color_levels, |look| &look.color_levels)
    }

    /// Shading groups.
    pub fn groups(&self) -> &Arc<[Group]> {
        self.look.as_ref().map_or(&self.placed.groups, |look| &look.groups)
    }

    /// The sprite of that index, which may be a merged one's, as it is now; its position counts from the cloud's origin.
    #[inline]
    pub fn sprite_now(&self, index: usize) -> Sprite {
        let rest = self.placed.sprites.all()[index];
        let mut now = Sprite { position: self.point_now(rest.position), ..rest };
        if self.scale != 1.0 {
            (now.width, now.height) = (rest.width * self.scale, rest.height * self.scale);
        }
        if let Some(InAir { air, stirs, reach_m }) = &self.air {
            let stir = &stirs[index];
            let height = self.placed.height_of(rest.position.y);
            now.position += air.carries(stir, height, *reach_m, now.width.min(now.height));
            let turns = stir.turn * air.turned;
            now.rotation += std::f32::consts::TAU * (turns - turns.floor());
        }
        now
    }

    /// How much of the sprite of that index there is in this air, 0 to 1; a factor of its alpha.
    #[inline]
    pub fn condensed(&self, index: usize) -> f32 {
        self.air.as_ref().map_or(1.0, |InAir { air, stirs, .. }| air.condensed(&stirs[index]))
    }

    /// From the centre of a sprite that is now so to a point of its quad, as that lies in the cloud at rest, where light is
    /// taken; the same directions otherwise.
    #[inline]
    pub fn at_rest_from(&self, offset: Vec3) -> Vec3 {
        let turned = self.turn.turned_back(offset);
        if self.scale == 1.0 { turned } else { turned / self.scale }
    }

    /// What other clouds leave of the directional light at a point that counts from the cloud's origin, e^(−τ/10).
    #[inline]
    pub fn shade_at(&self, point: Vec3) -> f32 {
        self.shade.as_ref().map_or(1.0, |shade| shade.at(point))
    }

    /// A direction of the world as it lies to the cloud at rest.
    pub fn direction_at_rest(&self, direction: Vec3) -> Vec3 {
        self.turn.turned_back(direction)
    }

    /// A direction of the cloud at rest as it lies in its model's space.
    #[inline]
    pub fn in_model(&self, at_rest: Vec3) -> Vec3 {
        let [sin, cos] = self.placed.heading;
        Turn::by(sin, cos).turned_back(at_rest)
    }

    /// Where the middle of the sprites' centres is, but for what the air does, metres from the cloud's origin.
    pub fn center_now(&self) -> Vec3 {
        self.point_now(self.placed.center)
    }

    /// How far from [`Self::center_now`] no sprite's centre lies, metres.
    pub fn radius_now(&self) -> f32 {
        self.placed.radius * self.stretch() + self.air_m()
    }

    /// How far the air carries any sprite at most, metres.
    pub fn air_m(&self) -> f32 {
        let most =
            |InAir { air, reach_m, .. }: &InAir<'_>| air.most_m(*reach_m, 2.0 * self.placed.largest * self.scale);
        self.air.as_ref().map_or(0.0, most)
    }

    /// How long what is so long in its model is now at most, but for what the air does; metres.
    pub fn length_now(&self, model_m: f32) -> f32 {
        model_m * self.placed.cloud.scale as f32 * self.stretch()
    }

    /// The radius of a sphere about [`Self::center_now`] that holds every quad, metres.
    pub fn reach_now(&self) -> f32 {
        let quads = (self.placed.reach - self.placed.radius) * self.scale;
        if self.stands() { self.placed.reach } else { self.radius_now() + quads.max(0.0) }
    }

    /// The largest radius of a sprite, metres.
    pub fn largest_now(&self) -> f32 {
        self.placed.largest * self.scale
    }

    /// What no distance between two points of it has grown by more than, but for what the air does.
    fn stretch(&self) -> f32 {
        self.growth.max(1.0) * self.scale
    }

    fn stands(&self) -> bool {
        self.air.is_none() && self.scale == 1.0 && self.growth == 1.0
    }

    /// Opacity at a distance from its centre, in radii and at rest.
    pub fn opacity_at(&self, radii: f32) -> f32 {
        self.formed.opacity(radii) * self.opacity
    }

    /// How opaque its colour levels make sprites at rest at a height, metres from its origin; 0 to 1.
    pub fn opacity_at_height(&self, y: f32) -> f32 {
        level_color(self.color_levels(), self.placed.height_of(y)).a.clamp(0.0, 1.0)
    }

    /// Whether there is anything of it.
    pub fn shows(&self) -> bool {
        self.formed.shows()
            && self.opacity > 0.0
            && self.air.as_ref().is_none_or(|in_air| in_air.air.humidity > -super::CONDENSING)
    }

    /// Whether it casts a shadow.
    pub fn casts(&self) -> bool {
        self.shows() && !self.is_hidden
    }

    /// Where a point of the cloud at rest is now, but for what the air does.
    #[inline]
    pub fn point_now(&self, point: Vec3) -> Vec3 {
        // At rest what is added is zero, and every bit stays.
        let grown = Vec3 { y: point.y + (point.y - self.placed.bottom) * (self.growth - 1.0), ..point };
        let turned = self.turn.turned(grown);
        if self.scale == 1.0 { turned } else { turned * self.scale }
    }
}
