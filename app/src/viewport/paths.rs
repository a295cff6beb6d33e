//! Camera paths in the viewport: the way, its keys with where they look, and what flies there at the clock's time.
//!
//! Those that are selected are drawn, the chosen one while the Flight panel is on the screen, and all when all outlines
//! are shown; never the one that the view goes along, which would be all around the eye. Ways are measured out once a
//! change.

use super::grip;
use super::screen::Screen;
use crate::state::{Item, Reading};
use crate::theme;
use cloudwright_core::camera::View;
use cloudwright_core::flight::{PathCurve, PathPoint};
use cloudwright_core::scene::{Camera, CameraPath, PathId, PathKey};
use egui::{Painter, Pos2, Shape, Stroke};
use glam::{DVec3, Vec3};

/// Of a leg, pieces that it is drawn in.
const PIECES: usize = 16;
/// Of a path, at most: a recorded one has many legs.
const MOST_PIECES: usize = 4096;
/// How near to a way, points.
const WAY_REACH: f32 = 5.0;
/// Of a key, points.
const KEY_RADIUS: f32 = 4.0;
/// From a key to where it looks, points.
const LOOK_LENGTH: f64 = 20.0;
/// Half of an aircraft's span, points.
const WING: f64 = 9.0;

/// The ways as they were last drawn.
#[derive(Default)]
pub(super) struct Paths {
    ways: Vec<Way>,
}

struct Way {
    path: CameraPath,
    curve: PathCurve,
    places: Vec<DVec3>,
}

impl Paths {
    /// Paints those that are shown but `ridden`.
    pub(super) fn paint(&mut self, painter: &Painter, screen: &Screen, ridden: Option<PathId>, reading: &Reading<'_>) {
        self.keep_up(ridden, reading);
        for Way { path, curve, places } in &self.ways {
            let selected = reading.view.selection.contains(Item::Path(path.id));
            let stroke = if selected { theme::SELECTED_BOX } else { theme::CAMERA };
            for stroke in [theme::casing(stroke), stroke] {
                for pair in places.windows(2) {
                    line(painter, screen, pair[0], pair[1], stroke);
                }
            }
            for (index, key) in path.keys.iter().enumerate() {
                let chosen = selected && reading.view.key_of(path.id) == Some(index);
                paint_key(painter, screen, key, stroke, chosen);
            }
            self.paint_traffic(painter, screen, path, curve, reading);
        }
    }

    /// The path that a click means, and its key.
    pub(super) fn under(&self, at: Pos2, screen: &Screen) -> Option<(PathId, Option<usize>)> {
        let keys = self.ways.iter().flat_map(|way| {
            let keys = way.path.keys.iter().enumerate();
            keys.filter_map(|(index, key)| Some((screen.find(key.position)?.distance(at), way.path.id, Some(index))))
        });
        let ways = self.ways.iter().flat_map(|way| {
            let lines = way.places.windows(2).filter_map(|pair| seen(screen, pair[0], pair[1]));
            lines.map(|[a, b]| (grip::nearest_of_line(at, a, b).distance(at), way.path.id, None))
        });
        let nearest = |near: &mut dyn Iterator<Item = (f32, PathId, Option<usize>)>, reach: f32| {
            near.filter(|(distance, ..)| *distance <= reach).min_by(|a, b| a.0.total_cmp(&b.0))
        };
        let (mut keys, mut ways) = (keys, ways);
        let found = nearest(&mut keys, grip::REACH).or_else(|| nearest(&mut ways, WAY_REACH))?;
        Some((found.1, found.2))
    }

    /// The ways of the paths that are shown, as they are now.
    fn keep_up(&mut self, ridden: Option<PathId>, reading: &Reading<'_>) {
        let scene = reading.session.scene();
        let chosen = reading.clock.path(scene).map(|path| path.id).filter(|_| reading.flight_shown);
        let shows = |path: &&CameraPath| {
            let selected = reading.view.selection.contains(Item::Path(path.id));
            (selected || chosen == Some(path.id) || reading.view.show_all_boxes) && ridden != Some(path.id)
        };
        let mut old = std::mem::take(&mut self.ways);
        for path in scene.paths.iter().filter(shows) {
            let known = old.iter().position(|way| way.path == *path).map(|at| old.swap_remove(at));
            self.ways.push(known.unwrap_or_else(|| Way::new(path)));
        }
    }

    /// The camera on the path and its aircraft, at the clock's time.
    fn paint_traffic(
        &self,
        painter: &Painter,
        screen: &Screen,
        path: &CameraPath,
        curve: &PathCurve,
        reading: &Reading<'_>,
    ) {
        if curve.duration_s() <= 0.0 {
            return;
        }
        let time_s = reading.clock.time_s();
        if let Some(at) = screen.find(curve.at(time_s).position) {
            painter.circle(at, KEY_RADIUS - 0.5, theme::NOW, theme::HANDLE_RIM);
        }
        for aircraft in reading.session.scene().aircraft.iter().filter(|aircraft| aircraft.path == path.id) {
            let selected = reading.view.selection.contains(Item::Aircraft(aircraft.id));
            let stroke = if selected { theme::SELECTED_BOX } else { theme::CAMERA };
            paint_aircraft(painter, screen, &curve.attitude_at(time_s + aircraft.ahead_s), stroke);
        }
    }
}

impl Way {
    fn new(path: &CameraPath) -> Self {
        let curve = PathCurve::new(path);
        let start_s = path.keys.first().map_or(0.0, |key| key.time_s);
        let legs = path.keys.len().saturating_sub(1);
        let pieces = (MOST_PIECES / legs.max(1)).clamp(1, PIECES);
        let mut places = Vec::new();
        for pair in path.keys.windows(2) {
            let at = |piece: usize| pair[0].time_s + (pair[1].time_s - pair[0].time_s) * piece as f64 / pieces as f64;
            places.extend((0..pieces).map(|piece| curve.at(at(piece) - start_s).position));
        }
        places.extend(path.keys.last().map(|key| key.position));
        Self { path: path.clone(), curve, places }
    }
}

fn paint_key(painter: &Painter, screen: &Screen, key: &PathKey, stroke: Stroke, chosen: bool) {
    let Some(at) = screen.find(key.position) else { return };
    let PathKey { position, heading_deg, pitch_deg, roll_deg, .. } = *key;
    let look = View::new(&Camera { heading_deg, pitch_deg, roll_deg, ..Camera::free(position) }, 1, 1).forward;
    let end = position + look.as_dvec3() * (screen.metres_per_point(position) * LOOK_LENGTH);
    for stroke in [theme::casing(stroke), stroke] {
        line(painter, screen, position, end, stroke);
    }
    let (radius, fill) = if chosen { (KEY_RADIUS + 2.0, theme::CHOSEN) } else { (KEY_RADIUS, theme::VIEWPORT_TEXT) };
    painter.circle(at, radius, fill, theme::HANDLE_RIM);
}

/// An arrow with its wings level or banked, of one size on the screen.
fn paint_aircraft(painter: &Painter, screen: &Screen, attitude: &PathPoint, stroke: Stroke) {
    if screen.find(attitude.position).is_none() {
        return;
    }
    let size = screen.metres_per_point(attitude.position) * WING;
    let turn = attitude.turn();
    let corner = |x: f64, z: f64| {
        let place: Vec3 = screen.relative(attitude.position + turn * DVec3::new(x, 0.0, z) * size);
        screen.project(place)
    };
    let corners = [corner(0.0, -1.4), corner(1.0, 0.8), corner(0.0, 0.4), corner(-1.0, 0.8)];
    if let [Some(nose), Some(right), Some(tail), Some(left)] = corners {
        for half in [[nose, right, tail], [nose, tail, left]] {
            painter.add(Shape::convex_polygon(half.into(), stroke.color.gamma_multiply(0.6), Stroke::NONE));
        }
        painter.add(Shape::closed_line(vec![nose, right, tail, left], stroke));
    }
}

fn line(painter: &Painter, screen: &Screen, a: DVec3, b: DVec3, stroke: Stroke) {
    if let Some(ends) = seen(screen, a, b) {
        painter.line_segment(ends, stroke);
    }
}

fn seen(screen: &Screen, a: DVec3, b: DVec3) -> Option<[Pos2; 2]> {
    screen.line(screen.relative(a), screen.relative(b))
}
