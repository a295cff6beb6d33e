//! What several subcommands take from a scene.

use super::failure::Failure;
use cloudwright_core::scene::{Camera, Scene};
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
            crate::opening::one_line(&format!("the cameras are {}", names.join(", ")))
        };
        Failure::argument(what, hint)
    })
}
