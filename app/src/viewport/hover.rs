//! What a press would take, shown while the pointer rests over it: a box by its outline, a key by a ring, all else by
//! brackets around it with its name.
//!
//! It is looked for once a place of the pointer, not once a frame.

use super::overlay;
use super::pick::{Clicks, Picked};
use super::places::Places;
use super::screen::Screen;
use super::wireframe;
use crate::state::{Item, Reading, box_of};
use crate::theme;
use crate::visible;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::{Camera, Cloud, CloudBox, PathId};
use cloudwright_core::version::Version;
use egui::{Painter, Pos2, Rect, Stroke, vec2};
use glam::DVec3;

/// Of a bracket's arms, points.
const ARM: f32 = 9.0;
/// From what is bracketed to the brackets, points.
const MARGIN: f32 = 5.0;
/// Of a ring around a key, points.
const RING: f32 = 9.0;

/// What the pointer is over.
#[derive(Debug, Default)]
pub(super) struct Hover {
    seen: Option<Seen>,
    /// What a press takes there, if anything.
    found: Option<Over>,
}

/// What it depends on.
#[derive(Debug, PartialEq)]
struct Seen {
    at: Pos2,
    camera: Camera,
    scene: Version,
    clock_s: f64,
    selected: Vec<Item>,
}

/// Something under the pointer.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Over {
    Path(PathId, Option<usize>),
    Thing(Picked),
}

impl Hover {
    /// Nothing is under the pointer, or something else has it.
    pub(super) fn leave(&mut self) {
        *self = Self::default();
    }

    /// Shows what a press at `at` would take, as `find` says.
    pub(super) fn show(
        &mut self,
        painter: &Painter,
        at: Pos2,
        screen: &Screen,
        camera: &Camera,
        reading: &Reading<'_>,
        find: impl FnOnce() -> Option<Over>,
    ) {
        let seen = Seen {
            at,
            camera: camera.clone(),
            scene: reading.session.revision(),
            clock_s: reading.clock.time_s(),
            selected: reading.view.selection.items().to_vec(),
        };
        if self.seen.as_ref() != Some(&seen) {
            self.found = find();
            self.seen = Some(seen);
        }
        match self.found {
            Some(Over::Path(id, key)) => paint_path(painter, screen, reading, id, key),
            Some(Over::Thing(picked)) => paint_thing(painter, screen, reading, picked),
            None => {}
        }
    }
}

fn paint_path(painter: &Painter, screen: &Screen, reading: &Reading<'_>, id: PathId, key: Option<usize>) {
    let Some(path) = reading.session.scene().path(id) else { return };
    let Some(at) = key.and_then(|key| screen.find(path.keys.get(key)?.position)) else { return };
    for stroke in [theme::casing(theme::HOVERED), theme::HOVERED] {
        painter.circle_stroke(at, RING, stroke);
    }
}

fn paint_thing(painter: &Painter, screen: &Screen, reading: &Reading<'_>, Picked { item, through }: Picked) {
    let (scene, view) = (reading.session.scene(), reading.view);
    if view.selection.items() == [item] {
        return;
    }
    let places = Places::of(reading);
    match item {
        Item::Cloud(id) => {
            let Some(cloud) = scene.cloud(id) else { return };
            let (now, model) = (places.seen(cloud), scene.model(cloud.model));
            let boxes = model.into_iter().flat_map(|model| model.boxes.iter());
            let corners = boxes.flat_map(|each| corners(&now, each));
            bracket(painter, screen, corners, &cloud.name);
        }
        Item::Box(model, id) => {
            let cloud = through.and_then(|id| scene.cloud(id));
            let Some((cloud, each)) = cloud.zip(box_of(scene, model, id)) else { return };
            wireframe::paint_hovered(painter, screen, &places.seen(cloud), each);
        }
        // Marks of these light up by themselves, or are as small as a bracket.
        Item::Camera(id) => {
            let Some(camera) = scene.cameras.with_id(id) else { return };
            bracket(painter, screen, [camera.position], &camera.name);
        }
        Item::Prop(id) => {
            let Some(prop) = scene.props.with_id(id) else { return };
            bracket(painter, screen, [prop.position], &prop.name);
        }
        _ => {}
    }
}

fn corners(cloud: &Cloud, each: &CloudBox) -> [DVec3; 8] {
    let space = ModelSpace::of(cloud);
    std::array::from_fn(|i| {
        let sign = |bit: usize| if i & bit == 0 { -0.5 } else { 0.5 };
        let within = each.size * DVec3::new(sign(1), sign(2), sign(4));
        space.to_world(each.center + each.orientation * within)
    })
}

/// Four corners around what shows of the places, and its name.
fn bracket(painter: &Painter, screen: &Screen, places: impl IntoIterator<Item = DVec3>, name: &str) {
    let shown = places.into_iter().filter_map(|place| screen.project(screen.relative(place)));
    let around = shown.fold(Rect::NOTHING, |around, at| around.union(Rect::from_pos(at))).expand(MARGIN);
    let rect = around.intersect(screen.rect.shrink(MARGIN));
    if !rect.is_positive() {
        return;
    }
    let arm = ARM.min(rect.width() * 0.5).min(rect.height() * 0.5);
    for stroke in [theme::casing(theme::HOVERED), theme::HOVERED] {
        for (corner, inwards) in [
            (rect.left_top(), vec2(1.0, 1.0)),
            (rect.right_top(), vec2(-1.0, 1.0)),
            (rect.left_bottom(), vec2(1.0, -1.0)),
            (rect.right_bottom(), vec2(-1.0, -1.0)),
        ] {
            arms(painter, corner, inwards * arm, stroke);
        }
    }
    overlay::label(painter, rect.left_top() + vec2(ARM, ARM), &visible::one_line(name));
}

fn arms(painter: &Painter, corner: Pos2, inwards: egui::Vec2, stroke: Stroke) {
    painter.line_segment([corner, corner + vec2(inwards.x, 0.0)], stroke);
    painter.line_segment([corner, corner + vec2(0.0, inwards.y)], stroke);
}

/// What a press would take, by all that may be there.
pub(super) fn over(
    path: Option<(PathId, Option<usize>)>,
    clicks: &Clicks,
    at: Pos2,
    screen: &Screen,
    camera: &Camera,
    reading: &Reading<'_>,
) -> Option<Over> {
    match path {
        Some((path, key)) => Some(Over::Path(path, key)),
        None => clicks.would_pick(at, screen, camera, reading).map(Over::Thing),
    }
}
