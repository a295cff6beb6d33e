//! Work off the frame that a dialog began: how far it has come, and its end.

use crate::panel::Stage;
use crate::worker::Latest;
use cloudwright_core::exchange::Note;
use cloudwright_core::watch::Watch;
use std::sync::Arc;
use std::time::Duration;

/// Between two looks at how far it has come.
const LOOK: Duration = Duration::from_millis(100);

/// What is being worked on; it is stopped when this is dropped.
pub(super) struct Work<Request, Answer> {
    worker: Latest<Request, Answer>,
    watch: Arc<Watch>,
}

impl<Request, Answer> Drop for Work<Request, Answer> {
    fn drop(&mut self) {
        self.watch.cancel();
    }
}

/// How far it has come.
pub(super) enum Progress<Request, Answer> {
    /// It is being chosen; and why the last try came to nothing.
    Choosing(Option<String>),
    Working(Work<Request, Answer>),
    Done(Vec<String>, Vec<Note>),
}

impl<Request: Send + 'static, Answer: Send + 'static> Progress<Request, Answer> {
    /// Sets `work` to the request, on a thread of its own.
    pub(super) fn begin(
        request: Request,
        work: impl Fn(Request, &Watch) -> Answer + Send + 'static,
        context: &egui::Context,
    ) -> Self {
        let (wake, watch) = (context.clone(), Arc::new(Watch::default()));
        let of_work = Arc::clone(&watch);
        let work = move |request| work(request, &of_work);
        match Latest::start_beside_the_window("of a dialog", work, move || wake.request_repaint()) {
            Ok(worker) => {
                worker.ask(request);
                Self::Working(Work { worker, watch })
            }
            Err(error) => Self::Choosing(Some(format!("The system gives no thread: {error}."))),
        }
    }

    /// The answer, once.
    pub(super) fn answer(&self) -> Option<Answer> {
        match self {
            Self::Working(work) => work.worker.newest(),
            Self::Choosing(_) | Self::Done(..) => None,
        }
    }

    /// Has the work end soon; its answer says what came of it.
    pub(super) fn stop(&self) {
        if let Self::Working(work) = self {
            work.watch.cancel();
        }
    }

    pub(super) fn stage(&self, context: &egui::Context) -> Stage<'_> {
        match self {
            Self::Choosing(refusal) => Stage::Choosing(refusal.as_deref()),
            Self::Working(work) => {
                context.request_repaint_after(LOOK);
                Stage::Working(work.watch.share())
            }
            Self::Done(lines, notes) => Stage::Done(lines, notes),
        }
    }
}
