//! What lies under the pointer, nearest first; and how repeated clicks go through it. Sprites stand in as spheres.
//!
//! One click takes the nearest cloud. Again on the same place it takes the box under the pointer, then the boxes
//! behind, then the clouds behind with theirs, and starts anew. Marked sprites, drawn cameras and marked props come first.

use super::cameras;
use super::places;
use super::props;
use super::screen::Screen;
use super::wireframe::shows_boxes_of;
use crate::state::{Item, Reading, SpriteMarks};
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::camera::NEAR_M;
use cloudwright_core::scene::{BoxId, Camera, Cloud, CloudBox, CloudId};
use cloudwright_core::sprites::Sprite;
use cloudwright_core::weather::CloudNow;
use egui::Pos2;
use glam::Vec3;
use std::collections::BTreeMap;

/// Of a sprite's radius: its rim is nearly clear.
const SOLID_SHARE: f32 = 0.7;
/// Clicks nearer to one another are on the same place, points.
const SAME_PLACE: f32 = 5.0;
/// How near to a dot a click means it, points.
const DOT_REACH: f32 = 8.0;

/// Something under the pointer, and the cloud that it is seen in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Picked {
    pub(super) item: Item,
    pub(super) through: Option<CloudId>,
}

/// The last click, which the next one may go on from.
#[derive(Debug, Default)]
pub(super) struct Clicks {
    last: Option<(Pos2, Camera, usize)>,
}

impl Clicks {
    /// What a click means now; none for a click on nothing.
    pub(super) fn pick(&mut self, at: Pos2, screen: &Screen, camera: &Camera, reading: &Reading<'_>) -> Option<Picked> {
        let next = self.next(at, screen, camera, reading);
        self.last = next.map(|(place, index, _)| (place, camera.clone(), index));
        next.map(|(.., picked)| picked)
    }

    /// What a click would mean.
    pub(super) fn would_pick(
        &self,
        at: Pos2,
        screen: &Screen,
        camera: &Camera,
        reading: &Reading<'_>,
    ) -> Option<Picked> {
        self.next(at, screen, camera, reading).map(|(.., picked)| picked)
    }

    /// What the next click at a place takes, as which of what lies there; and the place that it counts as.
    fn next(&self, at: Pos2, screen: &Screen, camera: &Camera, reading: &Reading<'_>) -> Option<(Pos2, usize, Picked)> {
        let under = under(at, screen, reading);
        let again = self.last.as_ref().filter(|(place, seen, _)| place.distance(at) <= SAME_PLACE && seen == camera);
        let place = again.map_or(at, |(place, ..)| *place);
        let index = match again {
            Some((.., index)) => (index + 1) % under.len().max(1),
            None => first(&under, reading),
        };
        Some((place, index, *under.get(index)?))
    }
}

/// What a first click means: who works on a cloud's boxes stays among them.
pub(super) fn first(under: &[Picked], reading: &Reading<'_>) -> usize {
    let scene = reading.session.scene();
    let seen_in = reading.view.selection.cloud(scene).map(|cloud| cloud.id);
    let among_boxes = matches!(reading.view.selection.primary(), Some(Item::Box(..) | Item::Sprite(..)));
    match under {
        [Picked { item: Item::Cloud(id), .. }, Picked { item: Item::Box(..), .. }, ..]
            if among_boxes && seen_in == Some(*id) =>
        {
            1
        }
        _ => 0,
    }
}

/// All that may be picked under the pointer, in the order of repeated clicks.
pub(super) fn under(at: Pos2, screen: &Screen, reading: &Reading<'_>) -> Vec<Picked> {
    let mut under = Vec::new();
    under.extend(cameras::under(at, screen, reading).map(|id| Picked { item: Item::Camera(id), through: None }));
    under.extend(props::under(at, screen, reading).map(|id| Picked { item: Item::Prop(id), through: None }));
    under.extend(dot_under(at, screen, reading));
    let ray = screen.ray(at);
    let mut met: Vec<(f32, &Cloud, Vec<BoxId>)> =
        of_clouds(reading, |cloud| reading.view.can_pick(reading.session.scene(), cloud))
            .filter_map(|(cloud, now)| {
                let (depth, boxes) = meet(cloud, &now, ray, screen, reading)?;
                Some((depth, cloud, boxes))
            })
            .collect();
    met.sort_by(|a, b| a.0.total_cmp(&b.0));
    for (_, cloud, boxes) in met {
        let through = Some(cloud.id);
        under.push(Picked { item: Item::Cloud(cloud.id), through });
        under.extend(boxes.into_iter().map(|id| Picked { item: Item::Box(cloud.model, id), through }));
    }
    under
}

/// View depth along a ray of the nearest cloud in view, or else of the ground, metres.
pub(super) fn depth(screen: &Screen, ray: Vec3, reading: &Reading<'_>) -> Option<f32> {
    let scene = reading.session.scene();
    let clouds = of_clouds(reading, |cloud| reading.view.shows(scene, cloud));
    let depths = |now: &CloudNow<'_>| hits(now, ray, screen).map(|(depth, _)| depth).reduce(f32::min);
    let nearest = clouds.filter_map(|(_, now)| depths(&now)).reduce(f32::min);
    nearest.or_else(|| {
        let altitude = scene.ground.as_ref()?.altitude_m;
        let depth = (altitude - screen.view.eye.y) as f32 / ray.y;
        (depth.is_finite() && depth > 0.0).then_some(depth)
    })
}

/// The clouds that are wanted, as they are at the clock's time.
fn of_clouds<'a>(
    reading: &Reading<'a>,
    wanted: impl Fn(&Cloud) -> bool,
) -> impl Iterator<Item = (&'a Cloud, CloudNow<'a>)> {
    let scene = reading.session.scene();
    let clouds = reading.clouds_now().into_iter().filter_map(|now| Some((scene.cloud(now.placed.id)?, now)));
    clouds.filter(move |(cloud, _)| wanted(cloud))
}

/// Whether the sprite of that index shows: it is not clear.
pub(super) fn is_there(now: &CloudNow<'_>, index: usize) -> bool {
    let rest = &now.placed.sprites[index];
    now.opacity_at(now.placed.radii_of(rest.position)) * now.condensed(index) > 0.0
}

/// The sprites that a ray meets, with the depths.
fn hits<'a>(now: &'a CloudNow<'_>, ray: Vec3, screen: &Screen) -> impl Iterator<Item = (f32, Sprite)> + use<'a> {
    let offset = screen.relative(now.origin());
    let near = meets(ray, offset + now.center_now(), now.reach_now()).is_some();
    let indices = if near { 0..now.placed.sprites.len() } else { 0..0 };
    indices
        .map(move |index| (index, now.sprite_now(index)))
        .filter_map(move |(index, sprite)| {
            Some((meets(ray, offset + sprite.position, sprite.radius() * SOLID_SHARE)?, index, sprite))
        })
        .filter(move |(_, index, _)| is_there(now, *index))
        .map(|(depth, _, sprite)| (depth, sprite))
}

/// How near a ray meets a cloud, and its boxes: first those whose sprites it meets, then those that it only passes.
fn meet(
    cloud: &Cloud,
    now: &CloudNow<'_>,
    ray: Vec3,
    screen: &Screen,
    reading: &Reading<'_>,
) -> Option<(f32, Vec<BoxId>)> {
    let may_pick = |id: BoxId| {
        let item = Item::Box(cloud.model, id);
        (!reading.view.hidden.contains(&item), !reading.view.locked.contains(&item))
    };
    let mut by_sprite: BTreeMap<BoxId, f32> = BTreeMap::new();
    for (depth, sprite) in hits(now, ray, screen) {
        let nearest = by_sprite.entry(sprite.box_id).or_insert(depth);
        *nearest = nearest.min(depth);
    }
    by_sprite.retain(|id, _| may_pick(*id).0);
    let model = reading.session.scene().model(cloud.model)?;
    let passed = model.boxes.iter().filter(|each| !by_sprite.contains_key(&each.id) && may_pick(each.id).0);
    let place = places::seen_as(reading, cloud, now);
    let mut by_box: Vec<(f32, BoxId)> =
        passed.filter_map(|each| Some((enters(&place, each, ray, screen)?, each.id))).collect();
    let nearest_sprite = by_sprite.values().copied().reduce(f32::min);
    let nearest_box = by_box.iter().map(|(depth, _)| *depth).reduce(f32::min);
    let depth = nearest_sprite.or(nearest_box.filter(|_| shows_boxes_of(cloud, reading.view)))?;
    let mut boxes: Vec<(f32, BoxId)> = by_sprite.into_iter().map(|(id, depth)| (depth, id)).collect();
    boxes.sort_by(|a, b| a.0.total_cmp(&b.0));
    by_box.sort_by(|a, b| a.0.total_cmp(&b.0));
    boxes.append(&mut by_box);
    Some((depth, boxes.into_iter().map(|(_, id)| id).filter(|id| may_pick(*id).1).collect()))
}

/// Where along `ray`, in its lengths, it comes nearest to a sphere's centre, if it meets the sphere before the eye.
fn meets(ray: Vec3, center: Vec3, radius: f32) -> Option<f32> {
    let along = center.dot(ray) / ray.length_squared();
    let at = along.max(0.0);
    ((ray * at).distance_squared(center) <= radius * radius).then_some(at.max(NEAR_M))
}

/// Where along `ray` it enters a box, by its three slabs.
fn enters(cloud: &Cloud, each: &CloudBox, ray: Vec3, screen: &Screen) -> Option<f32> {
    let space = ModelSpace::of(cloud);
    let to_box = each.orientation.conjugate();
    let eye = to_box * (space.from_world(screen.view.eye) - each.center);
    let along = to_box * (space.turn.conjugate() * ray.as_dvec3() / space.scale);
    let (mut enter, mut leave) = (f64::from(NEAR_M), f64::INFINITY);
    for axis in 0..3 {
        let half = each.size[axis] * 0.5;
        let ends = [-half, half].map(|end| (end - eye[axis]) / along[axis]);
        if along[axis] == 0.0 {
            if eye[axis].abs() > half {
                return None;
            }
            continue;
        }
        enter = enter.max(ends[0].min(ends[1]));
        leave = leave.min(ends[0].max(ends[1]));
    }
    (enter <= leave).then_some(enter as f32)
}

/// The sprites that are marked so that they can be picked: those of the cloud whose box or sprite is selected.
pub(super) fn dots<'a>(reading: &Reading<'a>) -> Option<(&'a Cloud, CloudNow<'a>)> {
    let (scene, view) = (reading.session.scene(), reading.view);
    let among_sprites = matches!(view.selection.primary(), Some(Item::Box(..) | Item::Sprite(..)));
    if view.sprite_marks == SpriteMarks::Off || !among_sprites {
        return None;
    }
    let cloud = view.selection.cloud(scene).filter(|cloud| view.can_pick(scene, cloud))?;
    let at = reading.session.derived().index_of(cloud.id)?;
    Some((cloud, reading.clouds_now().into_iter().nth(at)?))
}

/// Those of [`dots`] that are neither in a hidden nor in a locked box, and where they show.
pub(super) fn dots_on<'a>(
    screen: &'a Screen,
    reading: &Reading<'a>,
) -> impl Iterator<Item = (Pos2, f32, Picked)> + use<'a> {
    let view = reading.view;
    dots(reading).into_iter().flat_map(move |(cloud, now)| {
        let offset = screen.relative(now.origin());
        let there = (0..now.placed.sprites.len()).filter(|index| is_there(&now, *index));
        let sprites: Vec<Sprite> = there.map(|index| now.sprite_now(index)).collect();
        sprites.into_iter().filter_map(move |sprite| {
            let its_box = Item::Box(cloud.model, sprite.box_id);
            if view.hidden.contains(&its_box) || view.locked.contains(&its_box) {
                return None;
            }
            let center = offset + sprite.position;
            let item = Item::Sprite(cloud.model, sprite.box_id, sprite.index);
            Some((screen.project(center)?, screen.view.depth(center), Picked { item, through: Some(cloud.id) }))
        })
    })
}

/// The marked sprite that a click means: the nearest on the screen, of equally near ones the first in depth.
fn dot_under(at: Pos2, screen: &Screen, reading: &Reading<'_>) -> Option<Picked> {
    let near = dots_on(screen, reading).filter(|(place, ..)| place.distance(at) <= DOT_REACH);
    let key = |place: &Pos2| place.distance(at).round();
    let first = near.min_by(|a, b| key(&a.0).total_cmp(&key(&b.0)).then(a.1.total_cmp(&b.1)));
    first.map(|(.., picked)| picked)
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::{Category, CloudModel, ModelId};
    use egui::{Rect, pos2};
    use glam::{DQuat, DVec3};

    #[test]
    fn a_ray_enters_turned_boxes_far_from_the_origin() {
        let far = DVec3::new(1e6, 500.0, -1e6);
        let mut each = CloudBox::new(BoxId(1), DVec3::new(0.0, 10.0, 0.0));
        each.size = DVec3::new(20.0, 2.0, 2.0);
        each.orientation = DQuat::from_rotation_y(1.0);
        let model = CloudModel::new(ModelId(1), "", Category::CumulusHumilis);
        let cloud = Cloud { heading_deg: 1.0_f64.to_degrees(), scale: 2.0, ..Cloud::new(CloudId(1), &model, far) };
        // Heading and orientation cancel out: the box lies along x, 20 m above the cloud's position.
        let rect = Rect::from_min_max(pos2(0.0, 0.0), pos2(100.0, 100.0));
        let screen = Screen::new(&Camera::free(far + DVec3::new(0.0, 20.0, 100.0)), rect);
        let enter = |at| enters(&cloud, &each, screen.ray(at), &screen);
        let depth = enter(pos2(50.0, 50.0)).expect("straight ahead");
        assert!((depth - 98.0).abs() < 1e-3, "{depth}");
        assert!(enter(pos2(65.0, 50.0)).is_some() && enter(pos2(50.0, 55.0)).is_none(), "long across, not up");
        each.size = DVec3::ZERO;
        assert!(enters(&cloud, &each, screen.ray(pos2(20.0, 20.0)), &screen).is_none());
    }
}
