//! Shadows of clouds on clouds.
//!
//! Each cloud stands for itself by at most 32 balls, which let through about what its sprites do. Where one stands between
//! another and the light, their spots are drawn on a small grid across the light, over the other: a sprite's own cloud shades
//! it by what is baked.

use super::plane::{Spot, axes_across};
use super::{FALLOFF, Shadows, formed_at};
use crate::baked::{Ball, Ray};
use crate::weather::{CloudNow, Shade};
use glam::{DVec3, Vec2, Vec3};
use rayon::prelude::*;
use std::sync::Arc;

/// Nodes that half of a ball has across it, in the mean.
const NODES_ACROSS_HALF: f32 = 2.5;
/// The least and the most nodes along a side.
const NODES: [u32; 2] = [4, 24];
/// No spot is smaller than this, nodes.
const LEAST_SPOT: f32 = 0.75;
/// An optical depth that takes nothing that shows.
const SEEN: f32 = 0.02;

/// Of each of `clouds`, the shade of those others that cast one. The same bytes on any number of threads.
pub fn shades(clouds: &[CloudNow<'_>], shadows: &Shadows) -> Vec<Option<Shade>> {
    let spheres: Vec<Sphere> = clouds.par_iter().map(|cloud| Sphere::of(cloud, shadows.direction)).collect();
    let casters = Casters::new((0..clouds.len()).filter(|at| clouds[*at].casts()), &spheres);
    let shade_of = |at: usize| {
        let over: Vec<&CloudNow<'_>> = casters.over(at).map(|from| &clouds[from]).collect();
        if over.is_empty() || !clouds[at].shows() { None } else { shade_on(&clouds[at], &over, shadows) }
    };
    (0..clouds.len()).into_par_iter().with_min_len(8).map(shade_of).collect()
}

/// The clouds that cast shadows, side by side.
struct Casters<'a> {
    spheres: &'a [Sphere],
    /// In order of where they stand along one axis across the light.
    order: Vec<usize>,
    largest: f64,
}

impl<'a> Casters<'a> {
    fn new(casters: impl Iterator<Item = usize>, spheres: &'a [Sphere]) -> Self {
        let mut order: Vec<usize> = casters.collect();
        order.sort_by(|a, b| spheres[*a].across[0].total_cmp(&spheres[*b].across[0]).then(a.cmp(b)));
        let largest = order.iter().map(|at| spheres[*at].radius).fold(0.0, f64::max);
        Self { spheres, order, largest }
    }

    /// Those that come over the cloud of that index.
    fn over(&self, at: usize) -> impl Iterator<Item = usize> {
        let on = &self.spheres[at];
        let (middle, reach) = (on.across[0], on.radius + self.largest);
        let first = self.order.partition_point(|from| self.spheres[*from].across[0] < middle - reach);
        let beside =
            self.order[first..].iter().take_while(move |from| self.spheres[**from].across[0] <= middle + reach);
        let comes_over = move |from: &usize| {
            let sphere = &self.spheres[*from];
            *from != at && sphere.reaches > on.begins && sphere.is_across(on)
        };
        beside.copied().filter(comes_over)
    }
}

/// A cloud as it stands to the light.
struct Sphere {
    /// Its middle, across the light, metres.
    across: [f64; 2],
    radius: f64,
    /// How far along the light it begins and ends, metres.
    begins: f64,
    reaches: f64,
}

impl Sphere {
    fn of(cloud: &CloudNow<'_>, direction: Vec3) -> Self {
        let middle = cloud.origin() + cloud.center_now().as_dvec3();
        let (along, radius) = (middle.dot(direction.as_dvec3()), f64::from(cloud.reach_now()));
        let (level, upwards) = axes_across(direction);
        let across = [level, upwards].map(|axis| middle.dot(axis.as_dvec3()));
        Self { across, radius, begins: along - radius, reaches: along + radius }
    }

    fn is_across(&self, other: &Self) -> bool {
        let [x, y] = [0, 1].map(|i| self.across[i] - other.across[i]);
        let radii = self.radius + other.radius;
        x * x + y * y < radii * radii
    }
}

fn shade_on(cloud: &CloudNow<'_>, casters: &[&CloudNow<'_>], shadows: &Shadows) -> Option<Shade> {
    let (level, upwards) = axes_across(shadows.direction);
    let (middle, reach) = (cloud.center_now(), cloud.reach_now());
    let low = Vec2::new(middle.dot(level), middle.dot(upwards)) - reach;
    let balls: Vec<(Ball, f32)> = casters.iter().flat_map(|from| balls_over(cloud, from, shadows)).collect();
    let mean_half = balls.iter().map(|(ball, _)| ball.reach()).sum::<f32>() / balls.len().max(1) as f32;
    let nodes = ((2.0 * reach * NODES_ACROSS_HALF / mean_half.max(1e-3)).ceil() as u32).clamp(NODES[0], NODES[1]);
    let (last, side) = ((nodes - 1) as f32, nodes as usize);
    let nodes_a_metre = last / (2.0 * reach).max(1e-3);
    let mut sums = vec![[0.0_f32; 3]; side * side];
    let mut most = 0.0_f32;
    for (ball, depth) in &balls {
        let on_grid = Vec2::new(ball.center.dot(level), ball.center.dot(upwards)) - low;
        let [x, y] = ball.half_across(shadows.direction);
        let (half, wider) = (Vec2::new(x, y), LEAST_SPOT / nodes_a_metre);
        let half_now = Vec2::new(x.hypot(wider), y.hypot(wider));
        let spot = Spot {
            center: (on_grid * nodes_a_metre).to_array(),
            half: (half_now * nodes_a_metre).to_array(),
            depth: depth * (half.x * half.y) / (half_now.x * half_now.y),
        };
        let stands = ball.center.dot(shadows.direction);
        spot.draw([side, side], |at, depth| {
            let [all, along, deep] = &mut sums[at];
            (*all, *along, *deep) = (*all + depth, *along + depth * stands, *deep + depth * ball.reach());
            most = most.max(*all);
        });
    }
    (most > SEEN).then(|| Shade {
        axes: [level, upwards],
        direction: shadows.direction,
        low,
        nodes_a_metre: Vec2::splat(nodes_a_metre),
        size: [nodes; 2],
        share: shadows.share,
        nodes: Arc::from(sums),
    })
}

/// The balls of `from` that come over `cloud`, from whose origin they count, with their depths now.
fn balls_over<'c>(
    cloud: &CloudNow<'_>,
    from: &'c CloudNow<'_>,
    shadows: &Shadows,
) -> impl Iterator<Item = (Ball, f32)> + use<'c> {
    let offset = (from.origin() - cloud.origin()).as_vec3();
    let (middle, reach, direction) = (cloud.center_now(), cloud.reach_now(), shadows.direction);
    let shown = shadows.opacity * condensed(from);
    from.placed.casts().few.iter().filter_map(move |ball| {
        let now = Ball { center: ball_now(from, ball).center + offset, ..ball_now(from, ball) };
        let off = now.center - middle;
        let (along, near) = (off.dot(direction), now.reach() + reach);
        let comes_over = along > -near && off.length_squared() - along * along < near * near;
        let depth = if comes_over { ball.depth * formed_at(from, ball.center) * shown } else { 0.0 };
        (depth > 0.0).then_some((now, depth))
    })
}

/// A ball of a cloud's, metres from its origin, as it is now.
fn ball_now(cloud: &CloudNow<'_>, ball: &Ball) -> Ball {
    let inverse_half = ball.inverse_half.map(|inverse| inverse / cloud.scale);
    Ball { center: cloud.point_now(ball.center), inverse_half, depth: ball.depth }
}

/// How much of a cloud's sprites has condensed, in the mean.
fn condensed(cloud: &CloudNow<'_>) -> f32 {
    cloud.air.as_ref().map_or(1.0, |air| air.air.humidity.clamp(0.0, 1.0))
}

/// What is left of the light at a point of the world, by the balls of `cloud` that lie towards it from there.
pub fn left_at(clouds: &[CloudNow<'_>], shadows: &Shadows, point: DVec3) -> f32 {
    let ray = Ray::towards(shadows.direction);
    let of_cloud = |cloud: &CloudNow<'_>| {
        let from_origin = (point - cloud.origin()).as_vec3();
        let off = cloud.center_now() - from_origin;
        let (along, reach) = (off.dot(shadows.direction), cloud.reach_now());
        if along < -reach || off.length_squared() - along * along > reach * reach || !cloud.casts() {
            return 0.0;
        }
        let of = |ball: &Ball| {
            let depth = ball_now(cloud, ball).depth_beyond(from_origin, ray);
            if depth > 0.0 { depth * formed_at(cloud, ball.center) } else { 0.0 }
        };
        cloud.placed.casts().few.iter().map(of).sum::<f32>() * shadows.opacity * condensed(cloud)
    };
    crate::math::exp(-FALLOFF * clouds.iter().map(of_cloud).sum::<f32>())
}
