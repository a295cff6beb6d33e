//! A method's mark, what is known of it, and what a click on it does.

use crate::chart::report::MethodFigures;
use crate::chart::text::figure;
use crate::state::{Action, Reading, ViewChange};
use crate::theme;
use cloudwright_core::method::{self, Family};
use cloudwright_core::rules::Rasterizer;
use egui::{Sense, Shape, Stroke, Ui, vec2};
use egui_plot::MarkerShape;

/// Of a mark beside a name, and of the ring around one, points.
const MARK: f32 = 3.5;
const RING: f32 = 6.0;

/// Its family; another program's methods are others.
pub(super) fn family(method: &MethodFigures) -> Family {
    method::named(&method.name).map_or(Family::Other, |method| method.family)
}

/// As in `chart.html`: the truth is a diamond, what is known to fail a triangle.
pub(super) fn shape(family: Family) -> MarkerShape {
    match family {
        Family::Truth => MarkerShape::Diamond,
        Family::Shipped | Family::Other => MarkerShape::Circle,
        Family::Failing => MarkerShape::Up,
    }
}

/// A family's mark by itself, as in the chart: what is shipped has a ring.
pub(super) fn mark(ui: &mut Ui, family: Family) {
    let size = vec2(2.0 * RING, ui.spacing().interact_size.y);
    let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
    let (middle, color) = (rect.center(), theme::family(ui, family));
    let corners = |corners: &[[f32; 2]]| corners.iter().map(|[x, y]| middle + vec2(*x, *y) * MARK).collect();
    let painter = ui.painter();
    match family {
        Family::Truth => {
            let diamond = corners(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]);
            painter.add(Shape::convex_polygon(diamond, color, Stroke::NONE));
        }
        Family::Failing => {
            let triangle = corners(&[[0.0, -1.25], [1.2, 0.95], [-1.2, 0.95]]);
            painter.add(Shape::convex_polygon(triangle, color, Stroke::NONE));
        }
        Family::Other => {
            painter.circle_filled(middle, MARK, color);
        }
        Family::Shipped => {
            painter.circle_filled(middle, MARK, color);
            painter.circle_stroke(middle, RING, Stroke::new(1.5, color));
        }
    }
}

/// Whether the viewport is drawn by it.
pub(super) fn is_chosen(method: &MethodFigures, reading: &Reading<'_>) -> bool {
    reading.view.method.is_some_and(|chosen| chosen.name == method.name)
}

/// Has the viewport drawn by it; if it is already, by the window's own way, which is the device's where it has one.
pub(super) fn choose_method(method: &MethodFigures, reading: &Reading<'_>) -> Action {
    let is_new = |known: &&method::Method| known.rules.rasterizer != Rasterizer::Gpu && !is_chosen(method, reading);
    let method = method::named(&method.name).filter(is_new);
    Action::View(ViewChange::Method(method))
}

/// What it does, and its figures: for a tooltip.
pub(super) fn card(ui: &mut Ui, method: &MethodFigures) {
    ui.set_max_width(theme::DIALOG_WIDTH);
    ui.horizontal(|ui| {
        ui.strong(&method.name);
        ui.weak(family(method).name());
    });
    if let Some(known) = method::named(&method.name) {
        ui.label(known.about);
    }
    let mut words = format!("{} ms, mean FLIP {}", figure(method.cost.frame_ms), figure(method.error.flip_mean));
    if let Some(stability) = &method.stability {
        words += &format!(", flicker {}", figure(stability.excess_mean));
    }
    ui.label(words);
    let counts = &method.cost.counts;
    if counts.sprites > 0 {
        ui.weak(format!("{} sprites, overdraw {}", counts.sprites, figure(counts.overdraw_mean)));
    }
    ui.weak("Click: the viewport draws by it.");
}
