//! What a selection fills of the world: for bringing it into view.

use crate::state::{Item, Selection, Session, box_of};
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::InScene;
use cloudwright_core::sprites::PlacedCloud;
use glam::DVec3;

/// Centre and radius of a sphere around a selection; around all clouds for nothing.
pub(super) fn bounds(selection: &Selection, session: &Session) -> Option<(DVec3, f64)> {
    let clouds = session.derived().clouds();
    let spheres: Vec<(DVec3, f64)> = if selection.is_empty() {
        clouds.iter().map(sphere).collect()
    } else {
        selection.items().iter().flat_map(|item| spheres(*item, selection, session)).collect()
    };
    let (low, high) = spheres
        .iter()
        .map(|(center, radius)| (*center - *radius, *center + *radius))
        .reduce(|(low, high), (l, h)| (low.min(l), high.max(h)))?;
    let center = (low + high) * 0.5;
    let radius = spheres.iter().map(|(c, r)| c.distance(center) + r).fold(0.0, f64::max);
    Some((center, radius))
}

fn sphere(cloud: &PlacedCloud) -> (DVec3, f64) {
    (cloud.origin + cloud.center.as_dvec3(), f64::from(cloud.reach))
}

fn spheres(item: Item, selection: &Selection, session: &Session) -> Vec<(DVec3, f64)> {
    let scene = session.scene();
    match item {
        Item::Cloud(id) => session.placed(id).map(sphere).into_iter().collect(),
        Item::Model(id) | Item::Group(id, _) => {
            let placed = scene.clouds.iter().filter(|cloud| cloud.model == id);
            placed.filter_map(|cloud| session.placed(cloud.id)).map(sphere).collect()
        }
        // In the cloud that it was picked in: all of them might be far apart.
        Item::Box(model, id) | Item::Sprite(model, id, _) => {
            let found = box_of(scene, model, id).zip(selection.cloud(scene));
            let sphere = found.map(|(each, cloud)| {
                let center = ModelSpace::of(cloud).to_world(each.center);
                (center, each.size.length() * 0.5 * cloud.scale)
            });
            sphere.into_iter().collect()
        }
        other => other.listed(scene).into_iter().flat_map(InScene::points).map(|point| (point, 0.0)).collect(),
    }
}
