//! What several subcommands take from a scene.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::say;
use crate::saving::{self, Saved};
use crate::storage::{self, Over};
use cloudwright_core::formats::scene_file::EXTENSION;
use cloudwright_core::scene::{Camera, CameraPath, Scene};
use std::path::Path;

/// The camera of that name, or the scene's first.
pub(super) fn camera<'a>(scene: &'a Scene, path: &Path, name: Option<&str>) -> Result<&'a Camera, Failure> {
    let found = match name {
        Some(name) => scene.camera_named(name),
        None => scene.cameras.first(),
    };
    found.ok_or_else(|| {
        let what = match name {
            Some(name) => format!("{}: cameras: there is no camera “{name}”", path.display()),
            None => format!("{}: cameras: the scene has none", path.display()),
        };
        let names: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
        let hint = if names.is_empty() {
            "add a camera in the editor".into()
        } else {
            let nearest = name.map(|name| did_you_mean(name, &names)).unwrap_or_default();
            format!("{nearest}the cameras are {}", names.join(", "))
        };
        Failure::argument(what, hint)
    })
}

/// The path of that name, if one can fly along it.
pub(super) fn path<'a>(scene: &'a Scene, file: &Path, name: &str) -> Result<&'a CameraPath, Failure> {
    let Some(path) = scene.path_named(name) else {
        let names: Vec<&str> = scene.paths.iter().map(|path| path.name.as_str()).collect();
        let hint = if names.is_empty() {
            "the scene has no paths; record one in the editor".into()
        } else {
            format!("{}the paths are {}", did_you_mean(name, &names), names.join(", "))
        };
        return Err(Failure::argument(format!("{}: paths: there is no path “{name}”", file.display()), hint));
    };
    if path.keys.len() < 2 {
        let what = format!("{}: paths: “{name}” stands still: it has one key", file.display());
        return Err(Failure::argument(what, "add a key with a later time, or draw a still from a camera"));
    }
    Ok(path)
}

/// Known before the work, not after it: whether `output` can be written, and is none of the files that are read, which
/// are the scene's `file` and what it names.
pub(super) fn check_output(scene: &Scene, file: &Path, output: &Path) -> Result<(), Failure> {
    spare_inputs(scene, file, output)?;
    Ok(storage::check_writable(output)?)
}

/// That `output` is none of the files that are read, by whatever name.
pub(super) fn spare_inputs(scene: &Scene, file: &Path, output: &Path) -> Result<(), Failure> {
    match saving::in_use(scene, file, output) {
        Some(what) => {
            let what = format!("--output {}: that is {what}", output.display());
            Err(Failure::argument(what, "choose another name; it would be lost"))
        }
        None => Ok(()),
    }
}

/// That a scene would be written under a scene's name.
pub(super) fn check_scene_name(output: &Path) -> Result<(), Failure> {
    if output.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(EXTENSION)) {
        return Ok(());
    }
    let what = format!("{}: the ending is not a scene's", output.display());
    Err(Failure::argument(what, format!("end its name in .{EXTENSION}")))
}

/// Saves a scene that was read from the file `from`, if from any; over a file that is there only by `force`. What it
/// names is copied along.
pub(super) fn save_scene(scene: &Scene, from: Option<&Path>, output: &Path, force: bool) -> Result<(), Failure> {
    tell_copied(&saving::save(scene, from, output, over(force))?);
    Ok(())
}

/// The same, where `file`, which the scene names, came into it.
pub(super) fn save_scene_with(
    scene: &Scene,
    (from, file): (Option<&Path>, &Path),
    output: &Path,
    force: bool,
) -> Result<(), Failure> {
    tell_copied(&saving::save_with(scene, from, file, output, over(force))?);
    Ok(())
}

fn over(force: bool) -> Over {
    if force { Over::Anything } else { Over::Nothing }
}

fn tell_copied(saved: &Saved) {
    if !saved.copied.is_empty() {
        say(&format!("copied beside it: {}", saved.copied.join(", ")));
    }
}
