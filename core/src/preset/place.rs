//! A preset's cloud in an open scene.

use super::Preset;
use crate::document::{Edit, ListEdit};
use crate::scene::{BoxId, Category, Cloud, CloudId, CloudModel, GroupId, IdCounter, ModelId, Scene};
use glam::DVec3;
use std::collections::BTreeMap;

impl Preset {
    /// Edits that add the preset's model to `scene` and one cloud of it with its base's middle at `at` (metres in the
    /// world), ready for one transaction; and that cloud's id.
    ///
    /// Boxes get ids of the scene's, which are part of the key of their random numbers: each cloud that is placed has
    /// the preset's form with sprites of its own, as no two clouds are alike.
    pub fn place(&self, scene: &Scene, at: DVec3) -> (Vec<Edit>, CloudId) {
        let mut ids = scene.next_id;
        let found = self.scene().models.into_iter().next();
        let mut model = found.unwrap_or_else(|| CloudModel::new(ModelId(0), self.label, Category::CumulusHumilis));
        model.name = free_name(&model.name, scene);
        give_ids(&mut model, &mut ids);
        let cloud = Cloud {
            id: CloudId::new(&mut ids),
            name: model.name.clone(),
            model: model.id,
            position: at,
            heading_deg: 0.0,
            scale: 1.0,
            seed: None,
        };
        let id = cloud.id;
        let edits = vec![
            Edit::NextId(ids),
            Edit::Model(ListEdit::Insert { at: usize::MAX, value: model }),
            Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud }),
        ];
        (edits, id)
    }
}

/// New ids for the model, its groups and its boxes; what refers to a group follows it.
fn give_ids(model: &mut CloudModel, ids: &mut IdCounter) {
    model.id = ModelId::new(ids);
    let mut new_group = BTreeMap::new();
    for group in &mut model.groups {
        let new = GroupId::new(ids);
        new_group.insert(std::mem::replace(&mut group.id, new), new);
    }
    let follow = |group: &mut Option<GroupId>| *group = group.and_then(|old| new_group.get(&old).copied());
    for cloud_box in &mut model.boxes {
        cloud_box.id = BoxId::new(ids);
        follow(&mut cloud_box.group);
        cloud_box.sprite_edits.iter_mut().for_each(|edit| follow(&mut edit.group));
    }
}

/// `stem`, or `stem 2`, `stem 3`, …: the first that no model of the scene has.
fn free_name(stem: &str, scene: &Scene) -> String {
    let is_free = |name: &String| scene.models.iter().all(|model| model.name != *name);
    let numbered = (2_usize..).map(|n| format!("{stem} {n}"));
    std::iter::once(stem.to_owned()).chain(numbered).find(is_free).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::problem;
    use crate::scene::{GroupLight, ShadingGroup, SpriteEdit};

    #[test]
    fn one_step_adds_it_and_one_takes_it_back() {
        for preset in Preset::ALL {
            let mut document = Document::new(Preset::ALL[0].scene());
            let start = document.scene().clone();
            let at = DVec3::new(1000.0, 2000.0, -3000.0);
            let (edits, id) = preset.place(document.scene(), at);
            document.edit("Add", edits).expect("it fits");
            let (edits, second) = preset.place(document.scene(), at);
            document.edit("Add", edits).expect("it fits twice");
            let scene = document.scene();
            assert_eq!(problem::check(scene), [], "{}", preset.name);
            assert_ne!(id, second);
            let cloud = scene.cloud(id).expect("the cloud");
            let model = scene.model(cloud.model).expect("its model");
            assert_eq!(cloud.position, at);
            let original = &preset.scene().models[0];
            assert_eq!(model.boxes.len(), original.boxes.len());
            assert_eq!(model.color_levels, original.color_levels);
            let mut names: Vec<_> = scene.models.iter().map(|model| model.name.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            assert_eq!(names.len(), 3, "each model has a name of its own: {names:?}");
            document.undo();
            document.undo();
            assert_eq!(*document.scene(), start);
        }
    }

    #[test]
    fn references_to_groups_follow() {
        let mut model = Preset::ALL[0].scene().models.remove(0);
        for old in [7, 9] {
            model.groups.push(ShadingGroup { id: GroupId(old), name: String::new(), light: GroupLight::default() });
        }
        model.boxes[0].group = Some(GroupId(9));
        model.boxes[1].sprite_edits =
            vec![SpriteEdit { index: 0, moved: None, dropped: false, group: Some(GroupId(7)) }];
        let mut ids = IdCounter(500);
        give_ids(&mut model, &mut ids);
        assert_eq!(model.boxes[0].group, Some(model.groups[1].id));
        assert_eq!(model.boxes[1].sprite_edits[0].group, Some(model.groups[0].id));
        let taken = 1 + model.groups.len() + model.boxes.len();
        assert_eq!(ids.0, 500 + taken as u64);
        assert!(model.boxes.iter().all(|each| each.id.0 >= 500));
    }
}
