//! What the clock moves, as one animation: camera paths, the way of drifting clouds, and how far clouds have formed.

use super::container::{Buffer, Use};
use super::sampled::sampled;
use super::sprites::{CloudNode, Written, share_formed};
use super::{Leaving, Nodes, lens, placed, push, turn_of};
use crate::derived::Derived;
use crate::flight::PathCurve;
use crate::scene::Scene;
use crate::sprites::PlacedCloud;
use crate::weather::{CloudNow, WeatherRules, clouds_now};
use glam::{DQuat, DVec3};
use serde_json::{Value, json};

/// How far a straight line between two keys may be from the way, metres; far from the world's origin a key's own f32 adds to
/// it: 1/32 m at 1,000 km.
pub const TOLERANCE_M: f64 = 0.05;
/// How far a turn between two keys may be from the true one, degrees.
pub const TOLERANCE_DEG: f64 = 0.02;
/// How far alpha between two keys may be from the true one.
pub const TOLERANCE_OPACITY: f64 = 1.0 / 512.0;

/// A drift without end is told so long, seconds.
const DRIFT_S: f64 = 60.0;
/// A curve is looked at so often at least.
const LOOKS: usize = 32;

/// What the animation holds.
#[derive(Debug, Default)]
pub(super) struct Moves {
    /// How many clouds' alphas move.
    pub(super) forms: usize,
    /// How many clouds do more than drift and form.
    pub(super) turns: usize,
}

/// The animation's lists.
struct Animation<'a> {
    buffer: &'a mut Buffer,
    channels: Vec<Value>,
    samplers: Vec<Value>,
}

pub(super) fn write(
    root: &mut Value,
    buffer: &mut Buffer,
    nodes: &mut Nodes,
    leaving: &Leaving<'_>,
    (cameras, clouds, times_s): (&[usize], &Written, &[f64]),
) -> Moves {
    let Leaving { scene, derived, now, watch, .. } = *leaving;
    let mut animation = Animation { buffer, channels: Vec::new(), samplers: Vec::new() };
    for path in &scene.paths {
        let curve = PathCurve::new(path);
        let lens = lens(root, path.field_of_view_deg);
        let start = curve.at(0.0);
        let mut node = placed(&path.name, start.position, start.turn());
        node["camera"] = json!(lens);
        let node = nodes.add_top(node);
        if curve.duration_s() > 0.0 {
            let first_s = path.keys.first().map_or(0.0, |key| key.time_s);
            let keyed = path.keys.iter().map(|key| key.time_s - first_s);
            animation.fly(node, &times(keyed, curve.duration_s()), |time| {
                let point = curve.at(time);
                (point.position, point.turn())
            });
        }
    }
    let mut moves = Moves::default();
    if !times_s.is_empty() {
        for (camera, node) in scene.cameras.iter().zip(cameras) {
            let at = |time: f64| {
                let camera = derived.timeline().camera_at(camera, time);
                (camera.position, turn_of(&camera))
            };
            if times_s.iter().any(|time| at(*time) != at(0.0)) {
                animation.fly(*node, times_s, at);
            }
        }
        for (cloud, place) in now.clouds.iter().map(|cloud| cloud.placed).zip(&clouds.nodes) {
            if watch.is_cancelled() {
                break;
            }
            animation.drift(place.node, cloud, derived, times_s);
            moves.forms += usize::from(animation.form(*place, cloud, derived, times_s));
            moves.turns += usize::from(does_more(cloud, derived, times_s));
        }
    }
    if !animation.channels.is_empty() {
        let Animation { channels, samplers, .. } = animation;
        push(root, "animations", json!({ "name": "timeline", "channels": channels, "samplers": samplers }));
    }
    moves
}

/// Times at which what the scene's clock moves is looked at, at least; none if it moves nothing.
pub(super) fn times_of_clock(leaving: &Leaving<'_>) -> Vec<f64> {
    let Leaving { scene, derived, .. } = *leaving;
    let end_s = end_s(scene, derived);
    if end_s <= 0.0 {
        return Vec::new();
    }
    let formations = scene.clouds.iter().filter_map(|cloud| cloud.formation.as_ref());
    let begun = formations.flat_map(|formation| [formation.start_s, formation.end_s()]);
    let keyed = scene.tracks.iter().flat_map(|track| track.keys.iter().map(|key| key.time_s));
    times(keyed.chain(begun), end_s)
}

/// Whether a cloud's alpha is not the same at all those times.
pub(super) fn forms(cloud: &PlacedCloud, leaving: &Leaving<'_>, times_s: &[f64]) -> bool {
    let Leaving { scene, derived, .. } = *leaving;
    // What has neither formation nor tracks, and doesn't come in anew at a region's other side, is not looked at.
    let may = cloud.cloud.formation.is_some()
        || derived.timeline().cloud_at(&cloud.cloud, 0.0).is_some()
        || derived.timeline().wind().is_some() && scene.weather.region.is_some();
    let share = |time: &f64| at(cloud, derived, *time).map(|now| share_formed(&now));
    may && times_s.iter().any(|time| share(time) != share(&times_s[0]))
}

/// When the clock has nothing more to move but what moves for ever, seconds; of a wind alone a minute; 0 if nothing moves.
fn end_s(scene: &Scene, derived: &Derived) -> f64 {
    let formed = scene.clouds.iter().filter_map(|cloud| Some(cloud.formation.as_ref()?.end_s()));
    let keyed = scene.tracks.iter().filter_map(|track| Some(track.keys.last()?.time_s));
    let flown = scene.paths.iter().map(|path| PathCurve::new(path).duration_s());
    let end_s = formed.chain(keyed).chain(flown).fold(0.0, f64::max);
    let moves = derived.timeline().moves();
    if end_s <= 0.0 && moves { DRIFT_S } else { end_s }
}

/// Times to look at a curve at, at least: those of its keys, and evenly from 0 to the end.
fn times(keyed: impl Iterator<Item = f64>, end_s: f64) -> Vec<f64> {
    let even = (0..=LOOKS).map(|look| end_s * look as f64 / LOOKS as f64);
    let mut times: Vec<f64> = keyed.filter(|time| (0.0..=end_s).contains(time)).chain(even).collect();
    times.sort_by(f64::total_cmp);
    // What is a key's time all but the last bits is one time.
    times.dedup_by(|later, earlier| *later - *earlier < 1e-6);
    times
}

/// A cloud as it is at a second.
fn at<'a>(cloud: &'a PlacedCloud, derived: &'a Derived, clock_s: f64) -> Option<CloudNow<'a>> {
    clouds_now(std::slice::from_ref(cloud), derived.timeline(), clock_s, WeatherRules::default()).pop()
}

/// Whether its turn, scale or growth are not the same all the time, or air moves its sprites.
fn does_more(cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> bool {
    let now = |time: &f64| at(cloud, derived, *time).map(|now| (now.turn, now.scale, now.growth));
    let first = times_s.first().and_then(now);
    let streams = times_s.first().and_then(|time| at(cloud, derived, *time)).is_some_and(|now| now.air.is_some());
    streams || times_s.iter().any(|time| now(time) != first)
}

impl Animation<'_> {
    fn fly(&mut self, node: usize, times_s: &[f64], at: impl Fn(f64) -> (DVec3, DQuat)) {
        self.go(node, times_s, |time| at(time).0);
        let turns = sampled(
            times_s,
            |time| at(time).1,
            |a, b, share| a.slerp(b, share),
            |a, b| a.angle_between(b).to_degrees() <= TOLERANCE_DEG,
        );
        // Each on the near side of the one before: linear interpolation goes the short way in every reader.
        let mut last = DQuat::IDENTITY;
        let near: Vec<(f64, [f32; 4])> = turns
            .into_iter()
            .map(|(time, turn)| {
                last = if turn.dot(last) < 0.0 { -turn } else { turn };
                (time, last.as_quat().normalize().to_array())
            })
            .collect();
        self.channel(&json!({ "node": node, "path": "rotation" }), &near);
    }

    fn drift(&mut self, node: usize, cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) {
        let origin = |time: f64| at(cloud, derived, time).map_or(cloud.origin, |now| now.origin());
        let still = origin(0.0);
        if times_s.iter().any(|time| origin(*time) != still) {
            self.go(node, times_s, origin);
        }
    }

    fn go(&mut self, node: usize, times_s: &[f64], place: impl Fn(f64) -> DVec3) {
        let places = sampled(times_s, place, |a, b, share| a.lerp(b, share), |a, b| a.distance(b) <= TOLERANCE_M);
        let places: Vec<_> = places.into_iter().map(|(time, place)| (time, place.as_vec3().to_array())).collect();
        self.channel(&json!({ "node": node, "path": "translation" }), &places);
    }

    /// Moves the alpha of a cloud's own material. Whether it has one.
    fn form(&mut self, place: CloudNode, cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> bool {
        let Some(material) = place.material else { return false };
        let alphas = sampled(
            times_s,
            |time| at(cloud, derived, time).map_or(1.0, |now| f64::from(share_formed(&now))),
            |a, b, share| a + (b - a) * share,
            |a, b| (a - b).abs() <= TOLERANCE_OPACITY,
        );
        let factors: Vec<_> = alphas.into_iter().map(|(time, alpha)| (time, [1.0, 1.0, 1.0, alpha as f32])).collect();
        let pointer = format!("/materials/{material}/pbrMetallicRoughness/baseColorFactor");
        let target = json!({ "path": "pointer", "extensions": { "KHR_animation_pointer": { "pointer": pointer } } });
        self.channel(&target, &factors);
        true
    }

    fn channel<const N: usize>(&mut self, target: &Value, keys: &[(f64, [f32; N])]) {
        let times: Vec<[f32; 1]> = keys.iter().map(|(time, _)| [*time as f32]).collect();
        let values: Vec<[f32; N]> = keys.iter().map(|(_, value)| *value).collect();
        let sampler = json!({
            "input": self.buffer.floats(&times, Use::Other, true),
            "output": self.buffer.floats(&values, Use::Other, false),
            "interpolation": "LINEAR",
        });
        self.samplers.push(sampler);
        self.channels.push(json!({ "sampler": self.samplers.len() - 1, "target": target }));
    }
}
