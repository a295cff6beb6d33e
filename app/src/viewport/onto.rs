//! Snapping onto other boxes: a face that is dragged, or a box that is moved, comes to lie in the plane of a face of
//! another one as soon as that is a few points away. So tops and bases meet, and walls touch.
//!
//! The planes are collected when a drag begins, from what may be picked and lies in the picture; they stay as they are while
//! it goes on.

use super::places::Places;
use super::screen::Screen;
use crate::state::{Item, Reading};
use crate::theme;
use cloudwright_core::arrange::ModelSpace;
use cloudwright_core::scene::{BoxId, CloudBox, CloudId, ModelId};
use egui::{Painter, Shape, Stroke};
use glam::DVec3;

/// So near a plane is met, points.
const REACH: f64 = 8.0;
/// The cosine from which on a face lies across a direction; within a box of 10 km it is then off by less than 10 m.
const ACROSS: f64 = 0.999_999;

/// The faces of others that lie across one direction.
#[derive(Debug)]
pub(super) struct Planes {
    /// The direction, of length 1 in the world.
    normal: DVec3,
    /// By how far along it they are.
    faces: Vec<Face>,
}

#[derive(Debug, Clone)]
struct Face {
    /// Along the direction from the world's origin, metres.
    at_m: f64,
    /// In the world, in order around.
    corners: [DVec3; 4],
}

/// A face that is met.
#[derive(Debug, Clone)]
pub(super) struct Met {
    /// How far what is dragged has to go for it, along the direction, metres.
    pub(super) by_m: f64,
    corners: [DVec3; 4],
}

impl Planes {
    /// Of the boxes in the picture, but for those that `moves` says are dragged along.
    pub(super) fn across(
        normal: DVec3,
        moves: impl Fn(CloudId, ModelId, BoxId) -> bool,
        screen: &Screen,
        reading: &Reading<'_>,
    ) -> Self {
        let (scene, view) = (reading.session.scene(), reading.view);
        let places = Places::of(reading);
        let mut faces = Vec::new();
        for cloud in scene.clouds.iter().filter(|cloud| view.can_pick(scene, cloud)) {
            let Some(model) = scene.model(cloud.model) else { continue };
            let space = ModelSpace::of(&places.seen(cloud));
            for each in &model.boxes {
                if !view.hidden.contains(&Item::Box(model.id, each.id)) && !moves(cloud.id, model.id, each.id) {
                    faces.extend(faces_across(normal, &space, each, screen));
                }
            }
        }
        faces.sort_by(|a: &Face, b| a.at_m.total_cmp(&b.at_m));
        Self { normal, faces }
    }

    /// The plane nearest to any of `own`, places along the direction in metres, within reach of a hand at `near`.
    pub(super) fn nearest(&self, own: impl IntoIterator<Item = f64>, near: DVec3, screen: &Screen) -> Option<Met> {
        let reach_m = REACH * screen.metres_per_point(near);
        let met = own.into_iter().flat_map(|own_m| {
            let next = self.faces.partition_point(|face| face.at_m < own_m);
            let around = next.saturating_sub(1)..self.faces.len().min(next + 1);
            around.map(move |index| (self.faces[index].at_m - own_m, index))
        });
        let (by_m, index) = met.min_by(|a, b| a.0.abs().total_cmp(&b.0.abs()))?;
        (by_m.abs() <= reach_m).then(|| Met { by_m, corners: self.faces[index].corners })
    }

    /// Where a place is along the direction, metres.
    pub(super) fn along(&self, place: DVec3) -> f64 {
        place.dot(self.normal)
    }
}

impl Met {
    /// Shows the face that is met.
    pub(super) fn paint(&self, painter: &Painter, screen: &Screen) {
        let stroke = Stroke::new(2.0, theme::GIZMO_HOVERED);
        for (i, corner) in self.corners.iter().enumerate() {
            let next = self.corners[(i + 1) % 4];
            if let Some(line) = screen.line(screen.relative(*corner), screen.relative(next)) {
                painter.line_segment(line, theme::casing(stroke));
                painter.add(Shape::dashed_line(&line, stroke, 6.0, 4.0));
            }
        }
    }
}

/// Those of a box's faces that lie across `normal` and show in the picture.
fn faces_across(normal: DVec3, space: &ModelSpace, each: &CloudBox, screen: &Screen) -> Vec<Face> {
    let axes = DVec3::AXES.map(|axis| space.turn * (each.orientation * axis));
    let Some(axis) = axes.iter().position(|axis| axis.dot(normal).abs() > ACROSS) else { return Vec::new() };
    let half = each.size * 0.5;
    let [side, other] = [(axis + 1) % 3, (axis + 2) % 3];
    let corner = |out: f64, a: f64, b: f64| {
        let mut within = DVec3::ZERO;
        (within[axis], within[side], within[other]) = (half[axis] * out, half[side] * a, half[other] * b);
        space.to_world(each.center + each.orientation * within)
    };
    let faces = [-1.0, 1.0].map(|out| {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(a, b)| corner(out, a, b));
        Face { at_m: corner(out, 0.0, 0.0).dot(normal), corners }
    });
    let shows = |face: &Face| {
        let middle = (face.corners[0] + face.corners[2]) * 0.5;
        face.corners.iter().chain([&middle]).any(|place| screen.find(*place).is_some())
    };
    faces.into_iter().filter(shows).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::Camera;
    use egui::{Rect, pos2};
    use glam::DQuat;

    /// A hundred metres north of the eye, 10 m deep and as wide and tall.
    fn ahead() -> CloudBox {
        let mut each = CloudBox::new(BoxId(1), DVec3::new(0.0, 0.0, -100.0));
        each.size = DVec3::splat(10.0);
        each
    }

    fn screen() -> Screen {
        Screen::new(&Camera::free(DVec3::ZERO), Rect::from_min_max(pos2(0.0, 0.0), pos2(800.0, 600.0)))
    }

    #[test]
    fn planes_are_met_within_reach() {
        let (screen, space) = (screen(), ModelSpace { origin: DVec3::ZERO, turn: DQuat::IDENTITY, scale: 1.0 });
        let mut faces = faces_across(DVec3::Y, &space, &ahead(), &screen);
        faces.sort_by(|a, b| a.at_m.total_cmp(&b.at_m));
        let planes = Planes { normal: DVec3::Y, faces };
        let near = ahead().center;
        let reach_m = REACH * screen.metres_per_point(near);
        for (own_m, met) in [
            (4.0, Some(1.0)),
            (5.0 + reach_m * 0.9, Some(-reach_m * 0.9)),
            (5.0 + reach_m * 1.1, None),
            (-5.5, Some(0.5)),
            (1e9, None),
        ] {
            let found = planes.nearest([own_m], near, &screen).map(|met| met.by_m);
            assert!(
                found.zip(met).is_none_or(|(a, b)| (a - b).abs() < 1e-9) && found.is_some() == met.is_some(),
                "{own_m}: {found:?}"
            );
        }
        let both = planes.nearest([3.9, -5.2], near, &screen).expect("within reach");
        assert!((both.by_m - 0.2).abs() < 1e-9, "the nearer one");
    }

    #[test]
    fn only_faces_across_the_direction_and_in_the_picture_count() {
        let screen = screen();
        let at = |origin: DVec3, turn: DQuat| {
            faces_across(DVec3::Y, &ModelSpace { origin, turn, scale: 2.0 }, &ahead(), &screen).len()
        };
        assert_eq!(at(DVec3::ZERO, DQuat::IDENTITY), 2);
        assert_eq!(at(DVec3::ZERO, DQuat::from_rotation_y(1.0)), 0, "turned out of the picture");
        assert_eq!(at(DVec3::new(0.0, 0.0, 400.0), DQuat::IDENTITY), 0, "behind the eye");
        assert_eq!(at(DVec3::ZERO, DQuat::from_rotation_z(0.1)), 0, "tilted");
        assert_eq!(at(DVec3::ZERO, DQuat::from_rotation_z(std::f64::consts::FRAC_PI_2)), 2, "its side is its top");
    }
}
