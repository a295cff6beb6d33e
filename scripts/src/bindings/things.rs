//! Things to add, as maps by the file format's names, and to remove. What a map leaves out is as in the editor's new one.

use super::convert::{count, filled, of_id};
use super::scene::said;
use super::{Shared, Usage, answer};
use crate::error::Said;
use crate::recorder::Recorder;
use cloudwright_core::document::Edit;
use cloudwright_core::problem::{self, Problem};
use cloudwright_core::property::{Described, Owner};
use cloudwright_core::scene::{
    BoxId, Camera, CameraId, Category, Cloud, CloudBox, CloudId, CloudModel, GroupId, IdCounter, ModelId, ShadingGroup,
    Thing,
};
use glam::DVec3;
use rhai::{Array, Dynamic, Engine, ImmutableString, Map};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    (
        "add_model",
        "add_model(#{ name: \"tower\", category: \"cumulus_congestus\", boxes: [#{ center: […], size: […] }] })",
        "Adds a cloud model and gives its id. Its boxes are maps too.",
    ),
    ("add_box", "add_box(model, #{ center: [0, 300, 0], size: [800, 400, 800] })", "Adds a box to a model; its id."),
    ("add_cloud", "add_cloud(#{ model: model, position: [0, 900, -2000] })", "Places a model; gives the cloud's id."),
    ("add_camera", "add_camera(#{ name: \"tower\", position: [0, 600, 0] })", "Adds a camera; gives its id."),
    (
        "add_group",
        "add_group(model, #{ name: \"top\" })",
        "Adds a shading group to a model; its id is for boxes' `group`.",
    ),
    ("remove", "remove(\"cloud/7\")", "Takes a thing out with all that hangs on it."),
];

const IDS: (&str, &str) = ("id", "ids are given by the scene");

/// What the engine hands over as a map, as a map.
fn map(what: &str, value: &Dynamic) -> Result<Map, Said> {
    value.read_lock::<Map>().map(|map| map.clone()).ok_or_else(|| {
        let message = format!("{what} is {}, where a map is expected", super::convert::kind(value));
        Said::script(message, "#{ name: value, … }")
    })
}

/// `problems` as what the script must hear, where there are any; the rest of them would mostly be the same again.
fn none_of(problems: Vec<Problem>) -> Result<(), Said> {
    match problems.into_iter().next() {
        None => Ok(()),
        Some(Problem { place, message, hint, .. }) => Err(Said::script(format!("{place}: {message}"), hint)),
    }
}

/// `new`, if its numbers are within their ranges: told here, a fault has its line.
fn sound<T: Described>(thing: Thing, what: &str, new: T) -> Result<T, Said> {
    none_of(problem::check_new(Owner::Thing(thing), what, &new))?;
    Ok(new)
}

fn new_box(what: &str, model: ModelId, fields: &Map, counter: &mut IdCounter) -> Result<CloudBox, Said> {
    let new: CloudBox = filled(what, &CloudBox::new(BoxId::new(counter), DVec3::ZERO), fields, &[IDS])?;
    none_of(problem::check_new_box(what, &new))?;
    sound(Thing::Box(model, new.id), what, new)
}

fn add_model(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let mut fields = fields.clone();
    let boxes = match fields.remove("boxes") {
        Some(boxes) => boxes.read_lock::<Array>().map(|list| list.clone()).ok_or_else(|| {
            Said::script(format!("model.boxes is {}, where a list is expected", super::convert::kind(&boxes)), "")
        })?,
        None => Array::new(),
    };
    let groups = ("groups", "add them with add_group(model, #{ … }) and boxes with add_box(model, #{ group: … })");
    let make = |counter: &mut IdCounter| {
        let usual = CloudModel::new(ModelId::new(counter), "model", Category::CumulusHumilis);
        let mut model: CloudModel =
            sound(Thing::Model(usual.id), "model", filled("model", &usual, &fields, &[IDS, groups])?)?;
        for (index, each) in boxes.iter().enumerate() {
            let what = format!("model.boxes[{index}]");
            model.boxes.push(new_box(&what, usual.id, &map(&what, each)?, counter)?);
        }
        Ok(model)
    };
    recorder.add(make, Edit::Model)
}

fn add_cloud(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let model =
        fields.get("model").ok_or_else(|| Said::script("cloud: it lacks `model`", "the id of a cloud model"))?;
    let model = count("cloud.model", model)?;
    let Some(model) = recorder.scene().model(ModelId(model)).cloned() else {
        return Err(Said::script(format!("cloud.model: there is no model {model}"), "models() lists them"));
    };
    let make = |counter: &mut IdCounter| {
        let usual = Cloud::new(CloudId::new(counter), &model, DVec3::ZERO);
        sound(Thing::Cloud(usual.id), "cloud", filled("cloud", &usual, fields, &[IDS])?)
    };
    recorder.add(make, Edit::Cloud)
}

fn add_camera(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let make = |counter: &mut IdCounter| {
        let usual = Camera::new(CameraId::new(counter), "camera", DVec3::ZERO);
        sound(Thing::Camera(usual.id), "camera", filled("camera", &usual, fields, &[IDS])?)
    };
    recorder.add(make, Edit::Camera)
}

fn add_box(recorder: &mut Recorder, model: &Dynamic, fields: &Map) -> Result<u64, Said> {
    let model = ModelId(count("the model", model)?);
    recorder.add(|counter| new_box("box", model, fields, counter), |edit| Edit::Box(model, edit))
}

fn add_group(recorder: &mut Recorder, model: &Dynamic, fields: &Map) -> Result<u64, Said> {
    let model = ModelId(count("the model", model)?);
    let make = |counter: &mut IdCounter| {
        let id = GroupId::new(counter);
        let usual = serde_json::from_value::<ShadingGroup>(serde_json::json!({ "id": id, "name": "group" }));
        let usual = usual.map_err(|error| Said::script(error.to_string(), ""))?;
        sound(Thing::Group(model, id), "group", filled("group", &usual, fields, &[IDS])?)
    };
    recorder.add(make, |edit| Edit::Group(model, edit))
}

fn remove(recorder: &mut Recorder, address: &str) -> Result<(), Said> {
    match address.parse().map_err(said)? {
        Owner::Thing(thing) => recorder.remove(thing),
        owner => Err(Said::script(format!("{owner} is no thing that can be removed"), "cloud/7, model/3, camera/1")),
    }
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared) {
    let own = Rc::clone(recorder);
    engine
        .register_fn("add_model", move |fields: Map| answer(add_model(&mut own.borrow_mut(), &fields).and_then(of_id)));
    let own = Rc::clone(recorder);
    engine
        .register_fn("add_cloud", move |fields: Map| answer(add_cloud(&mut own.borrow_mut(), &fields).and_then(of_id)));
    let own = Rc::clone(recorder);
    engine.register_fn("add_camera", move |fields: Map| {
        answer(add_camera(&mut own.borrow_mut(), &fields).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("add_box", move |model: Dynamic, fields: Map| {
        answer(add_box(&mut own.borrow_mut(), &model, &fields).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("add_group", move |model: Dynamic, fields: Map| {
        answer(add_group(&mut own.borrow_mut(), &model, &fields).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("remove", move |address: ImmutableString| answer(remove(&mut own.borrow_mut(), &address)));
}
