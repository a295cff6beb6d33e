//! Writing all or nothing.
//!
//! The bytes go into a temporary file in the same folder, reach the disk, and only then take the name. Whoever looks
//! sees the old file or the new one, whole. A failed write leaves nothing; a killed one leaves its temporary file, which
//! the next write into that folder takes away.

use super::{Stamp, StorageError, leftover};
use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use tempfile::NamedTempFile;

/// A file that is being written, not yet under its name.
pub type Sink<'a> = BufWriter<&'a File>;

/// What may be replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Over {
    /// Whatever is there.
    Anything,
    /// Only this file; one that was changed since is left alone.
    Known(Stamp),
    /// Nothing: the name must be free.
    Nothing,
}

/// Puts `bytes` under the name `path`, all or nothing. A file that was there keeps its permissions, and a link still
/// leads to it.
///
/// # Errors
/// If there is no such folder, no permission or no space; what was there before is then untouched.
pub fn write_atomic(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    write_over(path, bytes, Over::Anything).map(drop)
}

/// As [`write_atomic`], for one file of many in a folder that [`check_writable`] was asked about: what killed programs
/// left there is not looked for again, as looking through n files n times would take longer than writing them.
///
/// # Errors
/// As [`write_atomic`].
pub fn write_one_of_many(path: &Path, bytes: &[u8]) -> Result<(), StorageError> {
    write(path, &target_of(path), Over::Anything, |sink| sink.write_all(bytes)).map(drop)
}

/// As [`write_atomic`], over what `over` allows. Gives the new file's stamp.
///
/// # Errors
/// As [`write_atomic`], and [`StorageError::InTheWay`].
pub fn write_over(path: &Path, bytes: &[u8], over: Over) -> Result<Stamp, StorageError> {
    let target = target_of(path);
    // First, as it may make the space that is needed.
    leftover::sweep(folder_of(&target));
    write(path, &target, over, |sink| sink.write_all(bytes))
}

/// Whether [`write_atomic`] could write there: asked before work that takes long. Takes away what killed programs left in
/// that folder, and leaves nothing behind.
///
/// # Errors
/// As [`write_atomic`], but for a full disk.
pub fn check_writable(path: &Path) -> Result<(), StorageError> {
    let target = target_of(path);
    leftover::sweep(folder_of(&target));
    temporary_beside(path, &target).map(drop)
}

/// The file itself: a link is written through, not replaced.
fn target_of(path: &Path) -> PathBuf {
    fs::canonicalize(path).unwrap_or_else(|_| path.into())
}

fn write(
    path: &Path,
    target: &Path,
    over: Over,
    fill: impl FnOnce(&mut Sink<'_>) -> io::Result<()>,
) -> Result<Stamp, StorageError> {
    check_free(path, target, over)?;
    Staged::write(path, target, over, fill)?.take_name()
}

/// Several files that take their names together, when all of them are whole on the disk: until then nothing is seen of
/// them, and nothing is left of them if it does not come to that.
#[derive(Debug, Default)]
pub struct Together(Vec<Staged>);

impl Together {
    /// Writes a file that will take the name `path`, over what `over` allows, with the bytes that `fill` writes as they
    /// come: it may be larger than the memory.
    ///
    /// # Errors
    /// As [`write_over`], and those of `fill`.
    pub fn add(
        &mut self,
        path: &Path,
        over: Over,
        fill: impl FnOnce(&mut Sink<'_>) -> io::Result<()>,
    ) -> Result<(), StorageError> {
        let target = target_of(path);
        check_free(path, &target, over)?;
        if self.0.is_empty() {
            leftover::sweep(folder_of(&target));
        }
        self.0.push(Staged::write(path, &target, over, fill)?);
        Ok(())
    }

    /// Gives all of them their names; the paths, in their order.
    ///
    /// # Errors
    /// If one can't take its name: those before it have theirs then.
    pub fn take_names(self) -> Result<Vec<PathBuf>, StorageError> {
        let take = |staged: Staged| {
            let path = staged.path.clone();
            staged.take_name().map(|_| path)
        };
        self.0.into_iter().map(take).collect()
    }
}

/// A file that is whole on the disk, under another name than its own.
#[derive(Debug)]
struct Staged {
    file: NamedTempFile,
    path: PathBuf,
    target: PathBuf,
    over: Over,
}

impl Staged {
    fn write(
        path: &Path,
        target: &Path,
        over: Over,
        fill: impl FnOnce(&mut Sink<'_>) -> io::Result<()>,
    ) -> Result<Self, StorageError> {
        let fail = |error: io::Error| StorageError::write(path, &error);
        let file = temporary_beside(path, target)?;
        let mut sink = Sink::new(file.as_file());
        fill(&mut sink).and_then(|()| sink.flush()).map_err(fail)?;
        drop(sink);
        if let Ok(before) = fs::metadata(target) {
            file.as_file().set_permissions(before.permissions()).map_err(fail)?;
        }
        file.as_file().sync_all().map_err(fail)?;
        Ok(Self { file, path: path.into(), target: target.into(), over })
    }

    fn take_name(self) -> Result<Stamp, StorageError> {
        let Self { file, path, target, over } = self;
        let fail = |error: io::Error| StorageError::write(&path, &error);
        // Taken before the name: what another program puts there later has another.
        let stamp = file.as_file().metadata().map(|about| Stamp::from_metadata(&about)).map_err(fail)?;
        // Writing took its time, in which another program may have saved.
        check_free(&path, &target, over)?;
        let persisted = match over {
            Over::Nothing => file.persist_noclobber(&target),
            Over::Anything | Over::Known(_) => file.persist(&target),
        };
        persisted.map_err(|error| match error.error.kind() {
            io::ErrorKind::AlreadyExists => taken(&path),
            _ => fail(error.error),
        })?;
        // The name itself reaches the disk with its folder. A system that can't do that has written the file all the same.
        if let Ok(folder) = File::open(folder_of(&target)) {
            let _ = folder.sync_all();
        }
        Ok(stamp)
    }
}

fn taken(path: &Path) -> StorageError {
    StorageError::InTheWay { path: path.into(), reason: "there is a file of that name already".into() }
}

/// That what lies at `target` may be replaced.
fn check_free(path: &Path, target: &Path, over: Over) -> Result<(), StorageError> {
    match over {
        Over::Nothing if fs::symlink_metadata(target).is_ok() => Err(taken(path)),
        // One that is gone can be written anew: nothing is lost.
        Over::Known(known) if Stamp::of(target).is_some_and(|stamp| stamp != known) => {
            Err(StorageError::InTheWay { path: path.into(), reason: "another program changed it".into() })
        }
        _ => Ok(()),
    }
}

fn temporary_beside(path: &Path, target: &Path) -> Result<NamedTempFile, StorageError> {
    // The temporary file's own name says nothing about this one's.
    if let Err(error) = fs::symlink_metadata(target)
        && error.kind() == io::ErrorKind::InvalidFilename
    {
        return Err(StorageError::write(path, &error));
    }
    if let Ok(before) = fs::metadata(target) {
        let refusal = if before.is_dir() {
            Some(("it is a folder", "give a file name in it"))
        } else if !before.is_file() {
            Some((
                "it is no ordinary file",
                "a device or a pipe can't be written whole or not at all; give a file name",
            ))
        } else if before.permissions().readonly() {
            Some(("it is write-protected", "choose another name, or take the protection off"))
        } else {
            None
        };
        if let Some((reason, hint)) = refusal {
            return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
        }
    }
    if fs::symlink_metadata(target).is_ok_and(|link| link.is_symlink()) {
        let (reason, hint) = ("it is a link that leads nowhere", "remove the link, or make what it leads to");
        return Err(StorageError::Write { path: path.into(), reason: reason.into(), hint: hint.into() });
    }
    loop {
        let mut builder = tempfile::Builder::new();
        builder.prefix(leftover::PREFIX).suffix(leftover::SUFFIX).rand_bytes(leftover::LETTERS);
        // Temporary files are private by default; this one becomes a file like any other, as the user's mask says.
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let file = builder.tempfile_in(folder_of(target)).map_err(|error| StorageError::write(path, &error))?;
        if leftover::hold(file.as_file(), file.path()) {
            return Ok(file);
        }
    }
}

fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage::read;

    #[test]
    fn writes_all_or_nothing() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        write_atomic(&path, b"one").expect("writable");
        write_atomic(&path, b"two").expect("writable");
        assert_eq!(read(&path, 3).expect("readable"), b"two");
        assert!(read(&path, 2).is_err(), "larger than the limit");
        assert!(write_atomic(&path.join("b.txt"), b"x").is_err(), "a file is no folder");
        assert!(write_atomic(folder.path(), b"x").is_err(), "a folder is no file");
        assert!(write_atomic(&folder.path().join("none/b.txt"), b"x").is_err());
        let stopped = |sink: &mut Sink<'_>| sink.write_all(&[0; 100_000]).and(Err(io::ErrorKind::Interrupted.into()));
        assert!(Together::default().add(&path, Over::Anything, stopped).is_err());
        assert_eq!(read(&path, 3).expect("readable"), b"two", "as before");
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1, "nothing is left behind");
    }

    #[test]
    fn several_files_appear_together_or_not_at_all() {
        let folder = tempfile::tempdir().expect("a folder");
        let [a, b] = ["a.txt", "b.txt"].map(|name| folder.path().join(name));
        write_atomic(&b, b"old").expect("writable");
        let mut together = Together::default();
        together.add(&a, Over::Anything, |sink| sink.write_all(b"one")).expect("writable");
        assert!(!a.exists(), "not before all are whole");
        assert!(together.add(&b, Over::Anything, |_| Err(io::ErrorKind::Interrupted.into())).is_err());
        drop(together);
        assert_eq!(read(&b, 9).expect("readable"), b"old", "as before");
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 1, "nothing is left behind");
        let mut together = Together::default();
        together.add(&a, Over::Anything, |sink| sink.write_all(b"one")).expect("writable");
        together.add(&b, Over::Anything, |sink| sink.write_all(b"two")).expect("writable");
        assert_eq!(together.take_names().expect("writable"), [a.clone(), b.clone()]);
        assert_eq!([a, b].map(|path| read(&path, 9).expect("readable")), [b"one", b"two"]);
    }

    #[cfg(unix)]
    #[test]
    fn keeps_permissions_and_links() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let (path, link) = (folder.path().join("a.txt"), folder.path().join("link.txt"));
        write_atomic(&path, b"one").expect("writable");
        fs::set_permissions(&path, fs::Permissions::from_mode(0o640)).expect("allowed");
        std::os::unix::fs::symlink(&path, &link).expect("allowed");
        write_atomic(&link, b"two").expect("writable");
        assert_eq!(read(&path, 9).expect("readable"), b"two");
        assert_eq!(fs::metadata(&path).expect("there").permissions().mode() & 0o777, 0o640);
        assert!(fs::symlink_metadata(&link).expect("there").file_type().is_symlink());
        fs::set_permissions(&path, fs::Permissions::from_mode(0o440)).expect("allowed");
        assert!(write_atomic(&path, b"three").is_err(), "write-protected");
    }

    #[test]
    fn only_what_is_known_is_replaced() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        let first = write_over(&path, b"one", Over::Nothing).expect("free");
        assert!(matches!(write_over(&path, b"two", Over::Nothing), Err(StorageError::InTheWay { .. })));
        let second = write_over(&path, b"second", Over::Known(first)).expect("known");
        assert_eq!(Stamp::of(&path), Some(second));
        assert!(matches!(write_over(&path, b"three", Over::Known(first)), Err(StorageError::InTheWay { .. })));
        assert_eq!(read(&path, 9).expect("readable"), b"second");
        let meanwhile = write(&path, &path, Over::Known(second), |sink| {
            fs::write(&path, "theirs")?;
            sink.write_all(b"three")
        });
        assert!(matches!(meanwhile, Err(StorageError::InTheWay { .. })), "another program was faster");
        assert_eq!(read(&path, 9).expect("readable"), b"theirs");
        fs::remove_file(&path).expect("there");
        write_over(&path, b"three", Over::Known(second)).expect("nothing is lost");
    }
}
