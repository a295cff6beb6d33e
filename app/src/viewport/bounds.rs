//! What a selection fills of the world at a time of the scene's clock: for bringing it into view.

use crate::state::{Item, Selection, Session, box_of};
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::camera::View;
use cloudwright_core::scene::{CloudId, InScene};
use cloudwright_core::weather::{CloudNow, WeatherRules};
use glam::DVec3;

/// Centre and radius of a sphere around a selection at `clock_s`; around all clouds for nothing.
pub(super) fn bounds(selection: &Selection, session: &Session, clock_s: f64) -> Option<(DVec3, f64)> {
    let now = Now { session, clock_s, clouds: session.derived().clouds_at(clock_s, WeatherRules::default()) };
    let spheres: Vec<(DVec3, f64)> = if selection.is_empty() {
        now.clouds.iter().map(sphere).collect()
    } else {
        selection.items().iter().flat_map(|item| now.spheres(*item, selection)).collect()
    };
    let (low, high) = spheres
        .iter()
        .map(|(center, radius)| (*center - *radius, *center + *radius))
        .reduce(|(low, high), (l, h)| (low.min(l), high.max(h)))?;
    let center = (low + high) * 0.5;
    let radius = spheres.iter().map(|(c, r)| c.distance(center) + r).fold(0.0, f64::max);
    Some((center, radius))
}

/// The middles of what a selection fills.
pub(super) fn middles(selection: &Selection, session: &Session, clock_s: f64) -> Vec<DVec3> {
    let now = Now { session, clock_s, clouds: session.derived().clouds_at(clock_s, WeatherRules::default()) };
    selection.items().iter().flat_map(|item| now.spheres(*item, selection)).map(|(center, _)| center).collect()
}

/// What a view that turns about `pivot` looks at, as a sphere: the selection, or else the nearest cloud in the picture's
/// middle. None where there is nothing, or `pivot` lies in it, or in any cloud, already.
pub(super) fn looked_at(
    selection: &Selection,
    session: &Session,
    clock_s: f64,
    view: &View,
    pivot: DVec3,
) -> Option<(DVec3, f64)> {
    let holds_pivot = |(center, radius): &(DVec3, f64)| center.distance(pivot) <= *radius;
    if !selection.is_empty() {
        return bounds(selection, session, clock_s).filter(|sphere| sphere.1 > 0.0 && !holds_pivot(sphere));
    }
    let now = session.derived().clouds_at(clock_s, WeatherRules::default());
    let clouds: Vec<(DVec3, f64)> = now.iter().map(sphere).collect();
    if clouds.iter().any(holds_pivot) {
        return None;
    }
    let forward = view.forward.as_dvec3();
    let depth = |(center, _): &(DVec3, f64)| (*center - view.eye).dot(forward);
    let is_met = |sphere: &(DVec3, f64)| {
        let beside = sphere.0 - view.eye - forward * depth(sphere);
        depth(sphere) > 0.0 && beside.length() <= sphere.1
    };
    clouds.into_iter().filter(is_met).min_by(|a, b| depth(a).total_cmp(&depth(b)))
}

fn sphere(cloud: &CloudNow<'_>) -> (DVec3, f64) {
    (cloud.origin() + cloud.center_now().as_dvec3(), f64::from(cloud.reach_now()))
}

/// The clouds at a time.
struct Now<'a> {
    session: &'a Session,
    clock_s: f64,
    clouds: Vec<CloudNow<'a>>,
}

impl Now<'_> {
    fn cloud(&self, id: CloudId) -> Option<&CloudNow<'_>> {
        self.clouds.get(self.session.derived().index_of(id)?)
    }

    fn spheres(&self, item: Item, selection: &Selection) -> Vec<(DVec3, f64)> {
        let scene = self.session.scene();
        match item {
            Item::Cloud(id) => self.cloud(id).map(sphere).into_iter().collect(),
            Item::Model(id) | Item::Group(id, _) => {
                let placed = scene.clouds.iter().filter(|cloud| cloud.model == id);
                placed.filter_map(|cloud| self.cloud(cloud.id)).map(sphere).collect()
            }
            Item::Folder(id) => scene.clouds_in(id).filter_map(|cloud| self.cloud(cloud.id)).map(sphere).collect(),
            // In the cloud that it was picked in: all of them might be far apart.
            Item::Box(model, id) | Item::Sprite(model, id, _) => {
                let found = box_of(scene, model, id).zip(selection.cloud(scene));
                let sphere = found.map(|(each, cloud)| {
                    let center = ModelSpace::of(cloud).to_world(each.center);
                    let radius = each.size.length() * 0.5 * cloud.scale;
                    match self.cloud(cloud.id) {
                        Some(now) => {
                            let center = now.point_now((center - now.placed.origin).as_vec3()).as_dvec3();
                            (now.origin() + center, radius * f64::from(now.scale))
                        }
                        None => (center, radius),
                    }
                });
                sphere.into_iter().collect()
            }
            Item::Camera(id) => {
                let camera = scene.cameras.with_id(id);
                let timeline = self.session.derived().timeline();
                camera.map(|camera| (timeline.camera_at(camera, self.clock_s).position, 0.0)).into_iter().collect()
            }
            other => other.listed(scene).into_iter().flat_map(InScene::points).map(|point| (point, 0.0)).collect(),
        }
    }
}
