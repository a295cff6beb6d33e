//! `cloudwright new`: a scene to start from, without the window.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::input;
use crate::starter::starter_scene;
use cloudwright_core::preset::Preset;
use cloudwright_core::scene::Scene;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Arguments {
    /// File to write, NAME.cloudscene
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// What is in the scene; `starter` if not given
    #[arg(long, value_name = "NAME")]
    preset: Option<String>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

/// What `new` writes if no preset is named.
const STARTER: (&str, &str) = ("starter", "One small cumulus before the camera, as in the editor's new scene.");

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    input::check_scene_name(&arguments.output)?;
    input::save_scene(&scene_of(arguments.preset.as_deref())?, None, &arguments.output, arguments.force)
}

/// The scene that a preset's name stands for.
fn scene_of(preset: Option<&str>) -> Result<Scene, Failure> {
    match preset {
        None => Ok(starter_scene()),
        Some(name) if name == STARTER.0 => Ok(starter_scene()),
        Some(name) => Preset::by_name(name).map(Preset::scene).ok_or_else(|| {
            let what = format!("--preset {name}: there is no such preset");
            let names: Vec<&str> = presets().map(|(name, _)| name).collect();
            Failure::argument(what, format!("{}the presets are {}", did_you_mean(name, &names), names.join(", ")))
        }),
    }
}

/// Names and what they stand for.
fn presets() -> impl Iterator<Item = (&'static str, &'static str)> {
    std::iter::once(STARTER).chain(Preset::ALL.iter().map(|preset| (preset.name, preset.help)))
}

fn after_help() -> String {
    let mut text = String::from(
        "Examples:
  cloudwright new sky.cloudscene
  cloudwright new sky.cloudscene --preset cumulus_congestus
  cloudwright new sky.cloudscene --force

Presets:",
    );
    for (name, help) in presets() {
        let _ = write!(text, "\n  {name:<20}  {help}");
    }
    text
}
