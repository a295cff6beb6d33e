//! Charting from frame to frame: what would be measured now, and whether what was measured is still of that.

use super::Editor;
use crate::state::{ChartChange, ChartSubject};
use cloudwright_core::sight::Sight;
use cloudwright_core::weather::Moment;

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
        let path = along_path.then(|| clock.path_to_fly(session.scene())).flatten().cloned();
        let width_px = self.charting.width_px;
        let size = [width_px, (width_px as f32 / self.viewport.aspect()).round().max(1.0) as u32];
        let hidden = view.hidden_in(session.scene());
        let sight = Sight { moment: self.moment(), hidden, ..Sight::still(self.camera(), size) };
        ChartSubject { revision: session.revision(), sight, path }
    }

    /// Whether that would be measured now as it was then. A path of the same revision is the same.
    fn still_looks_at(&self, ChartSubject { revision, sight, path }: &ChartSubject) -> bool {
        let Self { session, view, clock, .. } = self;
        let now = self.moment();
        let same_eye = || match path {
            Some(path) => clock.path(session.scene()).is_some_and(|chosen| chosen.id == path.id),
            None => sight.camera == *self.camera() && sight.moment.clock_s == now.clock_s,
        };
        let same_scene = *revision == session.revision() && sight.moment.time_h == now.time_h;
        same_scene && same_eye() && sight.hidden == view.hidden_in(session.scene())
    }

    /// That of the view; the beginning of the clock where that moves nothing, since it shows nowhere there.
    fn moment(&self) -> Moment {
        let moves = self.session.derived().moves();
        Moment { clock_s: if moves { self.clock.time_s() } else { 0.0 }, time_h: self.time_play.time_h() }
    }

    fn measure(&mut self, context: &egui::Context) {
        let of = self.looked_at(self.charting.along_path);
        let has_device = self.viewport.has_device();
        self.charting.measure(&self.session, of, has_device, context);
    }
}
