//! What lies under the pointer, and where: sprites stand in as spheres.

use crate::editor::{Item, Selection, Session, box_of, model_of};
use crate::panel::Reading;
use cloudwright_core::camera::View;
use cloudwright_core::scene::{BoxId, CloudId};
use cloudwright_core::sprites::PlacedCloud;
use glam::{DVec3, Vec3};

/// Of a sprite's radius: its rim is nearly clear.
const SOLID_SHARE: f32 = 0.7;

struct Hit {
    depth: f32,
    cloud: CloudId,
    box_id: BoxId,
}

/// The cloud that a ray meets first; the box in it if the cloud, or one of its boxes, is chosen already. With the
/// cloud in which it was met.
pub(super) fn pick(view: &View, ray: Vec3, reading: &Reading<'_>) -> Option<(Item, CloudId)> {
    let scene = reading.session.scene();
    let hit = nearest(view, ray, reading.session)?;
    let cloud = scene.cloud(hit.cloud)?;
    let inside = match reading.view.selection.primary() {
        Some(Item::Cloud(id)) => id == hit.cloud,
        Some(item) => model_of(item, scene) == Some(cloud.model),
        None => false,
    };
    Some((if inside { Item::Box(cloud.model, hit.box_id) } else { Item::Cloud(hit.cloud) }, hit.cloud))
}

/// View depth along a ray of the nearest cloud, or else of the ground, metres.
pub(super) fn depth(view: &View, ray: Vec3, session: &Session) -> Option<f32> {
    nearest(view, ray, session).map(|hit| hit.depth).or_else(|| {
        let altitude = session.scene().ground.as_ref()?.altitude_m;
        let depth = (altitude - view.eye.y) as f32 / ray.y;
        (depth.is_finite() && depth > 0.0).then_some(depth)
    })
}

fn nearest(view: &View, ray: Vec3, session: &Session) -> Option<Hit> {
    let hits = session.derived().clouds().iter().filter_map(|cloud| nearest_of(cloud, view, ray));
    hits.min_by(|a, b| a.depth.total_cmp(&b.depth))
}

fn nearest_of(cloud: &PlacedCloud, view: &View, ray: Vec3) -> Option<Hit> {
    let offset = (cloud.origin - view.eye).as_vec3();
    meets(ray, offset + cloud.center, cloud.reach)?;
    let hits = cloud.sprites.iter().filter_map(|sprite| {
        let depth = meets(ray, offset + sprite.position, sprite.radius() * SOLID_SHARE)?;
        Some(Hit { depth, cloud: cloud.id, box_id: sprite.box_id })
    });
    hits.min_by(|a, b| a.depth.total_cmp(&b.depth))
}

/// Where along `ray`, in its lengths, it comes nearest to a sphere's centre, if it meets the sphere before the eye.
fn meets(ray: Vec3, center: Vec3, radius: f32) -> Option<f32> {
    let along = center.dot(ray) / ray.length_squared();
    let at = along.max(0.0);
    ((ray * at).distance_squared(center) <= radius * radius).then_some(at.max(cloudwright_core::camera::NEAR_M))
}

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
                let center = super::wireframe::to_world(cloud, each.center);
                (center, each.size.length() * 0.5 * cloud.scale)
            });
            sphere.into_iter().collect()
        }
        Item::Camera(_) => Vec::new(),
    }
}
