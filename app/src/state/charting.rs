//! What each method costs and gets wrong in the open scene: measured off the frame, and shown as it comes.
//!
//! It is the measuring of `cloudwright chart` ([`Run`]), on all cores but the window's. What was measured stays until it
//! is measured anew; that the scene or the view has changed since is said, not hidden.

use super::Session;
use crate::chart::easel::Easel;
use crate::chart::report::Report;
use crate::chart::run::Run;
use crate::chart::subject::{Eye, Subject};
use crate::chart::{choice, html};
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

/// What is measured: one scene, as it is looked at.
#[derive(Debug, Clone)]
pub(crate) struct ChartSubject {
    /// Of the session.
    pub(crate) revision: Version,
    /// From where.
    pub(crate) eye: ChartEye,
    /// Of the day, hours.
    pub(crate) hour: f64,
    /// What is not drawn.
    pub(crate) hidden: Hidden,
}

/// Where a chart's pictures are seen from.
#[derive(Debug, Clone)]
pub(crate) enum ChartEye {
    View { camera: Box<Camera>, clock_s: f64 },
    Path(Box<CameraPath>),
}

struct Measured {
    report: Report,
    of: ChartSubject,
    is_stale: bool,
}

struct Work {
    news: Receiver<Result<Report, String>>,
    progress: Arc<Watch>,
    /// Apart from the progress, since a picture of the truth, which it cuts short, tells its own.
    stop: Arc<Watch>,
    of: ChartSubject,
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
    of: ChartSubject,
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
    pub(crate) fn forget(&mut self) {
        (self.work, self.measured, self.trouble) = (None, None, None);
    }

    /// Once a frame: takes up what has been measured meanwhile.
    pub(crate) fn keep_up(&mut self, context: &egui::Context) {
        self.take_up_news();
        if self.work.is_some() {
            context.request_repaint_after(LOOK);
        }
    }

    /// What the report is of.
    pub(crate) fn measured_of(&self) -> Option<&ChartSubject> {
        self.measured.as_ref().map(|measured| &measured.of)
    }

    /// Whether that is of another scene or view than the present one.
    pub(crate) fn set_stale(&mut self, is_stale: bool) {
        if let Some(measured) = &mut self.measured {
            measured.is_stale = is_stale;
        }
    }

    /// Measures that, off the frame, in pictures of `size` pixels; on the CPU alone unless the window `has_device`.
    pub(crate) fn measure(
        &mut self,
        session: &Session,
        of: ChartSubject,
        size: [u32; 2],
        has_device: bool,
        context: &egui::Context,
    ) {
        if session.derived().clouds().iter().all(|cloud| cloud.sprites.is_empty()) {
            self.trouble = Some("there are no sprites, so all methods draw the same".into());
            return;
        }
        self.trouble = self
            .begin(session, of, size, has_device, context)
            .err()
            .map(|error| format!("the system gives no thread: {error}"));
    }

    /// Ends the work. What was measured stays.
    pub(crate) fn stop(&mut self) {
        self.work = None;
    }

    fn begin(
        &mut self,
        session: &Session,
        of: ChartSubject,
        size: [u32; 2],
        has_device: bool,
        context: &egui::Context,
    ) -> std::io::Result<()> {
        let worker = match self.worker.take() {
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
        self.worker = Some(worker);
        self.work = Some(work);
        Ok(())
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
        ChartEye::View { camera, clock_s } => (Eye::Camera(camera), *clock_s),
        ChartEye::Path(path) => (Eye::Path(path), 0.0),
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
