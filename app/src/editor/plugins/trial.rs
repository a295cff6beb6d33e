//! A plugin tried with values that change, off the frame: one run at a time, and the latest values win.
//!
//! A run that is overtaken may go on for a moment: so a slider that is dragged shows something of a plugin that is quick,
//! and nothing waits for one that is not.

use crate::scripting::{self, Request};
use crate::state::Item;
use crate::worker::Latest;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::{Fault, Outcome, Patience, Plugin, ScriptError, Values};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long a run may take although other values are wanted.
const GRACE: Duration = Duration::from_millis(150);
/// After so long it is worth telling that one goes on.
const NOTICED: Duration = Duration::from_millis(250);

/// Runs of one plugin on one scene.
pub(super) struct Trial {
    worker: Latest<Job, Result<Outcome, ScriptError>>,
    scene: Arc<Scene>,
    selected: Arc<[Item]>,
    running: Option<Running>,
    /// Of what the last run was that came to an end of its own.
    ended: Option<Tried>,
}

/// What a run is of.
#[derive(Clone)]
struct Tried {
    plugin: Arc<Plugin>,
    values: Values,
}

struct Job {
    tried: Tried,
    scene: Arc<Scene>,
    selected: Arc<[Item]>,
    cancelled: Arc<AtomicBool>,
}

struct Running {
    tried: Tried,
    cancelled: Arc<AtomicBool>,
    since: Instant,
}

impl PartialEq for Tried {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.plugin, &other.plugin) && self.values == other.values
    }
}

impl Trial {
    /// Of `scene`, in which those things are selected.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(super) fn start(scene: Arc<Scene>, selected: &[Item], context: &egui::Context) -> std::io::Result<Self> {
        let wake = context.clone();
        let work = |Job { tried: Tried { plugin, values }, scene, selected, cancelled }: Job| {
            // It counts from when the run begins.
            let patience = Patience { cancelled, ..Patience::usual() };
            scripting::run(Request { plugin: &plugin, scene: &scene, selected: &selected, values: &values }, &patience)
        };
        let worker = Latest::start("plugin", work, move || wake.request_repaint())?;
        Ok(Self { worker, scene, selected: selected.into(), running: None, ended: None })
    }

    /// The scene that all runs begin with.
    pub(super) fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// Once a frame: sees that `plugin` is tried with `values`, and hands over what a run has come to.
    pub(super) fn keep_up(
        &mut self,
        plugin: &Arc<Plugin>,
        values: &Values,
        context: &egui::Context,
    ) -> Option<Result<Outcome, ScriptError>> {
        let mut answer = self.worker.newest();
        if answer.is_some() {
            let tried = self.running.take().map(|running| running.tried);
            answer = answer.filter(|answer| !matches!(answer, Err(error) if error.fault == Fault::Cancelled));
            self.ended = if answer.is_some() { tried } else { None };
        }
        let wanted = Tried { plugin: Arc::clone(plugin), values: values.clone() };
        match &self.running {
            Some(Running { tried, cancelled, since }) if *tried != wanted => {
                let left = GRACE.saturating_sub(since.elapsed());
                if left.is_zero() {
                    cancelled.store(true, Ordering::Relaxed);
                } else {
                    context.request_repaint_after(left);
                }
            }
            Some(Running { since, .. }) => context.request_repaint_after(NOTICED.saturating_sub(since.elapsed())),
            None if self.ended.as_ref() != Some(&wanted) => self.begin(wanted),
            None => {}
        }
        answer
    }

    fn begin(&mut self, tried: Tried) {
        let cancelled = Arc::<AtomicBool>::default();
        self.worker.ask(Job {
            tried: tried.clone(),
            scene: Arc::clone(&self.scene),
            selected: Arc::clone(&self.selected),
            cancelled: Arc::clone(&cancelled),
        });
        self.running = Some(Running { tried, cancelled, since: Instant::now() });
    }

    /// Whether what the last run came to is what those values come to.
    pub(super) fn is_of(&self, plugin: &Arc<Plugin>, values: &Values) -> bool {
        let is_it = |tried: &Tried| Arc::ptr_eq(&tried.plugin, plugin) && tried.values == *values;
        self.ended.as_ref().is_some_and(is_it)
    }

    /// Whether a run has gone on for so long that it is worth telling.
    pub(super) fn takes_long(&self) -> bool {
        self.running.as_ref().is_some_and(|running| running.since.elapsed() >= NOTICED)
    }

    /// The next values are tried even if they are those of the last run.
    pub(super) fn forget(&mut self) {
        self.ended = None;
    }
}

impl Drop for Trial {
    fn drop(&mut self) {
        if let Some(running) = &self.running {
            running.cancelled.store(true, Ordering::Relaxed);
        }
    }
}
