//! A scene into its file: what the command line and the editor save, the twin of [`crate::opening`].
//!
//! A scene names its atlas and models by what lies beside its file. One that is saved into another folder takes them
//! along: they are copied, for the old file still needs them too. So are models that were pasted from another scene.

use crate::opening::{self, Elsewhere, Named};
use crate::storage::{self, FileId, Folder, Over, Stamp, StorageError};
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};

/// Why a scene can't be saved.
#[derive(Debug, thiserror::Error)]
pub enum SaveError {
    /// It has a number that a file can't say.
    #[error("the scene can't be written down: {0}")]
    Text(#[from] serde_json::Error),
    /// The file can't be written.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// What a scene is read from would be lost.
    #[error("{}: that is {what} (choose another name; it would be lost)", path.display())]
    InUse {
        /// Which file.
        path: PathBuf,
        /// What of the scene lies there.
        what: String,
    },
    /// What is no scene has the ending of one.
    #[error("{}: an exporter writes no scene (end its name otherwise)", path.display())]
    NoScene {
        /// The name that was given.
        path: PathBuf,
    },
    /// A file of a name that the scene's own atlas or model has.
    #[error("{}: is another file than the scene's {what}, which would be copied there", path.display())]
    Another {
        /// Which file.
        path: PathBuf,
        /// What the scene has under that name.
        what: &'static str,
    },
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Saved {
    /// The scene's file.
    pub stamp: Stamp,
    /// Names of the files that it needs and that were copied beside it.
    pub copied: Vec<String>,
}

/// A file that a scene needs beside it, and that is not there yet.
#[derive(Debug)]
pub(crate) struct Copy {
    what: &'static str,
    name: String,
    from: PathBuf,
    to: PathBuf,
    max_bytes: usize,
}

/// Puts `scene` at `path`, whole or not at all, over what `over` allows, and with it copies of what it names from beside
/// `from`, its file until now.
///
/// # Errors
/// If it can't be written, or another file has the name of one to copy; what was there before is then untouched.
pub fn save(scene: &Scene, from: Option<&Path>, path: &Path, over: Over) -> Result<Saved, SaveError> {
    save_copying(scene, to_copy(scene, from, path)?, path, over)
}

/// As [`save`], where models that don't lie beside `from` may lie `elsewhere`.
///
/// # Errors
/// As [`save`].
pub(crate) fn save_bringing(
    scene: &Scene,
    from: Option<&Path>,
    elsewhere: &Elsewhere,
    path: &Path,
    over: Over,
) -> Result<Saved, SaveError> {
    let is_there = |name: &str| from.is_some_and(|from| FileId::of(&from.with_file_name(name)).is_some());
    let other = |named: &Named| elsewhere.get(&named.name).filter(|_| !is_there(&named.name));
    let (came, others): (Vec<Named>, Vec<Named>) =
        opening::named(scene).into_iter().partition(|named| other(named).is_some());
    let mut copies = missing(others, from, path)?;
    for named in came {
        let beside = elsewhere.get(&named.name).map(PathBuf::as_path);
        copies.extend(missing(vec![named], beside, path)?);
    }
    save_copying(scene, copies, path, over)
}

/// As [`save`], where `file`, which `scene` names, came into it from wherever it lies.
///
/// # Errors
/// As [`save`].
pub(crate) fn save_with(
    scene: &Scene,
    from: Option<&Path>,
    file: &Path,
    path: &Path,
    over: Over,
) -> Result<Saved, SaveError> {
    let is_it = |named: &Named| file.file_name().is_some_and(|name| name == named.name.as_str());
    let (came, others): (Vec<Named>, Vec<Named>) = opening::named(scene).into_iter().partition(is_it);
    let mut copies = missing(came, Some(file), path)?;
    copies.extend(missing(others, from, path)?);
    save_copying(scene, copies, path, over)
}

fn save_copying(scene: &Scene, copies: Vec<Copy>, path: &Path, over: Over) -> Result<Saved, SaveError> {
    let text = scene_file::write(scene)?;
    let mut done = Vec::new();
    // The scene comes last: whoever sees it finds what it needs.
    let copied = copies.iter().try_for_each(|copy| {
        done.push((copy, copy.make()?));
        Ok(())
    });
    match copied.and_then(|()| Ok(storage::write_over(path, text.as_bytes(), over)?)) {
        Ok(stamp) => Ok(Saved { stamp, copied: copies.into_iter().map(|copy| copy.name).collect() }),
        Err(error) => {
            done.iter().for_each(|(copy, _)| storage::remove_if_there(&copy.to));
            Err(error)
        }
    }
}

/// Writes what an exporter made of `scene`, whose file is `from`, all or nothing.
///
/// # Errors
/// If it can't be written, has the name of a scene, or would replace a file that the scene is read from.
pub fn export(text: &str, scene: &Scene, from: Option<&Path>, path: &Path, over: Over) -> Result<(), SaveError> {
    if path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case(scene_file::EXTENSION)) {
        return Err(SaveError::NoScene { path: path.into() });
    }
    check_unused(scene, from, path)?;
    storage::write_over(path, text.as_bytes(), over)?;
    Ok(())
}

/// That nothing which is read, `scene`'s file `from` and what it names, lies at `path`.
///
/// # Errors
/// If something does.
pub(crate) fn check_unused(scene: &Scene, from: Option<&Path>, path: &Path) -> Result<(), SaveError> {
    match from.and_then(|from| in_use(scene, from, path)) {
        Some(what) => Err(SaveError::InUse { path: path.into(), what }),
        None => Ok(()),
    }
}

/// Which of the files that are read, the scene's `file` and what it names, lies at `path`, by whatever name.
pub(crate) fn in_use(scene: &Scene, file: &Path, path: &Path) -> Option<String> {
    let there = FileId::of(path)?;
    let is_there = |input: &Path| FileId::of(input).as_ref() == Some(&there);
    if is_there(file) {
        return Some("the scene itself".into());
    }
    let named = opening::named(scene).into_iter().find(|named| is_there(&file.with_file_name(&named.name)))?;
    Some(format!("the scene's {}, {}", named.what, named.name))
}

/// What `scene` names beside the file `from` and would miss beside `path`.
///
/// # Errors
/// If a file that differs has one of the names.
pub(crate) fn to_copy(scene: &Scene, from: Option<&Path>, path: &Path) -> Result<Vec<Copy>, SaveError> {
    missing(opening::named(scene), from, path)
}

/// Which of the files that lie beside `from` are missing beside `path`.
fn missing(named: Vec<Named>, from: Option<&Path>, path: &Path) -> Result<Vec<Copy>, SaveError> {
    let mut copies = Vec::new();
    let Some(from) = from else { return Ok(copies) };
    for Named { what, name, max_bytes } in named {
        let [source, to] = [from, path].map(|scene| scene.with_file_name(&name));
        if FileId::of(&source) == FileId::of(&to) {
            continue;
        }
        // What can't be read was missed before: a scene needn't be complete to be saved.
        let Ok(bytes) = storage::read(&source, max_bytes) else { continue };
        if FileId::of(&to).is_none() {
            copies.push(Copy { what, name, from: source, to, max_bytes });
        } else if !storage::read(&to, max_bytes).is_ok_and(|there| there == bytes) {
            return Err(SaveError::Another { path: to, what });
        }
    }
    Ok(copies)
}

impl Copy {
    /// Gives the folder that it lies in.
    fn make(&self) -> Result<Folder, SaveError> {
        let folder = Folder::make(self.to.parent().unwrap_or(Path::new("")))?;
        let bytes = storage::read(&self.from, self.max_bytes)?;
        storage::write_over(&self.to, &bytes, Over::Nothing).map_err(|error| match error {
            StorageError::InTheWay { path, .. } => SaveError::Another { path, what: self.what },
            error => error.into(),
        })?;
        Ok(folder)
    }
}
