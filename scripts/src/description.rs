//! What a plugin says of itself: a top-level `const PLUGIN = #{ … }`, read before a line of the script runs.
//!
//! It is read from the parsed text, so that each fault has its line and column, and so that nothing runs by opening a
//! folder of plugins. Menu, dialog, flags of the command line and manual are to follow from this alone.

use crate::error::{ScriptError, did_you_mean};
use crate::literal::{Fields, Literal};
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
    /// What the names of the files that an exporter writes end in, without the dot; empty of other kinds.
    pub ending: String,
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
    /// A text for a file, of a scene that stays as it is.
    Exporter: "exporter";
}

const FIELDS: &[&str] = &["name", "kind", "sentence", "author", "version", "ending", "parameters"];
/// What files end in of which an exporter says nothing.
const USUAL_ENDING: &str = "txt";
/// No ending is longer.
const LONGEST_ENDING: usize = 12;

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
        let kind = PluginKind::read(kind)?;
        Ok(Self {
            name: fields.need_text("name")?,
            kind,
            ending: Self::ending(&fields, kind)?,
            sentence: fields.need_text("sentence")?,
            author: fields.text("author")?,
            version: fields.text("version")?,
            parameters,
        })
    }

    fn ending(fields: &Fields<'_>, kind: PluginKind) -> Result<String, ScriptError> {
        let is_exporter = kind == PluginKind::Exporter;
        let Some(literal) = fields.get("ending") else {
            return Ok(if is_exporter { USUAL_ENDING.into() } else { String::new() });
        };
        let fault = |message: String, hint: &str| Err(ScriptError::description(literal.position, message, hint));
        let ending = literal.text("ending")?;
        if !is_exporter {
            return fault(format!("kind {} writes no files", kind.name()), "an ending is for exporters");
        }
        let is_plain = ending.bytes().all(|b| b.is_ascii_lowercase() || b.is_ascii_digit());
        if !is_plain || !(1..=LONGEST_ENDING).contains(&ending.len()) {
            return fault(
                format!("“{ending}” is no ending of files"),
                "small letters and digits without a dot, such as csv",
            );
        }
        Ok(ending.into())
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parameter::{ParameterKind, ParameterValue};
    use crate::{Fault, Plugin};

    const GOOD: &str = r#"// A script may begin with words.
const PLUGIN = #{
    name: "Test", kind: "weather", sentence: "For tests.", author: "A", version: "2",
    parameters: [
        #{ name: "length_s", label: "Length", unit: "s", kind: "number", min: 1, max: 60.5, soft_max: 30, step: 0.5, initial: 9 },
        #{ name: "count", kind: "integer", min: -5, initial: -3 },
        #{ name: "mode", kind: "choice", choices: ["calm", "wild"] },
        #{ name: "tint", kind: "color", initial: [1, 0.5, 0], shown_if: #{ mode: "wild" } },
        #{ name: "again", kind: "flag" }, #{ name: "words", kind: "text", initial: "a b" },
        #{ name: "dice", kind: "seed", initial: 7 }, #{ name: "of", kind: "cloud" }, #{ name: "kind_of", kind: "model" },
        #{ name: "way", kind: "path" }, #{ name: "report", kind: "metar", initial: "METAR EDDF" },
        #{ name: "over_day", kind: "curve", unit: "°C", min: 0, max: 2, initial: [[0, 1], [0.5, 2], [1, 1]] },
    ],
};
fn run(p) { throw "it was run"; }
"#;

    #[test]
    fn a_plugin_says_what_it_is_before_it_runs() {
        let description = Plugin::read(GOOD).expect("a plugin").description;
        assert_eq!((description.name.as_str(), description.kind), ("Test", PluginKind::Weather));
        assert_eq!((description.author.as_str(), description.version.as_str()), ("A", "2"));
        assert_eq!(description.parameters.len(), 12);
        let length = description.parameter("length_s").expect("a length");
        let ParameterKind::Number(span) = &length.kind else { unreachable!("{length:?}") };
        assert_eq!((span.hard, span.soft, span.step, span.unit.as_str()), ([1.0, 60.5], [1.0, 30.0], Some(0.5), "s"));
        let initial = |name: &str| description.parameter(name).expect(name).initial.clone();
        assert_eq!(initial("length_s"), ParameterValue::Number(9.0));
        assert_eq!(initial("count"), ParameterValue::Whole(-3));
        assert_eq!(initial("mode"), ParameterValue::Text("calm".into()));
        assert_eq!(initial("tint"), ParameterValue::Color([1.0, 0.5, 0.0]));
        assert_eq!(initial("way"), ParameterValue::Whole(0));
        assert_eq!(initial("report"), ParameterValue::Text("METAR EDDF".into()));
        let curve = ParameterValue::Curve(vec![[0.0, 1.0], [0.5, 2.0], [1.0, 1.0]]);
        assert_eq!(initial("over_day"), curve);
        let read = |text: &str| description.parameter("over_day").expect("a curve").read_text(text);
        assert_eq!(read(&curve.to_string()), Ok(curve));
        for bad in ["", "0", "0:1,0:2", "0:3", "0:NaN", "NaN:1", "0:1;1:1"] {
            assert!(read(bad).is_err(), "{bad}");
        }
        let shown = description.parameter("tint").and_then(|tint| tint.shown_if.clone());
        assert_eq!(shown, Some(("mode".into(), ParameterValue::Text("wild".into()))));
    }

    #[test]
    fn an_exporter_says_what_its_files_end_in() {
        let read = |ending: &str| {
            let head = format!("const PLUGIN = #{{ name: \"E\", kind: \"exporter\", sentence: \"E.\"{ending} }};");
            let written = format!("{head}\nfn run(p) {{ \"\" }}");
            Plugin::read(&written).map(|plugin| plugin.description.ending).map_err(|error| error.to_string())
        };
        assert_eq!(read(""), Ok("txt".into()));
        assert_eq!(read(", ending: \"csv\""), Ok("csv".into()));
        for bad in ["", ".csv", "a/b", "CSV", "much too long", "ä"] {
            let error = read(&format!(", ending: \"{bad}\"")).expect_err(bad);
            assert!(error.contains("is no ending of files (small letters"), "{error}");
        }
    }

    /// `from` in the good one replaced with `to`: the fault is where the text `at` begins.
    #[test]
    fn faults_have_their_place_and_say_what_was_meant() {
        for (from, to, at, words) in [
            ("sentence:", "sentense:", "sentense:", "PLUGIN has no `sentense` (did you mean `sentence`?"),
            (", sentence: \"For tests.\"", "", "#{\n    name: \"Test\"", "PLUGIN lacks `sentence`"),
            ("\"For tests.\"", "\" \"", "\" \"", "sentence is empty"),
            ("\"Test\"", "7", "7, kind: \"weather\"", "name is a whole number, where a text is expected"),
            ("\"weather\"", "\"wether\"", "\"wether\"", "did you mean `weather`?"),
            ("label:", "lable:", "lable:", "did you mean `label`?"),
            ("\"integer\"", "\"intger\"", "\"intger\"", "did you mean `integer`?"),
            ("min: 1,", "min: 99,", "60.5", "max is below min"),
            ("soft_max: 30", "soft_max: 61", "61", "do not lie in order"),
            ("step: 0.5", "step: 0", "0, initial: 9", "above 0"),
            ("initial: 9", "initial: 99", "99 }", "99 is not a number from 1 to 60.5 s"),
            ("initial: -3", "initial: 1.5", "1.5 }", "is a number, where a whole number"),
            (
                "#{ name: \"count\"",
                "#{ name: \"length_s\"",
                "\"length_s\", kind: \"integer\"",
                "two parameters “length_s”",
            ),
            ("\"count\"", "\"Count 1\"", "\"Count 1\"", "is no name of a parameter"),
            ("[\"calm\", \"wild\"]", "[]", "[] }", "nothing to choose from"),
            ("[1, 0.5, 0]", "[1, 0.5]", "[1, 0.5],", "where a colour"),
            ("#{ mode: \"wild\" }", "#{ mood: \"wild\" }", "mood", "did you mean `mode`?"),
            ("#{ mode: \"wild\" }", "#{ mode: \"wlid\" }", "\"wlid\"", "the names are calm, wild"),
            ("initial: 7", "initial: -7", "-7", "it is 0 or more"),
            ("[0.5, 2]", "[0.5]", "[0.5]", "a point is a list, where a list of two numbers"),
            ("[0.5, 2]", "[0, 2]", "[[0, 1]", "to the right of the one before"),
            ("[0.5, 2]", "[0.5, 3]", "[[0, 1]", "0:1,0.5:3,1:1 is not a curve"),
            ("author:", "ending: \"csv\", author:", "\"csv\"", "kind weather writes no files"),
            ("initial: 9", "initial: f()", "f()", "would have to be computed"),
            ("const PLUGIN", "let PLUGIN", "// A script", "does not say what it is"),
        ] {
            let source = GOOD.replacen(from, to, 1);
            assert_ne!(source, GOOD, "{from}");
            let before = &source[..source.find(at).expect(at)];
            let (line, column) = (
                before.matches('\n').count() + 1,
                before.lines().next_back().map_or(0, |line| line.chars().count()) + 1,
            );
            let error = Plugin::read(&source).expect_err(to);
            assert_eq!(error.fault, Fault::Description, "{error}");
            assert!(error.to_string().contains(words), "{to}: no “{words}” in: {error}");
            assert_eq!(error.place.map(|place| (place.line, place.column)), Some((line, column)), "{to}: {error}");
        }
    }
}
