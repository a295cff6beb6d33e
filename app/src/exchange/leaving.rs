//! A scene into files of another kind: all of them, or none.

use crate::saving::{SaveError, check_unused};
use crate::storage::{Over, Together};
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::exchange::{ExportError, Files, Format, Leaving, Note, Options};
use cloudwright_core::scene::{Camera, CloudId, Scene};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::{CloudNow, Moment, SceneNow, WeatherRules};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

/// What leaves.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The scene as it is saved.
    pub scene: &'a Scene,
    /// Its sprites.
    pub derived: &'a Derived,
    /// The sheet of its tiles.
    pub atlas: &'a Atlas,
    /// Its file, which is not written over, and what it names neither.
    pub file: Option<&'a Path>,
}

/// How it is to leave.
#[derive(Debug, Clone)]
pub struct Order {
    /// As what.
    pub format: &'static Format,
    /// What is set of that.
    pub options: Options,
    /// Which clouds; all if that is not said.
    pub clouds: Option<Vec<CloudId>>,
    /// Whom sprites face, for formats that have corners with their light.
    pub camera: Option<Camera>,
    /// At which second and hour.
    pub moment: Moment,
    /// What may be replaced.
    pub over: Over,
}

/// What has left.
#[derive(Debug, Clone, PartialEq)]
pub struct Left {
    /// The files that were written.
    pub files: Vec<PathBuf>,
    /// What they do not carry.
    pub notes: Vec<Note>,
}

/// Why nothing has left.
#[derive(Debug, thiserror::Error)]
pub enum LeaveError {
    /// The format has no way to say it, or it was stopped.
    #[error(transparent)]
    Export(ExportError),
    /// A file can't be written.
    #[error(transparent)]
    Save(#[from] SaveError),
}

/// Writes `subject` to the file `to`, and to what its format puts beside that.
///
/// # Errors
/// If a file can't be written or is one that the scene is read from, if there is nothing to write, and if `watch` is
/// cancelled. Nothing is written then.
pub fn leave(subject: Subject<'_>, order: &Order, to: &Path, watch: &Watch) -> Result<Left, LeaveError> {
    let Subject { scene, derived, atlas, .. } = subject;
    if !derived.bake(watch) {
        return Err(LeaveError::Export(ExportError::Cancelled));
    }
    let mut now = SceneNow::new(scene, (derived.clouds(), derived.timeline()), order.moment, WeatherRules::default());
    if let Some(chosen) = &order.clouds {
        now.clouds.retain(|cloud: &CloudNow<'_>| chosen.contains(&cloud.placed.id));
    }
    // Corners depend on where the eye is and which way is up, not on the picture's size.
    let view = order.camera.as_ref().map(|camera| View::new(camera, 1, 1));
    let name = to.file_name().unwrap_or_default().to_string_lossy();
    let leaving = Leaving {
        scene,
        derived,
        moment: order.moment,
        now: &now,
        atlas,
        view: view.as_ref(),
        name: &name,
        options: &order.options,
        watch,
    };
    let mut files = Written { subject, to, over: order.over, together: Together::default(), failed: None };
    let written = order.format.write(&leaving, &mut files);
    let mut notes = written.map_err(|error| match files.failed.take() {
        Some(failed) if !matches!(error, ExportError::Cancelled) => failed.into(),
        _ => LeaveError::Export(error),
    })?;
    let is_meant = |id: &CloudId| order.clouds.as_ref().is_none_or(|chosen| chosen.contains(id));
    let unseen = scene.clouds.iter().filter(|cloud| is_meant(&cloud.id) && !scene.is_seen(cloud)).count();
    if unseen > 0 {
        notes.insert(0, Note::left_out(format!("clouds in hidden folders: {unseen}"), ""));
    }
    let files = files.together.take_names().map_err(SaveError::from)?;
    Ok(Left { files, notes })
}

/// The files of one export, beside the one that was asked for.
struct Written<'a> {
    subject: Subject<'a>,
    to: &'a Path,
    over: Over,
    together: Together,
    /// Why a file could not be written.
    failed: Option<SaveError>,
}

impl Written<'_> {
    fn write(&mut self, path: &Path, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> Result<(), SaveError> {
        check_unused(self.subject.scene, self.subject.file, path)?;
        Ok(self.together.add(path, self.over, |sink| fill(sink))?)
    }
}

impl Files for Written<'_> {
    fn add(&mut self, name: &str, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        let asked = self.to.file_name().is_some_and(|asked| asked.to_string_lossy() == name);
        let path = if asked { self.to.to_path_buf() } else { self.to.with_file_name(name) };
        self.write(&path, fill).map_err(|failed| {
            self.failed = Some(failed);
            ErrorKind::Other.into()
        })
    }
}
