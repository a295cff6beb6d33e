//! `cloudwright plugins`: which there are, and what can be set.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::run::{failure, is_file};
use super::{answer, counted};
use crate::storage;
use cloudwright_scripts::shipped::{self, SHIPPED};
use cloudwright_scripts::{Parameter, ParameterKind, Plugin};
use std::fmt::Write;
use std::path::Path;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright plugins
  cloudwright plugins scatter_clouds
  cloudwright plugins mine.rhai

What a plugin says of itself is read from its text; nothing of it runs.")]
pub(super) struct Arguments {
    /// Plugin to describe, by its name or as a file, NAME.rhai; all of them in short if not given
    #[arg(value_name = "PLUGIN")]
    plugin: Option<String>,
}

/// Larger files are no scripts; of smaller ones the scripts' own limit tells.
const FILE_BYTES: usize = 1 << 20;

/// A plugin and where it is from.
pub(super) struct Found {
    /// Its file, or its name.
    pub(super) from: String,
    pub(super) plugin: Plugin,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    match &arguments.plugin {
        Some(word) => answer(&page(&find(word)?)),
        None => answer(&list()?),
    }
}

/// The plugin that `word` names.
pub(super) fn find(word: &str) -> Result<Found, Failure> {
    let source = if is_file(word) {
        let bytes = storage::read(Path::new(word), FILE_BYTES)?;
        String::from_utf8(bytes)
            .map_err(|_| Failure::argument(format!("{word}: this is no text"), "a plugin is a text in UTF-8"))?
    } else {
        let Some(shipped) = shipped::named(word) else {
            let names: Vec<&str> = SHIPPED.iter().map(|shipped| shipped.name).collect();
            let hint =
                format!("{}the plugins are {}, or a file NAME.rhai", did_you_mean(word, &names), names.join(", "));
            return Err(Failure::argument(format!("there is no plugin “{word}”"), hint));
        };
        shipped.source.into()
    };
    let plugin = Plugin::read(&source).map_err(|error| failure(word, &error))?;
    Ok(Found { from: word.into(), plugin })
}

fn list() -> Result<String, Failure> {
    let mut text = String::new();
    for shipped in SHIPPED {
        let Found { plugin, .. } = find(shipped.name)?;
        let _ =
            writeln!(text, "{:<20}{:<11}{}", shipped.name, plugin.description.kind.name(), plugin.description.sentence);
    }
    Ok(text)
}

fn page(found: &Found) -> String {
    let description = &found.plugin.description;
    let mut text = format!("{} ({})\n{}\n", description.name, description.kind.name(), description.sentence);
    let by = [description.author.as_str(), description.version.as_str()].join(" ");
    if !by.trim().is_empty() {
        let _ = writeln!(text, "{}", by.trim());
    }
    let _ = writeln!(text, "\n{}:", counted(description.parameters.len(), "parameter", "parameters"));
    for parameter in &description.parameters {
        let _ = writeln!(text, "  {:<16}{}", parameter.name, meaning(parameter));
    }
    // Whatever a script says of itself is shown as one can see it, line by line.
    text.lines().map(|line| crate::visible::one_line(line) + "\n").collect()
}

fn meaning(parameter: &Parameter) -> String {
    let Parameter { label, help, kind, initial, .. } = parameter;
    let kind = match kind {
        ParameterKind::Seed => "a seed".into(),
        kind => kind.to_string(),
    };
    let initial = initial.to_string();
    let initial = if initial.is_empty() { "empty".into() } else { initial };
    let mut text = format!("{label}: {kind}; {initial} if not given");
    if !help.is_empty() {
        text.push_str(". ");
        text.push_str(help.trim_end_matches('.'));
    }
    text
}
