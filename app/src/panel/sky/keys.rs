//! Changes to the keys of a table over the day: hours are cyclic, to the minute, in order, and no two keys share one.

use cloudwright_core::color::Rgba;
use cloudwright_core::scene::{DailyKey, DailyTable};

/// The table and which of its keys the hand holds then.
pub(super) type Held = (DailyTable<Rgba>, usize);

/// Keys stand at least so far apart, hours.
const APART_H: f64 = 1.0 / 60.0;

/// With a key at another hour; just beside a key that stands there already. Where even that is taken it stays.
pub(super) fn moved(table: &DailyTable<Rgba>, index: usize, hour: f64) -> Option<Held> {
    let mut keys = table.keys.clone();
    if index >= keys.len() || !hour.is_finite() {
        return None;
    }
    let mut key = keys.remove(index);
    key.hour = free_hour(&keys, to_minute(hour), key.hour)?;
    Some(put(keys, key))
}

/// With a key more, of the colour that the table has there; a key that is there already is only held.
pub(super) fn added(table: &DailyTable<Rgba>, hour: f64) -> Option<Held> {
    let hour = to_minute(hour);
    if !hour.is_finite() {
        return None;
    }
    if let Some(index) = table.keys.iter().position(|key| are_one(key.hour, hour)) {
        return Some((table.clone(), index));
    }
    Some(put(table.keys.clone(), DailyKey { hour, sun_deg: None, value: table.at(hour, Rgba::mix) }))
}

/// Without a key. The last one stays.
pub(super) fn removed(table: &DailyTable<Rgba>, index: usize) -> Option<Held> {
    if table.keys.len() < 2 || index >= table.keys.len() {
        return None;
    }
    let mut keys = table.keys.clone();
    keys.remove(index);
    let held = index.min(keys.len() - 1);
    Some((DailyTable { keys }, held))
}

/// `changed`, which came of what is `shown` of the `filed` table on a day, as the file is to have it: keys by the sun that no
/// hand has moved say the hour that they said, and those that the sun does not reach on that day stay.
pub(super) fn as_filed(
    filed: &DailyTable<Rgba>,
    mut changed: DailyTable<Rgba>,
    shown: impl Fn(&DailyTable<Rgba>) -> DailyTable<Rgba>,
) -> DailyTable<Rgba> {
    let all_shown = shown(filed).keys;
    let is = |a: &DailyKey<Rgba>, b: &DailyKey<Rgba>| a.hour == b.hour && a.sun_deg == b.sun_deg;
    for key in filed.keys.iter().filter(|key| key.sun_deg.is_some()) {
        let on_day = shown(&DailyTable { keys: vec![*key] }).keys[0];
        if !all_shown.iter().any(|other| is(other, &on_day)) {
            changed.keys.push(*key);
            continue;
        }
        let is_free = changed.keys.iter().all(|other| is(other, &on_day) || !are_one(other.hour, key.hour));
        if let Some(same) = changed.keys.iter_mut().find(|other| is_free && is(other, &on_day)) {
            same.hour = key.hour;
        }
    }
    changed.keys.sort_by(|a, b| a.hour.total_cmp(&b.hour));
    changed
}

fn put(mut keys: Vec<DailyKey<Rgba>>, key: DailyKey<Rgba>) -> Held {
    let index = keys.iter().filter(|each| each.hour < key.hour).count();
    keys.insert(index, key);
    (DailyTable { keys }, index)
}

/// `hour`, or a minute to the side of the key there: to that from which it comes.
fn free_hour(others: &[DailyKey<Rgba>], hour: f64, from: f64) -> Option<f64> {
    let taken = |hour: f64| others.iter().find(|key| are_one(key.hour, hour));
    let Some(there) = taken(hour) else { return Some(hour) };
    let side = if way(there.hour, from) < 0.0 { -APART_H } else { APART_H };
    [side, -side].map(|step| (there.hour + step).rem_euclid(24.0)).into_iter().find(|hour| taken(*hour).is_none())
}

fn are_one(a: f64, b: f64) -> bool {
    way(a, b).abs() < APART_H * 0.99
}

/// Hours from `a` to `b` the shorter way round, −12 to 12.
fn way(a: f64, b: f64) -> f64 {
    (b - a + 12.0).rem_euclid(24.0) - 12.0
}

fn to_minute(hour: f64) -> f64 {
    ((hour * 60.0).round() / 60.0).rem_euclid(24.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table(hours: &[f64]) -> DailyTable<Rgba> {
        DailyTable::new(hours.iter().map(|hour| (*hour, Rgba::new(*hour as f32, 0.0, 0.0, 1.0))))
    }

    fn hours((table, held): &Held) -> (Vec<f64>, f32) {
        (table.keys.iter().map(|key| key.hour).collect(), table.keys[*held].value.rgb.r)
    }

    #[test]
    fn keys_move_round_the_clock_in_order() {
        let start = table(&[2.0, 8.0, 18.0]);
        let to = |hour| hours(&moved(&start, 2, hour).expect("there is room"));
        assert_eq!(to(5.0), (vec![2.0, 5.0, 8.0], 18.0));
        assert_eq!(to(24.5), (vec![0.5, 2.0, 8.0], 18.0));
        assert_eq!(to(-1.0), (vec![2.0, 8.0, 23.0], 18.0));
        assert_eq!(to(23.9999), (vec![0.0, 2.0, 8.0], 18.0));
        assert_eq!(to(8.0), (vec![2.0, 8.0, 8.0 + APART_H], 18.0), "stops just beside");
        assert_eq!(hours(&moved(&start, 0, 8.0).expect("room")).0, [8.0 - APART_H, 8.0, 18.0]);
        assert!(moved(&start, 3, 1.0).is_none() && moved(&start, 0, f64::NAN).is_none());
    }

    #[test]
    fn keys_are_added_where_there_is_none_and_one_stays() {
        let start = table(&[0.0, 12.0]);
        let (more, held) = added(&start, 6.0).expect("an hour");
        assert_eq!((more.keys.len(), held, more.keys[1].value.rgb.r), (3, 1, 6.0));
        assert_eq!(added(&start, 24.0), Some((start.clone(), 0)));
        assert!(added(&start, f64::INFINITY).is_none());
        let (fewer, held) = removed(&start, 1).expect("two");
        assert_eq!((hours(&(fewer.clone(), held)).0, held), (vec![0.0], 0));
        assert!(removed(&fewer, 0).is_none() && removed(&start, 9).is_none());
    }

    /// On a day on which the sun comes an hour later and does not get to −16°.
    #[test]
    fn what_goes_by_the_sun_and_was_not_moved_stays_as_it_was() {
        let by_sun =
            |hour: f64, sun_deg| DailyKey { hour, sun_deg: Some(sun_deg), value: Rgba::new(0.0, 0.0, 0.0, 1.0) };
        let filed =
            DailyTable { keys: vec![by_sun(2.0, -16.0), by_sun(6.0, 0.0), by_sun(8.0, 20.0), table(&[12.0]).keys[0]] };
        let shown = |table: &DailyTable<Rgba>| {
            let mut keys: Vec<_> = table.keys.iter().copied().filter(|key| key.sun_deg != Some(-16.0)).collect();
            keys.iter_mut().filter(|key| key.sun_deg.is_some()).for_each(|key| key.hour += 1.0);
            if keys.is_empty() { table.clone() } else { DailyTable { keys } }
        };
        let on_day = shown(&filed);
        assert_eq!(as_filed(&filed, on_day.clone(), shown), filed);
        let (more, _) = added(&on_day, 10.0).expect("it is free");
        let hours = |table: DailyTable<Rgba>| {
            as_filed(&filed, table, shown).keys.iter().map(|key| key.hour).collect::<Vec<_>>()
        };
        assert_eq!(hours(more), [2.0, 6.0, 8.0, 10.0, 12.0]);
        let (less, _) = removed(&on_day, 0).expect("others stay");
        assert_eq!(hours(less), [2.0, 8.0, 12.0]);
        // Moved to where another one's hour stands in the file: the two do not fall together.
        let (moved, _) = moved(&on_day, 0, 8.0).expect("it is free");
        assert_eq!(hours(moved), [2.0, 8.0, 9.0, 12.0]);
    }
}
