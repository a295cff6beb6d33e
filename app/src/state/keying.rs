//! What fields and handles show of keyed properties, and what it takes to key them.

use super::action::Action;
use super::reading::Reading;
use cloudwright_core::arrange::keys::{self, SAME_S};
use cloudwright_core::property::{Owner, Target};
use cloudwright_core::scene::{Cloud, KeyValue, Thing};
use std::borrow::Cow;

/// How properties stand to their tracks, at the clock's time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Keyed {
    /// None has a track.
    Not,
    /// At least one has a track, but not all a key here.
    Elsewhere,
    /// All have a key here.
    Here,
    /// A hand has changed one since.
    Changed,
}

/// Properties of the same row in several things, with the values that they show.
pub(crate) type Values = Vec<(Target, KeyValue)>;

impl Reading<'_> {
    /// The number that a track gives `target` at the clock's time; none without a track, or if a hand has changed it since.
    pub(crate) fn keyed_number(&self, target: &Target, part: usize) -> Option<f64> {
        let curve = self.session.derived().timeline().curve(target.owner, target.property.path)?;
        (part < target.parts()).then(|| target.bring_within(curve.at(self.clock.time_s(), part)))
    }

    /// Whether it has a track, which a hand may have changed it beside.
    pub(crate) fn has_track(&self, target: &Target) -> bool {
        let timeline = self.session.derived().timeline();
        timeline.curve(target.owner, target.property.path).is_some() || self.is_changed(target)
    }

    fn is_changed(&self, target: &Target) -> bool {
        self.view.timeline.is_unkeyed(target, self.clock.time_s())
    }

    /// How those properties stand to their tracks.
    pub(crate) fn keyed<'t>(&self, targets: impl IntoIterator<Item = &'t Target>) -> Keyed {
        let clock_s = self.clock.time_s();
        let (mut any, mut all) = (false, true);
        for target in targets {
            if self.is_changed(target) {
                return Keyed::Changed;
            }
            let curve = self.session.derived().timeline().curve(target.owner, target.property.path);
            any |= curve.is_some();
            all &= curve.is_some_and(|curve| has_time(curve.times_s(), clock_s));
        }
        match (any, all) {
            (false, _) => Keyed::Not,
            (true, false) => Keyed::Elsewhere,
            (true, true) => Keyed::Here,
        }
    }

    /// Keys all of `values` at the clock's time; where all have a key already that says so, takes those out.
    pub(crate) fn key_or_not(&self, label: &str, values: &Values) -> Action {
        let (scene, clock_s) = (self.session.scene(), self.clock.time_s());
        let label = label.to_lowercase();
        if self.keyed(values.iter().map(|(target, _)| target)) == Keyed::Here {
            let targets: Vec<Target> = values.iter().map(|(target, _)| *target).collect();
            let rekeyed = keys::removed(scene, &targets, clock_s);
            return Action::Keys { name: format!("Delete key of {label}"), rekeyed, live: false, choose: true };
        }
        let rekeyed = keys::keyed(scene, values, clock_s);
        Action::Keys { name: format!("Key {label}"), rekeyed, live: false, choose: true }
    }

    /// A cloud where its tracks have it at the clock's time.
    pub(crate) fn cloud_now<'c>(&self, cloud: &'c Cloud) -> Cow<'c, Cloud> {
        let now = self.session.derived().timeline().cloud_at(cloud, self.clock.time_s());
        now.map_or(Cow::Borrowed(cloud), Cow::Owned)
    }
}

/// A property of a cloud by its name.
trait OfCloud: Sized {
    fn of_cloud(cloud: &Cloud, path: &str) -> Option<Self>;
}

impl OfCloud for Target {
    fn of_cloud(cloud: &Cloud, path: &str) -> Option<Self> {
        format!("{}/{path}", Owner::Thing(Thing::Cloud(cloud.id))).parse().ok()
    }
}

/// A property of a cloud's place, `position`, `heading_deg` or `scale`, with its value.
pub(crate) fn place_value(cloud: &Cloud, path: &str) -> Option<(Target, KeyValue)> {
    let value = match path {
        "position" => KeyValue::Three(cloud.position.to_array()),
        "heading_deg" => KeyValue::One(cloud.heading_deg),
        _ => KeyValue::One(cloud.scale),
    };
    Some((Target::of_cloud(cloud, path)?, value))
}

/// Gives `cloud` the same place as `from` has, in that property.
pub(crate) fn take_place(cloud: &mut Cloud, from: &Cloud, path: &str) {
    match path {
        "position" => cloud.position = from.position,
        "heading_deg" => cloud.heading_deg = from.heading_deg,
        _ => cloud.scale = from.scale,
    }
}

/// Whether one of `times`, in rising order, is `time_s`.
fn has_time(times: &[f64], time_s: f64) -> bool {
    let at = times.partition_point(|time| *time < time_s - SAME_S);
    times.get(at).is_some_and(|time| (time - time_s).abs() < SAME_S)
}
