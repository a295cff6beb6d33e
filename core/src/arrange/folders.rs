//! Clouds into folders, and out of them.
//!
//! Which folder a cloud is in, the cloud says; so a folder that is deleted leaves its clouds, and nothing but the order of
//! clouds says in which order a folder's stand.

use super::duplicate::{self, Copy};
use super::{Arrangement, Names, Plan, at_end, order};
use crate::document::{Edit, ListEdit};
use crate::scene::{CloudId, Folder, FolderId, InScene, Scene, Thing};
use glam::DVec3;

/// A new folder of `clouds`, under a name that is free.
pub fn made(scene: &Scene, clouds: &[CloudId]) -> Arrangement {
    let mut plan = Plan::new(scene);
    let name = Names::new(scene.folders.iter().map(|folder| folder.name.as_str())).free("folder");
    let folder = Folder::new(FolderId::new(&mut plan.next_id), &name);
    let thing = Thing::Folder(folder.id);
    plan.made.push(thing);
    plan.edits.push(Edit::Folder(at_end(folder)));
    plan.edits.extend(clouds.iter().filter_map(|id| kept(scene, Thing::Cloud(*id), Some(thing))));
    plan.done()
}

/// Puts `clouds` into `folder`, or takes them out of theirs.
pub fn put(scene: &Scene, clouds: &[CloudId], folder: Option<FolderId>) -> Arrangement {
    let mut plan = Plan::new(scene);
    let others = clouds.iter().copied().filter(|id| scene.cloud(*id).is_some_and(|cloud| cloud.folder != folder));
    plan.made.extend(others.map(Thing::Cloud));
    plan.edits.extend(plan.made.iter().filter_map(|thing| kept(scene, *thing, folder.map(Thing::Folder))));
    plan.done()
}

/// The same, and before `before` of the scene's clouds, or at their end.
pub fn placed(scene: &Scene, clouds: &[CloudId], folder: Option<FolderId>, before: Option<CloudId>) -> Arrangement {
    let things: Vec<Thing> = clouds.iter().map(|id| Thing::Cloud(*id)).collect();
    let mut moved = order::moved(scene, &things, before.map(Thing::Cloud));
    if moved.edits.is_empty() {
        return put(scene, clouds, folder);
    }
    for value in moved.edits.iter_mut().filter_map(Edit::value_mut) {
        value.keep_in(folder.map(Thing::Folder));
    }
    moved
}

/// What the history calls that `count` clouds went into `folder`, or out of theirs.
pub fn told(scene: &Scene, count: usize, folder: Option<FolderId>) -> String {
    let clouds = if count == 1 { "Cloud" } else { "Clouds" };
    match folder.and_then(|id| scene.folders.with_id(id)) {
        Some(folder) => format!("{clouds} into folder {}", folder.name),
        None => format!("{clouds} out of the folder"),
    }
}

/// Copies of folders with copies of their clouds, `offset` metres in the world away.
pub fn duplicated(scene: &Scene, folders: &[FolderId], offset: DVec3) -> Arrangement {
    let chosen: Vec<Thing> = folders.iter().map(|id| Thing::Folder(*id)).collect();
    let ids: Vec<CloudId> = folders.iter().flat_map(|id| scene.clouds_in(*id)).map(|cloud| cloud.id).collect();
    let copies = duplicate::clouds(scene, &ids, offset, Copy::Linked);
    let mut plan = Plan::new(scene);
    for edit in &copies.edits {
        if let Edit::NextId(next) = edit {
            plan.next_id = *next;
        }
    }
    let mut names = Names::new(scene.folders.iter().map(|folder| folder.name.as_str()));
    let mut new = std::collections::BTreeMap::new();
    for old in scene.folders.iter().filter(|folder| chosen.contains(&Thing::Folder(folder.id))) {
        let id = FolderId::new(&mut plan.next_id);
        new.insert(old.id, id);
        plan.made.push(Thing::Folder(id));
        plan.edits.push(Edit::Folder(at_end(Folder { name: names.free(&old.name), ..Folder::new(id, "") })));
    }
    for mut edit in copies.edits {
        if let Edit::Cloud(ListEdit::Insert { value, .. }) = &mut edit {
            value.folder = value.folder.and_then(|old| new.get(&old).copied());
        }
        if !matches!(edit, Edit::NextId(_)) {
            plan.edits.push(edit);
        }
    }
    plan.done()
}

/// `things`, and what is kept in the folders among them.
pub fn with_contents(scene: &Scene, things: &[Thing]) -> Vec<Thing> {
    let mut all = things.to_vec();
    if things.iter().any(|thing| matches!(thing, Thing::Folder(_))) {
        let is_within = |folder: Option<FolderId>| folder.is_some_and(|id| things.contains(&Thing::Folder(id)));
        let within = scene.clouds.iter().filter(|cloud| is_within(cloud.folder)).map(|cloud| Thing::Cloud(cloud.id));
        let new: Vec<Thing> = within.filter(|cloud| !things.contains(cloud)).collect();
        all.extend(new);
    }
    all
}

/// Keeps `thing` in `folder`, or in none.
pub(super) fn kept(scene: &Scene, thing: Thing, folder: Option<Thing>) -> Option<Edit> {
    let mut edit = Edit::replacing(scene, thing)?;
    edit.value_mut()?.keep_in(folder);
    Some(edit)
}

/// The folder of that name, of several the one that is `folder` in the other scene too.
pub(super) fn like(scene: &Scene, folder: Thing, name: &str) -> Option<Thing> {
    let mut like = scene.folders.iter().filter(|each| each.name() == name).map(|each| Thing::Folder(each.id));
    let first = like.clone().next();
    like.find(|each| *each == folder).or(first)
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, two_clouds};
    use super::super::{clip, delete, transfer};
    use super::*;
    use crate::derived::Derived;
    use crate::problem::{check, scene_with_flight};

    fn ids(scene: &Scene) -> Vec<CloudId> {
        scene.clouds.iter().map(|cloud| cloud.id).collect()
    }

    /// Two clouds, the second in a folder "Anvils".
    fn with_folder() -> (Scene, FolderId) {
        let scene = two_clouds();
        let arrangement = made(&scene, &ids(&scene)[1..]);
        let mut after = applied(&scene, &arrangement);
        after.folders[0].name = "Anvils".into();
        let id = after.folders[0].id;
        assert_eq!(arrangement.made, [Thing::Folder(id)]);
        assert_eq!(check(&after), []);
        (after, id)
    }

    #[test]
    fn clouds_go_in_and_out() {
        let (scene, anvils) = with_folder();
        let all = ids(&scene);
        let folders = |scene: &Scene| scene.clouds.iter().map(|cloud| cloud.folder).collect::<Vec<_>>();
        assert_eq!(folders(&scene), [None, Some(anvils)]);
        let both = applied(&scene, &put(&scene, &all, Some(anvils)));
        assert_eq!(folders(&both), [Some(anvils); 2]);
        assert_eq!(put(&both, &all, Some(anvils)), Arrangement::default(), "they are there");
        assert_eq!(folders(&applied(&both, &put(&both, &all, None))), [None; 2]);
        let first = applied(&both, &placed(&both, &all[1..], None, Some(all[0])));
        assert_eq!((ids(&first), folders(&first)), (vec![all[1], all[0]], vec![None, Some(anvils)]));
        let told = [(1, None), (1, Some(anvils)), (2, Some(anvils))].map(|(count, into)| told(&both, count, into));
        assert_eq!(told, ["Cloud out of the folder", "Cloud into folder Anvils", "Clouds into folder Anvils"]);
        let second = applied(&both, &made(&both, &all[..1]));
        assert_eq!(second.folders[1].name, "folder");
        assert_ne!(second.folders[1].color, second.folders[0].color);
        let third = applied(&second, &made(&second, &[]));
        assert_eq!(third.folders[2].name, "folder 2");
    }

    #[test]
    fn a_folder_that_goes_leaves_its_clouds() {
        let (scene, anvils) = with_folder();
        let after = applied(&scene, &delete::things(&scene, &[Thing::Folder(anvils)]));
        assert_eq!((after.folders.len(), after.clouds.len(), after.clouds[1].folder), (0, 2, None));
        let all = with_contents(&scene, &[Thing::Folder(anvils)]);
        let after = applied(&scene, &delete::things(&scene, &all));
        assert_eq!((after.folders.len(), ids(&after)), (0, ids(&scene)[..1].to_vec()));
    }

    #[test]
    fn copies_keep_their_folder_or_bring_it_along() {
        let (scene, anvils) = with_folder();
        let cloud = Thing::Cloud(scene.clouds[1].id);
        let clip = clip::things(&scene, &[cloud]).expect("a cloud");
        let paste = |into: &Scene| {
            let pasted = clip::pasted(into, &clip, None).expect("pasted");
            assert_eq!(pasted.made.len(), 1, "the cloud alone is selected");
            applied(into, &pasted)
        };
        let here = paste(&scene);
        assert_eq!((here.folders.len(), here.clouds[2].folder), (1, Some(anvils)));
        let there = paste(&scene_with_flight());
        assert_eq!((there.folders.len(), there.folders[0].name.as_str()), (1, "Anvils"));
        assert_eq!(there.clouds.last().and_then(|cloud| cloud.folder), Some(there.folders[0].id));
        assert_eq!(there.folders[0].color, scene.folders[0].color);
        let twice = paste(&there);
        assert_eq!((twice.folders.len(), twice.clouds_in(twice.folders[0].id).count()), (1, 2), "it is there already");
        // So does *Append*.
        let appended = transfer::things(&scene, &[cloud], &scene_with_flight());
        assert_eq!(applied(&scene_with_flight(), &appended).folders.len(), 1);
        // A folder is copied with what is in it.
        let clip = clip::things(&scene, &[Thing::Folder(anvils)]).expect("a folder");
        assert_eq!((clip.scene.folders.len(), clip.scene.clouds.len(), clip.scene.models.len()), (1, 1, 1));
        let copies = applied(&scene, &duplicated(&scene, &[anvils], DVec3::X * 900.0));
        assert_eq!((copies.folders[1].name.as_str(), copies.clouds.len()), ("Anvils 2", 3));
        assert_eq!(copies.clouds[2].folder, Some(copies.folders[1].id));
    }

    #[test]
    fn clouds_of_a_hidden_folder_are_nowhere() {
        let (mut scene, anvils) = with_folder();
        let all = ids(&scene);
        let seen = |derived: &Derived| derived.clouds().iter().map(|cloud| cloud.id).collect::<Vec<_>>();
        let mut derived = Derived::new(&scene);
        let before = derived.clouds().to_vec();
        let work = derived.work_done();
        for hidden in [true, false] {
            let folder = Folder { hidden, ..scene.folders[0].clone() };
            let edit = Edit::Folder(ListEdit::Replace(folder));
            let change = edit.change();
            scene = applied(&scene, &Arrangement { edits: vec![edit], made: Vec::new() });
            derived.update(&scene, &change);
            assert_eq!(seen(&derived), if hidden { all[..1].to_vec() } else { all.clone() });
            assert_eq!(seen(&derived), seen(&Derived::new(&scene)), "as if computed anew");
            assert_eq!((scene.is_seen(&scene.clouds[1]), scene.is_seen(&scene.clouds[0])), (!hidden, true));
        }
        assert!(derived.clouds() == before);
        assert_eq!(derived.work_done().models_populated, work.models_populated, "what was strewn stayed");
        // Another cloud that comes into it goes out of sight; one that leaves comes back.
        scene.folders[0].hidden = true;
        let mut derived = Derived::new(&scene);
        assert_eq!(derived.work_done().models_populated, 1, "nothing is strewn for what is hidden");
        for (folder, count) in [(Some(anvils), 0), (None, 2)] {
            let edits = put(&scene, &all, folder).edits;
            let mut change = crate::change::Change::default();
            edits.iter().for_each(|edit| change.join(edit.change()));
            scene = applied(&scene, &Arrangement { edits, made: Vec::new() });
            derived.update(&scene, &change);
            assert_eq!(derived.clouds().len(), count);
        }
        scene.folders[0].locked = true;
        assert!(!scene.is_locked(&scene.clouds[1]));
        scene.clouds[1].folder = Some(anvils);
        assert!(scene.is_locked(&scene.clouds[1]) && !scene.is_locked(&scene.clouds[0]));
    }
}
