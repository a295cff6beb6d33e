//! What is there: properties by their addresses, and lists of ids.

use super::convert::{self, kind};
use super::{Answer, Shared, Usage, answer};
use crate::error::Said;
use crate::recorder::Recorder;
use cloudwright_core::property::{Address, NoSuchProperty, Owner, Parts};
use cloudwright_core::scene::{CloudModel, HasId, List, ModelId, Scene};
use rhai::{Array, Dynamic, Engine, ImmutableString};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    ("get", "get(\"cloud/7/opacity\")", "A value of the scene; of `cloud/7/position` the list of its three numbers."),
    ("set", "set(\"cloud/7/opacity\", 0.5)", "Gives it another value, of the same kind and within its range."),
    ("has", "has(\"cloud/7\")", "Whether the scene has that thing now."),
    ("clouds", "clouds()", "The ids of all clouds, in the scene's order."),
    ("models", "models()", "The ids of all cloud models."),
    ("cameras", "cameras()", "The ids of all cameras."),
    ("paths", "paths()", "The ids of all camera paths."),
    ("aircraft", "aircraft()", "The ids of all aircraft."),
    ("props", "props()", "The ids of all props: terrain, towers, what stands."),
    ("groups", "groups(model)", "The ids of a model's shading groups."),
    ("boxes", "boxes(model)", "The ids of a model's boxes."),
    ("boxes_of", "boxes_of(cloud)", "The ids of the boxes of a cloud's model."),
];

pub(super) fn said(error: NoSuchProperty) -> Said {
    Said::script(format!("there is no property “{}”", error.address), error.hint)
}

fn get(recorder: &Recorder, text: &str) -> Result<Dynamic, Said> {
    let addresses = Address::all(text).map_err(said)?;
    let part = |address: &Address| convert::of_value(address.property, &recorder.get(*address)?);
    match addresses.as_slice() {
        [one] => part(one),
        parts => Ok(Dynamic::from_array(parts.iter().map(part).collect::<Result<_, _>>()?)),
    }
}

fn set(recorder: &mut Recorder, text: &str, value: &Dynamic) -> Result<(), Said> {
    let addresses = Address::all(text).map_err(said)?;
    if let [one] = addresses.as_slice() {
        let value = convert::value(text, one.property, value)?;
        return recorder.set(*one, &value);
    }
    let list = value.read_lock::<Array>();
    let Some(list) = list.filter(|list| list.len() == addresses.len()) else {
        let message = format!("{text} is a list of {} numbers, and not {}", addresses.len(), kind(value));
        return Err(Said::script(message, "or set one of them by its own address"));
    };
    let values = addresses.iter().zip(list.iter());
    let values = values.map(|(address, each)| Ok((*address, convert::value(text, address.property, each)?)));
    let values = values.collect::<Result<Vec<_>, Said>>()?;
    // One end of a range pushes the other along, which would hide that they are the wrong way round.
    if let [(first, from), (_, to)] = values.as_slice()
        && first.property.parts == Parts::Ends
        && matches!((from, to), (cloudwright_core::property::Value::Number(a), cloudwright_core::property::Value::Number(b)) if a > b)
    {
        return Err(Said::script(format!("{text}: {from} to {to} is the wrong way round"), "[smallest, largest]"));
    }
    values.iter().try_for_each(|(address, value)| recorder.set(*address, value))
}

fn ids<T: HasId>(list: &List<T>) -> Answer<Array> {
    answer(list.iter().map(|each| convert::of_id(each.id().into())).collect())
}

fn model(scene: &Scene, id: u64) -> Result<&CloudModel, Said> {
    scene
        .model(ModelId(id))
        .ok_or_else(|| Said::script(format!("model/{id}: the scene has none"), "models() lists them"))
}

fn boxes(scene: &Scene, id: u64) -> Answer<Array> {
    ids(&model(scene, id)?.boxes)
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared) {
    let with = || Rc::clone(recorder);
    let own = with();
    engine.register_fn("get", move |address: ImmutableString| answer(get(&own.borrow(), &address)));
    let own = with();
    engine.register_fn("set", move |address: ImmutableString, value: Dynamic| {
        answer(set(&mut own.borrow_mut(), &address, &value))
    });
    let own = with();
    engine.register_fn("has", move |address: ImmutableString| {
        answer(address.parse().map_err(said).map(|owner: Owner| owner.is_in(own.borrow().scene())))
    });
    let own = with();
    engine.register_fn("clouds", move || ids(&own.borrow().scene().clouds));
    let own = with();
    engine.register_fn("models", move || ids(&own.borrow().scene().models));
    let own = with();
    engine.register_fn("cameras", move || ids(&own.borrow().scene().cameras));
    let own = with();
    engine.register_fn("paths", move || ids(&own.borrow().scene().paths));
    let own = with();
    engine.register_fn("aircraft", move || ids(&own.borrow().scene().aircraft));
    let own = with();
    engine.register_fn("props", move || ids(&own.borrow().scene().props));
    let own = with();
    engine.register_fn("groups", move |of: Dynamic| -> Answer<Array> {
        ids(&model(own.borrow().scene(), convert::count("the model", &of)?)?.groups)
    });
    let own = with();
    engine
        .register_fn("boxes", move |model: Dynamic| boxes(own.borrow().scene(), convert::count("the model", &model)?));
    let own = with();
    engine.register_fn("boxes_of", move |cloud: Dynamic| {
        let recorder = own.borrow();
        let id = convert::count("the cloud", &cloud)?;
        match recorder.scene().cloud(cloudwright_core::scene::CloudId(id)) {
            Some(cloud) => boxes(recorder.scene(), cloud.model.0),
            None => Err(Said::script(format!("cloud/{id}: the scene has none"), "clouds() lists them").into()),
        }
    });
}
