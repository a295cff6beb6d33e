//! What the clock moves, in keys: clouds, and the air that they are in.

use super::super::Leaving;
use crate::derived::Derived;
use crate::exchange::motion::{TOLERANCE_M, TOLERANCE_OPACITY, at, clock_end_s, times};
use crate::exchange::sampled::sampled;
use crate::scene::{CloudId, Track};
use crate::sprites::PlacedCloud;
use crate::weather::{AirNow, CONDENSING, CloudNow};
use std::sync::Arc;

/// Numbers of a cloud's key: second; displacement; core, falloff, growth, opacity, scale; sine and cosine of its turn.
pub(super) const CLOUD_NUMBERS: usize = 11;
/// Numbers of the air's key: second; lean; its shear; how far it turned; turbulence; humidity.
pub(super) const AIR_NUMBERS: usize = 10;
/// Numbers of a key of colour levels: second; of each level its height and colour.
pub(super) const LEVEL_NUMBERS: usize = 26;

/// When the page looks at what moves, at least; the moment alone if nothing does. Of a cloud: tracks of other clouds are
/// none of its business.
pub(super) fn times_s(leaving: &Leaving<'_>, of: Option<CloudId>) -> Vec<f64> {
    let Leaving { scene, derived, moment, .. } = leaving;
    let end_s = clock_end_s(scene, derived);
    if end_s <= 0.0 {
        return vec![moment.clock_s];
    }
    let mine = of.map(|id| id.to_string());
    let counts = |track: &&Track| {
        let cloud = track.property.strip_prefix("cloud/").and_then(|rest| rest.split('/').next());
        cloud.is_none() || mine.is_none() || cloud == mine.as_deref()
    };
    let keyed = scene.tracks.iter().filter(counts).flat_map(|track| track.keys.iter().map(|key| key.time_s));
    times(keyed, end_s.max(moment.clock_s))
}

/// Whether the clock moves anything of what the page shows.
pub(super) fn moves(leaving: &Leaving<'_>) -> bool {
    clock_end_s(leaving.scene, leaving.derived) > 0.0
}

/// The keys of a cloud; one if it stands.
pub(super) fn cloud(cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> Vec<[f32; CLOUD_NUMBERS]> {
    let numbers = |clock_s: f64| at(cloud, derived, clock_s).as_ref().map_or([0.0; 10], cloud_numbers);
    let near = |a: [f64; 10], b: [f64; 10]| {
        (0..10).all(|i| (a[i] - b[i]).abs() <= if i < 3 { TOLERANCE_M } else { TOLERANCE_OPACITY })
    };
    keys(times_s, numbers, near)
}

/// The keys of the air; none if it never moves sprites.
pub(super) fn air(first: Option<&PlacedCloud>, derived: &Derived, times_s: &[f64]) -> Vec<[f32; AIR_NUMBERS]> {
    let air = |clock_s: f64| at(first?, derived, clock_s)?.air.map(|in_air| in_air.air);
    if times_s.iter().all(|time_s| air(*time_s).is_none()) {
        return Vec::new();
    }
    let numbers = |clock_s: f64| air(clock_s).as_ref().map_or(STILL_AIR, air_numbers);
    // The turn of the loosest sprite in whole turns; all else in the reach of edges, or as shares.
    let near = |a: [f64; 9], b: [f64; 9]| (0..9).all(|i| (a[i] - b[i]).abs() <= TOLERANCE_OPACITY);
    keys(times_s, numbers, near)
}

/// The keys of a cloud's colour levels; none if they stand.
pub(super) fn levels(cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> Vec<[f32; LEVEL_NUMBERS]> {
    if !derived.timeline().moves_looks() {
        return Vec::new();
    }
    let numbers = |clock_s: f64| {
        let levels = at(cloud, derived, clock_s).map_or(cloud.color_levels, |now| *now.color_levels());
        let mut numbers = [0.0; 25];
        for (five, level) in numbers.chunks_mut(5).zip(levels) {
            five[0] = level.height;
            five[1..].iter_mut().zip(level.color.to_array()).for_each(|(slot, channel)| *slot = f64::from(channel));
        }
        numbers
    };
    let near = |a: [f64; 25], b: [f64; 25]| (0..25).all(|i| (a[i] - b[i]).abs() <= TOLERANCE_OPACITY);
    let keys = keys(times_s, numbers, near);
    if keys.len() > 1 { keys } else { Vec::new() }
}

/// Whether tracks move the light of a cloud's groups.
pub(super) fn moves_groups(cloud: &PlacedCloud, derived: &Derived, times_s: &[f64]) -> bool {
    derived.timeline().moves_looks()
        && times_s
            .iter()
            .any(|time_s| at(cloud, derived, *time_s).is_some_and(|now| !Arc::ptr_eq(now.groups(), &cloud.groups)))
}

/// Air that does nothing to sprites.
const STILL_AIR: [f64; 9] = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0 + CONDENSING as f64];

/// Keys of `N` numbers, each behind its second: `M` is `N` and one.
fn keys<const N: usize, const M: usize>(
    times_s: &[f64],
    of: impl Fn(f64) -> [f64; N],
    near: impl Fn([f64; N], [f64; N]) -> bool,
) -> Vec<[f32; M]> {
    let between = |a: [f64; N], b: [f64; N], share: f64| std::array::from_fn(|i| a[i] + (b[i] - a[i]) * share);
    let mut keys = sampled(times_s, of, between, &near);
    drop_needless(&mut keys, |a, b, share, on| near(between(a, b, share), on));
    let timed = |(time_s, numbers): (f64, [f64; N])| {
        std::array::from_fn(|i| if i == 0 { time_s as f32 } else { numbers[i - 1] as f32 })
    };
    keys.into_iter().map(timed).collect()
}

/// Drops keys that a straight line between the ones around them meets; of what stands, all but the first.
fn drop_needless<T: Copy + PartialEq>(keys: &mut Vec<(f64, T)>, meets: impl Fn(T, T, f64, T) -> bool) {
    if keys.iter().all(|(_, value)| *value == keys[0].1) {
        keys.truncate(1);
        return;
    }
    let mut kept: Vec<(f64, T)> = Vec::new();
    let mut from = 0;
    kept.extend(keys.first());
    for to in 2..keys.len() {
        let ((from_s, first), (to_s, last)) = (keys[from], keys[to]);
        let share = |time_s: f64| (time_s - from_s) / (to_s - from_s);
        if !keys[from + 1..to].iter().all(|(time_s, value)| meets(first, last, share(*time_s), *value)) {
            from = to - 1;
            kept.push(keys[from]);
        }
    }
    kept.extend(keys.last());
    *keys = kept;
}

fn cloud_numbers(now: &CloudNow<'_>) -> [f64; 10] {
    let [x, y, z] = now.displacement.to_array();
    let [sin, cos] = now.turn.sin_cos().map(f64::from);
    let [core, falloff, growth, opacity, scale] =
        [now.formed.core, now.formed.falloff, now.growth, now.opacity, now.scale].map(f64::from);
    [x, y, z, core, falloff, growth, opacity, scale, sin, cos]
}

fn air_numbers(air: &AirNow) -> [f64; 9] {
    let ([x, y, z], [sx, sy, sz]) = (air.lean.to_array(), air.lean_shear.to_array());
    [x, y, z, sx, sy, sz, air.turned, air.turbulence, air.humidity].map(f64::from)
}

#[cfg(test)]
mod tests {
    use super::drop_needless;

    #[test]
    fn keys_on_a_line_are_needless() {
        let line = |a: f64, b: f64, share: f64, on: f64| (a + (b - a) * share - on).abs() < 1e-9;
        for (values, want) in [
            (vec![2.0, 2.0, 2.0, 2.0], vec![0.0]),
            (vec![0.0, 1.0, 2.0, 3.0], vec![0.0, 3.0]),
            (vec![0.0, 1.0, 2.0, 1.0, 0.0], vec![0.0, 2.0, 4.0]),
            (vec![1.0, 0.0], vec![0.0, 1.0]),
            (vec![1.0, 1.0, 5.0], vec![0.0, 1.0, 2.0]),
        ] {
            let mut keys: Vec<(f64, f64)> = values.iter().enumerate().map(|(i, value)| (i as f64, *value)).collect();
            drop_needless(&mut keys, line);
            assert_eq!(keys.iter().map(|(time, _)| *time).collect::<Vec<_>>(), want, "{values:?}");
        }
    }
}
