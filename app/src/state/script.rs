//! The script that is being written: its text, its file, what is wrong with it, and what its last run said.

use crate::storage::Stamp;
use cloudwright_scripts::{PluginKind, ScriptError};
use std::path::{Path, PathBuf};

/// A script in the panel *Script*.
#[derive(Debug, Default)]
pub(crate) struct Script {
    pub(crate) text: String,
    /// Where it lies; none until it is saved.
    pub(crate) file: Option<PathBuf>,
    /// The file as it was last read or written here.
    pub(crate) known: Option<Stamp>,
    /// The text as it was last read or written here.
    pub(crate) saved: String,
    /// It is one that ships, to be read and copied.
    pub(crate) example: Option<&'static str>,
    /// What is wrong with the text, or went wrong as it ran.
    pub(crate) fault: Option<ScriptError>,
    /// What the last run said.
    pub(crate) output: Vec<String>,
    /// The file is another one than was read.
    pub(crate) changed_on_disk: bool,
    /// A run goes on.
    pub(crate) runs: bool,
}

/// Something to be done with it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) enum ScriptChange {
    /// Its text is now this.
    Type(String),
    /// Begin anew with the template of a kind.
    New(PluginKind),
    /// Read one that ships.
    Example(&'static str),
    /// Write on from the one that is shown, which ships.
    Copy,
    /// Open a file.
    Open(PathBuf),
    /// Write its file, or ask for a name.
    Save,
    /// Ask for a name.
    SaveAs,
    /// Read its file again, whatever is lost.
    Reload,
    /// Run it on the open scene.
    Run,
}

impl Script {
    /// Whether some of the text is nowhere else.
    pub(crate) fn is_modified(&self) -> bool {
        self.example.is_none() && self.text != self.saved
    }

    /// What it is called: its file's name, or what it is instead.
    pub(crate) fn title(&self) -> String {
        match (self.example, &self.file) {
            (Some(name), _) => format!("{name} (an example)"),
            (None, Some(file)) => file.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            (None, None) if self.text.is_empty() => "No script".into(),
            (None, None) => "New script".into(),
        }
    }

    /// As it lies in a file.
    pub(crate) fn of_file(path: &Path, text: String, known: Option<Stamp>) -> Self {
        Self { saved: text.clone(), text, file: Some(path.into()), known, ..Self::default() }
    }
}
