//! `cloudwright script-host`: what the program starts itself as, to run one plugin in a process of its own.
//!
//! It holds itself first, reads one request from stdin, answers on stdout and ends. When stdin closes, nobody waits for it.

use super::failure::Failure;
use crate::scripting;
use cloudwright_core::formats::scene_file;
use cloudwright_scripts::caged;
use std::io::{self, BufRead, Read};

/// Of a request: a scene's file at its largest, and as much again for what goes with it.
const MOST_BYTES: u64 = 2 * scene_file::MAX_BYTES as u64;

pub(super) fn run() -> Result<(), Failure> {
    let held = scripting::hold();
    held.map_err(|error| Failure::could_not(format!("the system sets no bounds: {error}"), "no script is run"))?;
    let mut request = Vec::new();
    let read = io::stdin().lock().take(MOST_BYTES).read_until(b'\n', &mut request);
    if read.is_err() || !request.ends_with(b"\n") {
        return Err(Failure::argument("there is no request", "cloudwright starts this itself; write cloudwright run"));
    }
    // Not joined: it waits as long as somebody waits for the answer.
    let left = std::thread::Builder::new().name("stdin".into()).spawn(|| {
        let _ = io::copy(&mut io::stdin(), &mut io::sink());
        std::process::exit(super::failure::COULD_NOT.into());
    });
    left.map_err(|error| Failure::could_not(format!("there is no thread: {error}"), "no script is run"))?;
    caged::serve(request, io::stdout());
    Ok(())
}
