//! Where clouds stand at the clock's time: as their tracks have them, carried by the wind and lifted with the base.
//!
//! Boxes, outlines and handles stand there. What a hand then moves is the cloud's own place; how far the air has carried it
//! from there stays.

use crate::state::Reading;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::Cloud;
use cloudwright_core::sprites::PlacedCloud;
use cloudwright_core::weather::CloudNow;
use glam::DVec3;
use std::borrow::Cow;
use std::cell::OnceCell;

/// Of one frame.
pub(super) struct Places<'a> {
    reading: &'a Reading<'a>,
    /// All clouds, if any is asked for and the clock moves some.
    now: OnceCell<Vec<CloudNow<'a>>>,
}

impl<'a> Places<'a> {
    pub(super) fn of(reading: &'a Reading<'a>) -> Self {
        Self { reading, now: OnceCell::new() }
    }

    /// How far the air has carried `cloud` from where its tracks have it, metres.
    pub(super) fn drift(&self, cloud: &Cloud) -> DVec3 {
        let derived = self.reading.session.derived();
        let timeline = derived.timeline();
        if !timeline.moves() {
            return DVec3::ZERO;
        }
        let now = derived.index_of(cloud.id).and_then(|at| self.now.get_or_init(|| self.reading.clouds_now()).get(at));
        now.map_or(DVec3::ZERO, |now| drift_of(self.reading, cloud, now))
    }

    /// `cloud` where it is seen.
    pub(super) fn seen<'c>(&self, cloud: &'c Cloud) -> Cow<'c, Cloud> {
        drifted(self.reading, cloud, self.drift(cloud))
    }

    /// The middle of its sprites where it is seen.
    pub(super) fn middle(&self, cloud: &Cloud) -> DVec3 {
        let seen = self.seen(cloud);
        let placed = self.reading.session.placed(cloud.id);
        placed.map_or(seen.position, |placed| middle_of(placed, cloud, &seen))
    }
}

/// `cloud`, which is `now` so, where it is seen.
pub(super) fn seen_as<'c>(reading: &Reading<'_>, cloud: &'c Cloud, now: &CloudNow<'_>) -> Cow<'c, Cloud> {
    drifted(reading, cloud, drift_of(reading, cloud, now))
}

fn drifted<'c>(reading: &Reading<'_>, cloud: &'c Cloud, drift: DVec3) -> Cow<'c, Cloud> {
    let mut now = reading.cloud_now(cloud);
    if drift != DVec3::ZERO {
        now.to_mut().position += drift;
    }
    now
}

fn drift_of(reading: &Reading<'_>, cloud: &Cloud, now: &CloudNow<'_>) -> DVec3 {
    let by_tracks = reading.session.derived().timeline().cloud_at(cloud, reading.clock.time_s());
    now.origin() - middle_of(now.placed, cloud, by_tracks.as_ref().unwrap_or(cloud))
}

/// Where the middle of a placed cloud's sprites is when the cloud is `now` elsewhere.
fn middle_of(placed: &PlacedCloud, cloud: &Cloud, now: &Cloud) -> DVec3 {
    if now == cloud {
        return placed.origin;
    }
    ModelSpace::of(now).to_world(ModelSpace::of(cloud).from_world(placed.origin))
}
