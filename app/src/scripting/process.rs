//! A process, its three pipes, and its end.
//!
//! Each pipe has a thread, so that neither side ever waits for the other to read. Nobody waits for these threads: what
//! holds a pipe's other end open can't hold a run up.

use super::ended;
use cloudwright_scripts::ScriptError;
use cloudwright_scripts::limits::ANSWER_BYTES;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::thread;
use std::time::{Duration, Instant};

/// What starts it as a script's host; see `cli/script_host.rs`.
pub(crate) const SUBCOMMAND: &str = "script-host";

/// Lines that wait to be heard.
const LINES_AHEAD: usize = 4;
/// Of what it says beside the answer.
const ERROR_BYTES: u64 = 16 << 10;
/// One that has stopped answering has so long to end by itself, which tells why; and what it said so long to arrive.
const TO_DIE: Duration = Duration::from_millis(500);
const STEP: Duration = Duration::from_millis(2);
/// Where the system's loader finds libraries, and what Windows starts no program without: all that it gets to know.
const VARIABLES: [&str; 2] = ["LD_LIBRARY_PATH", "SystemRoot"];

/// What comes out of it.
#[derive(Debug)]
pub(super) enum Heard {
    /// One line, with its newline.
    Line(Vec<u8>),
    /// More than any answer has.
    TooMuch,
    /// It says nothing any more.
    Nothing,
}

/// A process, which ends with this value.
#[derive(Debug)]
pub(super) struct Process {
    child: Child,
    heard: Receiver<Heard>,
    errors: Receiver<Vec<u8>>,
    stdin: Option<ChildStdin>,
    /// Its stdin is open as long as this is: so it knows that somebody waits for it.
    open: Option<Sender<()>>,
    /// It has ended; until then what it said last may still arrive.
    silent_until: Option<Instant>,
}

impl Process {
    /// # Errors
    /// If the system does not start it.
    pub(super) fn start(program: &Path) -> io::Result<Self> {
        let mut command = Command::new(program);
        command.arg(SUBCOMMAND).env_clear();
        command.envs(VARIABLES.iter().filter_map(|name| Some((name, std::env::var_os(name)?))));
        // With a heap of its own for each thread, a machine of many cores had no addresses left.
        command.env("MALLOC_ARENA_MAX", "2");
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        #[cfg(unix)]
        {
            use std::os::unix::process::CommandExt;
            // Ctrl-C is for who waits, and who then ends it.
            command.arg0("cloudwright").process_group(0);
        }
        let mut child = command.spawn()?;
        let (say, heard) = sync_channel(LINES_AHEAD);
        let (fail, errors) = channel();
        let (stdin, stdout, stderr) = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let process = Self { child, heard, errors, stdin, open: None, silent_until: None };
        if let Some(stdout) = stdout {
            thread("script's answer", move || listen(stdout, &say))?;
        }
        if let Some(stderr) = stderr {
            thread("script's errors", move || collect(stderr, &fail))?;
        }
        Ok(process)
    }

    /// Hands it `request`, once.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(super) fn ask(&mut self, request: Vec<u8>) -> io::Result<()> {
        let Some(mut stdin) = self.stdin.take() else { return Ok(()) };
        let (open, opened) = channel();
        self.open = Some(open);
        thread("script's request", move || {
            // One that does not read says so by what it answers.
            let _ = stdin.write_all(&request).and_then(|()| stdin.flush());
            let _ = opened.recv();
        })
    }

    /// What it says next, if it says so in time.
    pub(super) fn hear(&mut self, within: Duration) -> Option<Heard> {
        match self.heard.recv_timeout(within) {
            Ok(heard) => Some(heard),
            Err(RecvTimeoutError::Disconnected) => Some(Heard::Nothing),
            // Its pipe may be held open by what it has left behind.
            Err(RecvTimeoutError::Timeout) => match (self.silent_until, self.child.try_wait()) {
                (None, Ok(Some(_))) => {
                    self.silent_until = Some(Instant::now() + TO_DIE);
                    None
                }
                (Some(until), _) if Instant::now() >= until => Some(Heard::Nothing),
                _ => None,
            },
        }
    }

    /// Why one that says nothing any more has ended.
    pub(super) fn end(mut self) -> ScriptError {
        let status = self.wait(TO_DIE);
        let _ = self.child.kill();
        let errors = self.errors.recv_timeout(TO_DIE).unwrap_or_default();
        ended::why(status, &String::from_utf8_lossy(&errors))
    }

    /// How it ended by itself, if it does in time.
    fn wait(&mut self, within: Duration) -> Option<ExitStatus> {
        let until = Instant::now() + within;
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Some(status),
                Ok(None) if Instant::now() < until => thread::sleep(STEP),
                _ => return None,
            }
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // No zombie is left: one that is killed ends, and one that has ended is heard of.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn thread(name: &str, work: impl FnOnce() + Send + 'static) -> io::Result<()> {
    thread::Builder::new().name(name.into()).spawn(work).map(drop)
}

/// Its lines, until it says nothing any more or nobody hears.
fn listen(stdout: impl Read, say: &SyncSender<Heard>) {
    // The answer is one line of many; the others are short and few.
    let mut lines = BufReader::with_capacity(64 << 10, stdout.take(ANSWER_BYTES as u64 + (64 << 10)));
    loop {
        let mut line = Vec::new();
        let read = lines.read_until(b'\n', &mut line);
        let heard = match read {
            Ok(_) if line.ends_with(b"\n") => Heard::Line(line),
            Ok(_) if lines.get_ref().limit() == 0 => Heard::TooMuch,
            _ => Heard::Nothing,
        };
        let is_last = !matches!(heard, Heard::Line(_));
        if say.send(heard).is_err() || is_last {
            return;
        }
    }
}

/// What it says beside the answer; the rest is read and forgotten, as it would wait for a reader.
fn collect(mut stderr: impl Read, fail: &Sender<Vec<u8>>) {
    let mut errors = Vec::new();
    let _ = stderr.by_ref().take(ERROR_BYTES).read_to_end(&mut errors);
    let _ = fail.send(errors);
    let _ = io::copy(&mut stderr, &mut io::sink());
}
