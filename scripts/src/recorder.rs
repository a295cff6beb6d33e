//! What a script asks for: edits, tried at once in a draft of the scene.
//!
//! A script reads the draft, so it sees what it has done, as a hand would. Keys are gathered by property and put into
//! tracks at the end, or before something is removed: thousands are one edit a track. Every edit goes through
//! [`Document`], and the draft's own commit tells the faults that it would leave.

use crate::error::{Fault, Said, ScriptError};
use crate::limits::{EDITS, KEYS};
use cloudwright_core::arrange::{Arrangement, delete, keys::MOST_S};
use cloudwright_core::document::{Change, Document, Edit, EditError, ListEdit};
use cloudwright_core::problem::{self, Problem, Severity};
use cloudwright_core::property::{self, Address, Owner, Refusal, Target, Value};
use cloudwright_core::scene::{Beyond, HasId, IdCounter, KeyValue, List, Scene, Thing, Track, TrackId, TrackKey};
use std::collections::{BTreeMap, BTreeSet};

/// Keys are at one time if they are in the same step, parts of a second.
const STEPS_A_SECOND: f64 = 1e6;

/// The edits of a run so far.
#[derive(Debug)]
pub(crate) struct Recorder {
    draft: Document,
    edits: Vec<Edit>,
    /// By address.
    tracks: BTreeMap<String, Draft>,
    keys: usize,
    /// Boxes and groups in copies of models.
    copied: usize,
    /// Nothing may be asked for.
    read_only: bool,
}

/// A track in the making.
#[derive(Debug)]
struct Draft {
    /// None: it is not in the scene yet.
    id: Option<TrackId>,
    before: Beyond,
    after: Beyond,
    /// By step.
    keys: BTreeMap<i64, TrackKey>,
}

impl Recorder {
    pub(crate) fn new(scene: &Scene) -> Self {
        let draft = Document::new(scene.clone());
        Self { draft, edits: Vec::new(), tracks: BTreeMap::new(), keys: 0, copied: 0, read_only: false }
    }

    /// One for scripts that only read.
    pub(crate) fn read_only(scene: &Scene) -> Self {
        Self { read_only: true, ..Self::new(scene) }
    }

    fn may_write(&self) -> Result<(), Said> {
        if self.read_only {
            return Err(Said::script("an exporter changes nothing", "what changes the scene is of another kind: edit"));
        }
        Ok(())
    }

    /// The scene with what was asked for so far, keys apart.
    pub(crate) fn scene(&self) -> &Scene {
        self.draft.scene()
    }

    /// Another number after each change of the scene.
    pub(crate) fn revision(&self) -> usize {
        self.edits.len()
    }

    fn apply(&mut self, edit: Edit) -> Result<(), Said> {
        self.apply_and_tell(edit).map(|_| ())
    }

    fn apply_and_tell(&mut self, edit: Edit) -> Result<Change, Said> {
        self.may_write()?;
        if self.edits.len() >= EDITS {
            return Err(Said::limit(format!("the script changes more than {EDITS} things"), "make fewer of them"));
        }
        let change = self.draft.apply(edit.clone()).map_err(|error| Said::script(error.to_string(), ""))?;
        self.edits.push(edit);
        Ok(change)
    }

    /// Applies what gives a thing many values at once, and tells the faults of that.
    pub(crate) fn replace(&mut self, edit: Edit) -> Result<(), Said> {
        let change = self.apply_and_tell(edit)?;
        self.faultless(&change)
    }

    /// That `things`, which are in lists of the scene, have no faults.
    pub(crate) fn check(&self, things: &[Thing]) -> Result<(), Said> {
        let mut change = Change::default();
        for edit in things.iter().filter_map(|thing| Edit::replacing(self.scene(), *thing)) {
            change.join(edit.change());
        }
        self.faultless(&change)
    }

    fn faultless(&self, change: &Change) -> Result<(), Said> {
        let problems = problem::check_touched(self.scene(), change);
        match problems.into_iter().find(|problem| problem.severity == Severity::Error) {
            None => Ok(()),
            Some(Problem { place, message, hint, .. }) => Err(Said::script(format!("{place}: {message}"), hint)),
        }
    }

    /// Adds what `make` makes with the next ids.
    pub(crate) fn add<T>(
        &mut self,
        make: impl FnOnce(&mut IdCounter) -> Result<T, Said>,
        edit: impl FnOnce(ListEdit<T>) -> Edit,
    ) -> Result<u64, Said>
    where
        T: HasId,
    {
        let mut counter = self.scene().next_id;
        let value = make(&mut counter)?;
        let id = value.id().into();
        self.apply(Edit::NextId(counter))?;
        self.apply(edit(ListEdit::Insert { at: usize::MAX, value }))?;
        Ok(id)
    }

    /// The value at `address`.
    pub(crate) fn get(&self, address: Address) -> Result<Value, Said> {
        property::value(self.scene(), address).ok_or_else(|| self.not_there(address.owner, &address.to_string()))
    }

    pub(crate) fn set(&mut self, address: Address, value: &Value) -> Result<(), Said> {
        match Edit::set(self.scene(), address, value) {
            Ok(edit) => self.apply(edit),
            Err(EditError::Refused { refusal: Refusal::NotThere, .. }) => {
                Err(self.not_there(address.owner, &address.to_string()))
            }
            Err(error) => {
                let hint = address.property.kind.number().map_or(String::new(), |number| number.doc.into());
                Err(Said::script(error.to_string(), hint))
            }
        }
    }

    /// Takes `thing` out with all that hangs on it.
    pub(crate) fn remove(&mut self, thing: Thing) -> Result<(), Said> {
        self.need(thing)?;
        self.put_keys()?;
        let edits = delete::things(self.scene(), &[thing]).edits;
        edits.into_iter().try_for_each(|edit| self.apply(edit))
    }

    /// That `thing` is there.
    pub(crate) fn need(&self, thing: Thing) -> Result<(), Said> {
        if thing.is_in(self.scene()) {
            return Ok(());
        }
        let owner = Owner::Thing(thing);
        Err(self.not_there(owner, &owner.to_string()))
    }

    /// Does what `arrange` would do to the scene as it is now, and tells what that made.
    pub(crate) fn arrange(&mut self, arrange: impl FnOnce(&Scene) -> Arrangement) -> Result<Vec<Thing>, Said> {
        self.may_write()?;
        self.put_keys()?;
        let Arrangement { edits, made } = arrange(self.scene());
        for edit in edits {
            if let Edit::Model(ListEdit::Insert { value, .. }) = &edit {
                self.copied += value.boxes.len() + value.groups.len();
            }
            if self.copied > EDITS {
                let message = format!("the script copies models of more than {EDITS} boxes");
                return Err(Said::limit(message, "clouds may show the same model: duplicate"));
            }
            self.apply(edit)?;
        }
        Ok(made)
    }

    /// `key` of a property, in the place of one at its time.
    pub(crate) fn key(&mut self, target: &Target, key: TrackKey) -> Result<(), Said> {
        if !(-MOST_S..=MOST_S).contains(&key.time_s) {
            return Err(Said::script(format!("{} s is no time of a key", key.time_s), "seconds of the scene's clock"));
        }
        check_value(target, &key.value)?;
        self.keys += 1;
        if self.keys > KEYS {
            return Err(Said::limit(
                format!("the script sets more than {KEYS} keys"),
                "tracks go smoothly between few",
            ));
        }
        let step = (key.time_s * STEPS_A_SECOND).round() as i64;
        let key = TrackKey { time_s: step as f64 / STEPS_A_SECOND, ..key };
        self.draft_of(target)?.keys.insert(step, key);
        Ok(())
    }

    pub(crate) fn beyond(
        &mut self,
        target: &Target,
        before: Option<Beyond>,
        after: Option<Beyond>,
    ) -> Result<(), Said> {
        let draft = self.draft_of(target)?;
        draft.before = before.unwrap_or(draft.before);
        draft.after = after.unwrap_or(draft.after);
        Ok(())
    }

    /// Takes the key at that time away, and tells whether there was one.
    pub(crate) fn remove_key(&mut self, target: &Target, time_s: f64) -> Result<bool, Said> {
        let step = (time_s * STEPS_A_SECOND).round() as i64;
        Ok(self.draft_of(target)?.keys.remove(&step).is_some())
    }

    /// The addresses of all properties that have keys now, in their order.
    pub(crate) fn keyed(&self) -> BTreeSet<String> {
        let there = self.scene().tracks.iter().map(|track| track.property.clone());
        let mut keyed: BTreeSet<String> = there.collect();
        for (address, draft) in &self.tracks {
            if draft.keys.is_empty() {
                keyed.remove(address);
            } else {
                keyed.insert(address.clone());
            }
        }
        keyed
    }

    /// Takes all keys of a property away.
    pub(crate) fn clear_keys(&mut self, target: &Target) -> Result<(), Said> {
        self.draft_of(target)?.keys.clear();
        Ok(())
    }

    /// The keys of a property so far, by time.
    pub(crate) fn keys_of(&self, target: &Target) -> Result<Vec<TrackKey>, Said> {
        let address = target.to_string();
        if let Some(draft) = self.tracks.get(&address) {
            return Ok(draft.keys.values().cloned().collect());
        }
        let first = Address { owner: target.owner, property: target.property, part: 0 };
        if property::value(self.scene(), first).is_none() {
            return Err(self.not_there(target.owner, &address));
        }
        let track = self.scene().tracks.iter().find(|track| track.property == address);
        Ok(track.map(|track| track.keys.clone()).unwrap_or_default())
    }

    fn draft_of(&mut self, target: &Target) -> Result<&mut Draft, Said> {
        self.may_write()?;
        let address = target.to_string();
        if !self.tracks.contains_key(&address) {
            let first = Address { owner: target.owner, property: target.property, part: 0 };
            if property::value(self.scene(), first).is_none() {
                return Err(self.not_there(target.owner, &address));
            }
            let there = self.scene().tracks.iter().find(|track| track.property == address);
            let step = |key: &TrackKey| (key.time_s * STEPS_A_SECOND).round() as i64;
            let draft = match there {
                Some(track) => Draft {
                    id: Some(track.id),
                    before: track.before,
                    after: track.after,
                    keys: track.keys.iter().map(|key| (step(key), key.clone())).collect(),
                },
                None => Draft { id: None, before: Beyond::Hold, after: Beyond::Hold, keys: BTreeMap::new() },
            };
            self.tracks.insert(address.clone(), draft);
        }
        self.tracks.get_mut(&address).ok_or_else(|| Said::script("the track is gone", "report this"))
    }

    /// Has the scene show what was asked for so far, keys included.
    pub(crate) fn settle(&mut self) -> Result<(), Said> {
        // Who may not write has gathered none.
        self.put_keys()
    }

    /// Puts the keys that were gathered into tracks.
    fn put_keys(&mut self) -> Result<(), Said> {
        for (address, Draft { id, before, after, keys }) in std::mem::take(&mut self.tracks) {
            let keys: Vec<TrackKey> = keys.into_values().collect();
            match (id, keys.is_empty()) {
                (None, true) => {}
                (None, false) => {
                    let make = |counter: &mut IdCounter| {
                        let track = Track::new(TrackId::new(counter), address, keys);
                        Ok(Track { before, after, ..track })
                    };
                    self.add(make, Edit::Track)?;
                }
                (Some(id), true) => self.apply(Edit::Track(ListEdit::Remove(id)))?,
                (Some(id), false) => {
                    let track = Track { before, after, ..Track::new(id, address, keys) };
                    self.apply(Edit::Track(ListEdit::Replace(track)))?;
                }
            }
        }
        Ok(())
    }

    /// The edits, if they leave the scene without faults that it did not have.
    pub(crate) fn finish(&mut self) -> Result<Vec<Edit>, ScriptError> {
        let put = self.put_keys();
        put.map_err(|Said { fault, message, hint }| ScriptError::placeless(fault, message, hint))?;
        self.draft.commit().map_err(|error| {
            ScriptError::placeless(Fault::Scene, error.to_string(), "the scene would be left with faults")
        })?;
        Ok(std::mem::take(&mut self.edits))
    }

    fn not_there(&self, owner: Owner, address: &str) -> Said {
        let scene = self.scene();
        if owner.is_in(scene) {
            return Said::script(format!("{address} has no value now"), "what it belongs to is switched off");
        }
        let hint = match owner {
            Owner::Thing(Thing::Cloud(_)) => ids("the clouds", &scene.clouds),
            Owner::Thing(Thing::Camera(_)) => ids("the cameras", &scene.cameras),
            Owner::Thing(Thing::Path(_)) => ids("the paths", &scene.paths),
            Owner::Thing(Thing::Aircraft(_)) => ids("the aircraft", &scene.aircraft),
            Owner::Thing(Thing::Prop(_)) => ids("the props", &scene.props),
            Owner::Thing(Thing::Model(_) | Thing::Box(..) | Thing::Group(..)) => ids("the models", &scene.models),
            _ => String::new(),
        };
        Said::script(format!("{address}: the scene has none"), hint)
    }
}

/// That `value` is one that the property can have.
fn check_value(target: &Target, value: &KeyValue) -> Result<(), Said> {
    let parts = value.parts();
    if parts.len() != target.parts() {
        let wanted = if target.parts() == 1 { "a number" } else { "a list of three numbers" };
        return Err(Said::script(format!("{target}: a key of it has {wanted}"), ""));
    }
    let Some(range) = target.property.kind.number() else { return Ok(()) };
    let sound = |part: &f64| if target.property.cycle.is_some() { part.is_finite() } else { range.allows(*part) };
    match parts.iter().find(|part| !sound(part)) {
        None => Ok(()),
        Some(part) => {
            let message = format!("{target}: {part} is outside {} to {}", range.min, range.max);
            Err(Said::script(message, range.doc))
        }
    }
}

/// Which there are.
fn ids<T: HasId>(what: &str, list: &List<T>) -> String {
    const SHOWN: usize = 8;
    if list.is_empty() {
        return String::new();
    }
    let shown: Vec<String> = list.iter().take(SHOWN).map(|each| each.id().to_string()).collect();
    let more = if list.len() > SHOWN { ", …" } else { "" };
    format!("{what} are {}{more}", shown.join(", "))
}
