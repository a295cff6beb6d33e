//! What the clock moves, as keys between which straight lines are near enough: flights along paths, cameras that are moved,
//! the way of drifting clouds, and how far clouds have formed.

use super::Note;
use super::sampled::sampled;
use crate::derived::Derived;
use crate::flight::{PathCurve, PathPoint};
use crate::property::{Owner, Target};
use crate::scene::{Camera, CameraPath, Scene, Thing, Track};
use crate::sprites::PlacedCloud;
use crate::weather::{CloudNow, WeatherRules, clouds_now};
use glam::{DQuat, DVec3};

/// How far a straight line between two keys may be from the way, metres. Where keys are f32, those far from the world's origin
/// add to it: 1/32 m at 1,000 km.
pub const TOLERANCE_M: f64 = 0.05;
/// How far a turn, or a field of view, between two keys may be from the true one, degrees.
pub const TOLERANCE_DEG: f64 = 0.02;
/// How far alpha between two keys may be from the true one.
pub const TOLERANCE_OPACITY: f64 = 1.0 / 512.0;

/// A drift without end is told so long, seconds.
const DRIFT_S: f64 = 60.0;
/// A curve is looked at so often at least.
const LOOKS: usize = 32;

/// Values with their seconds, in order.
pub(super) type Keys<T> = Vec<(f64, T)>;

/// What a scene's clock moves.
pub(super) struct Motion<'a> {
    derived: &'a Derived,
    end_s: f64,
    /// Of each track, whose property it moves, and its keys' seconds.
    keyed: Vec<(Option<Owner>, Vec<f64>)>,
}

/// How a camera goes.
#[derive(Default)]
pub(super) struct Flight {
    pub(super) places: Keys<DVec3>,
    pub(super) turns: Keys<DQuat>,
    /// Of what it sees from top to bottom, degrees.
    pub(super) fields_of_view_deg: Keys<f64>,
}

/// How a cloud goes.
#[derive(Default)]
pub(super) struct Course {
    /// Of its origin; none of a cloud that stands.
    pub(super) places: Keys<DVec3>,
    /// Which share of it there is, 0 to 1; none of a cloud of which there is as much all the time.
    pub(super) formed: Keys<f64>,
    /// Whether it does more than drift and form.
    pub(super) does_more: bool,
}

impl<'a> Motion<'a> {
    pub(super) fn new(scene: &Scene, derived: &'a Derived) -> Self {
        let keyed = |track: &Track| {
            let target: Option<Target> = track.property.parse().ok();
            (target.map(|target| target.owner), track.keys.iter().map(|key| key.time_s).collect())
        };
        Self { derived, end_s: end_s(scene, derived), keyed: scene.tracks.iter().map(keyed).collect() }
    }

    /// When the last thing stops moving, seconds; 0 if nothing moves.
    pub(super) fn end_s(&self) -> f64 {
        self.end_s
    }

    /// When to look at a thing, at least: where it has a key, or what moves all things has one; and when it is said.
    fn times_of(&self, thing: Thing, also_s: impl IntoIterator<Item = f64>) -> Vec<f64> {
        let is_its = |owner: &Option<Owner>| match owner {
            Some(Owner::Thing(other)) => *other == thing || !matches!(other, Thing::Cloud(_) | Thing::Camera(_)),
            _ => true,
        };
        let keyed = self.keyed.iter().filter(|(owner, _)| is_its(owner));
        times(keyed.flat_map(|(_, times_s)| times_s.iter().copied()).chain(also_s), self.end_s)
    }

    /// How a camera of the scene goes; none if it stands.
    pub(super) fn camera(&self, camera: &Camera) -> Option<Flight> {
        let at = |time: f64| {
            let camera = self.derived.timeline().camera_at(camera, time);
            (camera.position, turn_of(&camera), camera.field_of_view_deg)
        };
        let (still, times_s) = (at(0.0), self.times_of(Thing::Camera(camera.id), []));
        times_s.iter().any(|time| at(*time) != still).then(|| Flight::along(&times_s, at))
    }

    pub(super) fn course(&self, cloud: &PlacedCloud) -> Course {
        let formation = cloud.cloud.formation.iter();
        let formed_s = formation.flat_map(|formation| [formation.start_s, formation.end_s()]);
        let times_s = self.times_of(Thing::Cloud(cloud.id), formed_s);
        let all: Vec<CloudNow<'_>> = times_s.iter().filter_map(|time| self.at(cloud, *time)).collect();
        let Some(first) = all.first() else { return Course::default() };
        let (still, formed) = (first.origin(), share_formed(first));
        let origin = |time: f64| self.at(cloud, time).map_or(cloud.origin, |now| now.origin());
        let share = |time: f64| self.at(cloud, time).map_or(1.0, |now| f64::from(share_formed(&now)));
        let shape = |now: &CloudNow<'_>| (now.turn, now.scale, now.growth);
        Course {
            places: match all.iter().any(|now| now.origin() != still) {
                true => keys_of_places(&times_s, origin),
                false => Keys::new(),
            },
            formed: match all.iter().any(|now| share_formed(now) != formed) {
                true => keys_of_numbers(&times_s, share, TOLERANCE_OPACITY),
                false => Keys::new(),
            },
            does_more: first.air.is_some() || all.iter().any(|now| shape(now) != shape(first)),
        }
    }

    /// A cloud as it is at a second.
    fn at<'b>(&'b self, cloud: &'b PlacedCloud, clock_s: f64) -> Option<CloudNow<'b>> {
        at(cloud, self.derived, clock_s)
    }
}

impl Flight {
    /// Along a path, from its first key on; none if that is the only one.
    pub(super) fn of(path: &CameraPath) -> Option<Self> {
        let curve = PathCurve::new(path);
        let first_s = path.keys.first().map_or(0.0, |key| key.time_s);
        let keyed = path.keys.iter().map(|key| key.time_s - first_s);
        let at = |time: f64| {
            let point = curve.at(time);
            (point.position, point.turn(), path.field_of_view_deg)
        };
        (curve.duration_s() > 0.0).then(|| Self::along(&times(keyed, curve.duration_s()), at))
    }

    fn along(times_s: &[f64], at: impl Fn(f64) -> (DVec3, DQuat, f64)) -> Self {
        let near = |a: DQuat, b: DQuat| a.angle_between(b).to_degrees() <= TOLERANCE_DEG;
        let mut turns = sampled(times_s, |time| at(time).1, |a, b, share| a.slerp(b, share), near);
        // Each on the near side of the one before: interpolation goes the short way in every reader.
        let mut last = DQuat::IDENTITY;
        for (_, turn) in &mut turns {
            *turn = if turn.dot(last) < 0.0 { -*turn } else { *turn };
            last = *turn;
        }
        let lens = at(0.0).2;
        Self {
            places: keys_of_places(times_s, |time| at(time).0),
            turns,
            fields_of_view_deg: match times_s.iter().any(|time| at(*time).2 != lens) {
                true => keys_of_numbers(times_s, |time| at(time).2, TOLERANCE_DEG),
                false => Keys::new(),
            },
        }
    }
}

/// Cameras of other tools look along −z, their top along +y, as ours at heading 0.
pub(super) fn turn_of(camera: &Camera) -> DQuat {
    let Camera { heading_deg, pitch_deg, roll_deg, position, .. } = *camera;
    PathPoint { position, heading_deg, pitch_deg, roll_deg }.turn()
}

/// How much of a cloud there is, 0 to 1: by its sprites' areas, up to 64 of them.
pub(super) fn share_formed(cloud: &CloudNow<'_>) -> f32 {
    const LOOKS: usize = 64;
    let sprites = &cloud.placed.sprites;
    let step = sprites.len().div_ceil(LOOKS).max(1);
    let (mut share, mut all) = (0.0, 0.0);
    for sprite in sprites.iter().step_by(step) {
        let area = sprite.width * sprite.height;
        share += area * cloud.opacity_at(cloud.placed.radii_of(sprite.position));
        all += area;
    }
    if all > 0.0 { (share / all).clamp(0.0, 1.0) } else { 1.0 }
}

/// How clouds form in what has one alpha a cloud, if any do.
pub(super) fn form_at_once(courses: &[Course]) -> Option<Note> {
    let count = courses.iter().filter(|course| !course.formed.is_empty()).count();
    (count > 0).then(|| Note::changed(format!("how {count} clouds form"), "all sprites of a cloud at once"))
}

/// What of clouds is not carried, if any do more than drift and form.
pub(super) fn does_more(courses: &[Course]) -> Option<Note> {
    let count = courses.iter().filter(|course| course.does_more).count();
    let what = format!("how {count} clouds turn, grow or stream");
    (count > 0).then(|| Note::left_out(what, "they drift as they were at the moment"))
}

fn keys_of_places(times_s: &[f64], place: impl Fn(f64) -> DVec3) -> Keys<DVec3> {
    sampled(times_s, place, |a, b, share| a.lerp(b, share), |a, b| a.distance(b) <= TOLERANCE_M)
}

fn keys_of_numbers(times_s: &[f64], number: impl Fn(f64) -> f64, tolerance: f64) -> Keys<f64> {
    sampled(times_s, number, |a, b, share| a + (b - a) * share, |a, b| (a - b).abs() <= tolerance)
}

/// When the clock has nothing more to move but what moves for ever, seconds; of a wind alone a minute; 0 if nothing moves.
fn end_s(scene: &Scene, derived: &Derived) -> f64 {
    let flown = scene.paths.iter().map(|path| PathCurve::new(path).duration_s()).fold(0.0, f64::max);
    let end_s = keyed_s(scene).max(flown);
    if end_s > 0.0 { end_s } else { clock_end_s(scene, derived) }
}

/// The same without paths.
pub(super) fn clock_end_s(scene: &Scene, derived: &Derived) -> f64 {
    let end_s = keyed_s(scene);
    if end_s <= 0.0 && derived.timeline().moves() { DRIFT_S } else { end_s }
}

/// When the last cloud has formed and the last track has its last key, seconds.
fn keyed_s(scene: &Scene) -> f64 {
    let formed = scene.clouds.iter().filter_map(|cloud| Some(cloud.formation.as_ref()?.end_s()));
    let keyed = scene.tracks.iter().filter_map(|track| Some(track.keys.last()?.time_s));
    formed.chain(keyed).fold(0.0, f64::max)
}

/// A cloud as it is at a second.
pub(super) fn at<'a>(cloud: &'a PlacedCloud, derived: &'a Derived, clock_s: f64) -> Option<CloudNow<'a>> {
    clouds_now(std::slice::from_ref(cloud), derived.timeline(), clock_s, WeatherRules::default()).pop()
}

/// Times to look at a curve at, at least: those of its keys, and evenly from 0 to the end; none if it has no end.
pub(super) fn times(keyed: impl Iterator<Item = f64>, end_s: f64) -> Vec<f64> {
    if end_s <= 0.0 {
        return Vec::new();
    }
    let even = (0..=LOOKS).map(|look| end_s * look as f64 / LOOKS as f64);
    let mut times: Vec<f64> = keyed.filter(|time| (0.0..=end_s).contains(time)).chain(even).collect();
    times.sort_by(f64::total_cmp);
    // What is a key's time all but the last bits is one time.
    times.dedup_by(|later, earlier| *later - *earlier < 1e-6);
    times
}
