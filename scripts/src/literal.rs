//! Values that stand written out in a script, each with its place, read from the parsed text before a line of it runs.

use crate::error::{ScriptError, did_you_mean};
use rhai::{Expr, Position};

/// A value and where it stands.
#[derive(Debug, Clone)]
pub(crate) struct Literal {
    pub(crate) value: Written,
    pub(crate) position: Position,
}

#[derive(Debug, Clone)]
pub(crate) enum Written {
    Flag(bool),
    Whole(i64),
    Number(f64),
    Text(String),
    List(Vec<Literal>),
    Map(Vec<Field>),
}

/// A name in a map with what it has.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    pub(crate) name: String,
    pub(crate) position: Position,
    pub(crate) literal: Literal,
}

impl Literal {
    /// What `expr` says.
    pub(crate) fn of(expr: &Expr) -> Result<Self, ScriptError> {
        let value = match expr {
            Expr::BoolConstant(flag, _) => Written::Flag(*flag),
            Expr::IntegerConstant(whole, _) => Written::Whole(*whole),
            Expr::FloatConstant(number, _) => Written::Number(**number),
            Expr::StringConstant(text, _) => Written::Text(text.to_string()),
            Expr::Array(items, _) => Written::List(items.iter().map(Self::of).collect::<Result<_, _>>()?),
            Expr::Map(fields, _) => {
                let field = |(name, expr): &(rhai::Ident, Expr)| {
                    Ok(Field { name: name.name.to_string(), position: name.pos, literal: Self::of(expr)? })
                };
                Written::Map(fields.0.iter().map(field).collect::<Result<_, ScriptError>>()?)
            }
            other => {
                return Err(ScriptError::description(
                    other.start_position(),
                    "PLUGIN is read before the script runs, and this would have to be computed",
                    "write the value itself: a number, a text, true or false, a list, a map",
                ));
            }
        };
        Ok(Self { value, position: expr.start_position() })
    }

    /// What it is, in words.
    pub(crate) fn kind(&self) -> &'static str {
        match self.value {
            Written::Flag(_) => "true or false",
            Written::Whole(_) => "a whole number",
            Written::Number(_) => "a number",
            Written::Text(_) => "a text",
            Written::List(_) => "a list",
            Written::Map(_) => "a map",
        }
    }

    pub(crate) fn wanted(&self, what: &str, wanted: &str) -> ScriptError {
        let message = format!("{what} is {}, where {wanted} is expected", self.kind());
        ScriptError::description(self.position, message, "")
    }

    pub(crate) fn text(&self, what: &str) -> Result<&str, ScriptError> {
        if let Written::Text(text) = &self.value { Ok(text) } else { Err(self.wanted(what, "a text")) }
    }

    pub(crate) fn number(&self, what: &str) -> Result<f64, ScriptError> {
        match self.value {
            Written::Number(number) if number.is_finite() => Ok(number),
            Written::Whole(whole) => Ok(whole as f64),
            _ => Err(self.wanted(what, "a number")),
        }
    }

    pub(crate) fn list(&self, what: &str) -> Result<&[Self], ScriptError> {
        if let Written::List(list) = &self.value { Ok(list) } else { Err(self.wanted(what, "a list")) }
    }

    pub(crate) fn fields(&self, what: &'static str) -> Result<Fields<'_>, ScriptError> {
        match &self.value {
            Written::Map(fields) => Ok(Fields { what, fields, position: self.position }),
            _ => Err(self.wanted(what, "a map, #{ name: value, … },")),
        }
    }
}

/// The fields of a map.
pub(crate) struct Fields<'a> {
    pub(crate) what: &'static str,
    pub(crate) fields: &'a [Field],
    pub(crate) position: Position,
}

impl<'a> Fields<'a> {
    /// That it has no others than `names`.
    pub(crate) fn only(&self, names: &[&'static str]) -> Result<(), ScriptError> {
        match self.fields.iter().find(|field| !names.contains(&field.name.as_str())) {
            None => Ok(()),
            Some(field) => {
                let near = did_you_mean(&field.name, names.iter().copied());
                let space = if near.is_empty() { "" } else { " " };
                Err(ScriptError::description(
                    field.position,
                    format!("{} has no `{}`", self.what, field.name),
                    format!("{near}{space}it has {}", names.join(", ")),
                ))
            }
        }
    }

    pub(crate) fn get(&self, name: &str) -> Option<&'a Literal> {
        self.fields.iter().find(|field| field.name == name).map(|field| &field.literal)
    }

    pub(crate) fn need(&self, name: &str) -> Result<&'a Literal, ScriptError> {
        self.get(name).ok_or_else(|| {
            ScriptError::description(self.position, format!("{} lacks `{name}`", self.what), "every one has it")
        })
    }

    /// A text that says something.
    pub(crate) fn need_text(&self, name: &str) -> Result<String, ScriptError> {
        let literal = self.need(name)?;
        let text = literal.text(name)?.trim();
        if text.is_empty() {
            return Err(ScriptError::description(literal.position, format!("{name} is empty"), "write some words"));
        }
        Ok(text.into())
    }

    pub(crate) fn text(&self, name: &str) -> Result<String, ScriptError> {
        self.get(name).map_or(Ok(String::new()), |literal| literal.text(name).map(Into::into))
    }

    pub(crate) fn number(&self, name: &str) -> Result<Option<f64>, ScriptError> {
        self.get(name).map(|literal| literal.number(name)).transpose()
    }
}
