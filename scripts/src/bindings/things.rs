//! Things to add, as maps by the file format's names, and to remove. What a map leaves out is as in the editor's new one.

use super::convert::{count, filled, map, of_id, vector};
use super::scene::said;
use super::{Answer, Shared, Usage, answer};
use crate::error::{Said, did_you_mean};
use crate::recorder::Recorder;
use cloudwright_core::arrange::Arrangement;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::preset::Preset;
use cloudwright_core::problem::{self, Problem};
use cloudwright_core::property::{Described, Owner};
use cloudwright_core::scene::{
    Aircraft, AircraftId, BoxId, Camera, CameraId, CameraPath, Category, Cloud, CloudBox, CloudId, CloudModel, GroupId,
    IdCounter, ModelId, PathId, Prop, PropId, ShadingGroup, Thing,
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
    (
        "add_path",
        "add_path(#{ name: \"over\", keys: [#{ time_s: 0, position: […], heading_deg: 0, pitch_deg: 0 }] })",
        "Adds a camera path, its keys in order of time; gives its id.",
    ),
    ("add_aircraft", "add_aircraft(#{ path: path, ahead_s: 4 })", "Adds an aircraft to a path; gives its id."),
    (
        "add_prop",
        "add_prop(#{ model: \"tower.glb\", position: [0, 0, -2000] })",
        "Adds a model that stands, of a file beside the scene's; gives its id.",
    ),
    (
        "add_preset",
        "add_preset(\"cumulus_humilis\", [0, 900, 0])",
        "Adds a ready-made cloud with its model; gives the cloud's id.",
    ),
    (
        "add_preset_model",
        "add_preset_model(\"cumulus_humilis\")",
        "Adds the model of a ready-made cloud alone; gives the model's id.",
    ),
    ("remove", "remove(\"cloud/7\")", "Takes a thing out with all that hangs on it; or the ground."),
];

pub(super) const IDS: (&str, &str) = ("id", "ids are given by the scene");

/// `problems` as what the script must hear, where there are any; the rest of them would mostly be the same again.
pub(super) fn none_of(problems: Vec<Problem>) -> Result<(), Said> {
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

fn add_path(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let make = |counter: &mut IdCounter| {
        let usual = CameraPath::new(PathId::new(counter), "path", Vec::new());
        sound(Thing::Path(usual.id), "path", filled("path", &usual, fields, &[IDS])?)
    };
    let id = recorder.add(make, Edit::Path)?;
    recorder.check(&[Thing::Path(PathId(id))])?;
    Ok(id)
}

fn add_aircraft(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let path =
        fields.get("path").ok_or_else(|| Said::script("aircraft: it lacks `path`", "the id of a camera path"))?;
    let path = PathId(count("aircraft.path", path)?);
    recorder.need(Thing::Path(path))?;
    let make = |counter: &mut IdCounter| {
        let usual = Aircraft::new(AircraftId::new(counter), "aircraft", path);
        sound(Thing::Aircraft(usual.id), "aircraft", filled("aircraft", &usual, fields, &[IDS])?)
    };
    let id = recorder.add(make, Edit::Aircraft)?;
    recorder.check(&[Thing::Aircraft(AircraftId(id))])?;
    Ok(id)
}

fn add_prop(recorder: &mut Recorder, fields: &Map) -> Result<u64, Said> {
    let make = |counter: &mut IdCounter| {
        let usual = Prop::new(PropId::new(counter), "", DVec3::ZERO);
        sound(Thing::Prop(usual.id), "prop", filled("prop", &usual, fields, &[IDS])?)
    };
    let id = recorder.add(make, Edit::Prop)?;
    recorder.check(&[Thing::Prop(PropId(id))])?;
    Ok(id)
}

fn preset(name: &str) -> Result<&'static Preset, Said> {
    Preset::by_name(name).ok_or_else(|| {
        let names: Vec<&str> = Preset::ALL.iter().map(|preset| preset.name).collect();
        let near = did_you_mean(name, names.iter().copied());
        let hint = if near.is_empty() { format!("there are {}", names.join(", ")) } else { near };
        Said::script(format!("there is no ready-made cloud “{name}”"), hint)
    })
}

fn add_preset(recorder: &mut Recorder, name: &str, at: [f64; 3]) -> Result<u64, Said> {
    let preset = preset(name)?;
    let (mut edits, id) = preset.place(recorder.scene(), DVec3::from(at));
    // Out of reach, or no place at all: told here, it has its line.
    if let Some(Edit::Cloud(ListEdit::Insert { value, .. })) = edits.last_mut() {
        *value = sound(Thing::Cloud(id), "cloud", value.clone())?;
    }
    recorder.arrange(|_| Arrangement { edits, made: Vec::new() })?;
    Ok(id.0)
}

fn add_preset_model(recorder: &mut Recorder, name: &str) -> Result<u64, Said> {
    let (mut edits, id) = preset(name)?.place(recorder.scene(), DVec3::ZERO);
    let Some(Edit::Cloud(ListEdit::Insert { value, .. })) = edits.pop() else {
        return Err(Said::script("the ready-made cloud has no model", "report this"));
    };
    debug_assert_eq!(value.id, id);
    recorder.arrange(|_| Arrangement { edits, made: Vec::new() })?;
    Ok(value.model.0)
}

fn remove(recorder: &mut Recorder, address: &str) -> Result<(), Said> {
    match address.parse().map_err(said)? {
        Owner::Ground => recorder.replace(Edit::Ground(None)),
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
    engine.register_fn("add_path", move |fields: Map| answer(add_path(&mut own.borrow_mut(), &fields).and_then(of_id)));
    let own = Rc::clone(recorder);
    engine.register_fn("add_aircraft", move |fields: Map| {
        answer(add_aircraft(&mut own.borrow_mut(), &fields).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("add_prop", move |fields: Map| answer(add_prop(&mut own.borrow_mut(), &fields).and_then(of_id)));
    let own = Rc::clone(recorder);
    engine.register_fn("add_preset", move |name: ImmutableString, at: Dynamic| -> Answer<Dynamic> {
        let at = vector("the place", &at)?;
        answer(add_preset(&mut own.borrow_mut(), &name, at).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("add_preset_model", move |name: ImmutableString| {
        answer(add_preset_model(&mut own.borrow_mut(), &name).and_then(of_id))
    });
    let own = Rc::clone(recorder);
    engine.register_fn("remove", move |address: ImmutableString| answer(remove(&mut own.borrow_mut(), &address)));
}
