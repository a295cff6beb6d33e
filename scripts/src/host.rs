//! Plugins read, and run: a script's `fn run(parameters)` is called once and yields edits, or nothing at all.
//!
//! A run has an engine of its own, in a thread of its own, whose stack is as large as the limits need. So tests run it;
//! the program runs it in a process of its own besides ([`crate::caged`]). What the script
//! asks for is tried at once in a draft of the scene, so that a fault has its line; the scene itself is only read. The
//! edits are for one transaction under the plugin's name ([`Outcome::apply`]). An exporter's run changes nothing and
//! returns a text, which whoever asked for it writes.

use crate::bindings::{self, Exported};
use crate::description::{Description, PluginKind};
use crate::error::{Fault, Said, ScriptError};
use crate::limits::{Hears, PRINTED_LETTERS, PRINTED_LINES, Patience, SOURCE_BYTES, STACK_BYTES, bare_engine};
use crate::parameter::Values;
use crate::recorder::Recorder;
use cloudwright_core::document::{Change, Document, Edit, EditError};
use cloudwright_core::scene::{Scene, Thing};
use rhai::debugger::{DebuggerCommand, DebuggerEvent};
use rhai::packages::{
    ArithmeticPackage, BasicArrayPackage, BasicFnPackage, BasicIteratorPackage, BasicMapPackage, BasicMathPackage,
    BasicStringPackage, LogicPackage, MoreStringPackage, Package,
};
use rhai::{AST, CallFnOptions, Dynamic, Engine, Position, Scope};
use serde::{Deserialize, Serialize};
use std::cell::{Cell, RefCell};
use std::rc::Rc;
use std::sync::Arc;
use std::time::Duration;

/// The function that a run calls.
pub const RUN: &str = "run";

/// A script that says what it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Plugin {
    /// What it says.
    pub description: Description,
    pub(crate) source: String,
}

/// What a run asked for.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Outcome {
    /// For one transaction, in order.
    pub edits: Vec<Edit>,
    /// Lines that the script printed.
    pub printed: Vec<String>,
    /// What an exporter returned, for a file.
    pub text: Option<String>,
}

impl Outcome {
    /// Does it, as one undo point under the plugin's name.
    ///
    /// # Errors
    /// If `document` no longer is what the run read; it is then as before.
    pub fn apply(self, plugin: &Plugin, document: &mut Document) -> Result<Change, EditError> {
        document.edit(&plugin.description.name, self.edits)
    }
}

impl Plugin {
    /// Reads what a script says it is, and runs nothing of it. It needs no process of its own: what a parser does is
    /// bounded by the text's size and depth, on a stack that holds that depth, and by the clock.
    ///
    /// # Errors
    /// If it is no program, does not say what it is, or lacks the function that runs it.
    pub fn read(source: &str) -> Result<Self, ScriptError> {
        if source.len() > SOURCE_BYTES {
            let message = format!("the script has {} bytes", source.len());
            return Err(ScriptError::placeless(Fault::Limit, message, format!("{SOURCE_BYTES} at most")));
        }
        let source = source.strip_prefix('\u{feff}').unwrap_or(source);
        // As deep as nested text may get, a parser may need more stack than a small thread has.
        let description = in_a_thread(|| {
            let ast = parse(&bare_engine(), source)?;
            let description = Description::of(&ast)?;
            match ast.iter_functions().find(|function| function.name == RUN) {
                Some(function) if function.params.len() == 1 => Ok(description),
                _ => Err(ScriptError::description(
                    Position::NONE,
                    "there is no function `run` with one parameter",
                    "what the plugin does stands in fn run(parameters) { … }",
                )),
            }
        })?;
        Ok(Self { description, source: source.into() })
    }

    /// The values that hold until something is chosen.
    pub fn values(&self) -> Values {
        Values::of(&self.description.parameters)
    }

    /// Has it do what it does to a draft of `scene`.
    ///
    /// # Errors
    /// If the script fails at any point, the result would have faults, or patience ends.
    pub fn run(&self, scene: &Scene, values: &Values, patience: &Patience) -> Result<Outcome, ScriptError> {
        self.run_on(scene, &[], values, patience)
    }

    /// As [`Plugin::run`], where `selected` are selected; what is not in the scene is left out.
    ///
    /// # Errors
    /// As [`Plugin::run`].
    pub fn run_on(
        &self,
        scene: &Scene,
        selected: &[Thing],
        values: &Values,
        patience: &Patience,
    ) -> Result<Outcome, ScriptError> {
        self.run_heard(scene, selected, values, patience, &(Arc::new(|_| ()) as Hears))
    }

    /// As [`Plugin::run_on`]; `hears` is told whose time passes.
    pub(crate) fn run_heard(
        &self,
        scene: &Scene,
        selected: &[Thing],
        values: &Values,
        patience: &Patience,
        hears: &Hears,
    ) -> Result<Outcome, ScriptError> {
        in_a_thread(|| self.run_here(scene, selected, values, patience, hears))
    }

    fn run_here(
        &self,
        scene: &Scene,
        selected: &[Thing],
        values: &Values,
        patience: &Patience,
        hears: &Hears,
    ) -> Result<Outcome, ScriptError> {
        let exports = self.description.kind == PluginKind::Exporter;
        let recorder = if exports { Recorder::read_only(scene) } else { Recorder::new(scene) };
        let recorder = Rc::new(RefCell::new(recorder));
        let exported = exports.then(|| Rc::new(Exported::new(patience, Arc::clone(hears))));
        let printed = Rc::new(RefCell::new(Vec::new()));
        let mut engine = engine();
        bindings::register(&mut engine, &recorder, selected, exported.as_ref(), patience);
        let (ours, places) = (patience.clone(), exported.clone());
        engine.on_progress(move |step| {
            let unasked = places.as_ref().map_or(Duration::ZERO, |places| places.unasked());
            ours.ended(step, unasked).map(|ended| Dynamic::from(Said::from(ended)))
        });
        let reached = follow(&mut engine);
        let lines = Rc::clone(&printed);
        engine.on_print(move |line| {
            let mut lines = lines.borrow_mut();
            if lines.len() < PRINTED_LINES {
                lines.push(line.chars().take(PRINTED_LETTERS).collect());
            }
        });
        let ast = parse(&engine, &self.source)?;
        let options = CallFnOptions::new().eval_ast(true).rewind_scope(true);
        let parameters = bindings::Parameters::new(values);
        let done =
            engine.call_fn_with_options::<Dynamic>(options, &mut Scope::new(), &ast, RUN, (Dynamic::from(parameters),));
        let returned = done.map_err(|error| {
            let mut known = names(&engine);
            known.extend(ast.iter_functions().map(|function| function.name.to_owned()));
            ScriptError::of_run(&error, reached.get(), &known, bindings::usage)
        })?;
        let text = exports.then(|| bindings::whole_text(&returned)).transpose();
        let text =
            text.map_err(|Said { fault, message, hint }| ScriptError::new(fault, reached.get(), message, hint))?;
        let edits = recorder.borrow_mut().finish()?;
        let printed = printed.take();
        Ok(Outcome { edits, printed, text })
    }
}

/// Where a run has come to, at any time: the engine's own errors of limits know no place.
#[allow(deprecated, reason = "the engine marks so what is not deprecated but may change")]
fn follow(engine: &mut Engine) -> Rc<Cell<Position>> {
    let reached = Rc::new(Cell::new(Position::NONE));
    let here = Rc::clone(&reached);
    engine.register_debugger(
        |_, debugger| debugger,
        move |_, event, _, _, position| {
            if matches!(event, DebuggerEvent::Step) && !position.is_none() {
                here.set(position);
            }
            Ok(DebuggerCommand::StepInto)
        },
    );
    reached
}

fn parse(engine: &Engine, source: &str) -> Result<AST, ScriptError> {
    engine.compile(source).map_err(|error| ScriptError::of_parse(&error))
}

/// The language with its arithmetic, lists, maps and texts; nothing that waits, asks the clock, or reads anything.
fn engine() -> Engine {
    let mut engine = bare_engine();
    ArithmeticPackage::new().register_into_engine(&mut engine);
    LogicPackage::new().register_into_engine(&mut engine);
    BasicMathPackage::new().register_into_engine(&mut engine);
    BasicArrayPackage::new().register_into_engine(&mut engine);
    BasicMapPackage::new().register_into_engine(&mut engine);
    BasicStringPackage::new().register_into_engine(&mut engine);
    MoreStringPackage::new().register_into_engine(&mut engine);
    BasicIteratorPackage::new().register_into_engine(&mut engine);
    BasicFnPackage::new().register_into_engine(&mut engine);
    engine.on_debug(|_, _, _| {});
    engine
}

/// What is registered besides the language's own, as Rhai's definition files have it.
pub(crate) fn definitions() -> String {
    let mut engine = Engine::new_raw();
    let (recorder, patience) = (Recorder::new(&Scene::default()), Patience::usual());
    bindings::register(&mut engine, &Rc::new(RefCell::new(recorder)), &[], None, &patience);
    engine.definitions().with_headers(true).single_file()
}

/// Names of all functions of the engine.
fn names(engine: &Engine) -> Vec<String> {
    let signatures = engine.gen_fn_signatures(true);
    let mut names: Vec<String> = signatures
        .iter()
        .filter_map(|signature| Some(signature.split('(').next()?.trim().trim_start_matches("fn ").to_owned()))
        .filter(|name| name.starts_with(|c: char| c.is_ascii_alphabetic()) && !name.contains('$'))
        .collect();
    names.sort_unstable();
    names.dedup();
    names
}

/// Does it on a stack that holds whatever the limits let through, and turns a panic of the engine's into an error.
fn in_a_thread<T: Send>(work: impl FnOnce() -> Result<T, ScriptError> + Send) -> Result<T, ScriptError> {
    let broken = |message: &str| Err(ScriptError::broken(message));
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().name("script".into()).stack_size(STACK_BYTES);
        match thread.spawn_scoped(scope, work) {
            Ok(running) => running.join().unwrap_or_else(|_| broken("the script's host broke down")),
            Err(_) => broken("there is no thread for the script"),
        }
    })
}
