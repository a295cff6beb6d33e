//! A scene into its file: what the command line and the editor save, the twin of [`crate::opening`].

use crate::storage::{self, Over, Stamp, StorageError};
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use std::path::Path;

/// Why a scene can't be saved.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// It has a number that a file can't say.
    #[error("the scene can't be written down: {0}")]
    Text(#[from] serde_json::Error),
    /// The file can't be written.
    #[error(transparent)]
    Storage(#[from] StorageError),
}

/// Puts `scene` at `path`, whole or not at all, over what `over` allows. Gives the file's stamp.
///
/// # Errors
/// If it can't be written; what was there before is then untouched.
pub fn save(scene: &Scene, path: &Path, over: Over) -> Result<Stamp, SaveError> {
    let text = scene_file::write(scene)?;
    Ok(storage::write_over(path, text.as_bytes(), over)?)
}
