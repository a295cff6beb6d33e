//! Camera paths: what is on the way at a time or after a distance, and how their legs are timed.
//!
//! A path runs from its first key, at second 0, to its last. Distances are along its curve, measured in short straight
//! pieces.

use super::convert::{count, filled, items, map, number, of_thing, of_vector};
use super::things::IDS;
use super::{Answer, Shared, Usage, answer};
use crate::error::Said;
use crate::limits::LIST_ITEMS;
use crate::recorder::Recorder;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::flight::{PathCurve, PathPoint, keys_from_samples, leg_speed_mps, with_speed_from};
use cloudwright_core::scene::{CameraPath, PathId, PathKey, Thing};
use glam::DVec3;
use rhai::{Array, Dynamic, Engine, Map};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    ("path_duration_s", "path_duration_s(path)", "Seconds from a path's first key to its last."),
    ("path_length_m", "path_length_m(path)", "How long its way is."),
    (
        "path_at",
        "path_at(path, 12.5)",
        "What is there so many seconds after its first key: position, direction, heading_deg, pitch_deg, roll_deg, \
         speed_mps, and time_s itself.",
    ),
    ("path_at_m", "path_at_m(path, 3000)", "The same after so many metres of the way."),
    ("along", "along(path, 500)", "The same every so many metres of the way, as a list."),
    ("set_leg_speed", "set_leg_speed(path, 0, 80)", "Has its first leg (0) flown at that mean speed, metres a second."),
    ("leg_speed_mps", "leg_speed_mps(path, 0)", "How fast its first leg (0) is flown on average."),
    (
        "thin_keys",
        "thin_keys(keys, 1.0, 0.5)",
        "Few of many keys of a path, whose curve misses the others by so many metres and degrees at most.",
    ),
];

/// Straight pieces that a leg between two keys is measured in.
const PIECES_A_LEG: usize = 64;
/// Beyond, a path's way takes too long to measure.
const MOST_KEYS: usize = 2_000;

fn path<'a>(recorder: &'a Recorder, path: &Dynamic) -> Result<&'a CameraPath, Said> {
    let id = PathId(count("the path", path)?);
    recorder.need(Thing::Path(id))?;
    let path = recorder.scene().path(id).ok_or_else(|| Said::script("the path is gone", "report this"))?;
    if path.keys.len() > MOST_KEYS {
        return Err(Said::limit(format!("path/{id} has more than {MOST_KEYS} keys"), "thin_keys makes them fewer"));
    }
    Ok(path)
}

/// A path's curve, and how far its way has come at some of its seconds.
struct Way {
    curve: PathCurve,
    /// Second and metres, both rising.
    reached: Vec<[f64; 2]>,
}

impl Way {
    fn of(path: &CameraPath) -> Self {
        let curve = PathCurve::new(path);
        let start_s = path.keys.first().map_or(0.0, |key| key.time_s);
        let mut reached = vec![[0.0, 0.0]];
        let (mut last, mut metres) = (curve.at(0.0).position, 0.0);
        for pair in path.keys.windows(2) {
            let [from, to] = [0, 1].map(|i| pair[i].time_s - start_s);
            for piece in 1..=PIECES_A_LEG {
                let time_s = from + (to - from) * piece as f64 / PIECES_A_LEG as f64;
                let here = curve.at(time_s).position;
                metres += here.distance(last);
                last = here;
                reached.push([time_s, metres]);
            }
        }
        Self { curve, reached }
    }

    fn length_m(&self) -> f64 {
        self.reached.last().map_or(0.0, |[_, metres]| *metres)
    }

    /// When that many metres lie behind; the ends before and after them.
    fn second(&self, metres: f64) -> f64 {
        let after = self.reached.partition_point(|[_, m]| *m < metres);
        let (Some([to_s, to]), Some([from_s, from])) = (self.reached.get(after), self.reached.get(after.max(1) - 1))
        else {
            return self.curve.duration_s();
        };
        let share = if to > from { (metres - from) / (to - from) } else { 0.0 };
        from_s + (to_s - from_s) * share.clamp(0.0, 1.0)
    }

    fn at(&self, time_s: f64) -> Map {
        let time_s = time_s.clamp(0.0, self.curve.duration_s());
        let point = self.curve.at(time_s);
        let PathPoint { position, heading_deg, pitch_deg, roll_deg } = point;
        let velocity = self.curve.velocity_at(time_s);
        // Who stands still has the direction in which the camera looks.
        let direction = velocity.try_normalize().unwrap_or_else(|| point.turn() * DVec3::NEG_Z);
        let number = Dynamic::from_float;
        Map::from([
            ("time_s".into(), number(time_s)),
            ("position".into(), of_vector(position.to_array())),
            ("direction".into(), of_vector(direction.to_array())),
            ("heading_deg".into(), number(heading_deg)),
            ("pitch_deg".into(), number(pitch_deg)),
            ("roll_deg".into(), number(roll_deg)),
            ("speed_mps".into(), number(velocity.length())),
        ])
    }

    /// Every `apart` metres from the start, the start included.
    fn along(&self, apart: f64) -> Result<Array, Said> {
        if apart <= 0.0 {
            return Err(Said::script(format!("the distance is {apart}"), "it is more than 0 metres"));
        }
        let steps = (self.length_m() / apart).floor();
        // Each is a map of nine numbers and its own name's place.
        let most = (LIST_ITEMS / 20) as f64;
        if steps >= most {
            let message = format!("the way has {} places {apart} m apart", steps + 1.0);
            return Err(Said::limit(message, format!("a list has {most} at most")));
        }
        Ok((0..=steps as usize).map(|i| Dynamic::from_map(self.at(self.second(i as f64 * apart)))).collect())
    }
}

fn way(recorder: &Shared, of: &Dynamic) -> Result<Way, Said> {
    path(&recorder.borrow(), of).map(Way::of)
}

fn leg(keys: &[PathKey], leg: &Dynamic) -> Result<usize, Said> {
    let leg = items("the leg", leg)?;
    if leg + 1 < keys.len() {
        return Ok(leg);
    }
    let legs = keys.len().saturating_sub(1);
    Err(Said::script(format!("there is no leg {leg}"), format!("the path has {legs}, counted from 0")))
}

fn set_leg_speed(recorder: &mut Recorder, of: &Dynamic, number_of: &Dynamic, speed: &Dynamic) -> Result<(), Said> {
    let path = path(recorder, of)?;
    let leg = leg(&path.keys, number_of)?;
    let speed = number("the speed", speed)?;
    if speed <= 0.0 {
        return Err(Said::script(format!("the speed is {speed}"), "it is more than 0 m/s"));
    }
    let keys = with_speed_from(&path.keys, leg, speed);
    let new = CameraPath { keys, ..path.clone() };
    recorder.replace(Edit::Path(ListEdit::Replace(new)))
}

fn thin_keys(keys: &Array, metres: f64, degrees: f64) -> Result<Array, Said> {
    if keys.len() > MOST_KEYS {
        return Err(Said::limit(format!("there are {} keys", keys.len()), format!("{MOST_KEYS} at most")));
    }
    let usual = PathKey { time_s: 0.0, position: DVec3::ZERO, heading_deg: 0.0, pitch_deg: 0.0, roll_deg: 0.0 };
    let key = |(i, key): (usize, &Dynamic)| -> Result<PathKey, Said> {
        let what = format!("keys[{i}]");
        filled(&what, &usual, &map(&what, key)?, &[IDS])
    };
    let keys = keys.iter().enumerate().map(key).collect::<Result<Vec<_>, _>>()?;
    keys_from_samples(&keys, metres, degrees).iter().map(of_thing).collect()
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared) {
    let with = || Rc::clone(recorder);
    let own = with();
    engine.register_fn("path_duration_s", move |of: Dynamic| -> Answer<f64> {
        answer(path(&own.borrow(), &of).map(|path| PathCurve::new(path).duration_s()))
    });
    let own = with();
    engine.register_fn("path_length_m", move |of: Dynamic| -> Answer<f64> { Ok(way(&own, &of)?.length_m()) });
    let own = with();
    engine.register_fn("path_at", move |of: Dynamic, time_s: Dynamic| -> Answer<Map> {
        Ok(way(&own, &of)?.at(number("the time", &time_s)?))
    });
    let own = with();
    engine.register_fn("path_at_m", move |of: Dynamic, metres: Dynamic| -> Answer<Map> {
        let way = way(&own, &of)?;
        Ok(way.at(way.second(number("the distance", &metres)?)))
    });
    let own = with();
    engine.register_fn("along", move |of: Dynamic, apart: Dynamic| -> Answer<Array> {
        Ok(way(&own, &of)?.along(number("the distance", &apart)?)?)
    });
    let own = with();
    engine.register_fn("set_leg_speed", move |of: Dynamic, leg: Dynamic, speed: Dynamic| {
        answer(set_leg_speed(&mut own.borrow_mut(), &of, &leg, &speed))
    });
    let own = with();
    engine.register_fn("leg_speed_mps", move |of: Dynamic, which: Dynamic| -> Answer<f64> {
        let recorder = own.borrow();
        let path = path(&recorder, &of)?;
        let leg = leg(&path.keys, &which)?;
        Ok(leg_speed_mps(&path.keys, leg).unwrap_or(0.0))
    });
    engine.register_fn("thin_keys", |keys: Array, metres: Dynamic, degrees: Dynamic| -> Answer<Array> {
        Ok(thin_keys(&keys, number("the metres", &metres)?, number("the degrees", &degrees)?)?)
    });
}
