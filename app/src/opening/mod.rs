//! A scene file with all that it names: what the command line and the editor open.
//!
//! A scene may name an atlas of its own and models of aircraft, files beside its own ([`Beside`]).

mod beside;

pub use beside::Beside;
pub(crate) use beside::{Elsewhere, Named, models_of, named};

use crate::storage::{self, StorageError};
use crate::visible;
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Problem;
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};

/// Why a scene can't be opened.
#[derive(Debug, thiserror::Error)]
pub enum OpenError {
    /// The file can't be read.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// It was read, and there is something wrong with it.
    #[error("{}", problem_lines(path, problems).join("\n"))]
    Problems {
        /// The scene file.
        path: PathBuf,
        /// All that is wrong.
        problems: Vec<Problem>,
    },
}

/// The scene of a file, whatever there is to say about what it names.
///
/// # Errors
/// If the file can't be read or the scene has errors.
pub fn open_scene(path: &Path) -> Result<Scene, OpenError> {
    let bytes = storage::read(path, scene_file::MAX_BYTES)?;
    scene_file::read(&bytes).map_err(|problems| OpenError::Problems { path: path.into(), problems })
}

/// The scene of a file and what it names.
///
/// # Errors
/// As [`open_scene`], and if one of the files that it names can't be used.
pub fn open(path: &Path) -> Result<(Scene, Beside), OpenError> {
    let scene = open_scene(path)?;
    match Beside::read(&scene, Some(path)) {
        (beside, problems) if problems.is_empty() => Ok((scene, beside)),
        (_, problems) => Err(OpenError::Problems { path: path.into(), problems }),
    }
}

/// The problems of a file, a line each.
pub fn problem_lines(path: &Path, problems: &[Problem]) -> Vec<String> {
    problems.iter().map(|problem| problem_line(path, problem)).collect()
}

/// `file: place: error: message (hint)`, or `note`.
pub fn problem_line(path: &Path, problem: &Problem) -> String {
    let Problem { place, message, hint, .. } = problem;
    visible::one_line(&format!("{}: {place}: {}: {message} ({hint})", path.display(), severity_name(problem)))
}

/// "error" or "note".
pub fn severity_name(problem: &Problem) -> &'static str {
    match problem.severity {
        cloudwright_core::problem::Severity::Error => "error",
        cloudwright_core::problem::Severity::Note => "note",
    }
}
