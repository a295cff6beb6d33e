//! What a map's colours stand for, in the viewport's lower right corner.

use super::slide::Scale;
use crate::chart::heat;
use crate::chart::text::figure;
use crate::state::Lens;
use crate::theme;
use crate::viewport::overlay;
use egui::{Align2, Color32, Mesh, Rect, Ui, Vec2, pos2, vec2};

/// Of the bar, points.
const BAR: Vec2 = vec2(180.0, 8.0);
/// Around it, points.
const PADDING: f32 = 8.0;
/// Of a line of text, points.
const LINE: f32 = 15.0;

/// How much of the corner it takes, points, with what is to be free above it.
pub(in crate::viewport) fn height(lens: Lens) -> f32 {
    match lens {
        Lens::Picture | Lens::Wipe => 0.0,
        Lens::Overdraw | Lens::WrongOrder | Lens::Error => size().y + theme::VIEWPORT_MARGIN,
    }
}

fn size() -> Vec2 {
    BAR + vec2(2.0 * PADDING, 2.0 * PADDING + 2.0 * LINE + 4.0)
}

/// Shows it; without a `scale` there is no map yet.
pub(super) fn show(ui: &mut Ui, rect: Rect, lens: Lens, scale: Option<&Scale>, progress: Option<f32>) {
    let title = match lens {
        Lens::Picture | Lens::Wipe => return,
        Lens::Overdraw => "Sprites blended on a pixel",
        Lens::WrongOrder => "Cost of the sprites' order, linear light",
        Lens::Error => "FLIP against the truth",
    };
    let size = size();
    let frame = Rect::from_min_size(rect.right_bottom() - size - Vec2::splat(theme::VIEWPORT_MARGIN), size);
    ui.painter().rect_filled(frame, 4.0, theme::HUD_SHADE);
    let inner = frame.shrink(PADDING);
    overlay::words(ui, inner.left_top(), Align2::LEFT_TOP, title);
    let bar = Rect::from_min_size(inner.left_top() + vec2(0.0, LINE + 2.0), BAR);
    ui.painter().add(colors(bar));
    let below = inner.left_bottom();
    let Some(Scale { brightest, mean }) = scale else {
        let words =
            progress.map_or("when the view rests".into(), |share| format!("being drawn, {:.0} %", share * 100.0));
        return overlay::words(ui, below, Align2::LEFT_BOTTOM, &words);
    };
    overlay::words(ui, below, Align2::LEFT_BOTTOM, "0");
    overlay::words(ui, inner.right_bottom(), Align2::RIGHT_BOTTOM, &figure(Some(f64::from(*brightest))));
    let more = if progress.is_some() { " …" } else { "" };
    let mean = format!("mean {}{more}", figure(Some(*mean)));
    overlay::words(ui, pos2(bar.center().x, below.y), Align2::CENTER_BOTTOM, &mean);
}

/// From left to right.
fn colors(bar: Rect) -> Mesh {
    let last = heat::COLORS.len() - 1;
    let mut mesh = Mesh::default();
    for (index, [r, g, b]) in heat::COLORS.into_iter().enumerate() {
        let x = bar.left() + bar.width() * index as f32 / last as f32;
        for y in [bar.top(), bar.bottom()] {
            mesh.colored_vertex(pos2(x, y), Color32::from_rgb(r, g, b));
        }
        if index < last {
            let first = 2 * index as u32;
            mesh.add_triangle(first, first + 1, first + 2);
            mesh.add_triangle(first + 1, first + 2, first + 3);
        }
    }
    mesh
}
