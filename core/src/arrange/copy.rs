//! Copies of boxes and groups under ids of their own, with their references among one another.

use crate::scene::{BoxId, CloudBox, CloudModel, GroupId, IdCounter, List, ModelId, ShadingGroup};
use std::collections::{BTreeMap, BTreeSet};

/// A whole model's copy, called `name`. It looks like the original.
pub(crate) fn copy_model(model: &CloudModel, name: String, counter: &mut IdCounter) -> CloudModel {
    let id = ModelId::new(counter);
    let (groups, boxes) = copy_parts(&model.groups, &model.boxes, counter);
    CloudModel { id, name, groups, boxes, ..model.clone() }
}

/// Copies that refer to one another as the originals do. A reference to a group that is not among them is dropped.
pub(super) fn copy_parts<'a>(
    groups: impl IntoIterator<Item = &'a ShadingGroup>,
    boxes: impl IntoIterator<Item = &'a CloudBox>,
    counter: &mut IdCounter,
) -> (List<ShadingGroup>, List<CloudBox>) {
    let mut new_id: BTreeMap<GroupId, GroupId> = BTreeMap::new();
    let groups = groups.into_iter().map(|group| {
        let id = GroupId::new(counter);
        new_id.insert(group.id, id);
        ShadingGroup { id, ..group.clone() }
    });
    let groups = groups.collect();
    let boxes = boxes.into_iter().map(|old| {
        let mut new = old.clone();
        new.id = BoxId::new(counter);
        new.key = Some(old.key.unwrap_or(old.id.0));
        for group in groups_of(&mut new) {
            *group = group.and_then(|id| new_id.get(&id).copied());
        }
        new
    });
    (groups, boxes.collect())
}

/// A box's references to groups: its own and its sprites'.
pub(super) fn groups_of(cloud_box: &mut CloudBox) -> impl Iterator<Item = &mut Option<GroupId>> {
    std::iter::once(&mut cloud_box.group).chain(cloud_box.sprite_edits.iter_mut().map(|edit| &mut edit.group))
}

/// The groups that boxes or their sprites are in.
pub(super) fn groups_used<'a>(boxes: impl IntoIterator<Item = &'a CloudBox>) -> BTreeSet<GroupId> {
    boxes
        .into_iter()
        .flat_map(|each| std::iter::once(each.group).chain(each.sprite_edits.iter().map(|edit| edit.group)))
        .flatten()
        .collect()
}
