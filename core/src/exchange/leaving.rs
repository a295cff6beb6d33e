//! What a writer is given, where its files go, and what it tells of what was lost.

use super::Options;
use crate::camera::View;
use crate::derived::Derived;
use crate::posed_sprite::Still;
use crate::scene::Scene;
use crate::sprites::Atlas;
use crate::watch::Watch;
use crate::weather::{Moment, SceneNow};
use schemars::JsonSchema;
use serde::Serialize;
use std::io::{self, Write};

/// A scene that leaves.
#[derive(Debug)]
pub struct Leaving<'a> {
    /// As it is saved.
    pub scene: &'a Scene,
    /// Its sprites.
    pub derived: &'a Derived,
    /// The second and hour at which it leaves.
    pub moment: Moment,
    /// It at that moment, with the clouds that are to leave.
    pub now: &'a SceneNow<'a>,
    /// The sheet of its tiles.
    pub atlas: &'a Atlas,
    /// Who looks at it, for formats that take corners with their light.
    pub view: Option<&'a View>,
    /// Of the file that was asked for: `sky.cld`.
    pub name: &'a str,
    /// What was set.
    pub options: &'a Options,
    /// How far it is, and whether it is still wanted.
    pub watch: &'a Watch,
}

impl Leaving<'_> {
    /// How it is looked at, if it is.
    pub fn still(&self) -> Option<Still<'_>> {
        self.view.map(|view| Still { view, light: &self.now.light })
    }
}

/// Where an export's files go: all of them, or none.
pub trait Files {
    /// Adds a file of that name, beside the one that was asked for or that one itself, with the bytes that `fill` writes.
    ///
    /// # Errors
    /// If it can't be written, and those of `fill`.
    fn add(&mut self, name: &str, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> io::Result<()>;
}

/// The name of the file that stands at that place among several, from 1: `sky.cld`, `sky_2.cld`, `sky_3.cld`.
pub fn numbered(name: &str, place: usize) -> String {
    match name.rsplit_once('.') {
        _ if place <= 1 => name.into(),
        Some((stem, ending)) => format!("{stem}_{place}.{ending}"),
        None => format!("{name}_{place}"),
    }
}

/// What kind of thing a note tells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NoteKind {
    /// It is not in what was made.
    LeftOut,
    /// It is there, and not as it was: rounded, clamped.
    Changed,
    /// The file does not say it, so something was taken.
    Assumed,
}

/// What an export or an import could not carry as it was.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema)]
pub struct Note {
    /// What kind of thing it tells.
    pub kind: NoteKind,
    /// Of what: "cloud “West”", "cameras".
    pub what: String,
    /// What became of it.
    pub how: String,
}

impl Note {
    /// It is not in what was made.
    pub fn left_out(what: impl Into<String>, how: impl Into<String>) -> Self {
        Self { kind: NoteKind::LeftOut, what: what.into(), how: how.into() }
    }

    /// It is there, and not as it was.
    pub fn changed(what: impl Into<String>, how: impl Into<String>) -> Self {
        Self { kind: NoteKind::Changed, what: what.into(), how: how.into() }
    }

    /// Something was taken that the file does not say.
    pub fn assumed(what: impl Into<String>, how: impl Into<String>) -> Self {
        Self { kind: NoteKind::Assumed, what: what.into(), how: how.into() }
    }
}

impl std::fmt::Display for Note {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self.kind {
            NoteKind::LeftOut => write!(f, "not carried: {}", self.what)?,
            NoteKind::Changed | NoteKind::Assumed => write!(f, "{}", self.what)?,
        }
        if self.how.is_empty() { Ok(()) } else { write!(f, ": {}", self.how) }
    }
}

/// Why nothing left.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// A file could not be written.
    #[error("{0}")]
    Io(#[from] io::Error),
    /// There is nothing that the format carries.
    #[error("the scene has no {0}")]
    Nothing(&'static str),
    /// It is more than the format holds.
    #[error("{what} is more than the format holds: at most {most}")]
    TooMuch {
        /// What, and how much there is of it.
        what: String,
        /// How much the format holds.
        most: String,
    },
    /// The watch was cancelled.
    #[error("stopped")]
    Cancelled,
    /// The format is only read.
    #[error("files of this kind are read, not written")]
    ReadOnly,
}

#[cfg(test)]
mod tests {
    use super::numbered;

    #[test]
    fn files_beside_the_first_are_numbered() {
        let names = [("a.cld", 1), ("a.cld", 2), ("a.b.cld", 3), ("a", 2)].map(|(name, place)| numbered(name, place));
        assert_eq!(names, ["a.cld", "a_2.cld", "a.b_3.cld", "a_2"]);
    }
}
