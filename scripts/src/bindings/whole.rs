//! A thing as a whole, by the file's own fields: read as a map, and changed by a map of those that are to be others.
//!
//! So lists and tables are in reach whose parts have no addresses to be added at: keys of a path, a day's light, single
//! sprites of a box.

use super::convert::{filled, of_thing};
use super::scene::said;
use super::things::{IDS, none_of};
use super::{Shared, Usage, answer};
use crate::error::Said;
use crate::recorder::Recorder;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::problem;
use cloudwright_core::property::{Described, Owner};
use cloudwright_core::scene::Thing;
use rhai::{Dynamic, Engine, ImmutableString, Map};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    ("fields", "fields(\"path/3\")", "All that the file says of a thing, of sky, weather, place or ground, as a map."),
    (
        "change",
        "change(\"path/3\", #{ keys: […] })",
        "Gives it other fields, whole lists and tables too; of `ground`, adds one where there is none.",
    ),
];

/// What has ids that others count on, and so is changed one by one.
const ONE_BY_ONE: [(&str, &str); 3] = [
    IDS,
    ("boxes", "change each by its own address; add_box and remove do the rest"),
    ("groups", "change each by its own address; add_group and remove do the rest"),
];

/// A thing of the scene that is to have some fields.
struct Whole<'a> {
    what: &'a str,
    owner: Owner,
    fields: &'a Map,
}

impl Whole<'_> {
    /// It as a map, and the edit that puts it in the place of the old one.
    fn of<T>(&self, old: &T, edit: impl FnOnce(T) -> Edit) -> Result<(Dynamic, Edit), Said>
    where
        T: Serialize + DeserializeOwned + Described,
    {
        let new: T = filled(self.what, old, self.fields, &ONE_BY_ONE)?;
        if !self.fields.is_empty() {
            none_of(problem::check_new(self.owner, self.what, &new))?;
        }
        Ok((of_thing(&new)?, edit(new)))
    }

    fn find(&self, recorder: &Recorder) -> Result<(Dynamic, Edit), Said> {
        let scene = recorder.scene();
        if let Owner::Thing(thing) = self.owner {
            recorder.need(thing)?;
        }
        // What is needed is there.
        let gone = || Said::script(format!("{} is gone", self.what), "report this");
        let model = |id| scene.model(id).ok_or_else(gone);
        macro_rules! listed {
            ($Kind:ident, $list:expr, $id:expr) => {
                self.of($list.with_id($id).ok_or_else(gone)?, |value| Edit::$Kind(ListEdit::Replace(value)))
            };
        }
        match self.owner {
            Owner::Sky => self.of(&scene.sky, Edit::Sky),
            Owner::Weather => self.of(&scene.weather, Edit::Weather),
            Owner::Site => self.of(&scene.site, Edit::Site),
            Owner::Ground => self.of(&scene.ground.clone().unwrap_or_default(), |new| Edit::Ground(Some(new))),
            Owner::Thing(Thing::Camera(id)) => listed!(Camera, scene.cameras, id),
            Owner::Thing(Thing::Model(id)) => listed!(Model, scene.models, id),
            Owner::Thing(Thing::Folder(id)) => listed!(Folder, scene.folders, id),
            Owner::Thing(Thing::Cloud(id)) => listed!(Cloud, scene.clouds, id),
            Owner::Thing(Thing::Path(id)) => listed!(Path, scene.paths, id),
            Owner::Thing(Thing::Aircraft(id)) => listed!(Aircraft, scene.aircraft, id),
            Owner::Thing(Thing::Prop(id)) => listed!(Prop, scene.props, id),
            Owner::Thing(Thing::Box(of, id)) => {
                let old = model(of)?.boxes.with_id(id).ok_or_else(gone)?;
                self.of(old, |new| Edit::Box(of, ListEdit::Replace(new)))
            }
            Owner::Thing(Thing::Group(of, id)) => {
                let old = model(of)?.groups.with_id(id).ok_or_else(gone)?;
                self.of(old, |new| Edit::Group(of, ListEdit::Replace(new)))
            }
            Owner::Thing(Thing::Track(_)) => {
                Err(Said::script("a track has no fields here", "keys, key and track read and change it"))
            }
            Owner::Thing(Thing::Sprite(..)) => Err(Said::script(
                "what is set of a sprite stands in its box's sprite_edits",
                "move_sprites, drop_sprites and reset_sprites change it",
            )),
            Owner::Scene | Owner::Sun => Err(Said::script(format!("{} has no fields here", self.what), "get and set")),
            Owner::AmbientKey(_) | Owner::DirectionalKey(_) | Owner::Level(..) | Owner::Key(..) => {
                Err(Said::script(format!("{} is a part of something", self.what), "take the whole, or get and set"))
            }
        }
    }
}

/// The fields of what is at `address`.
fn fields(recorder: &Recorder, address: &str) -> Result<Dynamic, Said> {
    let owner = address.parse().map_err(said)?;
    Whole { what: address, owner, fields: &Map::new() }.find(recorder).map(|(fields, _)| fields)
}

/// Gives it others.
fn change(recorder: &mut Recorder, address: &str, fields: &Map) -> Result<(), Said> {
    let owner = address.parse().map_err(said)?;
    let (_, edit) = Whole { what: address, owner, fields }.find(recorder)?;
    recorder.replace(edit)
}

pub(super) fn register(engine: &mut Engine, recorder: &Shared) {
    let own = Rc::clone(recorder);
    engine.register_fn("fields", move |address: ImmutableString| answer(fields(&own.borrow(), &address)));
    let own = Rc::clone(recorder);
    engine.register_fn("change", move |address: ImmutableString, fields: Map| {
        answer(change(&mut own.borrow_mut(), &address, &fields))
    });
}
