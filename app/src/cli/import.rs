//! `cloudwright import`: what another tool made, into a scene.

use super::exchange::{Answer, choice_failure, set_options, tell_notes};
use super::failure::Failure;
use super::progress::Progress;
use super::run::failure as plugin_failure;
use super::weather::layer_line;
use super::{answer, info, input, say};
use crate::exchange::{CameIn, ChooseError, ComeInError, Placing, ReadError, called, choose, come_in, read};
use crate::reports::{MOST_TIME, MakeError};
use crate::starter::empty_sky;
use crate::storage::FileId;
use crate::units::counted;
use crate::{opening, saving, storage};
use cloudwright_core::document::Document;
use cloudwright_core::exchange::{Arrived, ArrivedModel, Content, Note};
use cloudwright_core::scene::Scene;
use cloudwright_scripts::Patience;
use glam::DVec3;
use std::path::PathBuf;
use std::time::Instant;

/// Of clouds: at a fair-weather cumulus' height.
const USUAL_PLACE: DVec3 = DVec3::new(0.0, 1000.0, 0.0);

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright import cumulus.cld -o cumulus.cloudscene
  cloudwright import cumulus.cld sky.cloudscene -o more.cloudscene --at 2000,1200,-500
  cloudwright import Thunderstorms.WPR -o storm.cloudscene --seed 3
  cloudwright import island.glb sky.cloudscene -o coast.cloudscene --at 0,0,-8000
  cloudwright import jet.glb sky.cloudscene -o flown.cloudscene --set flies=yes

The file's ending chooses the format, or else --format does; `cloudwright formats` lists them, with what each carries and
what can be set of it. What could not be carried, and what the file does not say and was taken, is said on stderr. Without
SCENE, what comes in stands alone under an empty day's sky. A weather preset's clouds are made by the plugins that ship, as
many as cover the sky as it says, measured from below; they take the place of those that are there. A glTF model that was
not exported from here stands as a prop, or is an aircraft on the scene's first path with --set flies=yes; its file is copied
beside the scene that is written.")]
pub(super) struct Arguments {
    /// File to import; its ending chooses the format
    file: PathBuf,
    /// Scene that takes it; an empty one if not given
    scene: Option<PathBuf>,
    /// Scene to write
    #[arg(short, long, value_name = "SCENE")]
    output: PathBuf,
    /// The format, where the ending does not choose it
    #[arg(long, value_name = "NAME")]
    format: Option<String>,
    /// What an option of the format is to be, as often as needed
    #[arg(long, value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// Where it is put: x east, y up, z south, metres; clouds at 0,1000,0 if not given, a model at 0,0,0
    #[arg(long, value_name = "X,Y,Z", value_parser = place, allow_hyphen_values = true)]
    at: Option<DVec3>,
    /// Of weather: keep the clouds that are there
    #[arg(long)]
    keep_clouds: bool,
    /// Of weather: another sky of the same preset
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
    /// Answer with what came in, and what did not, as JSON
    #[arg(long)]
    json: bool,
    /// Replace a file that is there
    #[arg(long)]
    force: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let Arguments { file, output, .. } = arguments;
    let format = choose(file, arguments.format.as_deref()).map_err(|error| match error {
        ChooseError::Storage(error) => error.into(),
        ChooseError::Choice(error) => choice_failure(&error, &file.display().to_string(), false),
    })?;
    let mut options = format.usual_for_reading();
    set_options(&mut options, &arguments.set, format.read_options)?;
    let scene = match &arguments.scene {
        Some(path) => opening::open(path)?.0,
        None => empty_sky(),
    };
    check_output(arguments, &scene)?;
    let Arrived { content, mut notes } = read(file, format, &options).map_err(|error| match error {
        ReadError::Storage(error) => error.into(),
        misread @ ReadError::Misread { .. } => {
            let hint = format!("it was read as {}, {}; --format reads it otherwise", format.name, format.title);
            Failure::argument(misread.to_string(), hint)
        }
    })?;
    let mut document = Document::new(scene);
    let said = take(arguments, &mut document, &content, &mut notes)?;
    match content {
        Content::Model(_) => {
            let from = (arguments.scene.as_deref(), file.as_path());
            input::save_scene_with(document.scene(), from, output, arguments.force)?;
        }
        _ => input::save_scene(document.scene(), arguments.scene.as_deref(), output, arguments.force)?,
    }
    if arguments.json {
        let files = vec![output.display().to_string()];
        return answer(&info::json_text(&Answer { format: format.name, files, notes: &notes })?);
    }
    said.iter().for_each(|line| say(line));
    tell_notes(&notes);
    Ok(())
}

/// Puts what came in into the document, and says what that was.
fn take(
    arguments: &Arguments,
    document: &mut Document,
    content: &Content,
    notes: &mut Vec<Note>,
) -> Result<Vec<String>, Failure> {
    if let (Content::Scene(scene), None) = (content, &arguments.scene) {
        *document = Document::new(Scene::clone(scene));
        return Ok(vec![format!("the whole scene, {}", counted(scene.clouds.len(), "cloud", "clouds"))]);
    }
    let file_name = arguments.file.file_name().unwrap_or_default();
    let file_name = file_name.to_str().ok_or_else(|| {
        Failure::argument(format!("{}: its name is no text", arguments.file.display()), "give it another name")
    })?;
    let Arguments { at, seed, keep_clouds: keeps_clouds, .. } = *arguments;
    let progress = Progress::start_stoppable("making the sky");
    let patience = Patience { cancelled: progress.watch().cancelled(), until: Some(Instant::now() + MOST_TIME) };
    let (at, model_at) = (at.unwrap_or(USUAL_PLACE), at.unwrap_or_default());
    let came = come_in(document, content, &Placing { file_name, at, model_at, seed, keeps_clouds }, &patience);
    drop(progress);
    let CameIn { models, clouds, layers, model, notes: taken } = came.map_err(|error| match error {
        ComeInError::Make(MakeError::Plugin { plugin, error }) => plugin_failure(plugin, &error),
        ComeInError::Make(broken) => Failure::could_not(broken.to_string(), "report this"),
        ComeInError::Edit(error) => Failure::argument(error.to_string(), "nothing is written; choose another --at"),
        whole @ ComeInError::Whole => {
            Failure::argument(format!("{}: {whole}", arguments.file.display()), "leave the other scene out")
        }
    })?;
    notes.extend(taken);
    if let Some((thing, ArrivedModel { size, triangles, .. })) = model {
        let [width, height, length] = size.to_array();
        let triangles = counted(triangles, "triangle", "triangles");
        return Ok(vec![format!(
            "{} of {triangles}, {width:.1} m wide, {height:.1} m high, {length:.1} m long",
            called(thing)
        )]);
    }
    Ok(match content {
        Content::Weather(_) if layers.is_empty() => vec!["the preset has no clouds".into()],
        Content::Weather(_) => layers.iter().map(layer_line).collect(),
        _ => vec![format!("{}, {}", counted(models, "model", "models"), counted(clouds.len(), "cloud", "clouds"))],
    })
}

/// Known before the work: whether the scene can be written, and is none of what is read.
fn check_output(arguments: &Arguments, scene: &Scene) -> Result<(), Failure> {
    let Arguments { file, scene: from, output, .. } = arguments;
    input::check_scene_name(output)?;
    match from {
        Some(from) => input::check_output(scene, from, output)?,
        None => storage::check_writable(output)?,
    }
    if FileId::of(file).is_some_and(|file| FileId::of(output) == Some(file)) {
        let what = format!("--output {}: that is what is imported", output.display());
        return Err(Failure::argument(what, "choose another name; it would be lost"));
    }
    saving::to_copy(scene, from.as_deref(), output)?;
    Ok(())
}

/// `2000,1200,-500`.
fn place(text: &str) -> Result<DVec3, String> {
    let is_sound = |number: &f64| number.abs() <= 5e7;
    let numbers: Vec<Option<f64>> = text.split(',').map(|part| part.trim().parse().ok().filter(is_sound)).collect();
    match numbers[..] {
        [Some(x), Some(y), Some(z)] => Ok(DVec3::new(x, y, z)),
        _ => Err("write three numbers of metres, such as 2000,1200,-500".into()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places() {
        assert_eq!(place("1, 2.5,-3"), Ok(DVec3::new(1.0, 2.5, -3.0)));
        for bad in ["1,2", "1,2,3,4", "1,2,NaN", "1,2,1e9", "1,b,2", "a,1,2,3", ""] {
            assert!(place(bad).is_err(), "{bad}");
        }
    }
}
