//! What is wrong with a plugin, or went wrong as it ran: where, what, and what to do.

use crate::limits::Ended;
use cloudwright_core::spelling::closest;
use rhai::{EvalAltResult, LexError, ParseError, Position};
use serde::{Deserialize, Serialize};
use std::fmt;

/// A plugin can't be read, or a run of it ended early; nothing has been changed then.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error, Serialize, Deserialize)]
pub struct ScriptError {
    /// What kind of fault.
    pub fault: Fault,
    /// Where in the script; none for what no place is to blame for.
    pub place: Option<Place>,
    /// What is wrong.
    pub message: String,
    /// What was expected, what was meant, or what to do; may be empty.
    pub hint: String,
}

/// Kinds of faults.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Fault {
    /// It is no program.
    Syntax,
    /// It does not say what it is.
    Description,
    /// A parameter can't have that value.
    Value,
    /// It asked for what can't be done.
    Script,
    /// It asked for more than a script may have.
    Limit,
    /// It was no longer wanted.
    Cancelled,
    /// What it asked for would leave the scene with faults.
    Scene,
    /// A fault of ours.
    Broken,
}

/// A place in a script, both counted from 1.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub struct Place {
    /// The line.
    pub line: usize,
    /// The character in it.
    pub column: usize,
}

impl fmt::Display for ScriptError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(Place { line, column }) = self.place {
            write!(f, "line {line}, column {column}: ")?;
        }
        f.write_str(&self.message)?;
        if self.hint.is_empty() { Ok(()) } else { write!(f, " ({})", self.hint) }
    }
}

impl ScriptError {
    pub(crate) fn new(fault: Fault, position: Position, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { fault, place: place(position), message: message.into(), hint: hint.into() }
    }

    pub(crate) fn description(position: Position, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::new(Fault::Description, position, message, hint)
    }

    /// No place in the script is to blame.
    pub(crate) fn placeless(fault: Fault, message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::new(fault, Position::NONE, message, hint)
    }

    /// Nobody wants the result any more.
    pub fn stopped() -> Self {
        Ended::Cancelled.into()
    }

    /// Patience has ended.
    pub fn too_late() -> Self {
        Ended::TooLate.into()
    }

    /// The script asked for more than a script may have.
    pub fn limit(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self::placeless(Fault::Limit, message, hint)
    }

    /// A fault of ours.
    pub fn broken(message: impl Into<String>) -> Self {
        Self::placeless(Fault::Broken, message, "report this, with the script")
    }

    pub(crate) fn of_parse(error: &ParseError) -> Self {
        use rhai::ParseErrorType as Type;
        let message = error.err_type().to_string();
        if let Type::BadInput(LexError::Runtime(_)) = error.err_type() {
            return Self::new(Fault::Limit, error.position(), message, "make it shorter, and its functions simpler");
        }
        let hint = match error.err_type() {
            Type::Reserved(word) => not_here(word),
            Type::ExprTooDeep => "use names for parts of it",
            _ => message.split('\'').nth(1).map_or("", not_here),
        };
        Self::new(Fault::Syntax, error.position(), message, hint)
    }

    /// `names` are those of all functions that there are, and `usage` tells how each of ours is called. Where a limit
    /// ends a run, the engine tells no place: then it is the one that was last `reached`.
    pub(crate) fn of_run(
        error: &EvalAltResult,
        reached: Position,
        names: &[String],
        usage: fn(&str) -> Option<&'static str>,
    ) -> Self {
        use EvalAltResult as E;
        let inner = innermost(error);
        let position = position(error);
        let position = if inner.is_system_exception() || position.is_none() { reached } else { position };
        let new = |fault, message: String, hint: String| Self::new(fault, position, message, hint);
        match inner {
            E::ErrorRuntime(said, _) => match said.clone().try_cast::<Said>() {
                Some(Said { fault, message, hint }) => new(fault, message, hint),
                None => new(Fault::Script, said.to_string(), String::new()),
            },
            E::ErrorFunctionNotFound(signature, _) => {
                let name = signature.split([' ', '(']).next().unwrap_or_default();
                match usage(name) {
                    Some(usage) => new(Fault::Script, format!("there is no {signature}"), format!("write {usage}")),
                    None if names.iter().any(|each| each == name) => new(
                        Fault::Script,
                        format!("there is no function {signature}"),
                        format!("`{name}` is there, but takes other values"),
                    ),
                    None => new(
                        Fault::Script,
                        format!("there is no function {signature}"),
                        did_you_mean(name, names.iter().map(String::as_str)),
                    ),
                }
            }
            E::ErrorTerminated(why, _) => match why.clone().try_cast::<Said>() {
                Some(Said { fault, message, hint }) => new(fault, message, hint),
                None => new(Fault::Cancelled, "stopped".into(), String::new()),
            },
            E::ErrorTooManyOperations(_) => new(
                Fault::Limit,
                "the script does more than a script may".into(),
                "does a loop never end? functions that take whole lists do more at once".into(),
            ),
            E::ErrorStackOverflow(_) => {
                new(Fault::Limit, "functions call each other too deep".into(), "does one call itself for ever?".into())
            }
            E::ErrorTooManyVariables(_) | E::ErrorTooManyModules(_) | E::ErrorDataTooLarge(..) => {
                new(Fault::Limit, inner.unwrap_message(), "make less of it, or several smaller ones".into())
            }
            E::ErrorParsing(..) => new(Fault::Syntax, inner.unwrap_message(), String::new()),
            _ => new(Fault::Script, inner.unwrap_message(), String::new()),
        }
    }
}

/// What a function of ours has to say, on its way through the engine.
#[derive(Debug, Clone)]
pub(crate) struct Said {
    pub(crate) fault: Fault,
    pub(crate) message: String,
    pub(crate) hint: String,
}

impl Said {
    pub(crate) fn script(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { fault: Fault::Script, message: message.into(), hint: hint.into() }
    }

    pub(crate) fn limit(message: impl Into<String>, hint: impl Into<String>) -> Self {
        Self { fault: Fault::Limit, message: message.into(), hint: hint.into() }
    }
}

impl From<Ended> for Said {
    fn from(ended: Ended) -> Self {
        match ended {
            Ended::Cancelled => Self { fault: Fault::Cancelled, message: "stopped".into(), hint: String::new() },
            Ended::TooLate => Self::limit(
                "the script takes too long",
                "does a loop never end? functions that take whole lists do more at once",
            ),
        }
    }
}

impl From<Ended> for ScriptError {
    fn from(ended: Ended) -> Self {
        let Said { fault, message, hint } = ended.into();
        Self::placeless(fault, message, hint)
    }
}

impl From<Said> for Box<EvalAltResult> {
    fn from(said: Said) -> Self {
        Self::new(EvalAltResult::ErrorRuntime(rhai::Dynamic::from(said), Position::NONE))
    }
}

/// "did you mean `get`?", or nothing.
pub(crate) fn did_you_mean<'a>(unknown: &str, names: impl IntoIterator<Item = &'a str>) -> String {
    closest(unknown, names).map(|name| format!("did you mean `{name}`?")).unwrap_or_default()
}

fn not_here(word: &str) -> &'static str {
    match word {
        "eval" | "import" | "export" => "a plugin is one script that stands for itself; write functions in it",
        "**" => "write pow(x, y), which is the same on every machine",
        "default" => "what holds at first is called `initial`",
        "curry" => "call a function of your own with the value",
        _ => "",
    }
}

fn place(position: Position) -> Option<Place> {
    Some(Place { line: position.line()?, column: position.position().unwrap_or(1).max(1) })
}

fn innermost(error: &EvalAltResult) -> &EvalAltResult {
    match error {
        EvalAltResult::ErrorInFunctionCall(_, _, inner, _) | EvalAltResult::ErrorInModule(_, inner, _) => {
            innermost(inner)
        }
        _ => error,
    }
}

/// The innermost place that is known.
fn position(error: &EvalAltResult) -> Position {
    let own = error.position();
    match error {
        EvalAltResult::ErrorInFunctionCall(_, _, inner, _) | EvalAltResult::ErrorInModule(_, inner, _) => {
            let inner = position(inner);
            if inner.is_none() { own } else { inner }
        }
        _ => own,
    }
}

trait Message {
    fn unwrap_message(&self) -> String;
}

impl Message for EvalAltResult {
    /// Its words without the place, which is told before them.
    fn unwrap_message(&self) -> String {
        let text = self.to_string();
        text.rsplit_once(" (line ").map_or(text.clone(), |(message, _)| message.into())
    }
}
