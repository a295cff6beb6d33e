//! What can be chosen of a plugin, and the values that are.

use crate::error::{Fault, ScriptError, did_you_mean};
use crate::literal::{Fields, Literal, Written};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::fmt;

/// One thing that can be chosen.
#[derive(Debug, Clone, PartialEq)]
pub struct Parameter {
    /// As in the script and on the command line; numbers end in their unit: `length_s`.
    pub name: String,
    /// As on screen.
    pub label: String,
    /// A sentence for the artist; may be empty.
    pub help: String,
    /// What it is.
    pub kind: ParameterKind,
    /// What holds until something is chosen.
    pub initial: ParameterValue,
    /// It is shown only while another parameter, before it, has that value.
    pub shown_if: Option<(String, ParameterValue)>,
}

/// What a parameter is.
#[derive(Debug, Clone, PartialEq)]
pub enum ParameterKind {
    /// Any number in a range.
    Number(Span),
    /// A whole number in a range.
    Integer(Span),
    /// True or false.
    Flag,
    /// Words.
    Text,
    /// One of these names.
    Choice(Vec<String>),
    /// Linear light: three numbers from 0.
    Color,
    /// A whole number from 0: another one rolls the dice anew.
    Seed,
    /// The id of a cloud of the scene.
    Cloud,
    /// The id of a cloud model of the scene.
    Model,
    /// The id of a camera path of the scene.
    Path,
    /// Points of a line that runs from left to right: `[x, y]` each, and y in a range.
    Curve(Span),
    /// The words of weather reports, METAR or TAF.
    Metar,
}

/// What a number means and may be.
#[derive(Debug, Clone, PartialEq)]
pub struct Span {
    /// Behind the number; may be empty.
    pub unit: String,
    /// What it may be.
    pub hard: [f64; 2],
    /// How far a slider goes.
    pub soft: [f64; 2],
    /// How far one notch goes; none: as the field thinks best.
    pub step: Option<f64>,
}

/// What a parameter has.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum ParameterValue {
    /// True or false.
    Flag(bool),
    /// A number.
    Number(f64),
    /// A whole number, a seed or an id.
    Whole(i64),
    /// Words, or the name of a choice.
    Text(String),
    /// Linear light.
    Color([f64; 3]),
    /// A curve's points, in rising order of x.
    Curve(Vec<[f64; 2]>),
}

/// What all parameters of a plugin have.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
pub struct Values(pub(crate) BTreeMap<String, ParameterValue>);

const KINDS: &[&str] =
    &["number", "integer", "flag", "text", "choice", "color", "seed", "cloud", "model", "path", "curve", "metar"];
const OF_ALL: &[&str] = &["name", "label", "help", "kind", "initial", "shown_if"];
const OF_NUMBERS: &[&str] = &["unit", "min", "max", "soft_min", "soft_max", "step"];
/// Brightest channel that a colour parameter may have, as the scene's colours.
const BRIGHTEST: f64 = 1000.0;
/// What a number may be that says nothing of its range.
const ANY: [f64; 2] = [-1e12, 1e12];
/// A curve of more is no longer drawn by hand.
const MOST_POINTS: usize = 64;

impl Parameter {
    pub(crate) fn read(literal: &Literal, before: &[Self]) -> Result<Self, ScriptError> {
        let fields = literal.fields("a parameter")?;
        let name = fields.need_text("name")?;
        let name_at = fields.need("name")?.position;
        let is_word = |name: &str| {
            name.starts_with(|c: char| c.is_ascii_lowercase())
                && name.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit() || b == b'_')
        };
        if !is_word(&name) {
            let message = format!("“{name}” is no name of a parameter");
            return Err(ScriptError::description(name_at, message, "small letters, digits and _, such as length_s"));
        }
        if before.iter().any(|parameter| parameter.name == name) {
            let message = format!("there are two parameters “{name}”");
            return Err(ScriptError::description(name_at, message, "give each a name of its own"));
        }
        let kind = ParameterKind::read(&fields)?;
        let label = match fields.get("label") {
            Some(label) => label.text("label")?.into(),
            None => name.replace('_', " "),
        };
        let initial = match fields.get("initial") {
            Some(initial) => kind.value_of(initial)?,
            None => kind.usual().ok_or_else(|| {
                ScriptError::description(fields.position, format!("parameter “{name}” lacks `initial`"), "")
            })?,
        };
        let shown_if = fields.get("shown_if").map(|shown| Self::shown_if(shown, before)).transpose()?;
        Ok(Self { name, label, help: fields.text("help")?, kind, initial, shown_if })
    }

    fn shown_if(literal: &Literal, before: &[Self]) -> Result<(String, ParameterValue), ScriptError> {
        let fields = literal.fields("shown_if")?;
        let [field] = fields.fields else {
            return Err(ScriptError::description(
                literal.position,
                "shown_if has one name",
                "such as #{ looped: true }",
            ));
        };
        let Some(other) = before.iter().find(|parameter| parameter.name == field.name) else {
            let message = format!("there is no parameter “{}” before this one", field.name);
            let hint = did_you_mean(&field.name, before.iter().map(|parameter| parameter.name.as_str()));
            return Err(ScriptError::description(field.position, message, hint));
        };
        Ok((field.name.clone(), other.kind.value_of(&field.literal)?))
    }

    /// The value that `text` says, as on the command line.
    ///
    /// # Errors
    /// If it is of another kind or out of range.
    pub fn read_text(&self, text: &str) -> Result<ParameterValue, ScriptError> {
        let text = text.trim();
        let numbers = || text.split(',').map(|part| part.trim().parse::<f64>().ok()).collect::<Option<Vec<f64>>>();
        let value = match &self.kind {
            ParameterKind::Number(_) => text.parse().ok().map(ParameterValue::Number),
            ParameterKind::Integer(_)
            | ParameterKind::Seed
            | ParameterKind::Cloud
            | ParameterKind::Model
            | ParameterKind::Path => text.parse().ok().map(ParameterValue::Whole),
            ParameterKind::Flag => match text {
                "true" | "yes" | "on" => Some(ParameterValue::Flag(true)),
                "false" | "no" | "off" => Some(ParameterValue::Flag(false)),
                _ => None,
            },
            ParameterKind::Text | ParameterKind::Choice(_) | ParameterKind::Metar => {
                Some(ParameterValue::Text(text.into()))
            }
            ParameterKind::Curve(_) => points(text).map(ParameterValue::Curve),
            ParameterKind::Color => numbers().and_then(|parts| parts.try_into().ok()).map(ParameterValue::Color),
        };
        let value = value.filter(|value| self.kind.why_not(value).is_none());
        value.ok_or_else(|| {
            let message = format!("{}: “{text}” is not {}", self.name, self.kind);
            let near = match &self.kind {
                ParameterKind::Choice(names) => did_you_mean(text, names.iter().map(String::as_str)),
                _ => format!("it is {} if not given", self.initial),
            };
            ScriptError::placeless(Fault::Value, message, near)
        })
    }
}

impl ParameterKind {
    fn read(fields: &Fields<'_>) -> Result<Self, ScriptError> {
        let literal = fields.need("kind")?;
        let name = literal.text("kind")?;
        let only = |more: &[&'static str]| fields.only(&[OF_ALL, more].concat());
        Ok(match name {
            "number" | "integer" | "curve" => {
                only(OF_NUMBERS)?;
                let span = Span::read(fields)?;
                match name {
                    "number" => Self::Number(span),
                    "integer" => Self::Integer(span),
                    _ => Self::Curve(span),
                }
            }
            "choice" => {
                only(&["choices"])?;
                let list = fields.need("choices")?;
                let names = list.list("choices")?.iter().map(|each| each.text("a choice").map(String::from));
                let names = names.collect::<Result<Vec<_>, _>>()?;
                if names.is_empty() {
                    return Err(ScriptError::description(list.position, "there is nothing to choose from", ""));
                }
                Self::Choice(names)
            }
            "flag" | "text" | "color" | "seed" | "cloud" | "model" | "path" | "metar" => {
                only(&[])?;
                match name {
                    "flag" => Self::Flag,
                    "text" => Self::Text,
                    "color" => Self::Color,
                    "seed" => Self::Seed,
                    "cloud" => Self::Cloud,
                    "model" => Self::Model,
                    "path" => Self::Path,
                    _ => Self::Metar,
                }
            }
            _ => {
                let near = did_you_mean(name, KINDS.iter().copied());
                let hint = if near.is_empty() { format!("the kinds are {}", KINDS.join(", ")) } else { near };
                let message = format!("there is no kind of parameter “{name}”");
                return Err(ScriptError::description(literal.position, message, hint));
            }
        })
    }

    /// What holds if the script says nothing.
    fn usual(&self) -> Option<ParameterValue> {
        match self {
            Self::Flag => Some(ParameterValue::Flag(false)),
            Self::Text | Self::Metar => Some(ParameterValue::Text(String::new())),
            Self::Seed => Some(ParameterValue::Whole(1)),
            // None yet: an id is never 0.
            Self::Cloud | Self::Model | Self::Path => Some(ParameterValue::Whole(0)),
            Self::Choice(names) => names.first().cloned().map(ParameterValue::Text),
            Self::Number(_) | Self::Integer(_) | Self::Color | Self::Curve(_) => None,
        }
    }

    fn value_of(&self, literal: &Literal) -> Result<ParameterValue, ScriptError> {
        let value = match (self, &literal.value) {
            (Self::Number(_), Written::Number(_) | Written::Whole(_)) => {
                ParameterValue::Number(literal.number("initial")?)
            }
            (Self::Integer(_) | Self::Seed | Self::Cloud | Self::Model | Self::Path, Written::Whole(whole)) => {
                ParameterValue::Whole(*whole)
            }
            (Self::Flag, Written::Flag(flag)) => ParameterValue::Flag(*flag),
            (Self::Text | Self::Choice(_) | Self::Metar, Written::Text(text)) => ParameterValue::Text(text.clone()),
            (Self::Curve(_), Written::List(list)) => {
                let point = |literal: &Literal| match literal.list("a point")? {
                    [x, y] => Ok([x.number("x")?, y.number("y")?]),
                    _ => Err(literal.wanted("a point", "a list of two numbers, [x, y],")),
                };
                ParameterValue::Curve(list.iter().map(point).collect::<Result<_, _>>()?)
            }
            (Self::Color, Written::List(list)) if list.len() == 3 => {
                let mut color = [0.0; 3];
                for (channel, literal) in color.iter_mut().zip(list) {
                    *channel = literal.number("a channel")?;
                }
                ParameterValue::Color(color)
            }
            _ => return Err(literal.wanted("the value", &self.to_string())),
        };
        match self.why_not(&value) {
            None => Ok(value),
            Some(why) => Err(ScriptError::description(literal.position, format!("{value} is not {self}"), why)),
        }
    }

    /// Why it can't have `value`, which is of its kind of literal.
    fn why_not(&self, value: &ParameterValue) -> Option<String> {
        match (self, value) {
            (Self::Number(span), ParameterValue::Number(number)) => span.why_not(*number),
            (Self::Integer(span), ParameterValue::Whole(whole)) => span.why_not(*whole as f64),
            (Self::Seed | Self::Cloud | Self::Model | Self::Path, ParameterValue::Whole(whole)) => {
                (*whole < 0).then(|| "it is 0 or more".into())
            }
            (Self::Choice(names), ParameterValue::Text(text)) if !names.contains(text) => {
                Some(format!("the names are {}", names.join(", ")))
            }
            (Self::Color, ParameterValue::Color(channels)) => {
                let is_sound = |channel: &f64| (0.0..=BRIGHTEST).contains(channel);
                (!channels.iter().all(is_sound)).then(|| format!("each is 0 to {BRIGHTEST}"))
            }
            (Self::Curve(span), ParameterValue::Curve(points)) => {
                if !(1..=MOST_POINTS).contains(&points.len()) {
                    return Some(format!("it has 1 to {MOST_POINTS} points"));
                }
                if !points.iter().all(|[x, _]| x.is_finite() && x.abs() <= ANY[1]) {
                    return Some("each x is a number".into());
                }
                if !points.is_sorted_by(|a, b| a[0] < b[0]) {
                    return Some("each point lies to the right of the one before".into());
                }
                points.iter().find_map(|[_, y]| span.why_not(*y))
            }
            _ => None,
        }
    }
}

/// A curve's points as on the command line: `0:0,0.5:1,1:0`.
fn points(text: &str) -> Option<Vec<[f64; 2]>> {
    let point = |text: &str| {
        let (x, y) = text.split_once(':')?;
        Some([x.trim().parse().ok()?, y.trim().parse().ok()?])
    };
    text.split(',').map(point).collect()
}

impl Span {
    fn read(fields: &Fields<'_>) -> Result<Self, ScriptError> {
        let end = |name, usual| fields.number(name).map(|end| end.unwrap_or(usual));
        let hard = [end("min", ANY[0])?, end("max", ANY[1])?];
        let soft = [end("soft_min", hard[0])?, end("soft_max", hard[1])?];
        let step = fields.number("step")?;
        let fault = |name: &str, message: &str| {
            let position = fields.get(name).map_or(fields.position, |literal| literal.position);
            Err(ScriptError::description(position, message, ""))
        };
        if hard[0] > hard[1] {
            return fault("max", "max is below min");
        }
        if soft[0] > soft[1] || soft[0] < hard[0] || soft[1] > hard[1] {
            return fault("soft_max", "soft_min and soft_max do not lie in order within min and max");
        }
        if step.is_some_and(|step| step <= 0.0) {
            return fault("step", "a step is above 0");
        }
        Ok(Self { unit: fields.text("unit")?, hard, soft, step })
    }

    fn why_not(&self, number: f64) -> Option<String> {
        let [min, max] = self.hard;
        // NaN is in no range.
        (!(min..=max).contains(&number)).then(|| format!("it is {min} to {max}"))
    }
}

impl fmt::Display for ParameterKind {
    /// What is expected.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut number = |what: &str, span: &Span| {
            write!(f, "{what}")?;
            if span.hard[0] > ANY[0] || span.hard[1] < ANY[1] {
                write!(f, " from {} to {}", span.hard[0], span.hard[1])?;
            }
            if span.unit.is_empty() { Ok(()) } else { write!(f, " {}", span.unit) }
        };
        match self {
            Self::Number(span) => number("a number", span),
            Self::Integer(span) => number("a whole number", span),
            Self::Flag => f.write_str("true or false"),
            Self::Text => f.write_str("a text"),
            Self::Choice(names) => write!(f, "one of {}", names.join(", ")),
            Self::Color => f.write_str("a colour, r, g and b from 0"),
            Self::Seed => f.write_str("a seed, a whole number from 0"),
            Self::Cloud => f.write_str("the id of a cloud"),
            Self::Model => f.write_str("the id of a cloud model"),
            Self::Path => f.write_str("the id of a camera path"),
            Self::Curve(span) => number("a curve, x:y,x:y,… with x rising and y", span),
            Self::Metar => f.write_str("a weather report"),
        }
    }
}

impl fmt::Display for ParameterValue {
    /// As on the command line.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Flag(flag) => flag.fmt(f),
            Self::Number(number) => number.fmt(f),
            Self::Whole(whole) => whole.fmt(f),
            Self::Text(text) => text.fmt(f),
            Self::Color([r, g, b]) => write!(f, "{r},{g},{b}"),
            Self::Curve(points) => points.iter().enumerate().try_for_each(|(i, [x, y])| {
                let comma = if i == 0 { "" } else { "," };
                write!(f, "{comma}{x}:{y}")
            }),
        }
    }
}

impl Values {
    /// Those of `parameters` as they are until something is chosen.
    pub fn of(parameters: &[Parameter]) -> Self {
        Self(parameters.iter().map(|each| (each.name.clone(), each.initial.clone())).collect())
    }

    /// What the parameter of that name has.
    pub fn get(&self, name: &str) -> Option<&ParameterValue> {
        self.0.get(name)
    }

    /// Gives one of `parameters` the value that `text` says.
    ///
    /// # Errors
    /// If there is none of that name, or it can't have that value.
    pub fn set(&mut self, parameters: &[Parameter], name: &str, text: &str) -> Result<(), ScriptError> {
        let Some(parameter) = parameters.iter().find(|parameter| parameter.name == name) else {
            let names: Vec<&str> = parameters.iter().map(|parameter| parameter.name.as_str()).collect();
            let hint = if names.is_empty() {
                "it has none".into()
            } else {
                let near = did_you_mean(name, names.iter().copied());
                let space = if near.is_empty() { "" } else { " " };
                format!("{near}{space}the parameters are {}", names.join(", "))
            };
            return Err(ScriptError::placeless(Fault::Value, format!("there is no parameter “{name}”"), hint));
        };
        self.0.insert(name.into(), parameter.read_text(text)?);
        Ok(())
    }
}
