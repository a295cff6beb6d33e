//! Altitude, speed and heading at the foot of the picture, as a pilot reads them: while one flies.

use crate::theme;
use crate::units::{self, Units};
use cloudwright_core::scene::Camera;
use egui::{Align2, FontId, Label, Rect, RichText, Ui, vec2};

/// What the instruments say.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Readout {
    altitude_m: f64,
    speed_m_s: f64,
    heading_deg: f64,
}

impl Readout {
    /// On board of a camera that goes so fast.
    pub(super) fn of(camera: &Camera, speed_m_s: f64) -> Self {
        Self { altitude_m: camera.position.y, speed_m_s, heading_deg: camera.heading_deg }
    }

    /// "ALT 4 310 ft · 118 kt · HDG 042°".
    fn text(&self, units: Units) -> String {
        let altitude = units.altitude().text(self.altitude_m);
        let speed = units.speed().text(self.speed_m_s);
        format!("ALT {altitude} · {speed} · HDG {}", units::heading(self.heading_deg))
    }

    /// Shows it in the middle of the lower rim of `rect`, above the line of hints. Figures are of one width, so that
    /// they stand still while they change.
    pub(super) fn show(&self, ui: &mut Ui, rect: Rect, units: Units) {
        let text = self.text(units);
        let font = FontId::monospace(theme::HUD_TEXT);
        let painter = ui.painter_at(rect);
        let size = painter.layout_no_wrap(text.clone(), font.clone(), theme::VIEWPORT_TEXT).size();
        let at = rect.center_bottom() - vec2(0.0, theme::HUD_HEIGHT);
        let place = Align2::CENTER_BOTTOM.anchor_size(at, size);
        painter.rect_filled(place.expand2(vec2(10.0, 4.0)), 4.0, theme::HUD_SHADE);
        let text = RichText::new(text).font(font).color(theme::VIEWPORT_TEXT);
        ui.put(place, Label::new(text).selectable(false).extend());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_in_the_users_units() {
        let readout = Readout { altitude_m: 1313.0, speed_m_s: 60.7, heading_deg: -318.0 };
        assert_eq!(readout.text(Units::Aviation), "ALT 4\u{202F}310 ft · 118 kt · HDG 042°");
        assert_eq!(readout.text(Units::Metric), "ALT 1\u{202F}313 m · 219 km/h · HDG 042°");
    }
}
