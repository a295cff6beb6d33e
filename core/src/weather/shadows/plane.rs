//! The plane across the light on which the shadows for the ground are drawn, and the spot that each sprite makes on it.

use super::{Shadows, formed_at};
use crate::baked::Ball;
use crate::weather::CloudNow;
use glam::{DVec3, Vec3};

/// The most texels along a side: what each renderer has room for.
pub const MOST_TEXELS: u32 = 512;
/// Texels that the largest sprite of a cloud has across half of it, at most: finer shows no more of it.
const ACROSS_HALF: f32 = 8.0;
/// A sun's half width, radians: a shadow's edge is so much softer with each metre of its way.
pub const SUN_RADIUS: f32 = 0.004_65;
/// No spot is smaller than this, texels: it would twinkle.
pub const LEAST_SPOT: f32 = 0.75;

/// Texels on a plane across the light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShadowPlane {
    /// Its axes, unit: one level, one upwards.
    pub axes: [Vec3; 2],
    /// From the scene to the light, unit.
    pub direction: Vec3,
    /// Where the first texel begins along the axes, metres from the world's origin.
    pub from_m: [f64; 2],
    /// A texel's sides, metres.
    pub texel_m: [f32; 2],
    /// How many along each axis, at most [`MOST_TEXELS`]. On those along the edge no shadow falls.
    pub size: [u32; 2],
    /// Height of the ground, metres.
    pub ground_m: f64,
}

/// Two unit vectors across `direction`: a level one, and one that looks up.
pub fn axes_across(direction: Vec3) -> (Vec3, Vec3) {
    let level = Vec3::new(-direction.z, 0.0, direction.x).normalize_or(Vec3::X);
    (level, level.cross(direction))
}

impl ShadowPlane {
    /// Around those of `clouds` that cast a shadow; none if none does.
    pub(in crate::weather) fn new(clouds: &[CloudNow<'_>], direction: Vec3, ground_m: f64) -> Option<Self> {
        let (level, upwards) = axes_across(direction);
        let axes = [level, upwards];
        let (mut low, mut high, mut finest) = ([f64::MAX; 2], [f64::MIN; 2], f32::MAX);
        for cloud in clouds.iter().filter(|cloud| cloud.casts()) {
            let middle = cloud.origin() + cloud.center_now().as_dvec3();
            if !middle.is_finite() {
                continue;
            }
            let soft = penumbra_m(middle.y - ground_m, direction);
            // Level, a cloud is as wide as it is long; upwards, flat ones are less.
            for i in 0..2 {
                let at = middle.dot(axes[i].as_dvec3());
                let reach = f64::from(cloud.reach_now() + soft);
                (low[i], high[i]) = (low[i].min(at - reach), high[i].max(at + reach));
            }
            finest = finest.min(cloud.largest_now() / ACROSS_HALF);
        }
        if low[0] >= high[0] {
            return None;
        }
        let texel_m = [0, 1]
            .map(|i| rounded_up(((high[i] - low[i]) / f64::from(MOST_TEXELS - 4)).max(f64::from(finest)).max(0.01)));
        // With the clouds, so that what all drift alike leaves every texel as it is.
        let from_m = [0, 1].map(|i| low[i] - 1.5 * texel_m[i]);
        let size = [0, 1].map(|i| (((high[i] - from_m[i]) / texel_m[i]).ceil() as u32 + 2).min(MOST_TEXELS));
        Some(Self { axes, direction, from_m, texel_m: texel_m.map(|side| side as f32), size, ground_m })
    }

    /// Where a point of the world falls, texels from the first one's beginning.
    pub fn place(&self, point: DVec3) -> [f32; 2] {
        [0, 1].map(|i| ((point.dot(self.axes[i].as_dvec3()) - self.from_m[i]) / f64::from(self.texel_m[i])) as f32)
    }
}

/// To the next of four steps an octave, so that a cloud that grows does not make all texels grow with it at every moment.
fn rounded_up(metres: f64) -> f64 {
    libm::exp2((libm::log2(metres) * 4.0).ceil() * 0.25)
}

/// How much wider the half of a shadow's edge is than what casts it from so high above the ground, metres.
fn penumbra_m(height_m: f64, direction: Vec3) -> f32 {
    SUN_RADIUS * height_m.max(0.0) as f32 / direction.y
}

/// The shadow of one sprite: an ellipse, in texels of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Its middle.
    pub center: [f32; 2],
    /// Half its sides.
    pub half: [f32; 2],
    /// Optical depth in the middle; at a share r of the half it is (1 − r²)^1.5 of that.
    pub depth: f32,
}

impl Spot {
    /// Tells of each texel of a plane of that size that it covers: which, in rows, and its depth there.
    #[inline]
    pub(super) fn draw(&self, [width, height]: [usize; 2], mut tell: impl FnMut(usize, f32)) {
        let [columns, rows] = [0, 1].map(|i| self.span(i, [width, height][i]));
        for row in rows {
            let down = (row as f32 - self.center[1]) / self.half[1];
            for column in columns.clone() {
                let right = (column as f32 - self.center[0]) / self.half[0];
                let inside = 1.0 - down * down - right * right;
                if inside > 0.0 {
                    tell(row * width + column, self.depth * inside * inside.sqrt());
                }
            }
        }
    }

    /// Whether it may cover texels whose rows lie from one place to another.
    #[inline]
    pub(super) fn reaches_rows(&self, from: f32, to: f32) -> bool {
        self.center[1] + self.half[1] >= from && self.center[1] - self.half[1] <= to
    }

    /// The places along an axis that it may cover, of so many.
    pub(super) fn span(&self, axis: usize, side: usize) -> std::ops::Range<usize> {
        let (center, half) = (self.center[axis], self.half[axis]);
        let from = (center - half).ceil().clamp(0.0, side as f32);
        let to = ((center + half).floor() + 1.0).clamp(from, side as f32);
        from as usize..to as usize
    }
}

/// Those of all sprites of a cloud.
pub fn spots(cloud: &CloudNow<'_>, shadows: &Shadows, plane: &ShadowPlane) -> impl Iterator<Item = Spot> {
    let origin = cloud.origin();
    let [from_x, from_y] = plane.place(origin);
    let above_ground_m = (origin.y - plane.ground_m) as f32;
    let [texel_x, texel_y] = plane.texel_m;
    let depths = &cloud.placed.casts().depths;
    (0..cloud.placed.sprites.len()).filter_map(move |index| {
        let rest = &cloud.placed.sprites[index];
        let shown = formed_at(cloud, rest.position) * cloud.condensed(index) * shadows.opacity;
        let depth = depths[index] * shown;
        if depth <= 0.0 {
            return None;
        }
        let now = cloud.sprite_now(index);
        let soft = penumbra_m(f64::from(above_ground_m + now.position.y), plane.direction);
        let halves = crate::sprites::halves_of([now.width, now.height], now.rotation);
        let half = Ball::new(now.position, halves, 0.0).half_across(plane.direction);
        let texels = [texel_x, texel_y];
        let wider = [0, 1].map(|i| {
            let least = LEAST_SPOT * texels[i];
            (half[i] * half[i] + soft * soft + least * least).sqrt()
        });
        let center =
            [from_x + now.position.dot(plane.axes[0]) / texel_x, from_y + now.position.dot(plane.axes[1]) / texel_y];
        // As much light is taken away, over more ground.
        let depth = depth * (half[0] * half[1]) / (wider[0] * wider[1]);
        Some(Spot { center, half: [wider[0] / texel_x, wider[1] / texel_y], depth })
    })
}
