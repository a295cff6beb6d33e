//! A file of another kind into a scene.

use crate::reports::{MadeLayer, MakeError, Making, make_sky};
use crate::storage::{self, StorageError};
use cloudwright_core::document::{Document, EditError};
use cloudwright_core::exchange::{
    Arrived, ArrivedCloud, ArrivedModel, Arriving, ChoiceError, Content, Format, HEAD_BYTES, Note, Options,
};
use cloudwright_core::formats::Misread;
use cloudwright_core::reported::Sky;
use cloudwright_core::scene::{CloudId, Thing};
use cloudwright_scripts::Patience;
use glam::DVec3;
use std::path::{Path, PathBuf};

/// Why no format was chosen.
#[derive(Debug, thiserror::Error)]
pub enum ChooseError {
    /// The file can't be read.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// Its name and beginning fit none.
    #[error(transparent)]
    Choice(#[from] ChoiceError),
}

/// The format that `named` says, or else the one that the file at `path` is, by its name and beginning.
///
/// # Errors
/// If it can't be read, or there is none.
pub fn choose(path: &Path, named: Option<&str>) -> Result<&'static Format, ChooseError> {
    let head = storage::read_head(path, HEAD_BYTES)?;
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    Ok(Format::to_read(named, &name, &head)?)
}

/// Why a file can't be understood.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// It can't be read.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// It is broken, or of another kind.
    #[error("{}: {misread}", path.display())]
    Misread {
        /// Which file.
        path: PathBuf,
        /// What is wrong, and where.
        misread: Misread,
    },
}

/// What the file at `path` holds, which has to be of that format.
///
/// # Errors
/// If it can't be read, or is broken: with the place.
pub fn read(path: &Path, format: &Format, options: &Options) -> Result<Arrived, ReadError> {
    let bytes = storage::read(path, format.max_bytes())?;
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    let arriving = Arriving { bytes: &bytes, name: &name, options };
    format.read(&arriving).map_err(|misread| ReadError::Misread { path: path.into(), misread })
}

/// How what came in is put into a scene.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Placing<'a> {
    /// The file's name, by which a scene names the model that it is, beside its own file.
    pub file_name: &'a str,
    /// Where clouds are put, metres in the world.
    pub at: DVec3,
    /// And where a model is.
    pub model_at: DVec3,
    /// Of weather: another one is another sky.
    pub seed: u64,
    /// Of weather: whether the clouds that are there stay.
    pub keeps_clouds: bool,
}

/// What came into a scene.
#[derive(Debug, Clone, Default)]
pub struct CameIn {
    /// How many models of clouds.
    pub models: usize,
    /// The clouds, where they came as such.
    pub clouds: Vec<CloudId>,
    /// A sky's layers.
    pub layers: Vec<MadeLayer>,
    /// What flies or stands, and as what.
    pub model: Option<(Thing, ArrivedModel)>,
    /// What was taken, as the file does not say it.
    pub notes: Vec<Note>,
}

/// What a model has become, in words.
pub fn called(model: Thing) -> &'static str {
    match model {
        Thing::Aircraft(_) => "an aircraft",
        _ => "a prop",
    }
}

/// Why nothing came in.
#[derive(Debug, thiserror::Error)]
pub enum ComeInError {
    /// The scene can't take it.
    #[error(transparent)]
    Edit(#[from] EditError),
    /// No sky can be made of it.
    #[error(transparent)]
    Make(#[from] MakeError),
    /// It is a scene of its own.
    #[error("it holds a whole scene")]
    Whole,
}

/// Puts clouds, weather or a model into `document`: one undo point, or nothing.
///
/// # Errors
/// If it is a whole scene, if the scene can't take it, and if `patience` has an end.
pub fn come_in(
    document: &mut Document,
    content: &Content,
    placing: &Placing<'_>,
    patience: &Patience,
) -> Result<CameIn, ComeInError> {
    let Placing { file_name, at, model_at, seed, keeps_clouds } = *placing;
    match content {
        Content::Scene(_) => Err(ComeInError::Whole),
        Content::Weather(preset) => {
            let sky = Sky::of_preset(preset, document.scene());
            let making = Making { speed: 1.0, seed, keeps_clouds, moves_site: false, date: None };
            let made = make_sky(document, "Weather from a preset", sky, &making, patience)?;
            Ok(CameIn { layers: made.layers, ..CameIn::default() })
        }
        Content::Model(model) => {
            let (edits, thing, notes) = model.put(document.scene(), file_name, model_at);
            document.edit("Import", edits)?;
            Ok(CameIn { model: Some((thing, model.clone())), notes, ..CameIn::default() })
        }
        Content::Clouds(clouds) => {
            let (edits, placed) = ArrivedCloud::place_all(clouds, document.scene(), at);
            document.edit("Import", edits)?;
            Ok(CameIn { models: clouds.len(), clouds: placed, ..CameIn::default() })
        }
    }
}
