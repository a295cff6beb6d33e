//! The picture to the left of a handle, the truth to its right.

use super::{LensSource, paint};
use crate::theme::{self, icon};
use crate::viewport::overlay;
use crate::widget::Handle;
use cloudwright_core::property::Number;
use egui::{Align2, CursorIcon, FontId, Painter, Rect, Stroke, Ui, pos2, vec2};

/// Where the handle stands.
const PLACE: Number = Number {
    label: "Wipe",
    unit: "",
    min: 0.0,
    max: 1.0,
    doc: "Where the picture ends and the truth begins, from left to right.",
};
/// Of an arrow key.
const STEP: f64 = 0.01;
/// Within which the line is taken, points.
const REACH: f32 = 12.0;
/// Of the grip, points.
const GRIP: f32 = 13.0;

impl LensSource {
    pub(super) fn show_wipe(&mut self, ui: &mut Ui, painter: &Painter, rect: Rect, name: &str) {
        let x = |share: f64| rect.left() + rect.width() * share as f32;
        let line = |share: f64| Rect::from_center_size(pos2(x(share), rect.center().y), vec2(REACH, rect.height()));
        let handled = Handle {
            id: ui.scope_id().with("wipe"),
            rect: line(self.wipe).intersect(rect),
            name: PLACE.label,
            number: &PLACE,
            value: self.wipe,
            step: STEP,
        }
        .show(ui, |start, way| start + f64::from(way.x / rect.width().max(1.0)));
        self.wipe = handled.wanted.unwrap_or(self.wipe).clamp(PLACE.min, PLACE.max);
        let cut = x(self.wipe);
        if let Some(shown) = self.slide() {
            paint(painter, shown, rect, Rect::from_min_max(pos2(cut, rect.top()), rect.right_bottom()));
        }
        let middle = pos2(cut, rect.center().y);
        for (width, color) in [(4.0, theme::VIEWPORT_SHADE), (1.5, theme::VIEWPORT_TEXT)] {
            painter.vline(cut, rect.y_range(), Stroke::new(width, color));
        }
        let lit = handled.response.hovered() || handled.response.dragged() || handled.response.has_focus();
        let (fill, ink) =
            if lit { (theme::VIEWPORT_TEXT, theme::CASING) } else { (theme::HUD_SHADE, theme::VIEWPORT_TEXT) };
        painter.circle(middle, GRIP, fill, Stroke::new(1.5, theme::VIEWPORT_TEXT));
        let font = FontId::proportional(theme::HUD_TEXT);
        painter.text(middle, Align2::CENTER_CENTER, icon::ARROWS_LEFT_RIGHT, font, ink.to_opaque());
        let truth = match (self.progress(), self.slide()) {
            (Some(share), None) => format!("truth, {:.0} %", share * 100.0),
            (Some(share), Some(_)) => format!("truth, getting finer: {:.0} %", share * 100.0),
            (None, Some(_)) => "truth".into(),
            (None, None) => "truth, when the view rests".into(),
        };
        let beside = |side: f32| pos2(cut + side * (GRIP + 8.0), middle.y);
        overlay::plate(ui, beside(-1.0), Align2::RIGHT_CENTER, name);
        overlay::plate(ui, beside(1.0), Align2::LEFT_CENTER, &truth);
        handled.response.on_hover_cursor(CursorIcon::ResizeHorizontal);
    }
}
