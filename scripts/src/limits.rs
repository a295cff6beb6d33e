//! What a script may use, and how long it may take: all limits said here, none left to the engine's defaults.
//!
//! The engine's limits bound single values and steps, neither memory in all nor the stack. A run has a thread with a
//! stack of its own (`STACK_BYTES`) that holds what these limits let through; memory in all is bounded by the process
//! that it runs in ([`crate::caged`], [`MEMORY_BYTES`]).

use rhai::{Engine, LexError, Token};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// Longer scripts are refused before they are parsed.
pub const SOURCE_BYTES: usize = 256 << 10;
/// For lists in lists as deep as the limit on a list's items lets them be, when they are walked and dropped.
pub(crate) const STACK_BYTES: usize = 512 << 20;
/// Items of a list, those of lists in it included.
pub const LIST_ITEMS: usize = 20_000;
/// Things that one run may add or change.
pub const EDITS: usize = 50_000;
/// Keys that one run may set.
pub const KEYS: usize = 100_000;
/// Lines that one run may print.
pub const PRINTED_LINES: usize = 1_000;
/// Letters of each that are kept.
pub const PRINTED_LETTERS: usize = 1_000;
/// Of all texts that one run makes for files.
pub const EXPORTED_BYTES: usize = 64 << 20;
/// Of what a process answers: the longest text for a file, each of its letters written as two.
pub const ANSWER_BYTES: usize = 2 * EXPORTED_BYTES;
/// Of all that a process which runs a script has, as address space: the stack; a longest text as it grows, is joined and
/// is written into the answer, four times the largest answer in all; and as much again for the program itself, its
/// threads, a scene with its sprites and what the script keeps.
pub const MEMORY_BYTES: usize = STACK_BYTES + 8 * ANSWER_BYTES;

const OPERATIONS: u64 = 200_000_000;
const CALL_LEVELS: usize = 48;
/// Of expressions at the top and in functions.
const DEPTHS: [usize; 2] = [64, 48];
const VARIABLES: usize = 256;
const FUNCTIONS: usize = 256;
const TEXT_BYTES: usize = 64 << 10;
/// Fields of a map, or of all maps in a list.
const MAP_FIELDS: usize = 10_000;
/// What the parser may take: it compares each parameter of a function with all before it.
const READING: Duration = Duration::from_secs(2);
/// So many steps pass between two looks at the clock.
const STEPS_A_LOOK: u64 = 256;

/// How long whoever asked for a run will wait.
#[derive(Debug, Clone)]
pub struct Patience {
    /// Set by whoever no longer wants the result, from any thread.
    pub cancelled: Arc<AtomicBool>,
    /// When it is too late.
    pub until: Option<Instant>,
}

impl Patience {
    /// A plugin's run from now on: long enough for what a script should do, short enough for a hand to wait.
    pub const USUAL: Duration = Duration::from_millis(1_800);

    /// The usual time, from now on.
    pub fn usual() -> Self {
        Self { cancelled: Arc::default(), until: Some(Instant::now() + Self::USUAL) }
    }

    /// Why to stop at step `step`, if it is one to look at and `unasked` was not the script's own time.
    pub(crate) fn ended(&self, step: u64, unasked: Duration) -> Option<Ended> {
        if step.is_multiple_of(STEPS_A_LOOK) { self.ended_now(unasked) } else { None }
    }

    /// Why to stop now.
    pub(crate) fn ended_now(&self, unasked: Duration) -> Option<Ended> {
        if self.cancelled.load(Ordering::Relaxed) {
            return Some(Ended::Cancelled);
        }
        self.until.is_some_and(|until| Instant::now() >= until + unasked).then_some(Ended::TooLate)
    }
}

/// Whose time passes while a run goes on: what takes long may be the scene, which no script is to blame for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum TimeOf {
    /// The script's.
    Script,
    /// The scene's: its sprites are being placed.
    Scene,
}

/// Hears whose time it is from now on.
pub(crate) type Hears = Arc<dyn Fn(TimeOf) + Send + Sync>;

/// Why a run ends early.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Ended {
    Cancelled,
    TooLate,
}

/// An engine with nothing in it but the language, and these limits. Its time to read a script begins now.
pub(crate) fn bare_engine() -> Engine {
    let mut engine = Engine::new_raw();
    engine
        .set_max_operations(OPERATIONS)
        .set_max_call_levels(CALL_LEVELS)
        .set_max_expr_depths(DEPTHS[0], DEPTHS[1])
        .set_max_variables(VARIABLES)
        .set_max_functions(FUNCTIONS)
        .set_max_modules(0)
        .set_max_string_size(TEXT_BYTES)
        .set_max_array_size(LIST_ITEMS)
        .set_max_map_size(MAP_FIELDS)
        .set_strict_variables(true)
        .set_fail_on_invalid_map_property(true)
        .set_optimization_level(rhai::OptimizationLevel::None);
    // `**` is the system's pow, which differs from machine to machine; the others lead out of the script, or double.
    for symbol in ["eval", "import", "export", "**", "**=", "curry"] {
        engine.disable_symbol(symbol);
    }
    let until = Instant::now() + READING;
    #[allow(deprecated, reason = "the engine marks so what is not deprecated but may change")]
    engine.on_parse_token(move |token, _, _| {
        let is_late = Instant::now() >= until;
        if is_late { Token::LexError(Box::new(LexError::Runtime("it takes too long to read".into()))) } else { token }
    });
    engine
}

#[cfg(test)]
mod tests {
    use super::READING;
    use crate::{Fault, Plugin};
    use std::time::Instant;

    #[test]
    fn what_a_parser_would_take_minutes_for_is_refused() {
        let names: Vec<String> = (0..37_000).map(|i| format!("q{i}")).collect();
        let head = r#"const PLUGIN = #{ name: "Test", kind: "edit", sentence: "For tests." };"#;
        for begin in ["fn f(", "fn run(p) { let f = |"] {
            let start = Instant::now();
            let error = Plugin::read(&format!("{head}\n{begin}{}", names.join(","))).expect_err("no end");
            assert!(matches!(error.fault, Fault::Limit | Fault::Syntax), "{error}");
            assert!(start.elapsed() < READING * 3, "{error}: {:?}", start.elapsed());
        }
    }
}
