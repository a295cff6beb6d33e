//! What lies between the keys of a track's line: a colour's colours, the ramp of a share (how far a cloud has formed, its
//! opacity, humidity), or a line from the first key to the last.

use super::span::Span;
use crate::theme;
use crate::widget::color32;
use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::property::{Kind, Target};
use cloudwright_core::scene::Track;
use cloudwright_core::weather::Curve;
use egui::{Color32, Mesh, Rect, Stroke, Ui, vec2};

/// Between two samples, points.
const SAMPLE: f32 = 3.0;

/// Shows it in a track's line.
pub(super) fn show(ui: &Ui, rect: Rect, span: &Span, target: &Target, curve: &Curve, track: &Track) {
    let (Some(first), Some(last)) = (track.keys.first(), track.keys.last()) else { return };
    let band = rect.shrink2(vec2(0.0, 3.0));
    let ends = [span.x_of(first.time_s), span.x_of(last.time_s)];
    let kind = target.property.kind;
    if matches!(kind, Kind::Color(_)) {
        samples(band, ends, |left, right| {
            let color = color_of(curve.all_at(span.time_at((left + right) * 0.5)));
            (Rect::from_x_y_ranges(left..=right, band.y_range()), color)
        })
        .paint(ui);
        let rim = ui.visuals().widgets.noninteractive.bg_stroke;
        let [from, to] = ends.map(|x| x.clamp(rect.left(), rect.right()));
        ui.painter().hline(from..=to, band.top(), rim);
        ui.painter().hline(from..=to, band.bottom(), rim);
    } else if kind.number().is_some_and(|number| number.min == 0.0 && number.max == 1.0) {
        let color = theme::key(ui).gamma_multiply(0.25);
        samples(band, [rect.left(), rect.right()], |left, right| {
            let share = curve.at(span.time_at((left + right) * 0.5), 0).clamp(0.0, 1.0) as f32;
            let top = band.bottom() - share * band.height();
            (Rect::from_x_y_ranges(left..=right, top..=band.bottom()), color)
        })
        .paint(ui);
    } else {
        let [from, to] = ends.map(|x| x.clamp(rect.left(), rect.right()));
        let color = theme::key(ui).gamma_multiply(0.35);
        ui.painter().hline(from..=to, rect.center().y, Stroke::new(2.0, color));
    }
}

/// What a colour of a track looks like: linear light as the screen shows it.
pub(super) fn color_of(numbers: [f64; 3]) -> Color32 {
    let [r, g, b] = numbers.map(|number| number.max(0.0) as f32);
    color32(Rgba { rgb: Rgb::new(r, g, b), a: 1.0 })
}

/// Columns of a band.
struct Columns(Mesh);

fn samples(band: Rect, [from, to]: [f32; 2], column: impl Fn(f32, f32) -> (Rect, Color32)) -> Columns {
    let mut mesh = Mesh::default();
    let mut left = from.max(band.left());
    let end = to.min(band.right());
    while left < end {
        let right = (left + SAMPLE).min(end);
        let (rect, color) = column(left, right);
        mesh.add_colored_rect(rect, color);
        left = right;
    }
    Columns(mesh)
}

impl Columns {
    fn paint(self, ui: &Ui) {
        if !self.0.is_empty() {
            ui.painter().add(self.0);
        }
    }
}
