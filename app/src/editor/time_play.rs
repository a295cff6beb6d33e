//! The hour that is tried out, from frame to frame, and what becomes of it.

use super::Editor;
use crate::command::Command;
use cloudwright_core::document::Edit;

impl Editor {
    /// Runs, or stops where it is.
    pub(super) fn toggle_time(&mut self) {
        self.time_play.run_or_stop(self.session.scene().time_of_day_h);
    }

    /// The hour that is tried out becomes the scene's, as one step.
    pub(super) fn keep_hour(&mut self) {
        let Some(hour) = self.time_play.leave() else { return };
        let done = self.session.edit(Command::KeepHour.row().label(), vec![Edit::TimeOfDay(hour)]);
        self.report(done);
    }

    /// A frame's worth of time; the next frame is asked for only while it runs.
    pub(super) fn run_time(&mut self, context: &egui::Context) {
        let escape = context.input(|input| input.key_pressed(egui::Key::Escape)) && !self.viewport.has_keys();
        if self.time_play.runs() && escape {
            self.time_play.leave();
        }
        let seconds = context.input(|input| f64::from(input.stable_dt));
        self.time_play.advance(seconds, self.session.scene().time_of_day_h);
        if self.time_play.runs() {
            context.request_repaint();
        }
    }
}
