//! Plugins run: the one door through which window and command line have a script do something.
//!
//! Each run is a process of its own: this program once more, under a hidden subcommand, asked and heard by pipes. It holds
//! itself within bounds of the system's (`hold`), and is ended here: when it is no longer wanted, when patience ends, when
//! it says what is no answer, and in any case once it has answered. Whatever it does or dies of, a run is an outcome or
//! an error. The script's engine and what the two sides say are [`cloudwright_scripts::caged`]'s.

mod clock;
mod ended;
mod hold;
mod process;

pub(crate) use hold::hold;

use clock::Clock;
use cloudwright_core::scene::{Scene, Thing};
use cloudwright_scripts::caged::{self, Message};
use cloudwright_scripts::{Outcome, Patience, Plugin, ScriptError, Values};
use process::{Heard, Process};
use std::io;
use std::path::PathBuf;
use std::sync::OnceLock;
use std::sync::atomic::Ordering;
use std::time::{Duration, Instant};

/// So long passes between two looks at who waits.
const LOOK: Duration = Duration::from_millis(10);

/// What a run starts from.
#[derive(Debug, Clone, Copy)]
pub struct Request<'a> {
    /// Whose run.
    pub plugin: &'a Plugin,
    /// The scene as it is.
    pub scene: &'a Scene,
    /// What is selected in it.
    pub selected: &'a [Thing],
    /// What was chosen.
    pub values: &'a Values,
}

/// Has the plugin say what is to be done; blocks until it has, or `patience` ends.
///
/// # Errors
/// As [`Plugin::run`]; and if the process dies or can't be started.
pub fn run(request: Request<'_>, patience: &Patience) -> Result<Outcome, ScriptError> {
    match HOST.get() {
        Some(host) => host.run(request, patience),
        None => Host::this_program().map_err(|error| not_started(&error))?.run(request, patience),
    }
}

/// The program that a run is a process of.
#[derive(Debug, Clone)]
pub struct Host(PathBuf);

static HOST: OnceLock<Host> = OnceLock::new();

/// Has all runs be processes of `host`: for programs that have no such subcommand, as tests. The first call counts.
pub fn use_host(host: Host) {
    let _ = HOST.set(host);
}

impl Host {
    /// A program that takes the subcommand, as `cloudwright` does.
    pub fn at(program: impl Into<PathBuf>) -> Self {
        Self(program.into())
    }

    fn this_program() -> io::Result<Self> {
        // There it means the program that runs, even if its file has been replaced by a newer one meanwhile.
        if cfg!(target_os = "linux") { Ok(Self::at("/proc/self/exe")) } else { std::env::current_exe().map(Self) }
    }

    /// As [`run`], by a process of this program.
    ///
    /// # Errors
    /// As [`run`].
    pub fn run(&self, request: Request<'_>, patience: &Patience) -> Result<Outcome, ScriptError> {
        let Request { plugin, scene, selected, values } = request;
        let left = patience.until.map(|until| until.saturating_duration_since(Instant::now()));
        let mut process = Process::start(&self.0).map_err(|error| not_started(&error))?;
        // While it starts.
        process.ask(caged::request(plugin, scene, selected, values, left)?).map_err(|error| not_started(&error))?;
        let mut clock = Clock::start(left);
        loop {
            if patience.cancelled.load(Ordering::Relaxed) {
                return Err(ScriptError::stopped());
            }
            if let Some(error) = clock.over() {
                return Err(error);
            }
            match process.hear(LOOK) {
                None => {}
                Some(Heard::Line(line)) => match Message::read(&line)? {
                    Message::Time(whose) => clock.is(whose),
                    Message::Ended(done) => return done,
                },
                Some(Heard::TooMuch) => return Err(ScriptError::broken("the script's host answers without end")),
                Some(Heard::Nothing) => return Err(process.end()),
            }
        }
    }
}

fn not_started(error: &io::Error) -> ScriptError {
    let hint = "start Cloudwright anew, if it has been moved or replaced";
    ScriptError { hint: hint.into(), ..ScriptError::broken(format!("the script's host can't be started: {error}")) }
}
