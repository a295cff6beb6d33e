//! `cloudwright new`: a scene to start from, without the window.

use super::failure::Failure;
use crate::editor;
use crate::saving::{self, SaveError};
use crate::storage::{Over, StorageError};
use cloudwright_core::formats::scene_file::EXTENSION;
use cloudwright_core::scene::Scene;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = after_help())]
pub(super) struct Arguments {
    /// File to write, NAME.cloudscene
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// What is in the scene; the first preset below if not given
    #[arg(long, value_name = "NAME")]
    preset: Option<String>,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

/// A scene with its name and what it holds.
struct Preset {
    name: &'static str,
    help: &'static str,
    scene: fn() -> Scene,
}

/// The first one is what `new` writes if no other is named.
const PRESETS: &[Preset] = &[Preset {
    name: "starter",
    help: "one small cumulus before the camera, as in the editor's new scene",
    scene: editor::starter_scene,
}];

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { output, preset, force } = arguments;
    if !output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(EXTENSION)) {
        let what = format!("OUT {}: the ending is not a scene's", output.display());
        return Err(Failure::argument(what, format!("end its name in .{EXTENSION}")));
    }
    let scene = scene_of(preset.as_deref())?;
    let over = if *force { Over::Anything } else { Over::Nothing };
    saving::save(&scene, output, over).map(drop).map_err(|error| match error {
        SaveError::Storage(error @ StorageError::InTheWay { .. }) => {
            Failure::argument(error.to_string(), "choose another name, or --force")
        }
        SaveError::Storage(error) => error.into(),
        error @ SaveError::Text(_) => Failure::could_not(error.to_string(), "report this"),
    })
}

/// The scene that a preset's name stands for.
fn scene_of(preset: Option<&str>) -> Result<Scene, Failure> {
    let found = match preset {
        Some(name) => PRESETS.iter().find(|preset| preset.name == name),
        None => PRESETS.first(),
    };
    found.map(|preset| (preset.scene)()).ok_or_else(|| {
        let what = format!("--preset {}: there is no such preset", preset.unwrap_or_default());
        let names: Vec<&str> = PRESETS.iter().map(|preset| preset.name).collect();
        Failure::argument(what, format!("the presets are {}", names.join(", ")))
    })
}

fn after_help() -> String {
    let mut text = String::from(
        "Examples:
  cloudwright new sky.cloudscene
  cloudwright new sky.cloudscene --preset starter
  cloudwright new sky.cloudscene --force

Presets:",
    );
    for Preset { name, help, .. } in PRESETS {
        let _ = write!(text, "\n  {name:<20}  {help}");
    }
    text
}
