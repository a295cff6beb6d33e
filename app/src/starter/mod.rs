//! New things with values to start from: the scene of an empty window, skies to begin with, a cloud, a box.

mod template;

pub use template::Template;

use cloudwright_core::arrange::Names;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{
    BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, GroupCenter, IdCounter, ModelId, Scene,
};
use glam::DVec3;

/// A new scene with one small cumulus before the camera.
pub(crate) fn starter_scene() -> Scene {
    let mut scene = Scene::default();
    let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "cumulus", Category::CumulusHumilis);
    model.boxes = cumulus(&mut scene.next_id).into();
    let cloud = Cloud::new(CloudId::new(&mut scene.next_id), &model, DVec3::new(0.0, 1000.0, 0.0));
    scene.models.push(model);
    scene.clouds.push(cloud);
    if let Some(camera) = scene.cameras.get_mut(0) {
        camera.position = DVec3::new(0.0, 700.0, 3200.0);
        camera.pitch_deg = 6.0;
    }
    scene
}

/// A new scene whose camera looks up from the ground, under nothing.
pub(crate) fn empty_sky() -> Scene {
    let mut scene = Scene::default();
    if let Some(camera) = scene.cameras.get_mut(0) {
        camera.position = DVec3::new(0.0, 20.0, 3000.0);
        camera.pitch_deg = 14.0;
    }
    scene
}

/// A level base, a body and two heads.
fn cumulus(counter: &mut IdCounter) -> Vec<CloudBox> {
    let mut one = |name: &str, center: [f64; 3], size: [f64; 3], sprite_count, width: [f64; 2]| {
        let mut new = CloudBox::new(BoxId::new(counter), DVec3::from(center));
        new.name = name.into();
        new.size = DVec3::from(size);
        new.sprite_count = sprite_count;
        (new.width, new.height) = (width, width);
        new.light.center = GroupCenter::Pulled(0.33);
        new
    };
    let mut base = one("base", [0.0, 40.0, 0.0], [900.0, 50.0, 560.0], 24, [280.0, 380.0]);
    base.height = [130.0, 190.0];
    base.rotation_deg = [-5.0, 5.0];
    let mut body = one("body", [0.0, 190.0, 0.0], [1050.0, 260.0, 640.0], 70, [220.0, 360.0]);
    body.lumps = [3, 1, 2];
    let left = one("left head", [-220.0, 420.0, 40.0], [420.0, 260.0, 380.0], 28, [160.0, 280.0]);
    let right = one("right head", [230.0, 350.0, -30.0], [380.0, 200.0, 360.0], 24, [150.0, 260.0]);
    vec![base, body, left, right]
}

/// What new boxes are called, with a number behind it where that is taken in their model.
pub(crate) const BOX: &str = "box";

/// The names that a model's boxes have.
pub(crate) fn names_of_boxes(model: &CloudModel) -> Names {
    Names::new(model.boxes.iter().map(|each| each.name.as_str()))
}

/// A model of one box and its first cloud, as edits, with what to select.
pub(crate) fn add_cloud(scene: &Scene, at: DVec3) -> (Vec<Edit>, CloudId) {
    let mut counter = scene.next_id;
    let name = Names::new(scene.models.iter().map(|model| model.name.as_str())).free("cloud");
    let mut model = CloudModel::new(ModelId::new(&mut counter), &name, Category::CumulusHumilis);
    let first = CloudBox::new(BoxId::new(&mut counter), DVec3::ZERO);
    model.boxes.push(CloudBox { name: BOX.into(), ..first });
    let cloud = Cloud::new(CloudId::new(&mut counter), &model, at);
    let id = cloud.id;
    let edits = vec![
        Edit::NextId(counter),
        Edit::Model(ListEdit::Insert { at: usize::MAX, value: model }),
        Edit::Cloud(ListEdit::Insert { at: usize::MAX, value: cloud }),
    ];
    (edits, id)
}
