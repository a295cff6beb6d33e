//! Files of other programs, out and in: asked for, worked off the frame, and one undo point or nothing.

mod arriving;
mod leaving;

pub(super) use arriving::Arriving;
pub(super) use leaving::Leaving;

use crate::panel::Stage;
use crate::worker::Latest;
use cloudwright_core::exchange::Note;
use cloudwright_core::watch::Watch;
use std::sync::Arc;
use std::time::Duration;

/// Between two looks at how far it has come.
const LOOK: Duration = Duration::from_millis(100);

/// What is being worked on; it is stopped when this is dropped.
struct Work<Request, Answer> {
    worker: Latest<Request, Answer>,
    watch: Arc<Watch>,
}

impl<Request, Answer> Drop for Work<Request, Answer> {
    fn drop(&mut self) {
        self.watch.cancel();
    }
}

/// How far it has come.
enum Progress<Request, Answer> {
    /// It is being chosen; and why the last try came to nothing.
    Choosing(Option<String>),
    Working(Work<Request, Answer>),
    Done(Vec<String>, Vec<Note>),
}

impl<Request: Send + 'static, Answer: Send + 'static> Progress<Request, Answer> {
    /// Sets `work` to the request, on a thread of its own.
    fn begin(
        request: Request,
        work: impl Fn(Request, &Watch) -> Answer + Send + 'static,
        context: &egui::Context,
    ) -> Self {
        let (wake, watch) = (context.clone(), Arc::new(Watch::default()));
        let of_work = Arc::clone(&watch);
        let work = move |request| work(request, &of_work);
        match Latest::start_beside_the_window("exchange", work, move || wake.request_repaint()) {
            Ok(worker) => {
                worker.ask(request);
                Self::Working(Work { worker, watch })
            }
            Err(error) => Self::Choosing(Some(format!("The system gives no thread: {error}."))),
        }
    }

    /// The answer, once.
    fn answer(&self) -> Option<Answer> {
        match self {
            Self::Working(work) => work.worker.newest(),
            Self::Choosing(_) | Self::Done(..) => None,
        }
    }

    fn stage(&self, context: &egui::Context) -> Stage<'_> {
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
