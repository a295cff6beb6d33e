//! One kind of file, and how it is chosen.

use super::{Arrived, Arriving, ExportError, Files, Leaving, Note, OptionRow, Options, Part};
use crate::formats::Misread;
use crate::scene::Scene;
use crate::spelling::closest;

/// A kind of file that scenes leave as, or come from.
#[derive(Debug, Clone, Copy)]
pub struct Format {
    /// As on the command line.
    pub name: &'static str,
    /// As on screen.
    pub title: &'static str,
    /// How names of such files end, without the dot before it.
    pub endings: &'static [&'static str],
    /// One sentence for people: what it is good for.
    pub about: &'static str,
    /// What of a scene it carries.
    pub carries: &'static [Part],
    /// Whether it takes corners with their light as a camera sees them.
    pub corners: Corners,
    /// What can be set of it when it is written.
    pub write_options: &'static [OptionRow],
    /// What can be set of it when it is read.
    pub read_options: &'static [OptionRow],
    pub(super) write: Option<fn(&Leaving<'_>, &mut dyn Files) -> Result<Vec<Note>, ExportError>>,
    pub(super) read: Option<Reader>,
}

/// Whether a format has sprites' corners with their light as a camera sees them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Corners {
    /// Never.
    None,
    /// If they are asked for.
    Asked,
    /// Always.
    Always,
}

/// How a format is read.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reader {
    pub(super) read: fn(&Arriving<'_>) -> Result<Arrived, Misread>,
    /// Whether bytes look like such a file, for names that end like several formats' do.
    pub(super) knows: fn(&[u8]) -> bool,
    pub(super) max_bytes: usize,
}

/// So much of a file's beginning tells formats with one ending apart, bytes.
pub const HEAD_BYTES: usize = 1 << 16;

/// Why no format was chosen.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum ChoiceError {
    /// No format of that name.
    #[error("there is no format “{name}”")]
    Unknown {
        /// What was asked for.
        name: String,
        /// The one that was meant, perhaps.
        meant: Option<&'static str>,
    },
    /// The file's name ends like none's.
    #[error("the ending names no format")]
    NoEnding,
    /// The format is only read, or only written.
    #[error("{title} is {only}")]
    OneWay {
        /// Which format.
        title: &'static str,
        /// "read, not written", or the reverse.
        only: &'static str,
    },
}

impl Format {
    /// Whether scenes leave as it.
    pub fn is_written(&self) -> bool {
        self.write.is_some()
    }

    /// Whether it comes in.
    pub fn is_read(&self) -> bool {
        self.read.is_some()
    }

    /// Larger files are refused before they are read, bytes.
    pub fn max_bytes(&self) -> usize {
        self.read.map_or(0, |reader| reader.max_bytes)
    }

    /// What is set of it when it is written, as it usually is.
    pub fn usual_for_writing(&self) -> Options {
        Options::usual(self.write_options)
    }

    /// What is set of it when it is read, as it usually is.
    pub fn usual_for_reading(&self) -> Options {
        Options::usual(self.read_options)
    }

    /// The parts that `scene` has and the format does not carry.
    pub fn left_out(&self, scene: &Scene) -> Vec<Part> {
        Part::ALL.into_iter().filter(|part| part.is_in(scene) && !self.carries.contains(part)).collect()
    }

    /// Writes what leaves, and tells what could not.
    ///
    /// # Errors
    /// Those of `files`, if there is nothing to write, and if the watch is cancelled.
    pub fn write(&self, leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
        let write = self.write.ok_or(ExportError::ReadOnly)?;
        let notes = write(leaving, files);
        if leaving.watch.is_cancelled() {
            return Err(ExportError::Cancelled);
        }
        let mut notes = notes?;
        let parts: Vec<&str> = self.left_out(leaving.scene).into_iter().map(Part::name).collect();
        if !parts.is_empty() {
            notes.insert(0, Note::left_out(parts.join(", "), ""));
        }
        Ok(notes)
    }

    /// Reads what comes in.
    ///
    /// # Errors
    /// With the place of what is wrong.
    pub fn read(&self, arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
        match self.read {
            Some(reader) if arriving.bytes.len() > reader.max_bytes => {
                Err(Misread::new("file", format!("it is larger than {} MB", reader.max_bytes >> 20)))
            }
            Some(reader) => (reader.read)(arriving),
            None => Err(Misread::new("file", "files of this kind are written, not read")),
        }
    }

    /// How many of the file name's last letters are an ending of it; none if it ends otherwise.
    fn fits(&self, file_name: &str) -> Option<usize> {
        let name = file_name.to_lowercase();
        let ends = |ending: &&&str| {
            name.strip_suffix(**ending)
                .is_some_and(|stem| stem.is_empty() && ending.contains('.') || stem.ends_with('.'))
        };
        self.endings.iter().filter(ends).map(|ending| ending.len()).max()
    }
}

/// The format of `all` that `named` says, or else that a file of that name is written as: the one with the longest ending,
/// of equal ones the first.
pub(super) fn to_write(
    all: &'static [Format],
    named: Option<&str>,
    file_name: &str,
) -> Result<&'static Format, ChoiceError> {
    let written = |format: &&Format| format.is_written();
    chosen(all, named, written, "read, not written", || best(all.iter().filter(written), file_name))
}

/// The same for reading, where of formats with one ending that is taken which knows the `bytes`.
pub(super) fn to_read(
    all: &'static [Format],
    named: Option<&str>,
    file_name: &str,
    bytes: &[u8],
) -> Result<&'static Format, ChoiceError> {
    let read = |format: &&Format| format.is_read();
    let knows = |format: &&Format| format.read.is_some_and(|reader| (reader.knows)(bytes));
    chosen(all, named, read, "written, not read", || {
        let fitting = || all.iter().filter(read).filter(|format| format.fits(file_name).is_some());
        fitting().find(knows).or_else(|| best(fitting(), file_name))
    })
}

fn chosen(
    all: &'static [Format],
    named: Option<&str>,
    does: impl Fn(&&Format) -> bool,
    only: &'static str,
    by_file: impl Fn() -> Option<&'static Format>,
) -> Result<&'static Format, ChoiceError> {
    let Some(name) = named else { return by_file().ok_or(ChoiceError::NoEnding) };
    let Some(format) = all.iter().find(|format| format.name == name) else {
        return Err(ChoiceError::Unknown { name: name.into(), meant: closest(name, all.iter().map(|each| each.name)) });
    };
    if does(&format) { Ok(format) } else { Err(ChoiceError::OneWay { title: format.title, only }) }
}

fn best(formats: impl Iterator<Item = &'static Format>, file_name: &str) -> Option<&'static Format> {
    let fitting = formats.filter_map(|format| Some((format.fits(file_name)?, format)));
    fitting.reduce(|best, next| if next.0 > best.0 { next } else { best }).map(|(_, format)| format)
}
