//! `cloudwright run`: a plugin does what it does, to a scene or to an empty one; an exporter writes a file of its own.

use super::failure::Failure;
use super::plugins::{self, Found};
use super::progress::Progress;
use super::{input, say};
use crate::opening;
use crate::saving::{self, SaveError};
use crate::scripting::{self, Request};
use crate::storage::{self, Over};
use crate::units::counted;
use cloudwright_core::document::Document;
use cloudwright_core::scene::Scene;
use cloudwright_scripts::{Fault, Outcome, ParameterKind, Patience, Plugin, PluginKind, ScriptError, Values};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright run scatter_clouds -o sky.cloudscene --set count=40 --seed 7
  cloudwright run diurnal_cumulus sky.cloudscene -o day.cloudscene --set length_s=60 --set looped=yes
  cloudwright run mine.rhai sky.cloudscene -o out.cloudscene
  cloudwright run sprite_table sky.cloudscene -o sky.xyz --set axes=z_up

A plugin is one of those that `cloudwright plugins` lists, or a file that ends in .rhai; `cloudwright plugins NAME` tells
what can be set. Exporters write a file other than a scene. Without SCENE the others begin with an empty day. If anything fails, nothing is
written. Ctrl-C stops it.
Same plugin, scene and values: same scene, on every machine.")]
pub(super) struct Arguments {
    /// Plugin to run, by its name or as a file, NAME.rhai
    #[arg(value_name = "PLUGIN")]
    plugin: String,
    /// Scene that it starts from; an empty one if not given
    scene: Option<PathBuf>,
    /// Scene to write; of an exporter its file
    #[arg(short, long, value_name = "FILE")]
    output: PathBuf,
    /// What a parameter is to be, as often as needed
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Another seed, for plugins that have one
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// How long the script may take, 1 to 3600; about 2 if not given
    #[arg(long, value_name = "SECONDS", value_parser = clap::value_parser!(u64).range(1..=3600))]
    patience: Option<u64>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Found { from, plugin } = plugins::find(&arguments.plugin)?;
    let values = values(arguments, &plugin)?;
    if plugin.description.kind == PluginKind::Exporter {
        return export(arguments, &Found { from, plugin }, &values);
    }
    let scene = match &arguments.scene {
        Some(path) => opening::open(path)?.0,
        None => Scene::default(),
    };
    input::check_scene_name(&arguments.output)?;
    check_output(arguments, &scene)?;
    let outcome = outcome(arguments, &plugin, &scene, &values).map_err(|error| failure(&from, &error))?;
    let mut document = Document::new(scene);
    let (edits, printed) = (outcome.edits.len(), outcome.printed.clone());
    let done = outcome.apply(&plugin, &mut document);
    done.map_err(|error| Failure::could_not(error.to_string(), "report this"))?;
    input::save_scene(document.scene(), arguments.scene.as_deref(), &arguments.output, arguments.force)?;
    printed.iter().for_each(|line| say(line));
    say(&format!("{}: {}", plugin.description.name, counted(edits, "edit", "edits")));
    Ok(())
}

fn outcome(arguments: &Arguments, plugin: &Plugin, scene: &Scene, values: &Values) -> Result<Outcome, ScriptError> {
    let progress = Progress::start_stoppable("running the plugin");
    let time = arguments.patience.map_or(Patience::USUAL, Duration::from_secs);
    let patience = Patience { cancelled: progress.watch().cancelled(), until: Some(Instant::now() + time) };
    scripting::run(Request { plugin, scene, selected: &[], values }, &patience)
}

/// Writes what an exporter makes of a scene, all or nothing.
fn export(arguments: &Arguments, Found { from, plugin }: &Found, values: &Values) -> Result<(), Failure> {
    let Some(path) = &arguments.scene else {
        let what = format!("{from}: there is nothing to export");
        return Err(Failure::argument(what, format!("name a scene: cloudwright run {from} SCENE -o FILE")));
    };
    let output = &arguments.output;
    if input::check_scene_name(output).is_ok() {
        let what = format!("--output {}: an exporter writes no scene", output.display());
        return Err(Failure::argument(what, "end its name otherwise"));
    }
    let scene = opening::open(path)?.0;
    input::check_output(&scene, path, output)?;
    let Outcome { printed, text, .. } =
        outcome(arguments, plugin, &scene, values).map_err(|error| failure(from, &error))?;
    let text = text.unwrap_or_default();
    let over = if arguments.force { Over::Anything } else { Over::Nothing };
    storage::write_over(output, text.as_bytes(), over).map_err(|error| Failure::from(SaveError::Storage(error)))?;
    printed.iter().for_each(|line| say(line));
    say(&format!("{}: {}", plugin.description.name, counted(text.lines().count(), "line", "lines")));
    Ok(())
}

fn values(arguments: &Arguments, plugin: &Plugin) -> Result<Values, Failure> {
    let parameters = &plugin.description.parameters;
    let mut values = plugin.values();
    let refuse = |flag: &str, error: &ScriptError| Failure::argument(format!("{flag}: {}", error.message), &error.hint);
    for set in &arguments.set {
        let Some((name, value)) = set.split_once('=') else {
            return Err(Failure::argument(format!("--set {set}: there is no ="), "write it as count=40"));
        };
        values.set(parameters, name.trim(), value).map_err(|error| refuse("--set", &error))?;
    }
    if let Some(seed) = arguments.seed {
        let Some(parameter) = parameters.iter().find(|parameter| parameter.kind == ParameterKind::Seed) else {
            let what = format!("--seed {seed}: {} has no seed", arguments.plugin);
            return Err(Failure::argument(what, "it makes the same each time"));
        };
        values.set(parameters, &parameter.name, &seed.to_string()).map_err(|error| refuse("--seed", &error))?;
    }
    Ok(values)
}

/// Known before the work: whether the output can be written, and is none of what is read.
fn check_output(arguments: &Arguments, scene: &Scene) -> Result<(), Failure> {
    let Arguments { scene: from, output, .. } = arguments;
    match from {
        Some(from) => input::check_output(scene, from, output)?,
        None => storage::check_writable(output)?,
    }
    saving::to_copy(scene, from.as_deref(), output)?;
    Ok(())
}

/// `from: line 3, column 7: message (hint)`.
pub(super) fn failure(from: &str, error: &ScriptError) -> Failure {
    let place = error.place.map(|place| format!("line {}, column {}: ", place.line, place.column)).unwrap_or_default();
    let what = format!("{from}: {place}{}", error.message);
    match error.fault {
        Fault::Cancelled => Failure::stopped(),
        Fault::Broken => Failure::could_not(what, &error.hint),
        _ if error.hint.is_empty() => Failure::argument(what, "nothing is written; mend the script there"),
        _ => Failure::argument(what, &error.hint),
    }
}

/// Whether `word` is the name of a file, not of a plugin.
pub(super) fn is_file(word: &str) -> bool {
    Path::new(word).extension().is_some_and(|ending| ending.eq_ignore_ascii_case("rhai"))
}
