//! What a plugin says of itself: a top-level `const PLUGIN = #{ … }`, read before a line of the script runs.
//!
//! It is read from the parsed text, so that each fault has its line and column, and so that nothing runs by opening a
//! folder of plugins. Menu, dialog, flags of the command line and manual are to follow from this alone.

use crate::error::{ScriptError, did_you_mean};
use crate::literal::Literal;
use crate::parameter::Parameter;
use rhai::{AST, ASTFlags, Position, Stmt};

/// Name of the constant.
pub const PLUGIN: &str = "PLUGIN";
/// More parameters would be no dialog.
const MOST_PARAMETERS: usize = 64;

/// What a plugin is.
#[derive(Debug, Clone, PartialEq)]
pub struct Description {
    /// As in the menu, and in the history of edits.
    pub name: String,
    /// What it makes.
    pub kind: PluginKind,
    /// One sentence for the artist.
    pub sentence: String,
    /// Whose it is.
    pub author: String,
    /// As the author counts.
    pub version: String,
    /// What can be chosen, in the dialog's order.
    pub parameters: Vec<Parameter>,
}

macro_rules! kinds {
    ($($(#[$doc:meta])* $Kind:ident: $name:literal;)*) => {
        /// What a plugin makes.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum PluginKind {
            $($(#[$doc])* $Kind,)*
        }

        impl PluginKind {
            /// All that there are.
            pub const ALL: &'static [Self] = &[$(Self::$Kind),*];

            /// As in scripts.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$Kind => $name,)*
                }
            }
        }
    };
}
kinds! {
    /// Clouds, models, boxes.
    Generator: "generator";
    /// Changes of what is there.
    Edit: "edit";
    /// Colour levels, groups, tables, sky.
    Look: "look";
    /// A timeline.
    Weather: "weather";
}

const FIELDS: &[&str] = &["name", "kind", "sentence", "author", "version", "parameters"];

impl Description {
    /// What the script says it is.
    pub(crate) fn of(ast: &AST) -> Result<Self, ScriptError> {
        let constant = |stmt: &Stmt| matches!(stmt, Stmt::Var(x, flags, _) if x.0.as_str() == PLUGIN && flags.contains(ASTFlags::CONSTANT));
        let mut found = ast.statements().iter().filter(|stmt| constant(stmt));
        let Some(Stmt::Var(first, ..)) = found.next() else {
            return Err(ScriptError::description(
                Position::new(1, 1),
                "the script does not say what it is",
                "it begins const PLUGIN = #{ name: \"…\", kind: \"weather\", … };",
            ));
        };
        if let Some(Stmt::Var(_, _, position)) = found.next() {
            return Err(ScriptError::description(*position, "PLUGIN is there twice", "a script is one plugin"));
        }
        Self::read(&Literal::of(&first.1)?)
    }

    fn read(literal: &Literal) -> Result<Self, ScriptError> {
        let fields = literal.fields(PLUGIN)?;
        fields.only(FIELDS)?;
        let kind = fields.need("kind")?;
        let parameters = match fields.get("parameters") {
            Some(list) => Self::parameters(list)?,
            None => Vec::new(),
        };
        Ok(Self {
            name: fields.need_text("name")?,
            kind: PluginKind::read(kind)?,
            sentence: fields.need_text("sentence")?,
            author: fields.text("author")?,
            version: fields.text("version")?,
            parameters,
        })
    }

    fn parameters(literal: &Literal) -> Result<Vec<Parameter>, ScriptError> {
        let list = literal.list("parameters")?;
        if list.len() > MOST_PARAMETERS {
            let message = format!("there are {} parameters", list.len());
            return Err(ScriptError::description(literal.position, message, format!("{MOST_PARAMETERS} at most")));
        }
        let mut parameters: Vec<Parameter> = Vec::with_capacity(list.len());
        for each in list {
            let parameter = Parameter::read(each, &parameters)?;
            parameters.push(parameter);
        }
        Ok(parameters)
    }

    /// The parameter of that name.
    pub fn parameter(&self, name: &str) -> Option<&Parameter> {
        self.parameters.iter().find(|parameter| parameter.name == name)
    }
}

impl PluginKind {
    fn read(literal: &Literal) -> Result<Self, ScriptError> {
        let name = literal.text("kind")?;
        Self::ALL.iter().copied().find(|kind| kind.name() == name).ok_or_else(|| {
            let names: Vec<&str> = Self::ALL.iter().map(|kind| kind.name()).collect();
            let near = did_you_mean(name, names.iter().copied());
            let hint = if near.is_empty() { format!("the kinds are {}", names.join(", ")) } else { near };
            ScriptError::description(literal.position, format!("there is no kind of plugin “{name}”"), hint)
        })
    }
}
