//! The hostile scripts, each through a process: stopped in time with its message, and within the bound of memory.

use crate::{host, run_by};
use cloudwright_scripts::{Fault, Patience, Plugin, ScriptError};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// For what would be told in time on a machine that is not busy, and for what must be held without a clock.
const LONG: Duration = Duration::from_secs(60);
/// What a script may take, and what the process may take to start and to end on a busy machine.
const MOST: Duration = Duration::from_millis(2_000 + 1_500);

fn scripts(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/hostile").join(folder);
    let entries = fs::read_dir(folder).expect("a folder").flatten().map(|entry| entry.path());
    let mut paths: Vec<PathBuf> = entries.filter(|path| path.extension().is_some_and(|end| end == "rhai")).collect();
    paths.sort();
    paths
}

fn refused(source: &str, patience: Duration) -> Result<(), ScriptError> {
    let plugin = Plugin::read(source)?;
    let patience = Patience { until: Some(Instant::now() + patience), ..Patience::usual() };
    run_by(&host(), &plugin, &patience).map(drop)
}

fn told(said: &Result<(), ScriptError>) -> String {
    said.as_ref().map_or_else(ToString::to_string, |()| "it went through".into())
}

/// Whether `text` has all parts of `wanted`, which `;` divides; or those of one of its alternatives, which ` | ` does.
fn says(wanted: &str, text: &str) -> bool {
    wanted.split(" | ").any(|one| one.split(';').all(|part| text.contains(part.trim())))
}

#[allow(clippy::print_stdout, reason = "what it measured is to be read")]
fn check(folder: &str, at_least: usize) {
    let (mut table, mut wrong, mut count) = (String::new(), String::new(), 0);
    for path in scripts(folder) {
        let source = fs::read_to_string(&path).expect("text");
        let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
        let wanted = source.lines().next().and_then(|line| line.strip_prefix("// expect: ")).expect("what it must say");
        #[cfg(target_os = "linux")]
        let watch = crate::watched::Watch::start();
        let start = Instant::now();
        let mut said = refused(&source, Patience::USUAL);
        let took = start.elapsed();
        // Time is what ends it here; with more of that, what it asks for must.
        if says("takes too long", &told(&said)) && !says(wanted, &told(&said)) {
            said = refused(&source, LONG);
        }
        #[cfg(target_os = "linux")]
        let seen = watch.end();
        count += 1;
        let text = told(&said);
        match said {
            Err(error) if error.fault != Fault::Broken && says(wanted, &text) => {}
            _ => wrong += &format!("{name}: no “{wanted}” in: {text}\n"),
        }
        if took > MOST {
            wrong += &format!("{name}: took {took:?}\n");
        }
        let _ = write!(table, "{name:<30}{:>6} ms", took.as_millis());
        #[cfg(target_os = "linux")]
        {
            let most = cloudwright_scripts::limits::MEMORY_BYTES as u64;
            let _ =
                write!(table, "{:>6} MiB held{:>6} MiB reserved", seen.resident_kib >> 10, seen.addresses_kib >> 10);
            if seen.bound == most && (seen.addresses_kib << 10 > most || seen.files.is_some_and(|files| files > 0)) {
                wrong += &format!("{name}: {seen:?}\n");
            }
        }
        let _ = writeln!(table, "   {}", text.chars().take(110).collect::<String>());
    }
    println!("{table}");
    assert!(wrong.is_empty(), "{wrong}");
    assert!(count >= at_least, "{count}");
}

#[test]
fn what_one_thread_stops_a_process_stops() {
    let _alone = crate::alone();
    check("", 60);
}

#[test]
fn what_fills_memory_or_the_stack_ends_a_process_and_not_its_caller() {
    let _alone = crate::alone();
    check("caged", 15);
    #[cfg(target_os = "linux")]
    assert!(crate::watched::children().iter().all(|(_, state)| *state != 'Z'), "{:?}", crate::watched::children());
}
