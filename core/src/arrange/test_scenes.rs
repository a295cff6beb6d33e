//! Scenes to arrange, and the one door that every arrangement is tried through.

use super::Arrangement;
use crate::derived::Derived;
use crate::document::Document;
use crate::problem;
use crate::property::Target;
use crate::scene::{
    BoxId, Category, Cloud, CloudBox, CloudId, CloudModel, GroupCenter, GroupId, GroupLight, KeyValue, ModelId, Scene,
    ShadingGroup, Track, TrackId, TrackKey,
};
use crate::sprites::PlacedCloud;
use glam::{DQuat, DVec3};
use std::collections::BTreeSet;

/// Two clouds of two models, each with three turned boxes, the last two in a named group, on no ground.
pub(super) fn two_clouds() -> Scene {
    let mut scene = Scene { ground: None, ..Scene::default() };
    for (i, category) in [(1.0, Category::CumulusCongestus), (2.0, Category::Stratocumulus)] {
        let mut model = CloudModel::new(ModelId::new(&mut scene.next_id), "heap", category);
        model.seed = i as u64 * 7;
        let group = GroupId::new(&mut scene.next_id);
        let light =
            GroupLight { c_med: 0.3 * i, center: GroupCenter::At(DVec3::new(10.0, 20.0, i)), ..GroupLight::default() };
        model.groups.push(ShadingGroup { id: group, name: "crown".into(), light });
        for j in 0..3 {
            let at = f64::from(j);
            let mut new = CloudBox::new(BoxId::new(&mut scene.next_id), DVec3::new(600.0 * at, 40.0 * i, -100.0 * at));
            new.size = DVec3::new(400.0, 150.0 + 50.0 * at, 250.0);
            new.orientation = DQuat::from_scaled_axis(DVec3::new(0.3, 0.2 * at, -0.4 * i));
            new.group = (j > 0).then_some(group);
            model.boxes.push(new);
        }
        let id = CloudId::new(&mut scene.next_id);
        scene.clouds.push(Cloud {
            name: "cloud".into(),
            heading_deg: 35.0 * i,
            scale: 1.0 + 0.5 * i,
            seed: (i > 1.0).then_some(99),
            ..Cloud::new(id, &model, DVec3::new(-3000.0 * i, 900.0, 2000.0 * i))
        });
        scene.models.push(model);
    }
    assert_eq!(problem::check(&scene), []);
    scene
}

/// Gives each of those properties a track with one key.
pub(super) fn with_tracks(scene: &mut Scene, properties: &[String]) {
    for property in properties {
        let parts = property.parse::<Target>().expect("a property").parts();
        let value = if parts == 3 { KeyValue::Three([0.5; 3]) } else { KeyValue::One(0.5) };
        let id = TrackId::new(&mut scene.next_id);
        scene.tracks.push(Track::new(id, property.clone(), vec![TrackKey::new(1.0, value)]));
    }
}

/// What the scene's tracks move, in no order. All of it is there.
pub(super) fn moved(scene: &Scene) -> BTreeSet<String> {
    let targets = scene.tracks.iter().map(|track| track.property.parse::<Target>().expect("a property"));
    targets.inspect(|target| assert!(target.owner.is_in(scene), "{target}")).map(|target| target.to_string()).collect()
}

/// The scene after one transaction (which is refused if it leaves an error behind); undo and redo lead back and forth exactly.
pub(super) fn applied(scene: &Scene, arrangement: &Arrangement) -> Scene {
    let mut document = Document::new(scene.clone());
    document.edit("Arrange", arrangement.edits.iter().cloned()).expect("the edits fit the scene");
    let after = document.scene().clone();
    assert!(arrangement.edits.is_empty() || after != *scene, "edits that do nothing: {:#?}", arrangement.edits);
    document.undo();
    assert_eq!(document.scene(), scene, "undo");
    document.redo();
    assert_eq!(*document.scene(), after, "redo");
    after
}

/// The sprites of the cloud at that place of the scene's list.
pub(super) fn placed(scene: &Scene, cloud: usize) -> PlacedCloud {
    Derived::new(scene).clouds()[cloud].clone()
}

/// Each sprite's place in the world, size, turn and tile, and its group's centre and light.
fn looks(cloud: &PlacedCloud) -> Vec<[f64; 13]> {
    let look = |sprite: &crate::sprites::Sprite| {
        let group = &cloud.groups[sprite.group as usize];
        let [x, y, z] = (cloud.origin + sprite.position.as_dvec3()).to_array();
        let [a, b, c] = (cloud.origin + group.center.as_dvec3()).to_array();
        let [low, medium, high] = group.c.map(f64::from);
        let size = [sprite.width, sprite.height].map(f64::from);
        [x, y, z, size[0], size[1], sprite.rotation.into(), sprite.tile.into(), a, b, c, low, medium, high]
    };
    cloud.sprites.iter().map(look).collect()
}

/// The same sprites at the same places, within a millimetre: positions are f32 from the middle of some kilometres.
pub(super) fn assert_same_looks(a: &PlacedCloud, b: &PlacedCloud) {
    let (a, b) = (looks(a), looks(b));
    assert_eq!(a.len(), b.len());
    assert!(!a.is_empty());
    for (a, b) in a.iter().zip(&b) {
        let apart = a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(apart < 1e-3, "{a:?} and {b:?}");
    }
}
