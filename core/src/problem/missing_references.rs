//! What is named must exist: the models and folders of clouds, the paths of aircraft, the groups of boxes and sprites, the
//! sprites that were edited.

use super::Problem;
use super::scope::Scope;
use crate::change::Change;
use crate::scene::{CloudBox, CloudModel, ForKind, GroupId, Listed, Thing, for_each_kind};
use rustc_hash::FxHashSet;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Arguments;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    let Scope { scene, change } = scope;
    // Where something may be gone, all that may have named it is asked.
    let everything = Change::everything();
    let naming = Scope { scene, change: if change.touches_lists() { &everything } else { change } };
    let mut hanging = Hanging { scope: naming, found: Vec::new() };
    for_each_kind(&mut hanging);
    let mut there: BTreeMap<&str, FxHashSet<u64>> = BTreeMap::new();
    for (list_name, i, field, on) in hanging.found {
        let Some((id, others_name, others)) = on.among(scene) else { continue };
        if !there.entry(others_name).or_insert_with(|| others.iter().copied().collect()).contains(&id) {
            problems.push(Problem::error(
                format!("{list_name}[{i}].{field}"),
                format!("there is no {} {id}", on.word()),
                format!("the {others_name} are {}", list(others.iter().map(u64::to_string))),
            ));
        }
    }
    for (i, model) in scope.models() {
        let groups: BTreeSet<GroupId> = model.groups.iter().map(|group| group.id).collect();
        for (j, cloud_box) in model.boxes.iter().enumerate() {
            check_box(format_args!("models[{i}].boxes[{j}]"), (model, &groups), cloud_box, problems);
        }
    }
}

/// What hangs on something, or is kept in it: list, position, field, and on or in what.
struct Hanging<'a> {
    scope: Scope<'a>,
    found: Vec<(&'static str, usize, &'static str, Thing)>,
}

impl ForKind for Hanging<'_> {
    fn kind<T: Listed>(&mut self) {
        let named = |(i, value): (usize, &T)| {
            let named = [value.hangs_on(), value.kept_in()].into_iter().flatten();
            named.map(move |(field, on)| (T::LIST, i, field, on))
        };
        self.found.extend(self.scope.all::<T>().flat_map(named));
    }
}

fn check_box(
    place: Arguments<'_>,
    (model, ids): (&CloudModel, &BTreeSet<GroupId>),
    cloud_box: &CloudBox,
    problems: &mut Vec<Problem>,
) {
    let missing = |id: &Option<GroupId>| id.filter(|id| !ids.contains(id));
    let groups = || format!("the model's groups are {}", list(model.groups.iter().map(|g| g.id.to_string())));
    if let Some(id) = missing(&cloud_box.group) {
        problems.push(Problem::error(format!("{place}.group"), format!("there is no group {id}"), groups()));
    }
    let mut seen = BTreeSet::new();
    for (k, edit) in cloud_box.sprite_edits.iter().enumerate() {
        let place = format_args!("{place}.sprite_edits[{k}]");
        if let Some(id) = missing(&edit.group) {
            problems.push(Problem::error(format!("{place}.group"), format!("there is no group {id}"), groups()));
        }
        if !seen.insert(edit.index) {
            problems.push(Problem::error(
                format!("{place}.index"),
                format!("sprite {} is edited twice", edit.index),
                "join the two edits",
            ));
        }
        if edit.index >= cloud_box.sprite_count {
            problems.push(Problem::note(
                format!("{place}.index"),
                format!("sprite {} is edited, but the box has only {}", edit.index, cloud_box.sprite_count),
                "the edit waits until there are that many sprites again",
            ));
        }
    }
}

fn list(names: impl Iterator<Item = String>) -> String {
    let names: Vec<_> = names.take(20).collect();
    if names.is_empty() { "none".into() } else { names.join(", ") }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, scene_with_flight};
    use crate::scene::{FolderId, GroupId, ModelId, PathId};

    #[test]
    fn refuses() {
        let mut scene = scene_with_flight();
        scene.clouds[0].model = ModelId(77);
        scene.models[0].boxes[0].group = Some(GroupId(78));
        scene.aircraft[0].path = PathId(79);
        scene.clouds[0].folder = Some(FolderId(80));
        assert_found(&scene, "clouds[0].model", "no model 77");
        assert_found(&scene, "clouds[0].folder", "no folder 80");
        assert_found(&scene, "aircraft[0].path", "no path 79");
        assert_found(&scene, "models[0].boxes[0].group", "no group 78");
    }
}
