//! A preset's cloud in an open scene.

use super::Preset;
use crate::arrange::{Names, copy_model};
use crate::document::{Edit, ListEdit};
use crate::scene::{Category, Cloud, CloudId, CloudModel, ModelId, Scene};
use glam::DVec3;

impl Preset {
    /// Edits that add the preset's model to `scene` and one cloud of it with its base's middle at `at` (metres in the
    /// world), ready for one transaction; and that cloud's id.
    ///
    /// It looks like the preset's picture; another seed strews it anew.
    pub fn place(&self, scene: &Scene, at: DVec3) -> (Vec<Edit>, CloudId) {
        let mut ids = scene.next_id;
        let found = self.scene().models.into_iter().next();
        let original = found.unwrap_or_else(|| CloudModel::new(ModelId(0), self.label, Category::CumulusHumilis));
        let name = Names::new(scene.models.iter().map(|model| model.name.as_str())).free(&original.name);
        let model = copy_model(&original, name, &mut ids);
        let cloud = Cloud::new(CloudId::new(&mut ids), &model, at);
        let id = cloud.id;
        let edits = vec![
            Edit::NextId(ids),
            Edit::Model(ListEdit::Insert { at: usize::MAX, value: model }),
            Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud }),
        ];
        (edits, id)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Document;
    use crate::problem;

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
}
