//! A scene file with all that it names: what the command line and the editor open.
//!
//! A scene may name an atlas of its own, a PNG beside the scene file. It is found and judged here, once, so that
//! `check`, `render` and the editor say the same about it.

use crate::storage::{self, StorageError};
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem::Problem;
use cloudwright_core::scene::Scene;
use cloudwright_core::sprites::Atlas;
use std::path::{Component, Path, PathBuf};
use std::sync::Arc;

/// No sheet of 512 × 512 pixels is larger than this, bytes.
const MAX_ATLAS_BYTES: usize = 16 << 20;

/// The sheet that a scene names; none for the built-in one.
pub type SceneAtlas = Option<Arc<Atlas>>;

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

/// The scene of a file, whatever there is to say about its atlas.
///
/// # Errors
/// If the file can't be read or the scene has errors.
pub fn open_scene(path: &Path) -> Result<Scene, OpenError> {
    let bytes = storage::read(path, scene_file::MAX_BYTES)?;
    scene_file::read(&bytes).map_err(|problems| OpenError::Problems { path: path.into(), problems })
}

/// The scene of a file and its atlas.
///
/// # Errors
/// As [`open_scene`], and if the atlas that it names can't be used.
pub fn open(path: &Path) -> Result<(Scene, SceneAtlas), OpenError> {
    let scene = open_scene(path)?;
    match atlas_of(&scene, Some(path)) {
        Ok(atlas) => Ok((scene, atlas)),
        Err(problem) => Err(OpenError::Problems { path: path.into(), problems: vec![problem] }),
    }
}

/// The atlas that `scene` names, read from beside `scene_path`.
///
/// # Errors
/// A problem at `atlas` if there is no such file beside it or it is no sheet.
pub fn atlas_of(scene: &Scene, scene_path: Option<&Path>) -> Result<SceneAtlas, Problem> {
    let Some(name) = &scene.atlas else { return Ok(None) };
    let problem = |message: String, hint: &str| Problem::error("atlas", format!("“{name}”: {message}"), hint);
    // A scene from elsewhere has no business with files in other folders.
    let beside = Path::new(name).components().all(|part| matches!(part, Component::Normal(_)));
    if !beside || name.is_empty() {
        return Err(problem("it doesn't lie beside the scene file".into(), "copy it there, and give its name alone"));
    }
    let Some(scene_path) = scene_path else {
        return Err(problem("the scene has no folder yet".into(), "save the scene beside its atlas"));
    };
    let bytes = storage::read(&scene_path.with_file_name(name), MAX_ATLAS_BYTES).map_err(|error| {
        problem(format!("can't be read: {}", error.reason()), "put it beside the scene file, or take `atlas` out")
    })?;
    let hint = "an atlas is a PNG of 512 × 512 pixels with alpha; take `atlas` out for the built-in one";
    Atlas::from_png(&bytes).map(|atlas| Some(Arc::new(atlas))).map_err(|error| problem(error.to_string(), hint))
}

/// The sheet to draw with.
pub fn sheet(atlas: &SceneAtlas) -> &Atlas {
    atlas.as_deref().unwrap_or_else(|| Atlas::built_in())
}

/// The problems of a file, a line each.
pub fn problem_lines(path: &Path, problems: &[Problem]) -> Vec<String> {
    problems.iter().map(|problem| problem_line(path, problem)).collect()
}

/// `file: place: error: message (hint)`, or `note`.
pub fn problem_line(path: &Path, problem: &Problem) -> String {
    let Problem { place, message, hint, .. } = problem;
    one_line(&format!("{}: {place}: {}: {message} ({hint})", path.display(), severity_name(problem)))
}

/// "error" or "note".
pub fn severity_name(problem: &Problem) -> &'static str {
    match problem.severity {
        cloudwright_core::problem::Severity::Error => "error",
        cloudwright_core::problem::Severity::Note => "note",
    }
}

/// Text out of a file made safe for a terminal: control characters become spaces.
pub fn one_line(text: &str) -> String {
    text.chars().map(|c| if c.is_control() { ' ' } else { c }).collect()
}
