//! `cloudwright plugins`: which there are, and what can be set.

use super::answer;
use super::arguments::did_you_mean;
use super::failure::Failure;
use super::run::{failure, is_file};
use crate::plugins::{Entry, Library, Origin, ReadError};
use crate::storage::Folders;
use crate::units::counted;
use crate::visible;
use cloudwright_scripts::{Parameter, ParameterKind, Plugin};
use std::fmt::Write;
use std::path::Path;
use std::sync::Arc;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright plugins
  cloudwright plugins scatter_clouds
  cloudwright plugins mine.rhai
  cloudwright plugins --manual > MANUAL.md

The user's own lie in the folder `plugins` beside the settings, which the editor opens by Open plugin folder. Where one
of them has the name of one that ships, the name means that one; give the file instead. What a plugin says of itself is
read from its text; nothing of it runs.")]
pub(super) struct Arguments {
    /// Plugin to describe, by its name or as a file, NAME.rhai; all of them in short if not given
    #[arg(value_name = "PLUGIN")]
    plugin: Option<String>,
    /// The whole manual, as Markdown: all functions, and what ships
    #[arg(long, conflicts_with = "plugin")]
    manual: bool,
}

/// A plugin and where it is from.
pub(super) struct Found {
    /// Its file, or its name.
    pub(super) from: String,
    pub(super) plugin: Arc<Plugin>,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    if arguments.manual {
        let manual = cloudwright_scripts::manual::manual();
        return answer(&manual.map_err(|error| failure("a plugin that ships", &error))?);
    }
    match &arguments.plugin {
        Some(word) => answer(&page(&find(word)?)),
        None => answer(&list()),
    }
}

/// The plugin that `word` names: a file, or one of the library.
pub(super) fn find(word: &str) -> Result<Found, Failure> {
    if is_file(word) {
        return found(word.into(), Entry::of_file(Path::new(word)).read);
    }
    let library = library();
    match library.into_named(word) {
        Ok(Entry { origin: Origin::File(path), read }) => found(path.display().to_string(), read),
        Ok(Entry { read, .. }) => found(word.into(), read),
        Err(library) => {
            let names: Vec<String> = library.entries().iter().map(|entry| entry.origin.name()).collect();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            let hint =
                format!("{}the plugins are {}, or a file NAME.rhai", did_you_mean(word, &names), names.join(", "));
            Err(Failure::argument(format!("there is no plugin “{word}”"), hint))
        }
    }
}

fn found(from: String, read: Result<Arc<Plugin>, ReadError>) -> Result<Found, Failure> {
    match read {
        Ok(plugin) => Ok(Found { from, plugin }),
        Err(ReadError::Script(error)) => Err(failure(&from, &error)),
        Err(ReadError::Storage(error)) => Err(error.into()),
        Err(ReadError::NoText) => {
            Err(Failure::argument(format!("{from}: this is no text"), "a plugin is a text in UTF-8"))
        }
    }
}

/// All that ship, and those in the user's folder.
fn library() -> Library {
    Library::read(Folders::of_user().map(|folders| folders.plugins()).as_deref())
}

/// A line each; those of the user's folder under its name, a broken one with what is wrong.
fn list() -> String {
    let mut text = String::new();
    let mut are_theirs = false;
    for Entry { origin, read } in library().entries() {
        if let (Origin::File(path), false) = (origin, are_theirs) {
            are_theirs = true;
            let _ = writeln!(text, "\nin {}:", path.parent().unwrap_or(path).display());
        }
        let (kind, words) = match read {
            Ok(plugin) => (plugin.description.kind.name(), plugin.description.sentence.clone()),
            Err(error) => ("broken", error.to_string()),
        };
        let _ = writeln!(text, "{:<20}{kind:<11}{words}", origin.name());
    }
    as_seen(&text)
}

fn page(found: &Found) -> String {
    let description = &found.plugin.description;
    let mut text = format!("{} ({})\n{}\n", description.name, description.kind.name(), description.sentence);
    let by = [description.author.as_str(), description.version.as_str()].join(" ");
    if !by.trim().is_empty() {
        let _ = writeln!(text, "{}", by.trim());
    }
    if !description.ending.is_empty() {
        let _ = writeln!(text, "Its files end in .{} if nothing else is given.", description.ending);
    }
    let _ = writeln!(text, "\n{}:", counted(description.parameters.len(), "parameter", "parameters"));
    for parameter in &description.parameters {
        let _ = writeln!(text, "  {:<16}{}", parameter.name, meaning(parameter));
    }
    as_seen(&text)
}

/// Whatever a script says of itself is shown as one can see it, line by line.
fn as_seen(text: &str) -> String {
    text.lines().map(|line| visible::one_line(line) + "\n").collect()
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
