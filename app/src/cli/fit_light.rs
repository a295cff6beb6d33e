//! `cloudwright fit-light`: a scene whose clouds are lit as nearly as they can be as a path tracer lights them.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::progress::Progress;
use super::{input, say};
use crate::units::{hour, time_of_day};
use crate::{opening, saving};
use cloudwright_core::document::Document;
use cloudwright_core::fit_light::{Choice, FitError, FittedModel, Free, MOST_SAMPLES, USUAL_SAMPLES, fit_light};
use cloudwright_core::scene::{ModelId, Scene};
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright fit-light fair_weather.cloudscene -o lit.cloudscene
  cloudwright fit-light storm.cloudscene -o lit.cloudscene --model cumulonimbus --time 18:00 --time 20:30
  cloudwright fit-light storm.cloudscene -o lit.cloudscene --keep levels --keep self-shadow

One cloud of each model is looked at alone, at rest, from six places, by the suns of the scene's hour and of 8, 12, 16 and 20
o'clock as far as the sun is up; a slow path tracer says what its vapour would show. The brightness of the five colour levels,
the three shares of each box and shading group (evenly from the cloud's bottom to its top) and the self-shadow are set so that
the sprites' light comes nearest to that. Hues, heights and opacities of the levels stay, and so does the halo. A card that
faces the sun is as bright as the scene's greatest directional light, the sky as the one that is drawn is on average, and what
is below the horizon a fifth of that; on the whole the cloud stays as bright as it was.
The error is the root of the mean square of the difference, the sky's light and the sun's each by itself, as a share of the
path tracer's; the correlation says how light and shade lie in the same places, 1 at best. A model that can't be brought
nearer stays as it is. Ctrl-C stops it; nothing is written then. In the editor it is a command that can be undone.")]
pub(super) struct Arguments {
    /// Scene to fit
    scene: PathBuf,
    /// Scene to write
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
    /// Name of a model to fit; all that clouds show if not given
    #[arg(long, value_name = "NAME")]
    model: Vec<String>,
    /// Time of day whose sun counts, in place of the usual ones
    #[arg(long, value_name = "HH:MM", value_parser = time_of_day)]
    time: Vec<f64>,
    /// What stays as it is
    #[arg(long, value_enum, value_name = "WHAT")]
    keep: Vec<Part>,
    /// Samples a pixel of the path tracer's; four times as many halve its noise
    #[arg(long, value_name = "N", default_value_t = USUAL_SAMPLES, value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_SAMPLES)))]
    samples: u32,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

/// What can be fitted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Part {
    /// The brightness of the colour levels
    Levels,
    /// The shares of the directional light: Cmin, Cmed and Cmax
    Shares,
    /// The self-shadow
    SelfShadow,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let (scene, beside) = opening::open(&arguments.scene)?;
    input::check_scene_name(&arguments.output)?;
    input::check_output(&scene, &arguments.scene, &arguments.output)?;
    saving::to_copy(&scene, Some(&arguments.scene), &arguments.output)?;
    let is_free = |part: Part| !arguments.keep.contains(&part);
    let choice = Choice {
        models: models(&scene, &arguments.scene, &arguments.model)?,
        free: Free {
            levels: is_free(Part::Levels),
            shares: is_free(Part::Shares),
            self_shadow: is_free(Part::SelfShadow),
        },
        hours: arguments.time.clone(),
        samples: arguments.samples,
    };
    let progress = Progress::start_stoppable("fitting light");
    let fitted = fit_light(&scene, beside.sheet(), &choice, progress.watch());
    drop(progress);
    let fitted = fitted.map_err(|error| failure(&error))?;
    let mut document = Document::new(scene);
    let done = document.edit("Fit light", fitted.edits);
    done.map_err(|error| Failure::could_not(error.to_string(), "report this"))?;
    input::save_scene(document.scene(), Some(&arguments.scene), &arguments.output, arguments.force)?;
    let hours: Vec<String> = fitted.hours.iter().map(|time_h| hour(*time_h)).collect();
    say(&format!("by the sun at {}", hours.join(", ")));
    fitted.models.iter().flat_map(FittedModel::in_words).for_each(|line| say(&line));
    Ok(())
}

/// The models of those names, each once.
fn models(scene: &Scene, file: &Path, names: &[String]) -> Result<Vec<ModelId>, Failure> {
    let mut models = Vec::new();
    for name in names {
        let of_name = scene.models.iter().filter(|model| model.name == *name).map(|model| model.id);
        let before = models.len();
        models.extend(of_name);
        if models.len() == before {
            let names: Vec<&str> = scene.models.iter().map(|model| model.name.as_str()).collect();
            let what = format!("--model: {}: there is no model “{name}”", file.display());
            let hint = format!("{}the models are {}", did_you_mean(name, &names), names.join(", "));
            return Err(Failure::argument(
                what,
                if names.is_empty() { "the scene has no models".into() } else { hint },
            ));
        }
    }
    models.sort_unstable();
    models.dedup();
    Ok(models)
}

fn failure(error: &FitError) -> Failure {
    let message = error.to_string();
    match error {
        FitError::NothingFree => Failure::argument(format!("--keep: {message}"), "keep at most two of the three"),
        FitError::NoClouds => Failure::argument(message, "there is nothing to fit"),
        FitError::SunIsDown(time_h) => {
            let what = format!("--time {}: the sun is not above the horizon then", hour(*time_h));
            Failure::argument(what, "name hours of daylight; it must stand 2° high")
        }
        FitError::NeverUp => Failure::argument(message, "name hours of daylight by --time"),
        FitError::Cancelled => Failure::stopped(),
    }
}
