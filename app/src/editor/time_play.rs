//! The time of day from frame to frame, and what becomes of it when it stops.

use super::Editor;
use cloudwright_core::document::Edit;

impl Editor {
    /// Starts at the scene's hour; or stops, and the scene's hour is the one that was reached.
    pub(super) fn toggle_time(&mut self) {
        if let Some(hour) = self.time_play.stop() {
            let edit = Edit::TimeOfDay(hour);
            let done = self.session.edit(&edit.name(), vec![edit]);
            self.report(done);
        } else {
            self.time_play.start(self.session.scene().time_of_day_h);
        }
    }

    /// A frame's worth of time; the next frame is asked for only while it runs.
    pub(super) fn run_time(&mut self, context: &egui::Context) {
        if !self.time_play.is_on() {
            return;
        }
        if context.input(|input| input.key_pressed(egui::Key::Escape)) && !self.viewport.has_keys() {
            self.time_play.drop_hour();
            return;
        }
        self.time_play.advance(context.input(|input| f64::from(input.stable_dt)));
        context.request_repaint();
    }
}
