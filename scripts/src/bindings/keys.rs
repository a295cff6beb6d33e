//! The timeline: keys of properties, and what holds before the first and after the last.

use super::convert::{filled, number, text, vector};
use super::scene::said;
use super::{Answer, Shared, Usage, answer};
use crate::error::{Said, did_you_mean};
use crate::limits::LIST_ITEMS;
use crate::recorder::Recorder;
use cloudwright_core::property::Target;
use cloudwright_core::scene::{Beyond, KeyValue, Leaves, TrackKey};
use rhai::{Array, Dynamic, Engine, ImmutableString, Map};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    (
        "key",
        "key(\"sky/exposure_ev\", 20.0, 1.5), or with #{ leaves: \"linear\", turns: 1 } behind it",
        "The property has that value at that second of the scene's clock.",
    ),
    (
        "track",
        "track(\"sky/exposure_ev\", #{ before: \"hold\", after: \"repeat\" })",
        "What holds before its first key and after its last: hold, repeat or swing.",
    ),
    (
        "keys",
        "keys(\"sky/exposure_ev\")",
        "The property's keys by time, as maps: time_s, value, leaves, and turns and handles where they are set.",
    ),
    ("keyed", "keyed()", "The addresses of all properties that have keys."),
    ("remove_key", "remove_key(\"sky/exposure_ev\", 20.0)", "Takes the key at that second away, if there is one."),
    ("clear_keys", "clear_keys(\"sky/exposure_ev\")", "Takes all keys of the property away."),
];

fn target(address: &str) -> Result<Target, Said> {
    address.parse().map_err(said)
}

fn key(recorder: &mut Recorder, address: &str, time_s: &Dynamic, value: &Dynamic, more: &Map) -> Result<(), Said> {
    let target = target(address)?;
    let time_s = number("the key's time", time_s)?;
    let value = if value.read_lock::<Array>().is_some() {
        KeyValue::Three(vector(address, value)?)
    } else {
        KeyValue::One(number(address, value)?)
    };
    let places = [("time_s", "it stands before the value"), ("value", "it stands before the map")];
    let key: TrackKey = filled("key", &TrackKey::new(time_s, value), more, &places)?;
    if key.turns.is_some() && !target.turns() {
        return Err(Said::script(format!("{target} is no angle, so its keys have no `turns`"), ""));
    }
    recorder.key(&target, key)
}

fn beyond(what: &str, fields: &Map) -> Result<Option<Beyond>, Said> {
    const NAMES: [(&str, Beyond); 3] = [("hold", Beyond::Hold), ("repeat", Beyond::Repeat), ("swing", Beyond::Swing)];
    let Some(value) = fields.get(what) else { return Ok(None) };
    let name = text(what, value)?;
    let found = NAMES.iter().find(|(known, _)| *known == name).map(|(_, beyond)| *beyond);
    found.map(Some).ok_or_else(|| Said::script(format!("{what} is “{name}”"), "it is hold, repeat or swing"))
}

fn track(recorder: &mut Recorder, address: &str, fields: &Map) -> Result<(), Said> {
    const NAMES: [&str; 2] = ["before", "after"];
    if let Some(name) = fields.keys().find(|name| !NAMES.contains(&name.as_str())) {
        return Err(Said::script(format!("a track has no `{name}`"), did_you_mean(name, NAMES)));
    }
    let (before, after) = (beyond("before", fields)?, beyond("after", fields)?);
    recorder.beyond(&target(address)?, before, after)
}

fn of_value(value: &KeyValue) -> Dynamic {
    match value.parts() {
        [one] => Dynamic::from_float(*one),
        parts => Dynamic::from_array(parts.iter().copied().map(Dynamic::from_float).collect()),
    }
}

fn of_key(key: &TrackKey) -> Map {
    let leaves = match key.leaves {
        Leaves::Step => "step",
        Leaves::Linear => "linear",
        Leaves::Smooth => "smooth",
    };
    let mut map = Map::from([
        ("time_s".into(), Dynamic::from_float(key.time_s)),
        ("value".into(), of_value(&key.value)),
        ("leaves".into(), leaves.into()),
    ]);
    if let Some(turns) = key.turns {
        map.insert("turns".into(), Dynamic::from_int(turns.into()));
    }
    if let Some(handles) = &key.handles {
        let slopes = [("arrives".into(), of_value(&handles.arrives)), ("leaves".into(), of_value(&handles.leaves))];
        map.insert("handles".into(), Dynamic::from_map(Map::from(slopes)));
    }
    map
}

fn keys(recorder: &Recorder, address: &str) -> Result<Array, Said> {
    let keys = recorder.keys_of(&target(address)?)?;
    // Of vectors, the engine counts the three numbers too.
    let items: usize = keys.iter().map(|key| 1 + key.value.parts().len()).sum();
    if items > LIST_ITEMS {
        return Err(Said::limit(format!("{address} has {} keys", keys.len()), "too many for a list"));
    }
    Ok(keys.iter().map(|key| Dynamic::from_map(of_key(key))).collect())
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared) {
    let own = Rc::clone(recorder);
    engine.register_fn("key", move |address: ImmutableString, time_s: Dynamic, value: Dynamic| {
        answer(key(&mut own.borrow_mut(), &address, &time_s, &value, &Map::new()))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("key", move |address: ImmutableString, time_s: Dynamic, value: Dynamic, more: Map| {
        answer(key(&mut own.borrow_mut(), &address, &time_s, &value, &more))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("track", move |address: ImmutableString, fields: Map| {
        answer(track(&mut own.borrow_mut(), &address, &fields))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("keys", move |address: ImmutableString| answer(keys(&own.borrow(), &address)));
    let own = Rc::clone(recorder);
    engine.register_fn("keyed", move || -> Array { own.borrow().keyed().into_iter().map(Dynamic::from).collect() });
    let own = Rc::clone(recorder);
    engine.register_fn("remove_key", move |address: ImmutableString, time_s: Dynamic| -> Answer<bool> {
        let time_s = number("the key's time", &time_s)?;
        answer(target(&address).and_then(|target| own.borrow_mut().remove_key(&target, time_s)))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("clear_keys", move |address: ImmutableString| {
        answer(target(&address).and_then(|target| own.borrow_mut().clear_keys(&target)))
    });
}
