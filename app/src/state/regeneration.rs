//! Clouds computed off the frame: one piece of work at a time, and the latest scene wins.
//!
//! Work that a newer scene overtook is cancelled, unless it is nearly done: a drag that asks at every frame then still
//! shows something now and then. The thread starts with the first work and has a pool of its own, which leaves a core
//! and the common pool to the window and its pictures.

use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::scene::Scene;
use cloudwright_core::watch::Watch;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Between two looks at how far the work is.
const LOOK: Duration = Duration::from_millis(100);
/// What will take no longer than this is worth finishing though it is overtaken.
const NEARLY_DONE: Duration = Duration::from_millis(500);

/// What the clouds are to become.
#[derive(Debug)]
pub(super) struct Request {
    pub(super) scene: Arc<Scene>,
    pub(super) before: Arc<Derived>,
    pub(super) change: Change,
}

#[derive(Debug, Default)]
pub(super) struct Regeneration {
    worker: Option<Latest<(Request, Arc<Watch>), Option<Derived>>>,
    in_hand: Option<InHand>,
    /// What is in hand, if anything, is overtaken.
    is_wanted: bool,
    since: Option<Instant>,
}

#[derive(Debug)]
struct InHand {
    watch: Arc<Watch>,
    begun: Instant,
}

impl InHand {
    fn is_worth_finishing(&self) -> bool {
        let (elapsed, share) = (self.begun.elapsed(), self.watch.share().max(1e-3));
        elapsed < LOOK || elapsed.mul_f32((1.0 - share) / share) < NEARLY_DONE
    }
}

impl Regeneration {
    /// There is much to do, and it is another than before.
    pub(super) fn want(&mut self) {
        if self.pending().is_none() {
            self.since = Some(Instant::now());
        }
        self.is_wanted = true;
    }

    /// Nothing is wanted any longer.
    pub(super) fn abandon(&mut self) {
        self.is_wanted = false;
        if let Some(work) = &self.in_hand {
            work.watch.cancel();
        }
    }

    /// Since when something is wanted, and how much of it is done.
    pub(super) fn pending(&self) -> Option<(Instant, f32)> {
        let going_on = self.in_hand.as_ref().filter(|work| !work.watch.is_cancelled());
        let share = going_on.map_or(0.0, |work| work.watch.share());
        self.since.filter(|_| self.is_wanted || going_on.is_some()).map(|since| (since, share))
    }

    /// What was computed, if it is still of use.
    pub(super) fn answer(&mut self) -> Option<Derived> {
        let answer = self.worker.as_ref()?.newest()?;
        let work = self.in_hand.take()?;
        answer.filter(|_| !work.watch.is_cancelled())
    }

    /// Sees that what is wanted gets done; has the window look again while anything is pending.
    pub(super) fn keep_up(&mut self, request: impl FnOnce() -> Request, context: &egui::Context) {
        match &self.in_hand {
            Some(work) if self.is_wanted && !work.is_worth_finishing() => work.watch.cancel(),
            None if self.is_wanted => self.begin(request(), context),
            _ => {}
        }
        if self.pending().is_some() {
            context.request_repaint_after(LOOK);
        }
    }

    fn begin(&mut self, request: Request, context: &egui::Context) {
        if self.worker.is_none() {
            let wake = context.clone();
            let work = |(request, watch): (Request, Arc<Watch>)| {
                request.before.plan(&request.scene, &request.change).place(&watch)
            };
            // Without a thread the clouds stay as they are, and the bar shows that they wait.
            self.worker = Latest::start_beside_the_window("clouds", work, move || wake.request_repaint()).ok();
        }
        if let Some(worker) = &self.worker {
            let watch = Arc::new(Watch::default());
            worker.ask((request, Arc::clone(&watch)));
            self.in_hand = Some(InHand { watch, begun: Instant::now() });
            self.is_wanted = false;
        }
    }
}

impl Drop for Regeneration {
    fn drop(&mut self) {
        self.abandon();
    }
}
