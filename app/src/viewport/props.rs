//! Where props stand, as marks: when one is selected, or all outlines are shown.

use super::screen::Screen;
use crate::state::{Item, Reading};
use crate::theme;
use cloudwright_core::flight::PathPoint;
use cloudwright_core::scene::{List, Prop, PropId};
use egui::{Painter, Pos2};
use glam::DVec3;

/// Half of a mark's width, points.
const HALF: f64 = 9.0;
/// How near to a mark's middle a click means it, points.
const REACH: f32 = 12.0;

/// Paints a frame at the foot of each, with its north.
pub(super) fn paint(painter: &Painter, screen: &Screen, reading: &Reading<'_>) {
    for prop in &now(reading) {
        if !is_marked(prop, reading) {
            continue;
        }
        let selected = reading.view.selection.contains(Item::Prop(prop.id));
        let stroke = if selected { theme::SELECTED_BOX } else { theme::CAMERA };
        let Prop { position, heading_deg, pitch_deg, roll_deg, .. } = *prop;
        let turn = PathPoint { position, heading_deg, pitch_deg, roll_deg }.turn();
        let size = screen.metres_per_point(position) * HALF;
        let at = |x: f64, y: f64, z: f64| screen.relative(position + turn * DVec3::new(x, y, z) * size);
        let foot = [at(-1.0, 0.0, -1.0), at(1.0, 0.0, -1.0), at(1.0, 0.0, 1.0), at(-1.0, 0.0, 1.0)];
        let sides = (0..4).map(|i| [foot[i], foot[(i + 1) % 4]]);
        let north = [at(0.0, 0.0, -1.0), at(0.0, 0.0, -2.0)];
        let up = [at(0.0, 0.0, 0.0), at(0.0, 2.5, 0.0)];
        let lines: Vec<[Pos2; 2]> = sides.chain([north, up]).filter_map(|[a, b]| screen.line(a, b)).collect();
        for stroke in [theme::casing(stroke), stroke] {
            lines.iter().for_each(|ends| {
                painter.line_segment(*ends, stroke);
            });
        }
    }
}

/// The prop whose mark a click means.
pub(super) fn under(at: Pos2, screen: &Screen, reading: &Reading<'_>) -> Option<PropId> {
    let props = now(reading);
    let marked = props.iter().filter(|prop| is_marked(prop, reading));
    let near = marked.filter_map(|prop| Some((screen.find(prop.position)?.distance(at), prop.id)));
    near.filter(|(distance, _)| *distance <= REACH).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, id)| id)
}

fn is_marked(prop: &Prop, reading: &Reading<'_>) -> bool {
    let view = reading.view;
    view.show_all_boxes || view.selection.contains(Item::Prop(prop.id))
}

/// Where their tracks have them now.
fn now(reading: &Reading<'_>) -> List<Prop> {
    let scene = reading.session.scene();
    if scene.props.is_empty() {
        return List::new();
    }
    reading.session.derived().timeline().surroundings_at(scene, reading.clock.time_s()).props.clone()
}
