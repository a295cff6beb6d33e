//! The command line, one file a subcommand.
//!
//! Answers go to stdout, everything else to stderr. A failure is reported here, once, with what, where and what to do,
//! and its kind decides the exit code: 0 done, 1 problems found, 2 unusable input, 3 could not do it.

mod arguments;
mod chart;
mod check;
mod edit;
mod exchange;
mod export;
mod failure;
mod fit_light;
mod fly;
mod formats;
mod import;
mod info;
mod input;
mod misspelt;
mod new;
mod painter;
mod plugins;
mod progress;
mod render;
mod run;
pub mod schemas;
mod script_host;
mod table;
mod thin;
mod weather;

use crate::visible;
use clap::Parser;
use failure::Failure;
use std::ffi::OsString;
use std::io::{self, Write};
use std::process::ExitCode;
use table::{Arguments, Subcommand};

/// Does what `args` say (the first is the program's name), and tells how it went.
pub fn run(args: impl IntoIterator<Item = OsString>) -> ExitCode {
    crate::signals::fail_at_the_size_limit();
    let args: Vec<OsString> = args.into_iter().collect();
    let done = match (misspelt::check(&args), Arguments::try_parse_from(&args)) {
        (Err(failure), _) => Err(failure),
        (Ok(()), Ok(arguments)) => perform(&arguments),
        (Ok(()), Err(error)) => return refuse(error, &args),
    };
    match done {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure.lines().iter().for_each(|line| say(line));
            ExitCode::from(failure.exit_code())
        }
    }
}

fn perform(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.command {
        None => edit::run(arguments.scene.as_deref(), arguments.renderer),
        Some(Subcommand::New(arguments)) => new::run(arguments),
        Some(Subcommand::Render(arguments)) => render::run(arguments),
        Some(Subcommand::Fly(arguments)) => fly::run(arguments),
        Some(Subcommand::Chart(arguments)) => chart::run(arguments),
        Some(Subcommand::Check(arguments)) => check::run(arguments),
        Some(Subcommand::Info(arguments)) => info::run(arguments),
        Some(Subcommand::Export(arguments)) => export::run(arguments),
        Some(Subcommand::Formats(arguments)) => formats::run(arguments),
        Some(Subcommand::Import(arguments)) => import::run(arguments),
        Some(Subcommand::Thin(arguments)) => thin::run(arguments),
        Some(Subcommand::FitLight(arguments)) => fit_light::run(arguments),
        Some(Subcommand::Run(arguments)) => run::run(arguments),
        Some(Subcommand::Plugins(arguments)) => plugins::run(arguments),
        Some(Subcommand::Weather(arguments)) => weather::run(arguments),
        Some(Subcommand::ScriptHost) => script_host::run(),
    }
}

/// Help and version are answers, and go to stdout with code 0; all else is bad input with code 2.
fn refuse(error: clap::Error, args: &[OsString]) -> ExitCode {
    // clap quotes what it was given as it is; so it is asked once more, about the same where all can be seen.
    let visible = args.iter().map(|arg| visible::one_line(&arg.to_string_lossy()));
    let error = Arguments::try_parse_from(visible).err().unwrap_or(error);
    let _ = error.print();
    ExitCode::from(if error.use_stderr() { failure::UNUSABLE_INPUT } else { 0 })
}

/// Tells a person something in a line, beside the answer.
fn say(text: &str) {
    let _ = writeln!(io::stderr(), "{}", visible::one_line(text));
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
