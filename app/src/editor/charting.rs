//! Charting from frame to frame: what would be measured now, and whether what was measured is still of that.

use super::Editor;
use crate::state::{ChartChange, ChartEye, ChartSubject};

impl Editor {
    /// Once a frame: what has been measured meanwhile, and whether it is still of what is seen.
    pub(super) fn keep_chart(&mut self, context: &egui::Context) {
        self.charting.keep_up(context);
        let is_stale = self.charting.measured_of().is_some_and(|of| !self.still_looks_at(of));
        self.charting.set_stale(is_stale);
    }

    pub(super) fn change_chart(&mut self, change: ChartChange, context: &egui::Context) {
        let charting = &mut self.charting;
        match change {
            ChartChange::AlongPath(along_path) => charting.along_path = along_path,
            ChartChange::Width(width_px) => charting.width_px = width_px,
            ChartChange::Tolerance(tolerance) => charting.tolerance = tolerance,
            ChartChange::ShowsFlicker(flicker) => charting.shows_flicker = flicker,
            ChartChange::Measure => self.measure(context),
            ChartChange::Stop => charting.stop(),
        }
    }

    /// What would be measured now: the path, if there is one that leads anywhere, or the view.
    fn looked_at(&self, along_path: bool) -> ChartSubject {
        let Self { session, view, clock, .. } = self;
        let eye = match along_path.then(|| clock.path_to_fly(session.scene())).flatten() {
            Some(path) => ChartEye::Path(Box::new(path.clone())),
            None => ChartEye::View { camera: Box::new(self.camera().clone()), clock_s: self.forming_s() },
        };
        ChartSubject { revision: session.revision(), eye, hour: self.hour(), hidden: view.hidden_in(session.scene()) }
    }

    /// Whether that would be measured now as it was then. A path of the same revision is the same.
    fn still_looks_at(&self, of: &ChartSubject) -> bool {
        let Self { session, view, clock, .. } = self;
        let same_eye = || match &of.eye {
            ChartEye::Path(path) => clock.path(session.scene()).is_some_and(|chosen| chosen.id == path.id),
            ChartEye::View { camera, clock_s } => **camera == *self.camera() && *clock_s == self.forming_s(),
        };
        let same_scene = of.revision == session.revision() && of.hour == self.hour();
        same_scene && same_eye() && of.hidden == view.hidden_in(session.scene())
    }

    /// The clock, seconds; 0 where nothing forms, since it shows nowhere there.
    fn forming_s(&self) -> f64 {
        let forms = self.session.scene().clouds.iter().any(|cloud| cloud.formation.is_some());
        if forms { self.clock.time_s() } else { 0.0 }
    }

    fn hour(&self) -> f64 {
        self.time_play.hour().unwrap_or(self.session.scene().time_of_day_h)
    }

    fn measure(&mut self, context: &egui::Context) {
        let of = self.looked_at(self.charting.along_path);
        let width_px = self.charting.width_px;
        let size = [width_px, (width_px as f32 / self.viewport.aspect()).round().max(1.0) as u32];
        let has_device = self.viewport.has_device();
        self.charting.measure(&self.session, of, size, has_device, context);
    }
}
