//! A named shading group that no box and no sprite is in does nothing: mentioned, not refused, as it may be meant for
//! later.

use super::Problem;
use super::scope::Scope;
use crate::scene::GroupId;
use std::collections::BTreeSet;

pub(super) fn check(scope: Scope<'_>, problems: &mut Vec<Problem>) {
    for (i, model) in scope.models() {
        let of_sprites = model.boxes.iter().flat_map(|each| each.sprite_edits.iter().map(|edit| edit.group));
        let used: BTreeSet<GroupId> = model.boxes.iter().map(|each| each.group).chain(of_sprites).flatten().collect();
        for (j, group) in model.groups.iter().enumerate().filter(|(_, group)| !used.contains(&group.id)) {
            problems.push(Problem::note(
                format!("models[{i}].groups[{j}]"),
                format!("nothing is in shading group {} “{}”", group.id, group.name),
                "put boxes or sprites into it, or delete it",
            ));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{assert_found, sound_scene};
    use crate::scene::{GroupId, GroupLight, ShadingGroup};

    #[test]
    fn mentions() {
        let mut scene = sound_scene();
        let id = GroupId::new(&mut scene.next_id);
        scene.models[0].groups.push(ShadingGroup { id, name: "crown".into(), light: GroupLight::default() });
        assert_found(&scene, "models[0].groups[0]", "nothing is in");
    }
}
