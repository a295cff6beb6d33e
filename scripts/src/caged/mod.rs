//! A run in a process of its own: what its two sides say to each other, as bytes.
//!
//! One line of JSON goes in, the `Request`: scene, script, selection, values. Lines come back, a [`Message`] each:
//! whose time passes, and at last the outcome or the error. JSON, as all of it is a file's already and its floats come
//! back to the bit. There are no processes here: who starts one, holds it and ends it is the program's business.
//!
//! What a plugin says of itself is read without a process ([`Plugin::read`]): nothing runs then, and what a parser does
//! with a text is bounded by the text: its size, its depth, a stack that holds that depth, and the clock.

mod bounded;

use crate::error::ScriptError;
use crate::host::{Outcome, Plugin};
use crate::limits::{ANSWER_BYTES, Hears, Patience, TimeOf};
use crate::parameter::Values;
use bounded::Bounded;
use cloudwright_core::scene::{Scene, Thing};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;
use std::io::Write;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// What a run starts from.
#[derive(Debug, Serialize, Deserialize)]
struct Request<'a> {
    source: Cow<'a, str>,
    scene: Cow<'a, Scene>,
    selected: Cow<'a, [Thing]>,
    values: Cow<'a, Values>,
    /// How long the script may take.
    left: Option<Duration>,
}

/// What a process says.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Message {
    /// Whose time it is from now on. Before the first one, the process has not begun.
    Time(TimeOf),
    /// How it ended; nothing comes after that.
    Ended(Result<Outcome, ScriptError>),
}

/// What to hand to a process: a line that ends in its newline. The script may take as long as is `left`.
///
/// # Errors
/// If the scene has what no file can say, as NaN.
pub fn request(
    plugin: &Plugin,
    scene: &Scene,
    selected: &[Thing],
    values: &Values,
    left: Option<Duration>,
) -> Result<Vec<u8>, ScriptError> {
    let request = Request {
        source: plugin.source.as_str().into(),
        scene: Cow::Borrowed(scene),
        selected: selected.into(),
        values: Cow::Borrowed(values),
        left,
    };
    let mut line = serde_json::to_vec(&request)
        .map_err(|error| ScriptError::broken(format!("the scene can't be told: {error}")))?;
    line.push(b'\n');
    Ok(line)
}

impl Message {
    /// What a line says.
    ///
    /// # Errors
    /// If it is none of ours.
    pub fn read(line: &[u8]) -> Result<Self, ScriptError> {
        serde_json::from_slice(line)
            .map_err(|error| ScriptError::broken(format!("the script's host answers what can't be read: {error}")))
    }

    /// A line, if it is not too long for whoever reads it.
    fn line(&self) -> Option<Vec<u8>> {
        let mut line = Bounded::new(ANSWER_BYTES);
        serde_json::to_writer(&mut line, self).ok()?;
        line.write_all(b"\n").ok()?;
        Some(line.into())
    }
}

/// The process's side: does what the line `request` asks for, and says so to `output`. A reader that is gone is no fault.
pub fn serve(request: Vec<u8>, output: impl Write + Send + 'static) {
    let output = Arc::new(Mutex::new(output));
    let say = move |message: &Message| {
        let line = message.line().or_else(|| {
            let hint = "change fewer things at once, or smaller ones";
            let error = ScriptError::limit(format!("the script asks for more than {} MiB", ANSWER_BYTES >> 20), hint);
            Message::Ended(Err(error)).line()
        });
        let mut output = output.lock().unwrap_or_else(PoisonError::into_inner);
        let _ = line.map(|line| output.write_all(&line).and_then(|()| output.flush()));
    };
    let say = Arc::new(say);
    let told = Arc::clone(&say);
    let ended = run(request, &(Arc::new(move |whose| told(&Message::Time(whose))) as Hears));
    say(&Message::Ended(ended));
}

fn run(request: Vec<u8>, hears: &Hears) -> Result<Outcome, ScriptError> {
    let Request { source, scene, selected, values, left } = serde_json::from_slice(&request)
        .map_err(|error| ScriptError::broken(format!("the script's host is asked what can't be read: {error}")))?;
    drop(request);
    hears(TimeOf::Script);
    let patience = Patience { cancelled: Arc::default(), until: left.map(|left| Instant::now() + left) };
    Plugin::read(&source)?.run_heard(&scene, &selected, &values, &patience, hears)
}

#[cfg(test)]
mod tests;
