//! `cloudwright thin`: a scene with no more sprites than its pictures need.

use super::failure::Failure;
use super::progress::Progress;
use super::{input, say};
use crate::units::counted;
use crate::{opening, saving};
use cloudwright_core::document::Document;
use cloudwright_core::thin::{ThinError, thin};
use cloudwright_core::weather::Timeline;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright thin overcast.cloudscene --tolerance 0.01 -o light.cloudscene

Sprites are dropped that show least, as long as no view differs from the scene as it was by more than the tolerance:
neither from its cameras, nor along its paths, nor in eight views around each cloud, by the light of its time of day.
Of many clouds, 150 are looked at from around: of each model its share, and first of those with the most sprites. A model
of which none is looked at keeps all its sprites. Ctrl-C stops it; nothing is written then.
The difference is the mean FLIP, 0 to 1: 0.01 is hard to see, 0.05 is plain. In the editor it is a command that can be
undone; by hand, Reset gives a sprite back. Into another folder, the scene takes its own atlas and models along.")]
pub(super) struct Arguments {
    /// Scene to thin
    scene: PathBuf,
    /// Scene to write
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
    /// Largest mean FLIP of any view, above 0 and at most 1
    #[arg(long, value_name = "FLIP", default_value_t = 0.01)]
    tolerance: f64,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (scene, beside) = opening::open(&arguments.scene)?;
    input::check_scene_name(&arguments.output)?;
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    saving::to_copy(&scene, Some(&arguments.scene), &arguments.output)?;
    let progress = Progress::start_stoppable("thinning");
    let thinned = thin(&scene, beside.sheet(), arguments.tolerance, progress.watch());
    drop(progress);
    let thinned = thinned.map_err(|error| failure(&error))?;
    let moves = Timeline::new(&scene).moves();
    let mut document = Document::new(scene);
    let done = document.edit("Thin", thinned.edits);
    done.map_err(|error| Failure::could_not(error.to_string(), "report this"))?;
    input::save_scene(document.scene(), Some(&arguments.scene), &arguments.output, arguments.force)?;
    say(&format!(
        "sprites: {} of {} are left, {:.0} %",
        thinned.after,
        thinned.before,
        100.0 * thinned.after as f64 / thinned.before as f64
    ));
    say(&format!(
        "error: mean FLIP {:.4} at most, of {}; that is {}",
        thinned.error,
        counted(thinned.views, "view", "views"),
        thinned.worst_view
    ));
    if moves {
        say("judged at rest: where wind and dry air part clouds, what was hidden may be missed");
    }
    if thinned.models_left > 0 {
        let left = counted(thinned.models_left, "model keeps", "models keep");
        say(&format!("not looked at from around: {left} all sprites, as other models have more"));
    }
    Ok(())
}

fn failure(error: &ThinError) -> Failure {
    let message = error.to_string();
    match error {
        ThinError::Tolerance(_) => Failure::argument(format!("--tolerance: {message}"), "such as 0.01"),
        ThinError::NoSprites => Failure::argument(message, "there is nothing to thin"),
        ThinError::CannotHold { .. } => Failure::could_not(message, "nothing is written; raise the tolerance"),
        ThinError::Cancelled => Failure::stopped(),
    }
}
