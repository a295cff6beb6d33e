//! Things of one scene put into another, or once more into the same.
//!
//! What a thing can't be without comes along: a cloud's model, an aircraft's path. If the other scene has one that is
//! equal but for its name, its tracks included, that one is shared. So does a cloud's folder, unless the other scene has
//! one of its name. All else gets ids of its own and a name that is free.

use super::copied::Copied;
use super::copy::copy_model;
use super::{Arrangement, Names, Plan, folders, keys};
use crate::document::{Edit, ListEdit};
use crate::scene::{Cloud, Folder, ForKind, IdCounter, InScene, List, Listed, Scene, Thing, Track, for_each_kind};
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

/// Puts `things` of `from` into the scene `into`. Where one of the clouds would stand at the very place of another, all come
/// beside them; what else would hide its like steps aside. Tracks come with what they move.
pub fn things(from: &Scene, things: &[Thing], into: &Scene) -> Arrangement {
    let Wanted { chosen, needed, .. } = Wanted::new(from, things);
    let clouds: Vec<&Cloud> = from.clouds.iter().filter(|cloud| chosen.contains(&Thing::Cloud(cloud.id))).collect();
    let transfer = Transfer { offset: aside(from, &clouds, into), ..Transfer::new(from, into) };
    let mut all = All { transfer, chosen, needed, alone: BTreeMap::new() };
    for_each_kind(&mut all);
    all.transfer.done()
}

/// `things` of a scene with what they can't be without, and the tracks of both.
pub(super) fn with_needs(scene: &Scene, things: &[Thing]) -> BTreeSet<Thing> {
    let Wanted { chosen, needed, .. } = Wanted::new(scene, things);
    let mut all = &chosen | &needed;
    all.extend(keys::doomed(scene, &all));
    all
}

/// What is chosen, and what that hangs on.
struct Wanted<'s> {
    scene: &'s Scene,
    chosen: BTreeSet<Thing>,
    needed: BTreeSet<Thing>,
}

impl<'s> Wanted<'s> {
    fn new(scene: &'s Scene, things: &[Thing]) -> Self {
        let chosen = folders::with_contents(scene, things).into_iter().collect();
        let mut wanted = Self { scene, chosen, needed: BTreeSet::new() };
        for_each_kind(&mut wanted);
        wanted
    }
}

impl ForKind for Wanted<'_> {
    fn kind<T: Listed>(&mut self) {
        let chosen = T::list(self.scene).iter().filter(|value| self.chosen.contains(&T::thing(value.id())));
        let needs = |value: &T| [value.hangs_on(), value.kept_in()].into_iter().flatten().map(|(_, needed)| needed);
        self.needed.extend(chosen.flat_map(needs));
    }
}

/// As many widths of all `clouds` to the east that none of them stands where one of `into` does.
fn aside(from: &Scene, clouds: &[&Cloud], into: &Scene) -> DVec3 {
    let taken: BTreeSet<[u64; 3]> = into.clouds.iter().map(|cloud| bits(cloud.position)).collect();
    let step = DVec3::X * width(from, clouds);
    let offset = |steps: usize| step * steps as f64;
    let is_free = |steps: &usize| clouds.iter().all(|cloud| !taken.contains(&bits(cloud.position + offset(*steps))));
    (0..=into.clouds.len()).find(is_free).map_or(DVec3::ZERO, offset)
}

fn bits(at: DVec3) -> [u64; 3] {
    // Zero is one place, whatever its sign.
    (at + DVec3::ZERO).to_array().map(f64::to_bits)
}

/// From the westernmost to the easternmost end of the boxes, however they are turned, whole metres.
fn width(scene: &Scene, clouds: &[&Cloud]) -> f64 {
    let models = scene.models_by_id();
    let ends = clouds.iter().map(|cloud| {
        let boxes = models.get(&cloud.model).map(|model| &model.boxes).into_iter().flatten();
        let reach = boxes.map(|each| each.center.with_y(0.0).length() + 0.5 * each.size.x.max(each.size.z));
        let reach = cloud.scale * reach.fold(0.0, f64::max);
        [cloud.position.x - reach, cloud.position.x + reach]
    });
    let ends = ends.reduce(|[a, b], [c, d]| [a.min(c), b.max(d)]).unwrap_or_default();
    (ends[1] - ends[0]).round().max(1.0)
}

/// Copies on their way.
struct Transfer<'a> {
    from: &'a Scene,
    plan: Plan<'a>,
    copied: Copied,
    /// What stands for things of `from` in the other scene.
    new: BTreeMap<Thing, Thing>,
    /// Of clouds, metres.
    offset: DVec3,
}

impl<'a> Transfer<'a> {
    fn new(from: &'a Scene, into: &'a Scene) -> Self {
        let (plan, copied, new) = (Plan::new(into), Copied::default(), BTreeMap::new());
        Self { from, plan, copied, new, offset: DVec3::ZERO }
    }

    /// Copies `value` under that name.
    fn take<T: Listed>(&mut self, value: &T, name: String) {
        let Self { from, plan, copied, new, offset } = self;
        let old = T::thing(value.id());
        if let Thing::Model(id) = old {
            let Some(model) = from.model(id) else { return };
            let copy = copy_model(model, name, &mut plan.next_id);
            copied.model(model, &copy);
            new.insert(old, Thing::Model(copy.id));
            return plan.insert_model(copy);
        }
        let Some((mut edit, copy)) = Edit::copying(from, old, &mut plan.next_id) else { return };
        if let (Some((_, on)), Some(value)) = (value.hangs_on(), edit.value_mut())
            && let Some(on) = new.get(&on)
        {
            value.hang_on(*on);
        }
        if let Some(value) = edit.value_mut() {
            let folder = value.kept_in().and_then(|(_, folder)| new.get(&folder).copied());
            value.keep_in(folder);
        }
        match &mut edit {
            Edit::Cloud(ListEdit::Insert { value, .. }) => value.position += *offset,
            other => step_aside::<T>(other, copy, plan.scene),
        }
        edit.value_mut().into_iter().for_each(|value| value.name_mut().clone_from(&name));
        copied.thing(old, copy);
        new.insert(old, copy);
        plan.edits.push(edit);
    }

    fn done(mut self) -> Arrangement {
        self.copied.insert_tracks_of(self.from, &mut self.plan, self.offset);
        self.plan.done()
    }
}

/// All that is wanted, kind after kind.
struct All<'a> {
    transfer: Transfer<'a>,
    chosen: BTreeSet<Thing>,
    needed: BTreeSet<Thing>,
    /// Things of the other scene by themselves, once that was asked.
    alone: BTreeMap<Thing, Vec<Edit>>,
}

impl ForKind for All<'_> {
    fn kind<T: Listed>(&mut self) {
        if T::LIST == Track::LIST {
            return;
        }
        let mut names = Names::new(T::list(self.transfer.plan.scene).iter().map(InScene::name));
        for value in T::list(self.transfer.from) {
            let old = T::thing(value.id());
            let is_needed = self.needed.contains(&old);
            if !is_needed && !self.chosen.contains(&old) {
                continue;
            }
            let twin = if is_needed { self.twin(value) } else { None };
            match twin {
                Some(twin) => drop(self.transfer.new.insert(old, twin)),
                None => self.transfer.take(value, names.free(value.name())),
            }
            if !is_needed {
                self.transfer.plan.made.extend(self.transfer.new.get(&old));
            }
        }
    }
}

impl All<'_> {
    /// What the other scene has that is equal to `value` but for its name; of folders, what has its name.
    fn twin<T: Listed>(&mut self, value: &T) -> Option<Thing> {
        let into = self.transfer.plan.scene;
        if T::LIST == Folder::LIST {
            return folders::like(into, T::thing(value.id()), value.name());
        }
        let wanted = alone(self.transfer.from, value);
        let is_equal =
            |other: &&T| *self.alone.entry(T::thing(other.id())).or_insert_with(|| alone(into, *other)) == wanted;
        T::list(into).iter().find(is_equal).map(|other| T::thing(other.id()))
    }
}

/// A thing with its tracks, under ids that count from 1 and without a name.
fn alone<T: Listed>(scene: &Scene, value: &T) -> Vec<Edit> {
    let nowhere = Scene { cameras: List::new(), ..Scene::default() };
    let mut transfer = Transfer::new(scene, &nowhere);
    transfer.take(value, String::new());
    transfer.done().edits
}

/// Moves what `new` adds under the id of `copy` until it is no longer as one of its kind that is there, of whatever name.
fn step_aside<T: Listed>(new: &mut Edit, copy: Thing, into: &Scene) {
    let Some(id) = T::id_of(copy) else { return };
    let nameless = |mut edit: Edit| {
        edit.value_mut()?.name_mut().clear();
        Some(edit)
    };
    let like_new = |other: &T| Some(Edit::copying(into, T::thing(other.id()), &mut IdCounter(id.into()))?.0);
    let there: Vec<Edit> = T::list(into).iter().filter_map(like_new).filter_map(nameless).collect();
    while let Some(now) = nameless(new.clone()).filter(|now| there.contains(now)) {
        new.value_mut().into_iter().for_each(InScene::step_aside);
        if nameless(new.clone()) == Some(now) {
            break;
        }
    }
}
