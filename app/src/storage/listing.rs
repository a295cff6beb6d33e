//! Which files of a kind lie in a folder, and whether they are still the same.

use super::{Stamp, names_in};
use std::path::{Path, PathBuf};

/// Of more files than these, the first by name are listed.
const MOST_FILES: usize = 1_000;

/// The files in a folder whose names end alike, in the order of their names, with their stamps.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Listing(Vec<(PathBuf, Option<Stamp>)>);

impl Listing {
    /// Of the files in `folder`, not in folders within, that end in `.ending`, in capitals or not. A folder that can't
    /// be looked at is an empty one.
    pub fn of(folder: &Path, ending: &str) -> Self {
        let ends = |name: &PathBuf| name.extension().is_some_and(|its| its.eq_ignore_ascii_case(ending));
        let mut names: Vec<PathBuf> = names_in(folder).into_iter().filter(ends).collect();
        names.sort_unstable();
        names.truncate(MOST_FILES);
        let stamped = names.into_iter().map(|name| {
            let path = folder.join(name);
            let stamp = Stamp::of(&path);
            (path, stamp)
        });
        Self(stamped.collect())
    }

    /// The files.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(|(path, _)| path.as_path())
    }
}
