//! A progress bar on stderr for what takes over half a second, if a person is there to see it.

use crate::signals;
use cloudwright_core::watch::Watch;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::thread::JoinHandle;
use std::time::Duration;

const PATIENCE: Duration = Duration::from_millis(500);
const STEP: Duration = Duration::from_millis(100);
const PARTS: u32 = 1000;
const PLAIN: &str = "{spinner} {msg} {bar:30} {percent:>3} % {elapsed}";
/// Once it is known how far it has come.
const WITH_TIME_LEFT: &str = "{spinner} {msg} {bar:30} {percent:>3} % {elapsed}, {eta} left";

/// Runs until dropped.
pub(super) struct Progress {
    /// How far it is; not known as long as that is 0.
    watch: Arc<Watch>,
    /// Dropping it ends the thread.
    stop: Option<Sender<()>>,
    thread: Option<JoinHandle<()>>,
}

impl Progress {
    /// Begins a task; `what` stands beside the bar.
    pub(super) fn start(what: &str) -> Self {
        let watch = Arc::new(Watch::default());
        let mut progress = Self { watch: Arc::clone(&watch), stop: None, thread: None };
        if std::io::stderr().is_terminal() {
            let (stop, stopped) = channel::<()>();
            let what = what.to_owned();
            progress.stop = Some(stop);
            progress.thread = Some(std::thread::spawn(move || {
                if stopped.recv_timeout(PATIENCE) != Err(RecvTimeoutError::Timeout) {
                    return;
                }
                let bar = bar(&what);
                while stopped.recv_timeout(STEP) == Err(RecvTimeoutError::Timeout) {
                    let position = (watch.share() * PARTS as f32) as u64;
                    if position > 0 && bar.position() == 0 {
                        bar.set_style(style(WITH_TIME_LEFT));
                    }
                    bar.set_position(position);
                    bar.tick();
                }
                bar.finish_and_clear();
            }));
        }
        progress
    }

    /// Begins a task that ends early by itself once its watch is cancelled, as it is by Ctrl-C.
    pub(super) fn start_stoppable(what: &str) -> Self {
        let progress = Self::start(what);
        signals::set_when_told_to_end(&progress.watch.cancelled());
        progress
    }

    /// Says how far it has come, 0 to 1; from any thread.
    pub(super) fn set(&self, share: f32) {
        self.watch.reach(share);
    }

    /// For what tells itself how far it has come.
    pub(super) fn watch(&self) -> &Watch {
        &self.watch
    }
}

fn bar(what: &str) -> ProgressBar {
    let bar = ProgressBar::with_draw_target(Some(PARTS.into()), ProgressDrawTarget::stderr());
    bar.with_style(style(PLAIN)).with_message(what.to_owned())
}

fn style(template: &str) -> ProgressStyle {
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.stop = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
