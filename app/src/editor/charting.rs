//! What each method costs and gets wrong in the open scene: measured off the frame, and shown as it comes.
//!
//! It is the measuring of `cloudwright chart` ([`Run`]), on all cores but the window's. What was measured stays until it
//! is measured anew; that the scene or the view has changed since is said, not hidden.

use super::{Editor, Session};
use crate::chart::report::Report;
use crate::chart::run::Run;
use crate::chart::subject::{Eye, Subject};
use crate::chart::{choice, easel::Easel, html};
use crate::opening::Beside;
use crate::renderer::RenderError;
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::method;
use cloudwright_core::scene::{Camera, CameraPath, Scene};
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use cloudwright_render::AdapterChoice;
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, TryRecvError, channel};
use std::time::Duration;

/// Between two looks at how far it has come.
const LOOK: Duration = Duration::from_millis(100);

/// How wide pictures may be that methods are measured on, pixels.
pub(crate) const WIDTHS_PX: [u32; 3] = [320, 640, 960];

/// How often each method is timed; the median counts.
const ROUNDS: u32 = 3;

/// What is to be measured, what is being measured, and what was.
pub(crate) struct Charting {
    /// The chosen path instead of the view.
    pub(crate) along_path: bool,
    /// One of [`WIDTHS_PX`].
    pub(crate) width_px: u32,
    /// Mean FLIP that is good enough.
    pub(crate) tolerance: f64,
    /// The flicker instead of the error, if there is one.
    pub(crate) shows_flicker: bool,
    /// Begins with the first wish.
    worker: Option<Latest<Wish, ()>>,
    work: Option<Work>,
    measured: Option<Measured>,
    trouble: Option<String>,
}

/// Something about the chart.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ChartChange {
    AlongPath(bool),
    Width(u32),
    Tolerance(f64),
    ShowsFlicker(bool),
    Measure,
    Stop,
}

/// Of one scene, as it was looked at.
#[derive(Debug, Clone)]
struct Of {
    revision: Version,
    eye: OwnedEye,
    hour: f64,
    hidden: Hidden,
}

#[derive(Debug, Clone)]
enum OwnedEye {
    View { camera: Box<Camera>, clock_s: f64 },
    Path(Box<CameraPath>),
}

struct Measured {
    report: Report,
    of: Of,
    is_stale: bool,
}

struct Work {
    news: Receiver<Result<Report, String>>,
    progress: Arc<Watch>,
    /// Apart from the progress, since a picture of the truth, which it cuts short, tells its own.
    stop: Arc<Watch>,
    of: Of,
}

impl Drop for Work {
    fn drop(&mut self) {
        self.stop.cancel();
    }
}

struct Wish {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    of: Of,
    size: [u32; 2],
    /// Whether the window has a device that draws.
    has_device: bool,
    progress: Arc<Watch>,
    stop: Arc<Watch>,
    tell: Sender<Result<Report, String>>,
    context: egui::Context,
}

impl Default for Charting {
    fn default() -> Self {
        Self {
            along_path: false,
            width_px: WIDTHS_PX[0],
            tolerance: html::DEFAULT_TOLERANCE,
            shows_flicker: false,
            worker: None,
            work: None,
            measured: None,
            trouble: None,
        }
    }
}

impl Charting {
    /// How far the work is, 0 to 1, if it goes on.
    pub(crate) fn progress(&self) -> Option<f32> {
        self.work.as_ref().map(|work| work.progress.share())
    }

    /// What is known.
    pub(crate) fn report(&self) -> Option<&Report> {
        self.measured.as_ref().map(|measured| &measured.report)
    }

    /// Whether that is of another scene or view than the present one.
    pub(crate) fn is_stale(&self) -> bool {
        self.measured.as_ref().is_some_and(|measured| measured.is_stale)
    }

    /// Why the last try came to nothing.
    pub(crate) fn trouble(&self) -> Option<&str> {
        self.trouble.as_deref()
    }

    /// Another scene is open.
    pub(super) fn forget(&mut self) {
        (self.work, self.measured, self.trouble) = (None, None, None);
    }

    fn take_up_news(&mut self) {
        let Some(work) = &self.work else { return };
        loop {
            match work.news.try_recv() {
                Ok(Ok(report)) => {
                    self.measured = Some(Measured { report, of: work.of.clone(), is_stale: false });
                }
                Ok(Err(trouble)) => self.trouble = Some(trouble),
                Err(TryRecvError::Empty) => return,
                Err(TryRecvError::Disconnected) => break,
            }
        }
        self.work = None;
    }
}

impl Editor {
    /// Once a frame: what has been measured meanwhile, and whether it is still of what is seen.
    pub(super) fn keep_chart(&mut self, context: &egui::Context) {
        self.charting.take_up_news();
        if self.charting.work.is_some() {
            context.request_repaint_after(LOOK);
        }
        if let Some(mut measured) = self.charting.measured.take() {
            measured.is_stale = !self.still_looks_at(&measured.of);
            self.charting.measured = Some(measured);
        }
    }

    pub(super) fn change_chart(&mut self, change: ChartChange, context: &egui::Context) {
        let charting = &mut self.charting;
        match change {
            ChartChange::AlongPath(along_path) => charting.along_path = along_path,
            ChartChange::Width(width_px) => charting.width_px = width_px,
            ChartChange::Tolerance(tolerance) => charting.tolerance = tolerance,
            ChartChange::ShowsFlicker(flicker) => charting.shows_flicker = flicker,
            ChartChange::Measure => self.measure(context),
            ChartChange::Stop => charting.work = None,
        }
    }

    /// What would be measured now: the path, if there is one that leads anywhere, or the view.
    fn looked_at(&self, along_path: bool) -> Of {
        let Self { session, view, clock, .. } = self;
        let eye = match along_path.then(|| clock.path_to_fly(session.scene())).flatten() {
            Some(path) => OwnedEye::Path(Box::new(path.clone())),
            None => OwnedEye::View { camera: Box::new(self.camera().clone()), clock_s: self.forming_s() },
        };
        Of { revision: session.revision(), eye, hour: self.hour(), hidden: view.hidden_in(session.scene()) }
    }

    /// Whether that would be measured now as it was then. A path of the same revision is the same.
    fn still_looks_at(&self, of: &Of) -> bool {
        let Self { session, view, clock, .. } = self;
        let same_eye = || match &of.eye {
            OwnedEye::Path(path) => clock.path(session.scene()).is_some_and(|chosen| chosen.id == path.id),
            OwnedEye::View { camera, clock_s } => **camera == *self.camera() && *clock_s == self.forming_s(),
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
        if self.session.derived().clouds().iter().all(|cloud| cloud.sprites.is_empty()) {
            self.charting.trouble = Some("there are no sprites, so all methods draw the same".into());
            return;
        }
        let width_px = self.charting.width_px;
        let size = [width_px, (width_px as f32 / self.viewport.aspect()).round().max(1.0) as u32];
        let has_device = self.viewport.has_device();
        self.charting.trouble = begin(&mut self.charting, &self.session, of, size, has_device, context)
            .err()
            .map(|error| format!("the system gives no thread: {error}"));
    }
}

fn begin(
    charting: &mut Charting,
    session: &Session,
    of: Of,
    size: [u32; 2],
    has_device: bool,
    context: &egui::Context,
) -> std::io::Result<()> {
    let worker = match charting.worker.take() {
        Some(worker) => worker,
        None => {
            let wake = context.clone();
            let work = |wish: Wish| {
                if let Err(Ended::Trouble(trouble)) = measure(&wish) {
                    // Nobody may listen any more.
                    let _ = wish.tell.send(Err(trouble));
                }
            };
            Latest::start_beside_the_window("charting", work, move || wake.request_repaint())?
        }
    };
    let (tell, news) = channel();
    let (progress, stop) = (Arc::new(Watch::default()), Arc::new(Watch::default()));
    let (scene, derived, beside) = session.to_draw();
    let work = Work { news, progress: Arc::clone(&progress), stop: Arc::clone(&stop), of: of.clone() };
    let context = context.clone();
    worker.ask(Wish { scene, derived, beside, of, size, has_device, progress, stop, tell, context });
    charting.worker = Some(worker);
    charting.work = Some(work);
    Ok(())
}

/// Why there is no more to come.
enum Ended {
    Stopped,
    Trouble(String),
}

impl From<RenderError> for Ended {
    fn from(error: RenderError) -> Self {
        Self::Trouble(error.to_string())
    }
}

fn measure(wish: &Wish) -> Result<(), Ended> {
    let Wish { scene, derived, beside, of, size, has_device, progress, stop, tell, context } = wish;
    let (eye, clock_s) = match &of.eye {
        OwnedEye::View { camera, clock_s } => (Eye::Camera(camera), *clock_s),
        OwnedEye::Path(path) => (Eye::Path(path), 0.0),
    };
    let (atlas, meshes, hidden) = (beside.sheet(), beside.meshes(), &of.hidden);
    let subject = Subject { scene, derived, atlas, meshes, eye, size: *size, time_h: of.hour, clock_s, hidden };
    // Whoever has the CPU draw in the window wants no device opened.
    let asked = if *has_device { Vec::new() } else { choice::on_the_cpu() };
    let (easels, left_out) = choice::easels(&subject, &asked);
    let easels = easels.into_iter().map(|easel| easel.until(stop)).collect();
    let head = Report { size: *size, view: Some(eye.view()), left_out, ..Report::default() };
    let truth = Easel::new(subject, method::truth(), &AdapterChoice::Any)?.until(stop);
    let hear = |share| progress.reach(share);
    let mut run = Run::new(&subject, truth, easels, ROUNDS, head, &hear);
    let mut keep = |report: &Report| {
        if stop.is_cancelled() {
            return Err(Ended::Stopped);
        }
        let _ = tell.send(Ok(report.clone()));
        context.request_repaint();
        Ok(())
    };
    run.measure_errors(&mut keep)?;
    run.measure_costs(&mut keep)
}
