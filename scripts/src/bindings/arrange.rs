//! What hands do with many things at once, by ids: the core's own arrangements. And what is selected.

use super::convert::{count, list, of_id, vector};
use super::{Answer, Shared, Usage, answer};
use crate::error::Said;
use crate::recorder::Recorder;
use cloudwright_core::arrange::Arrangement;
use cloudwright_core::arrange::duplicate::{self, Copy};
use cloudwright_core::arrange::mirror::{self, Axis};
use cloudwright_core::property::Owner;
use cloudwright_core::scene::{BoxId, CloudId, ModelId, Scene, Thing};
use glam::DVec3;
use rhai::{Array, Dynamic, Engine, ImmutableString};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    ("selection", "selection()", "The addresses of what is selected, such as cloud/7; none on the command line."),
    (
        "duplicate",
        "duplicate([7, 8], [500, 0, 0])",
        "Copies clouds with their tracks, metres away; both show the same models. Gives the copies' ids.",
    ),
    ("duplicate_own", "duplicate_own([7, 8], [500, 0, 0])", "As duplicate, with copies of their models."),
    (
        "duplicate_boxes",
        "duplicate_boxes(model, boxes(model), [0, 300, 0])",
        "Copies boxes within their model, metres away in its space. Gives the copies' ids.",
    ),
    ("make_own", "make_own([7])", "Gives clouds whose models others show too copies of those; the ids of such clouds."),
    (
        "mirror",
        "mirror([7], \"x\")",
        "Mirrors the models of clouds along x, y or z, in all clouds that show them. Gives the clouds' ids.",
    ),
    ("mirror_boxes", "mirror_boxes(model, boxes(model), \"x\")", "Mirrors boxes of a model about their middle."),
];

/// Those of ids that are all there, as `thing` makes things of them.
fn there<T: FromNumber>(recorder: &Recorder, ids: &Dynamic, thing: impl Fn(T) -> Thing) -> Result<Vec<T>, Said> {
    let ids = list("the list of ids", ids)?;
    let ids = ids.iter().enumerate().map(|(i, id)| {
        let id = T::of(count(&format!("number {i} of the list"), id)?);
        recorder.need(thing(id))?;
        Ok(id)
    });
    ids.collect()
}

/// An id that can be made of a number.
trait FromNumber: std::marker::Copy {
    fn of(number: u64) -> Self;
}

impl FromNumber for CloudId {
    fn of(number: u64) -> Self {
        Self(number)
    }
}

impl FromNumber for BoxId {
    fn of(number: u64) -> Self {
        Self(number)
    }
}

fn model(recorder: &Recorder, model: &Dynamic) -> Result<ModelId, Said> {
    let model = ModelId(count("the model", model)?);
    recorder.need(Thing::Model(model))?;
    Ok(model)
}

fn offset(value: &Dynamic) -> Result<DVec3, Said> {
    vector("the offset", value).map(DVec3::from_array)
}

fn axis(name: &str) -> Result<Axis, Said> {
    match name {
        "x" => Ok(Axis::X),
        "y" => Ok(Axis::Y),
        "z" => Ok(Axis::Z),
        _ => Err(Said::script(format!("there is no axis “{name}”"), "\"x\", \"y\" or \"z\"")),
    }
}

/// The ids of what was made; all are of one kind.
fn made(things: &[Thing]) -> Result<Array, Said> {
    let id = |thing: &Thing| match thing {
        Thing::Cloud(id) => of_id(id.0),
        Thing::Box(_, id) => of_id(id.0),
        other => Err(Said::script(format!("a {} was made", other.word()), "report this")),
    };
    things.iter().map(id).collect()
}

fn copied(recorder: &mut Recorder, ids: &Dynamic, by: &Dynamic, copy: Copy) -> Result<Array, Said> {
    let (ids, by) = (there(recorder, ids, Thing::Cloud)?, offset(by)?);
    made(&recorder.arrange(|scene| duplicate::clouds(scene, &ids, by, copy))?)
}

fn boxes(
    recorder: &mut Recorder,
    of: &Dynamic,
    ids: &Dynamic,
    arrange: impl FnOnce(&Scene, ModelId, &[BoxId]) -> Arrangement,
) -> Result<Array, Said> {
    let model = model(recorder, of)?;
    let ids = there(recorder, ids, |id| Thing::Box(model, id))?;
    made(&recorder.arrange(|scene| arrange(scene, model, &ids))?)
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared, selected: &[Thing]) {
    let with = || Rc::clone(recorder);
    let (own, selected) = (with(), selected.to_vec());
    engine.register_fn("selection", move || -> Array {
        let recorder = own.borrow();
        let there = selected.iter().filter(|thing| thing.is_in(recorder.scene()));
        there.map(|thing| Owner::Thing(*thing).to_string().into()).collect()
    });
    let own = with();
    engine.register_fn("duplicate", move |ids: Dynamic, by: Dynamic| {
        answer(copied(&mut own.borrow_mut(), &ids, &by, Copy::Linked))
    });
    let own = with();
    engine.register_fn("duplicate_own", move |ids: Dynamic, by: Dynamic| {
        answer(copied(&mut own.borrow_mut(), &ids, &by, Copy::Own))
    });
    let own = with();
    engine.register_fn("duplicate_boxes", move |of: Dynamic, ids: Dynamic, by: Dynamic| -> Answer<Array> {
        let by = offset(&by)?;
        let copies = |scene: &_, model, ids: &[BoxId]| duplicate::boxes(scene, model, ids, by);
        answer(boxes(&mut own.borrow_mut(), &of, &ids, copies))
    });
    let own = with();
    engine.register_fn("make_own", move |ids: Dynamic| -> Answer<Array> {
        let mut recorder = own.borrow_mut();
        let ids = there(&recorder, &ids, Thing::Cloud)?;
        answer(recorder.arrange(|scene| duplicate::make_own(scene, &ids)).and_then(|things| made(&things)))
    });
    let own = with();
    engine.register_fn("mirror", move |ids: Dynamic, along: ImmutableString| -> Answer<Array> {
        let mut recorder = own.borrow_mut();
        let (ids, axis) = (there(&recorder, &ids, Thing::Cloud)?, axis(&along)?);
        answer(recorder.arrange(|scene| mirror::clouds(scene, &ids, axis)).and_then(|things| made(&things)))
    });
    let own = with();
    engine.register_fn("mirror_boxes", move |of: Dynamic, ids: Dynamic, along: ImmutableString| -> Answer<Array> {
        let axis = axis(&along)?;
        let mirrored = |scene: &_, model, ids: &[BoxId]| mirror::boxes(scene, model, ids, axis);
        answer(boxes(&mut own.borrow_mut(), &of, &ids, mirrored))
    });
}
