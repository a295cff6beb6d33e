//! What each method costs and gets wrong in the open scene: measured off the frame, and shown as it comes.
//!
//! It is the measuring of `cloudwright chart` ([`Run`]), on all cores but the window's. What was measured stays until it
//! is measured anew; that the scene or the view has changed since is said, not hidden.

use super::Session;
use crate::chart::charted::Charted;
use crate::chart::report::Report;
use crate::chart::run::Run;
use crate::chart::subject::Subject;
use crate::chart::{choice, html};
use crate::opening::Beside;
use crate::renderer::RenderError;
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::method;
use cloudwright_core::scene::{CameraPath, Scene};
use cloudwright_core::sight::Sight;
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
    /// Begins with the first request.
    worker: Option<Latest<Request, ()>>,
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
    /// As in [`Subject`].
    pub(crate) sight: Sight,
    /// The flight; none for the view as it stands.
    pub(crate) path: Option<CameraPath>,
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

struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    of: ChartSubject,
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

    /// Measures that, off the frame; on the CPU alone unless the window `has_device`.
    pub(crate) fn measure(&mut self, session: &Session, of: ChartSubject, has_device: bool, context: &egui::Context) {
        if session.derived().clouds().iter().all(|cloud| cloud.sprites.is_empty()) {
            self.trouble = Some("there are no sprites, so all methods draw the same".into());
            return;
        }
        self.trouble = self
            .begin(session, of, has_device, context)
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
        has_device: bool,
        context: &egui::Context,
    ) -> std::io::Result<()> {
        let worker = match self.worker.take() {
            Some(worker) => worker,
            None => {
                let wake = context.clone();
                let work = |request: Request| {
                    if let Err(Ended::Trouble(trouble)) = measure(&request) {
                        // Nobody may listen any more.
                        let _ = request.tell.send(Err(trouble));
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
        worker.ask(Request { scene, derived, beside, of, has_device, progress, stop, tell, context });
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

fn measure(request: &Request) -> Result<(), Ended> {
    let Request { scene, derived, beside, of, has_device, progress, stop, tell, context } = request;
    let subject = Subject { scene, derived, atlas: beside.sheet(), sight: &of.sight, path: of.path.as_ref() };
    // Whoever has the CPU draw in the window wants no device opened.
    let asked = if *has_device { Vec::new() } else { choice::on_the_cpu() };
    let (charted, left_out) = choice::charted(&subject, &asked);
    let charted = charted.into_iter().map(|one| one.until(stop)).collect();
    let head = Report { size: of.sight.size, view: Some(subject.view()), left_out, ..Report::default() };
    let truth = Charted::new(subject, method::truth(), &AdapterChoice::Any)?.until(stop);
    let hear = |share| progress.reach(share);
    let mut run = Run::new(&subject, truth, charted, ROUNDS, head, &hear);
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
