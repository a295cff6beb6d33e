//! A folder to write into, which goes again if nothing is written.

use super::StorageError;
use std::fs;
use std::path::{Path, PathBuf};

/// A folder that is there. What had to be made for it is taken away when this is dropped, as far as it is still empty:
/// whatever fails in between, no empty folder is left behind.
#[derive(Debug)]
pub struct Folder {
    /// The innermost first.
    made: Vec<PathBuf>,
}

impl Folder {
    /// Makes the folder, and those that it lies in, if they are not there.
    ///
    /// # Errors
    /// If one of them is a file, or can't be made.
    pub fn make(path: &Path) -> Result<Self, StorageError> {
        if path.exists() && !path.is_dir() {
            let (reason, hint) = ("it is a file", "give a folder, or the name of a new one");
            return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
        }
        let is_missing = |folder: &&Path| !folder.as_os_str().is_empty() && !folder.exists();
        let folder = Self { made: path.ancestors().take_while(is_missing).map(PathBuf::from).collect() };
        fs::create_dir_all(path).map_err(|error| StorageError::write(path, &error))?;
        Ok(folder)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        for folder in &self.made {
            // Fails where something lies in it, which is as it should be.
            let _ = fs::remove_dir(folder);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_was_made_and_is_empty_goes() {
        let home = tempfile::tempdir().expect("a folder");
        let [there, inner] = ["there", "there/new/inner"].map(|name| home.path().join(name));
        fs::create_dir(&there).expect("writable");
        drop(Folder::make(&inner).expect("writable"));
        assert!(there.exists() && !there.join("new").exists());
        drop(Folder::make(&there).expect("it is there"));
        assert!(there.exists(), "others made it");
        let folder = Folder::make(&inner).expect("writable");
        fs::write(there.join("new/a.txt"), "x").expect("writable");
        drop(folder);
        assert!(there.join("new/a.txt").exists() && !inner.exists());
        let long = home.path().join("short").join("x".repeat(300)).join("inner");
        assert!(Folder::make(&long).is_err() && !home.path().join("short").exists());
    }
}
