//! Something tried with values that change, off the frame: one try at a time, and the latest values win.
//!
//! A try that is overtaken may go on for a moment: so a slider that is dragged shows something of what is quick, and
//! nothing waits for what is not.

use crate::worker::Latest;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long a try may take although other values are wanted.
const GRACE: Duration = Duration::from_millis(150);
/// After so long it is worth telling that one goes on.
const NOTICED: Duration = Duration::from_millis(250);

/// What is done with a try: its answer, or none if it was cancelled.
pub(super) type Worker<Wanted, Answer> = Latest<Try<Wanted>, Option<Answer>>;

/// One try.
pub(super) struct Try<Wanted> {
    /// What it is of.
    pub(super) wanted: Wanted,
    /// Set once it is no longer wanted.
    pub(super) cancelled: Arc<AtomicBool>,
}

/// Tries of one thing with values that change.
pub(super) struct Trial<Wanted, Answer> {
    worker: Worker<Wanted, Answer>,
    running: Option<Running<Wanted>>,
    /// Of what the last try was that came to an end of its own.
    ended: Option<Wanted>,
}

struct Running<Wanted> {
    wanted: Wanted,
    cancelled: Arc<AtomicBool>,
    since: Instant,
}

impl<Wanted: Clone + PartialEq + Send + 'static, Answer: Send + 'static> Trial<Wanted, Answer> {
    pub(super) fn by(worker: Worker<Wanted, Answer>) -> Self {
        Self { worker, running: None, ended: None }
    }

    /// Once a frame: sees that `wanted` is tried, and hands over what a try has come to.
    pub(super) fn keep_up(&mut self, wanted: &Wanted, context: &egui::Context) -> Option<Answer> {
        let answer = self.worker.newest();
        if let Some(answer) = &answer {
            let tried = self.running.take().map(|running| running.wanted);
            self.ended = tried.filter(|_| answer.is_some());
        }
        match &self.running {
            Some(running) if running.wanted != *wanted => {
                let left = GRACE.saturating_sub(running.since.elapsed());
                if left.is_zero() {
                    running.cancelled.store(true, Ordering::Relaxed);
                } else {
                    context.request_repaint_after(left);
                }
            }
            Some(running) => context.request_repaint_after(NOTICED.saturating_sub(running.since.elapsed())),
            None if self.ended.as_ref() != Some(wanted) => self.begin(wanted),
            None => {}
        }
        answer.flatten()
    }

    fn begin(&mut self, wanted: &Wanted) {
        let cancelled = Arc::<AtomicBool>::default();
        self.worker.ask(Try { wanted: wanted.clone(), cancelled: Arc::clone(&cancelled) });
        self.running = Some(Running { wanted: wanted.clone(), cancelled, since: Instant::now() });
    }

    /// Whether what the last try came to is what `wanted` comes to.
    pub(super) fn is_of(&self, wanted: &Wanted) -> bool {
        self.ended.as_ref() == Some(wanted)
    }

    /// Whether a try has gone on for so long that it is worth telling.
    pub(super) fn takes_long(&self) -> bool {
        self.running.as_ref().is_some_and(|running| running.since.elapsed() >= NOTICED)
    }

    /// Nothing is wanted for now: a try that goes on ends, and the next one begins anew whatever it is of.
    pub(super) fn forget(&mut self) {
        self.cancel();
        self.ended = None;
    }
}

impl<Wanted, Answer> Trial<Wanted, Answer> {
    fn cancel(&self) {
        if let Some(running) = &self.running {
            running.cancelled.store(true, Ordering::Relaxed);
        }
    }
}

impl<Wanted, Answer> Drop for Trial<Wanted, Answer> {
    fn drop(&mut self) {
        self.cancel();
    }
}
