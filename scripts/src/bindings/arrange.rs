//! What hands do with many things at once, by ids: the core's own arrangements. And what is selected.

use super::convert::{count, items, list, number, of_id, of_vector, text, vector};
use super::scene::said;
use super::{Answer, Shared, Usage, answer};
use crate::error::{Said, did_you_mean};
use crate::recorder::Recorder;
use cloudwright_core::arrange::duplicate::{self, Copy};
use cloudwright_core::arrange::group::{self, Destination};
use cloudwright_core::arrange::mirror::{self, Axis};
use cloudwright_core::arrange::place_many::{self, Pattern, Places};
use cloudwright_core::arrange::{Arrangement, Refusal, join, split};
use cloudwright_core::property::Owner;
use cloudwright_core::scene::{BoxId, CloudId, GroupId, ModelId, Scene, Thing};
use glam::DVec3;
use rhai::{Array, Dynamic, Engine, ImmutableString, Map};
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
    (
        "copy",
        "copy([\"camera/1\", \"path/3\"])",
        "Copies cameras, paths, aircraft and props with their tracks; gives the copies' addresses.",
    ),
    ("join", "join([7, 8])", "Makes one cloud of several: the first of them; gives its id."),
    ("split", "split(cloud, [box])", "Parts boxes off into a cloud of their own; gives that cloud's id."),
    (
        "place_many",
        "place_many(model, #{ count: 40, center: [0, 1000, 0], extent: [16000, 12000], pattern: \"strewn\" })",
        "Places a model in a rectangle, in a grid or strewn, as the dialog does: also altitude_spread_m, scale, seed and \
         random_heading. Gives the clouds' ids.",
    ),
    (
        "put_in_group",
        "put_in_group(model, [\"model/3/box/9\"], \"top\")",
        "Puts boxes and sprites into a new shading group of that name, into one by its id, or, by (), into their own \
         again. Gives the group's id, or ().",
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

pub(super) fn model(recorder: &Recorder, model: &Dynamic) -> Result<ModelId, Said> {
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
pub(super) fn made(things: &[Thing]) -> Result<Array, Said> {
    let id = |thing: &Thing| match thing {
        Thing::Cloud(id) => of_id(id.0),
        Thing::Box(_, id) => of_id(id.0),
        Thing::Group(_, id) => of_id(id.0),
        other => Err(Said::script(format!("a {} was made", other.word()), "report this")),
    };
    things.iter().map(id).collect()
}

/// The first of those.
fn first_made(things: &[Thing]) -> Result<Dynamic, Said> {
    made(things)?.into_iter().next().ok_or_else(|| Said::script("nothing was made", "report this"))
}

/// What the core refuses, as it says it.
fn refused(refusal: &Refusal) -> Said {
    Said::script(refusal.to_string(), "")
}

/// Those of addresses that are all there.
fn things(recorder: &Recorder, addresses: &Dynamic) -> Result<Vec<Thing>, Said> {
    let addresses = list("the list of addresses", addresses)?;
    let thing = |(i, address): (usize, &Dynamic)| {
        let address = text(&format!("number {i} of the list"), address)?;
        match address.parse().map_err(said)? {
            Owner::Thing(Thing::Sprite(model, each, index)) => {
                recorder.need(Thing::Box(model, each))?;
                Ok(Thing::Sprite(model, each, index))
            }
            Owner::Thing(thing) => recorder.need(thing).map(|()| thing),
            owner => Err(Said::script(format!("{owner} is no thing"), "cloud/7, camera/1, path/3")),
        }
    };
    addresses.iter().enumerate().map(thing).collect()
}

fn copy_things(recorder: &mut Recorder, addresses: &Dynamic) -> Result<Array, Said> {
    let things = things(recorder, addresses)?;
    let alone = |t: &&Thing| matches!(t, Thing::Camera(_) | Thing::Path(_) | Thing::Aircraft(_) | Thing::Prop(_));
    if let Some(other) = things.iter().find(|thing| !alone(thing)) {
        return Err(Said::script(
            format!("a {} is not copied so", other.word()),
            "duplicate and duplicate_boxes are for these",
        ));
    }
    let made = recorder.arrange(|scene| duplicate::things(scene, &things))?;
    Ok(made.iter().map(|thing| Owner::Thing(*thing).to_string().into()).collect())
}

fn join_clouds(recorder: &mut Recorder, ids: &Dynamic) -> Result<Dynamic, Said> {
    let ids = there(recorder, ids, Thing::Cloud)?;
    let arrangement = join::clouds(recorder.scene(), &ids).map_err(|refusal| refused(&refusal))?;
    first_made(&recorder.arrange(|_| arrangement)?)
}

fn split_boxes(recorder: &mut Recorder, cloud: &Dynamic, ids: &Dynamic) -> Result<Dynamic, Said> {
    let id = CloudId(count("the cloud", cloud)?);
    recorder.need(Thing::Cloud(id))?;
    let model = recorder.scene().cloud(id).map_or(ModelId(0), |cloud| cloud.model);
    let ids = there(recorder, ids, |each| Thing::Box(model, each))?;
    let arrangement = split::boxes(recorder.scene(), id, &ids).map_err(|refusal| refused(&refusal))?;
    first_made(&recorder.arrange(|_| arrangement)?)
}

fn place_many_clouds(recorder: &mut Recorder, of: &Dynamic, fields: &Map) -> Result<Array, Said> {
    const NAMES: [&str; 8] =
        ["count", "center", "extent", "pattern", "altitude_spread_m", "scale", "seed", "random_heading"];
    let of = model(recorder, of)?;
    if let Some(name) = fields.keys().find(|name| !NAMES.contains(&name.as_str())) {
        return Err(Said::script(format!("place_many: there is no `{name}`"), did_you_mean(name, NAMES)));
    }
    let or = |name: &str, usual: Dynamic| fields.get(name).cloned().unwrap_or(usual);
    let pair = |name: &str, usual: f64| {
        let Some(given) = fields.get(name) else { return Ok([usual, usual]) };
        match list(name, given)?.as_slice() {
            [a, b] => Ok([number(name, a)?, number(name, b)?]),
            _ => Err(Said::script(
                format!("{name} is no list of two numbers"),
                "extent: [east, south], scale: [least, most]",
            )),
        }
    };
    let places = Places {
        center: vector("center", &or("center", of_vector([0.0; 3])))?.into(),
        extent: pair("extent", 10_000.0)?.into(),
        count: items("count", &or("count", 20_i64.into()))? as u32,
        pattern: match text("pattern", &or("pattern", "strewn".into()))?.as_str() {
            "grid" => Pattern::Grid,
            "strewn" => Pattern::Strewn,
            other => return Err(Said::script(format!("pattern is “{other}”"), "it is grid or strewn")),
        },
        altitude_spread_m: number("altitude_spread_m", &or("altitude_spread_m", 0.0.into()))?,
        scale: pair("scale", 1.0)?,
        seed: count("seed", &or("seed", 1_i64.into()))?,
        random_heading: or("random_heading", true.into())
            .as_bool()
            .map_err(|_| Said::script("random_heading is no flag", "true or false"))?,
    };
    let [least, most] = places.scale;
    if places.extent.min_element() < 0.0 || places.altitude_spread_m < 0.0 || !(0.0 < least && least <= most) {
        return Err(Said::script("place_many: a measure is below 0, or scale is the wrong way round", "metres"));
    }
    let clouds = recorder.arrange(|scene| place_many::model(scene, of, &places))?;
    recorder.check(&clouds)?;
    made(&clouds)
}

fn put_in_group(recorder: &mut Recorder, of: &Dynamic, addresses: &Dynamic, into: &Dynamic) -> Result<Dynamic, Said> {
    let of = model(recorder, of)?;
    let things = things(recorder, addresses)?;
    if let Some(other) = things.iter().find(|t| !matches!(t, Thing::Box(m, _) | Thing::Sprite(m, ..) if *m == of)) {
        return Err(Said::script(format!("{} is no box or sprite of model {of}", Owner::Thing(*other)), ""));
    }
    let destination = if into.is_unit() {
        Destination::Own
    } else if let Ok(name) = into.clone().into_string() {
        Destination::New(name)
    } else {
        let id = GroupId(count("the group", into)?);
        recorder.need(Thing::Group(of, id))?;
        Destination::Existing(id)
    };
    let made = recorder.arrange(|scene| group::put(scene, of, &things, &destination))?;
    let group = made.iter().find_map(|thing| if let Thing::Group(_, id) = thing { Some(id.0) } else { None });
    group.map_or(Ok(Dynamic::UNIT), of_id)
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
    engine.register_fn("copy", move |addresses: Dynamic| answer(copy_things(&mut own.borrow_mut(), &addresses)));
    let own = with();
    engine.register_fn("join", move |ids: Dynamic| answer(join_clouds(&mut own.borrow_mut(), &ids)));
    let own = with();
    engine.register_fn("split", move |cloud: Dynamic, ids: Dynamic| {
        answer(split_boxes(&mut own.borrow_mut(), &cloud, &ids))
    });
    let own = with();
    engine.register_fn("place_many", move |of: Dynamic, fields: Map| {
        answer(place_many_clouds(&mut own.borrow_mut(), &of, &fields))
    });
    let own = with();
    engine.register_fn("put_in_group", move |of: Dynamic, addresses: Dynamic, into: Dynamic| {
        answer(put_in_group(&mut own.borrow_mut(), &of, &addresses, &into))
    });
    let own = with();
    engine.register_fn("mirror_boxes", move |of: Dynamic, ids: Dynamic, along: ImmutableString| -> Answer<Array> {
        let axis = axis(&along)?;
        let mirrored = |scene: &_, model, ids: &[BoxId]| mirror::boxes(scene, model, ids, axis);
        answer(boxes(&mut own.borrow_mut(), &of, &ids, mirrored))
    });
}
