//! The clouds of a scene at a moment: their tracks, the wind that carries them, and where they wrap round.

use super::cloud_now::{InAir, REACH, Turn};
use super::{AirNow, CloudNow, Formed, FormingRule, Look, Timeline, WeatherRules};
use crate::math::smoothstep;
use crate::scene::{Cloud, CloudModel, ModelId, Region, Weather};
use crate::sprites::{Group, GroupKey, PlacedCloud, heading_turn};
use glam::{DVec2, DVec3};
use rayon::prelude::*;
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// How much higher a base lies for each degree that the dew point is below the temperature, metres (Espy 1841).
const LIFT_M_PER_C: f64 = 125.0;

/// What is known of a moment before any cloud is looked at.
struct Course<'a> {
    timeline: &'a Timeline,
    clock_s: f64,
    forming: FormingRule,
    air: Option<AirNow>,
    /// Carried by the wind, metres.
    way_m: DVec2,
    lift_m: f64,
    growth: f64,
    region: Option<Region>,
}

/// All of `clouds` at `clock_s`, seconds of the scene's clock, by its `timeline`; clouds form and stream by those rules.
pub fn clouds_now<'a>(
    clouds: &'a [PlacedCloud],
    timeline: &Timeline,
    clock_s: f64,
    rules: WeatherRules,
) -> Vec<CloudNow<'a>> {
    // What is no time is the beginning.
    let clock_s = if clock_s.is_finite() { clock_s } else { 0.0 };
    let weather = timeline.weather_at(clock_s);
    let rest = timeline.weather();
    let wind = timeline.wind();
    let spread_c = |weather: &Weather| weather.temperature_c - weather.dew_point_c;
    let blown = wind.map(|wind| (rules.streaming.lean(wind, clock_s, rest.lag_s), wind.blown_m(clock_s)));
    let course = Course {
        timeline,
        clock_s,
        forming: rules.forming,
        air: AirNow::new(&weather, blown, clock_s),
        way_m: wind.map_or(DVec2::ZERO, |wind| wind.way_m(clock_s)),
        lift_m: LIFT_M_PER_C * (spread_c(&weather) - spread_c(rest)),
        growth: weather.growth,
        region: rest.region.filter(|_| wind.is_some()),
    };
    if course.air.is_some() {
        // Made once, by all cores.
        clouds.par_iter().for_each(|cloud| {
            cloud.stirs();
        });
    }
    let mut now: Vec<CloudNow<'_>> = clouds.iter().map(|placed| course.cloud(placed)).collect();
    course.keyed_looks(&mut now);
    now
}

impl<'a> Course<'_> {
    /// A cloud as its tracks have it, or as it was placed.
    fn cloud(&self, placed: &'a PlacedCloud) -> CloudNow<'a> {
        let rest = &placed.cloud;
        let of_share = (rest.wind_share > 0.0).then(|| self.way_m * rest.wind_share);
        match self.timeline.cloud_at(rest, self.clock_s) {
            Some(now) => self.as_keyed(placed, &now, self.timeline.way_m(placed.id, self.clock_s).or(of_share)),
            None => self.as_keyed(placed, rest, of_share),
        }
    }

    /// A cloud that is `now` what its tracks make of it. `way_m`: how far the wind has carried it; none if it never does.
    fn as_keyed(&self, placed: &'a PlacedCloud, now: &Cloud, way_m: Option<DVec2>) -> CloudNow<'a> {
        let rest = &placed.cloud;
        let mut cloud = CloudNow::at_rest(placed);
        cloud.formed = match now.formed {
            Some(formed) => Formed::by_hand(&formed, now.formation.as_ref()),
            None => self.forming.formed(now.formation.as_ref(), self.clock_s),
        };
        cloud.opacity = now.opacity as f32;
        cloud.growth = (now.growth * (1.0 + (self.growth - 1.0) * now.base_share)) as f32;
        if now.heading_deg != rest.heading_deg || now.scale != rest.scale || now.position != rest.position {
            self.replace(&mut cloud, now);
        }
        cloud.displacement.y += self.lift_m * now.base_share;
        if let Some(way_m) = way_m {
            cloud.displacement += DVec3::new(way_m.x, 0.0, way_m.y);
            // Who lets go of the wind stays in the region.
            if let Some(region) = &self.region {
                cloud.formed = cloud.formed.and(wrap(region, &mut cloud));
            }
        }
        cloud.air =
            self.air.map(|air| InAir { air, stirs: placed.stirs(), reach_m: REACH * placed.radius * cloud.scale });
        cloud
    }

    /// Puts it where `now` has it: turned and scaled about where its model's origin stands.
    fn replace(&self, cloud: &mut CloudNow<'_>, now: &Cloud) {
        let placed = cloud.placed;
        let rest = &placed.cloud;
        let turn = heading_turn(now.heading_deg - rest.heading_deg);
        let (scale, arm) = (now.scale / rest.scale, placed.origin - rest.position);
        cloud.displacement = now.position + turn * (arm * scale) - placed.origin;
        // About +y by twice the half-angle that the quaternion holds.
        let (half_sin, half_cos) = (turn.y, turn.w);
        cloud.turn = Turn::by((2.0 * half_sin * half_cos) as f32, (half_cos * half_cos - half_sin * half_sin) as f32);
        cloud.scale = scale as f32;
    }

    /// Colours and light of models that have tracks of them.
    fn keyed_looks(&self, clouds: &mut [CloudNow<'_>]) {
        if !self.timeline.moves_looks() {
            return;
        }
        let mut models: FxHashMap<ModelId, Option<CloudModel>> = FxHashMap::default();
        for cloud in clouds {
            let id = cloud.placed.cloud.model;
            let now = models.entry(id).or_insert_with(|| self.timeline.model_at(id, self.clock_s));
            cloud.look = now.as_ref().map(|now| Arc::new(look(cloud.placed, now)));
        }
    }
}

fn look(placed: &PlacedCloud, now: &CloudModel) -> Look {
    let light = |group: &Group| match group.key {
        GroupKey::Named(id) => now.groups.with_id(id).map(|group| group.light),
        GroupKey::Lump(id, _) => now.boxes.with_id(id).map(|each| each.light),
    };
    let shares = |group: &Group| {
        let light = light(group);
        light.map_or(group.c, |light| [light.c_min, light.c_med, light.c_max].map(|c| c as f32))
    };
    // Where only colours have tracks, the groups are those at rest, and known as such to who draws.
    let groups = if placed.groups.iter().all(|group| shares(group) == group.c) {
        Arc::clone(&placed.groups)
    } else {
        placed.groups.iter().map(|group| Group { c: shares(group), ..*group }).collect()
    };
    Look { color_levels: now.color_levels, groups }
}

/// Brings a cloud that has drifted out of `region` in again on the other side, and tells how far it has formed so near to
/// the border: at the border itself nothing of it shows, so nothing is seen to jump.
fn wrap(region: &Region, cloud: &mut CloudNow<'_>) -> Formed {
    let Region { center_x_m, center_z_m, width_m, depth_m, border_m } = *region;
    let middle = cloud.origin() + cloud.center_now().as_dvec3();
    let mut whole = f64::INFINITY;
    let mut along = |at: f64, center: f64, side: f64| {
        let from_low = (at - center + 0.5 * side).rem_euclid(side);
        whole = whole.min(from_low.min(side - from_low));
        center - 0.5 * side + from_low - at
    };
    cloud.displacement.x += along(middle.x, center_x_m, width_m);
    cloud.displacement.z += along(middle.z, center_z_m, depth_m);
    Formed::of_progress(if border_m > 0.0 { smoothstep(0.0, border_m as f32, whole as f32) } else { 1.0 })
}
