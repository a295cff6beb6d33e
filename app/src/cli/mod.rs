//! The command line, one file a subcommand.
//!
//! Answers go to stdout, everything else to stderr. A failure is reported here, once, with what, where and what to do,
//! and its kind decides the exit code: 0 done, 1 problems found, 2 unusable input, 3 could not do it.

mod arguments;
mod chart;
mod check;
mod edit;
mod export;
mod failure;
mod fly;
mod info;
mod input;
mod new;
mod painter;
mod progress;
mod render;
mod table;
mod thin;

use clap::Parser;
use failure::Failure;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;
use table::{Arguments, Subcommand};

/// Does what `args` say (the first is the program's name), and tells how it went.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    crate::signals::fail_at_the_size_limit();
    let arguments = match Arguments::try_parse_from(args) {
        Ok(arguments) => arguments,
        Err(error) => {
            // Help and version are answers, and go to stdout with code 0; all else is bad input with code 2.
            let _ = error.print();
            return ExitCode::from(if error.use_stderr() { failure::UNUSABLE_INPUT } else { 0 });
        }
    };
    let done = match &arguments.command {
        None => edit::run(arguments.scene.as_deref(), arguments.renderer),
        Some(Subcommand::New(arguments)) => new::run(arguments),
        Some(Subcommand::Render(arguments)) => render::run(arguments),
        Some(Subcommand::Fly(arguments)) => fly::run(arguments),
        Some(Subcommand::Chart(arguments)) => chart::run(arguments),
        Some(Subcommand::Check(arguments)) => check::run(arguments),
        Some(Subcommand::Info(arguments)) => info::run(arguments),
        Some(Subcommand::Export(arguments)) => export::run(arguments),
        Some(Subcommand::Thin(arguments)) => thin::run(arguments),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            let text = failure.to_string();
            if !text.is_empty() {
                say(&text);
            }
            ExitCode::from(failure.exit_code())
        }
    }
}

/// Tells a person something, beside the answer.
fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{text}");
}

/// Writes the answer to stdout.
fn answer(text: &str) -> Result<(), Failure> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        // Whoever read it has read enough: `cloudwright info … | head`.
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Stdout(error)),
        _ => Ok(()),
    }
}
