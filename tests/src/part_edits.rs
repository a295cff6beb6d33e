//! One edit for each part of a cloud, in a scene of four heaps: what follows a change of name, colours, light, place or
//! shape, what comes and goes, is asked of each.

use crate::small_scenes::heap;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{BoxId, Cloud, CloudId, CloudModel, IdCounter, ModelId, Scene};
use glam::DVec3;

/// An edit of the scene [`heaps`].
#[derive(Clone, Copy)]
pub struct PartEdit {
    /// What is changed.
    pub name: &'static str,
    /// All that it takes.
    pub edits: fn(&Scene) -> Vec<Edit>,
    /// Which of the heaps it changes, by their index; those after a lost or a new one change their index alone.
    pub of: &'static [usize],
}

/// All of them.
pub const PART_EDITS: [PartEdit; 9] = [
    PartEdit { name: "name", of: &[1], edits: |scene| cloud(scene, 1, |cloud| cloud.name = "other".into()) },
    PartEdit {
        name: "colours",
        of: &[1, 3],
        edits: |scene| model(scene, 1, |model| model.color_levels[2].color.a = 0.5),
    },
    PartEdit { name: "light", of: &[1, 3], edits: |scene| model(scene, 1, |model| model.boxes[0].light.c_max = 0.7) },
    PartEdit { name: "place", of: &[2], edits: |scene| cloud(scene, 2, |cloud| cloud.position.x += 250.0) },
    PartEdit { name: "altitude", of: &[2], edits: |scene| cloud(scene, 2, |cloud| cloud.position.y += 25.0) },
    PartEdit { name: "heading", of: &[2], edits: |scene| cloud(scene, 2, |cloud| cloud.heading_deg = 77.0) },
    PartEdit { name: "shape", of: &[2], edits: |scene| model(scene, 0, |model| model.boxes[0].sprite_count = 9) },
    PartEdit { name: "one more", of: &[4], edits: |scene| one_more(scene) },
    PartEdit { name: "one less", of: &[2], edits: |scene| vec![Edit::Cloud(ListEdit::Remove(scene.clouds[2].id))] },
];

/// Four heaps far from one another, of three models: the first of one, the third of another, the second and the fourth
/// of the last. The camera `main` sees them all from afar; the second is at the origin's column.
pub fn heaps() -> Scene {
    let mut scene = heap(40);
    let mut counter = scene.next_id;
    let (first, at) = (scene.models[0].clone(), scene.clouds[0].clone());
    let mut copies = [first.clone(), first.clone()];
    for copy in &mut copies {
        copy.id = ModelId::new(&mut counter);
        copy.boxes.iter_mut().for_each(|each| each.id = BoxId::new(&mut counter));
    }
    let heap = |counter: &mut IdCounter, model: &CloudModel, x: f64| Cloud {
        id: CloudId::new(counter),
        model: model.id,
        position: at.position + DVec3::X * x,
        seed: Some(x.abs() as u64),
        ..at.clone()
    };
    let [last, third] = copies;
    scene.clouds = vec![
        heap(&mut counter, &first, -4000.0),
        heap(&mut counter, &last, 0.0),
        heap(&mut counter, &third, 4000.0),
        heap(&mut counter, &last, 8000.0),
    ]
    .into();
    scene.models = vec![third, last, first].into();
    scene.cameras[0].position = DVec3::new(2000.0, 1000.0, 14_000.0);
    scene.next_id = counter;
    scene
}

fn cloud(scene: &Scene, at: usize, change: impl FnOnce(&mut Cloud)) -> Vec<Edit> {
    let mut cloud = scene.clouds[at].clone();
    change(&mut cloud);
    vec![Edit::Cloud(ListEdit::Replace(cloud))]
}

fn model(scene: &Scene, at: usize, change: impl FnOnce(&mut CloudModel)) -> Vec<Edit> {
    let mut model = scene.models[at].clone();
    change(&mut model);
    vec![Edit::Model(ListEdit::Replace(model))]
}

fn one_more(scene: &Scene) -> Vec<Edit> {
    let mut counter = scene.next_id;
    let id = CloudId::new(&mut counter);
    let position = DVec3::new(-6500.0, 1000.0, 0.0);
    let value = Cloud { id, position, ..scene.clouds[0].clone() };
    vec![Edit::NextId(counter), Edit::Cloud(ListEdit::Insert { at: usize::MAX, value })]
}
