//! What tests, benches and asset makers share. Ships nothing.

pub mod atlas;
pub mod authoring;
pub mod gpu;
pub mod small_scenes;

use std::path::PathBuf;

/// The project's root.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A shipped scene's file.
pub fn scene_path(name: &str) -> PathBuf {
    root().join("assets/scenes").join(name).with_extension("cloudscene")
}
