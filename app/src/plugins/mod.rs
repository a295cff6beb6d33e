//! Which plugins there are: those within the program, and the user's in a folder.
//!
//! Only what they say they are is read; nothing of them runs. One that can't be read stays in the list, with what is
//! wrong with it. Two may have one name: each knows where it is from. Window and command line read the same library.

mod chosen;
mod templates;

pub use chosen::carried_over;
pub use templates::template;

use crate::storage::{self, Listing, StorageError};
use cloudwright_scripts::shipped::SHIPPED;
use cloudwright_scripts::{Plugin, PluginKind, ScriptError};
use std::fmt;
use std::path::{Path, PathBuf};
use std::sync::{Arc, LazyLock};

/// What a plugin's file ends in.
pub const EXTENSION: &str = "rhai";
/// Larger files are no scripts; of smaller ones the scripts' own limit tells.
const FILE_BYTES: usize = 1 << 20;

/// Where a plugin is from.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord)]
pub enum Origin {
    /// The one of that name within the program.
    Shipped(&'static str),
    /// A file.
    File(PathBuf),
}

/// Why a plugin can't be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// Its file can't be read.
    #[error(transparent)]
    Storage(#[from] StorageError),
    /// Its file is no text.
    #[error("this is no text (a plugin is a text in UTF-8)")]
    NoText,
    /// It is no plugin.
    #[error(transparent)]
    Script(#[from] ScriptError),
}

/// One plugin, or what should be one.
#[derive(Debug)]
pub struct Entry {
    /// Where it is from.
    pub origin: Origin,
    /// What it says it is.
    pub read: Result<Arc<Plugin>, ReadError>,
}

/// All that there are: those that ship, then the user's, each by name.
#[derive(Debug, Default)]
pub struct Library {
    entries: Vec<Entry>,
    /// The user's folder as it was when it was read.
    seen: Listing,
}

impl Origin {
    /// By which the command line calls it: the file's name without its ending.
    pub fn name(&self) -> String {
        match self {
            Self::Shipped(name) => (*name).into(),
            Self::File(path) => path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        }
    }

    /// In a word: its file's name, or that it ships.
    pub fn in_short(&self) -> String {
        match self {
            Self::Shipped(_) => "shipped".into(),
            Self::File(path) => path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        }
    }
}

impl fmt::Display for Origin {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Shipped(_) => f.write_str("ships with Cloudwright"),
            Self::File(path) => path.display().fmt(f),
        }
    }
}

impl Entry {
    /// All that ship. They are read once: nothing changes them.
    fn shipped() -> impl Iterator<Item = Self> {
        static READ: LazyLock<Vec<(&str, Result<Arc<Plugin>, ScriptError>)>> = LazyLock::new(|| {
            SHIPPED.iter().map(|shipped| (shipped.name, Plugin::read(shipped.source).map(Arc::new))).collect()
        });
        let entry = |(name, read): &(&'static str, Result<_, ScriptError>)| Self {
            origin: Origin::Shipped(name),
            read: read.clone().map_err(ReadError::from),
        };
        READ.iter().map(entry)
    }

    /// The one in a file.
    pub fn of_file(path: &Path) -> Self {
        let read = || Ok(Arc::new(Plugin::read(&source(path)?)?));
        Self { origin: Origin::File(path.into()), read: read() }
    }

    /// It, if it could be read.
    pub fn plugin(&self) -> Option<&Arc<Plugin>> {
        self.read.as_ref().ok()
    }
}

/// The text of a plugin's file.
///
/// # Errors
/// If it can't be read, or is no text.
pub fn source(path: &Path) -> Result<String, ReadError> {
    let bytes = storage::read(path, FILE_BYTES)?;
    String::from_utf8(bytes).map_err(|_| ReadError::NoText)
}

/// The plugins in a folder as they lie there, to be watched.
pub fn listing(folder: &Path) -> Listing {
    Listing::of(folder, EXTENSION)
}

impl Library {
    /// All that ship, and those in the user's folder, if there is one. Takes a while: each is parsed.
    pub fn read(folder: Option<&Path>) -> Self {
        // Looked at before it is read: what is changed in between is noticed later.
        let seen = folder.map(listing).unwrap_or_default();
        let mut entries: Vec<Entry> = Entry::shipped().collect();
        entries.extend(seen.paths().map(Entry::of_file));
        Self { entries, seen }
    }

    /// The user's folder as it was when it was read.
    pub fn seen(&self) -> &Listing {
        &self.seen
    }

    /// All, broken ones too.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The one from there.
    pub fn from(&self, origin: &Origin) -> Option<&Entry> {
        self.entries.iter().find(|entry| entry.origin == *origin)
    }

    /// The one that the command line means by `name`: one that ships before one of the user's. The whole library if
    /// there is none.
    pub fn into_named(mut self, name: &str) -> Result<Entry, Self> {
        match self.entries.iter().position(|entry| entry.origin.name() == name) {
            Some(at) => Ok(self.entries.swap_remove(at)),
            None => Err(self),
        }
    }

    /// Those of a kind, as they stand in a menu: by what they are called there.
    pub fn of_kind(&self, kind: PluginKind) -> Vec<(&Entry, &Arc<Plugin>)> {
        let read = self.entries.iter().filter_map(|entry| Some((entry, entry.plugin()?)));
        let mut found: Vec<_> = read.filter(|(_, plugin)| plugin.description.kind == kind).collect();
        found.sort_by(|(_, a), (_, b)| a.description.name.cmp(&b.description.name));
        found
    }

    /// Those that can't be read, with the reason.
    pub fn broken(&self) -> impl Iterator<Item = (&Origin, &ReadError)> {
        self.entries.iter().filter_map(|entry| Some((&entry.origin, entry.read.as_ref().err()?)))
    }

    /// What `plugin` from `origin` is called on screen: its name, and where it is from if another one has that name too.
    pub fn label(&self, origin: &Origin, plugin: &Plugin) -> String {
        let name = &plugin.description.name;
        let same = self.entries.iter().filter_map(Entry::plugin).filter(|other| other.description.name == *name);
        if same.count() > 1 { format!("{name} ({})", origin.in_short()) } else { name.clone() }
    }
}
