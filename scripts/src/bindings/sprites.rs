//! Single sprites, always many at once: which lie near a line, and what a hand does with them.
//!
//! A sprite of a model is a box's id and the sprite's number in it, `[box, index]`.

use super::arrange::{made, model};
use super::convert::{count, list, number, of_id, of_vector, places, vector};
use super::placed::Placed;
use super::{Answer, Shared, Usage, answer};
use crate::error::Said;
use crate::recorder::Recorder;
use cloudwright_core::arrange::sprites::{self, SpriteId};
use cloudwright_core::arrange::{Arrangement, ModelSpace, auto_group};
use cloudwright_core::scene::{BoxId, CloudId, ModelId, Scene, Thing};
use glam::DVec3;
use rhai::{Array, Dynamic, Engine};
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    (
        "sprites_near",
        "sprites_near(cloud, [[0, 900, 0], [0, 900, -5000]], 150)",
        "Those sprites of a cloud, [box, index] each, that come so near to the line through places in the world.",
    ),
    ("drop_sprites", "drop_sprites(model, [[box, 7]])", "Takes sprites out of a model."),
    (
        "move_sprites",
        "move_sprites(model, [[box, 7, [0, 300, 0]]])",
        "Puts sprites of a model to places in its space, where no cull drops them.",
    ),
    ("reset_sprites", "reset_sprites(model, [[box, 7]])", "Gives sprites back the places that chance gave them."),
    ("to_world", "to_world(cloud, [0, 300, 0])", "Where a place of a cloud's model lies in the world."),
    ("to_model", "to_model(cloud, [0, 900, -2000])", "Which place of its model lies there in the world."),
    (
        "auto_group",
        "auto_group(cloud)",
        "Groups the sprites of a cloud's model anew, none of more than 30; gives the groups' ids.",
    ),
];

fn space(recorder: &Recorder, cloud: &Dynamic) -> Result<(CloudId, ModelSpace), Said> {
    let id = CloudId(count("the cloud", cloud)?);
    recorder.need(Thing::Cloud(id))?;
    let cloud = recorder.scene().cloud(id).ok_or_else(|| Said::script("the cloud is gone", "report this"))?;
    Ok((id, ModelSpace::of(cloud)))
}

/// How far `place` lies from the line through `places`.
fn from_line(place: DVec3, places: &[DVec3]) -> f64 {
    let from_piece = |pair: &[DVec3]| {
        let way = pair[1] - pair[0];
        let share = ((place - pair[0]).dot(way) / way.length_squared()).clamp(0.0, 1.0);
        // Two places in one have no way between them.
        place.distance(pair[0] + way * if share.is_nan() { 0.0 } else { share })
    };
    match places {
        [one] => place.distance(*one),
        _ => places.windows(2).map(from_piece).fold(f64::INFINITY, f64::min),
    }
}

fn near(recorder: &Shared, placed: &Placed, cloud: &Dynamic, line: &Dynamic, metres: f64) -> Result<Array, Said> {
    let recorder = recorder.borrow();
    let (id, _) = space(&recorder, cloud)?;
    let line: Vec<DVec3> = places("the places", line)?.into_iter().map(DVec3::from).collect();
    placed.tell(&recorder, |derived| {
        let Some(cloud) = derived.cloud(id) else { return Ok(Array::new()) };
        // Far from all of it, none needs a look.
        let middle = cloud.origin + cloud.center.as_dvec3();
        if from_line(middle, &line) > metres + f64::from(cloud.reach) {
            return Ok(Array::new());
        }
        let is_near = |sprite: &&cloudwright_core::sprites::Sprite| {
            let place = cloud.origin + sprite.position.as_dvec3();
            from_line(place, &line) < metres + f64::from(sprite.radius())
        };
        let found = cloud.sprites.iter().filter(is_near);
        let pair = |sprite: &cloudwright_core::sprites::Sprite| {
            Ok(Dynamic::from_array(vec![of_id(sprite.box_id.0)?, Dynamic::from_int(sprite.index.into())]))
        };
        found.map(pair).collect()
    })
}

/// Box and index, and what follows them.
fn sprite(
    recorder: &Recorder,
    of: ModelId,
    i: usize,
    value: &Dynamic,
    length: usize,
) -> Result<(SpriteId, Vec<Dynamic>), Said> {
    let what = format!("number {i} of the list");
    let parts = list(&what, value)?;
    if parts.len() != length {
        let hint = if length == 2 { "[box, index]" } else { "[box, index, [x, y, z]]" };
        return Err(Said::script(format!("{what} is a list of {}", parts.len()), hint));
    }
    let id = BoxId(count("the box", &parts[0])?);
    recorder.need(Thing::Box(of, id))?;
    let index = count("the index", &parts[1])?;
    let tried =
        recorder.scene().model(of).and_then(|model| model.boxes.with_id(id)).map_or(0, |each| each.sprite_count);
    match u32::try_from(index) {
        Ok(index) if index < tried => Ok(((id, index), parts)),
        _ => Err(Said::script(format!("{what}: box {id} has no sprite {index}"), format!("it has {tried}, from 0 on"))),
    }
}

fn changed(
    recorder: &mut Recorder,
    of: &Dynamic,
    given: &Dynamic,
    arrange: fn(&Scene, ModelId, &[SpriteId]) -> Arrangement,
) -> Result<(), Said> {
    let of = model(recorder, of)?;
    let given = list("the sprites", given)?;
    let ids = given.iter().enumerate().map(|(i, each)| sprite(recorder, of, i, each, 2).map(|(id, _)| id));
    let ids = ids.collect::<Result<Vec<_>, _>>()?;
    recorder.arrange(|scene| arrange(scene, of, &ids)).map(|_| ())
}

fn moved(recorder: &mut Recorder, of: &Dynamic, given: &Dynamic) -> Result<(), Said> {
    let of = model(recorder, of)?;
    let given = list("the sprites", given)?;
    let place = |(i, each): (usize, &Dynamic)| {
        let (id, parts) = sprite(recorder, of, i, each, 3)?;
        Ok((id, DVec3::from(vector("its place", &parts[2])?)))
    };
    let places = given.iter().enumerate().map(place).collect::<Result<Vec<_>, Said>>()?;
    recorder.arrange(|scene| sprites::moved(scene, of, &places))?;
    recorder.check(&[Thing::Model(of)])
}

fn grouped(recorder: &Shared, placed: &Placed, cloud: &Dynamic) -> Result<Array, Said> {
    let mut recorder = recorder.borrow_mut();
    let (id, _) = space(&recorder, cloud)?;
    let arrangement = placed.tell(&recorder, |derived| {
        let scene = recorder.scene();
        let cloud = scene.cloud(id).zip(scene.cloud(id).and_then(|cloud| scene.model(cloud.model)));
        let populated = cloud.and_then(|(cloud, model)| derived.populated(model.id, cloud.seed.unwrap_or(model.seed)));
        Ok(cloud.zip(populated).map(|((_, model), sprites)| auto_group::model(scene, model.id, sprites)))
    })?;
    made(&recorder.arrange(|_| arrangement.unwrap_or_default())?)
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared, placed: &Rc<Placed>) {
    let with = || Rc::clone(recorder);
    let (own, all) = (with(), Rc::clone(placed));
    engine.register_fn("sprites_near", move |cloud: Dynamic, line: Dynamic, metres: Dynamic| -> Answer<Array> {
        Ok(near(&own, &all, &cloud, &line, number("the distance", &metres)?)?)
    });
    let (own, all) = (with(), Rc::clone(placed));
    engine.register_fn("auto_group", move |cloud: Dynamic| -> Answer<Array> { Ok(grouped(&own, &all, &cloud)?) });
    let own = with();
    engine.register_fn("drop_sprites", move |of: Dynamic, given: Dynamic| {
        answer(changed(&mut own.borrow_mut(), &of, &given, sprites::dropped))
    });
    let own = with();
    engine.register_fn("reset_sprites", move |of: Dynamic, given: Dynamic| {
        answer(changed(&mut own.borrow_mut(), &of, &given, sprites::reset))
    });
    let own = with();
    engine.register_fn("move_sprites", move |of: Dynamic, given: Dynamic| {
        answer(moved(&mut own.borrow_mut(), &of, &given))
    });
    let own = with();
    engine.register_fn("to_world", move |cloud: Dynamic, place: Dynamic| -> Answer<Dynamic> {
        let (_, space) = space(&own.borrow(), &cloud)?;
        Ok(of_vector(space.to_world(vector("the place", &place)?.into()).to_array()))
    });
    let own = with();
    engine.register_fn("to_model", move |cloud: Dynamic, place: Dynamic| -> Answer<Dynamic> {
        let (_, space) = space(&own.borrow(), &cloud)?;
        Ok(of_vector(space.from_world(vector("the place", &place)?.into()).to_array()))
    });
}
