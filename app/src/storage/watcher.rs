//! Notices that another program changed a file, or the files of a folder.
//!
//! A thread looks at times and lengths every two seconds, and wakes the window only when they differ from what is known.
//! Looking is cheaper than it sounds, works on every disk, and also sees a file that is replaced.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

const BETWEEN_LOOKS: Duration = Duration::from_secs(2);
/// A file that is being written changes again within this.
const UNTIL_SETTLED: Duration = Duration::from_millis(200);

/// A file or folder as it was seen, by what is looked at: a `Stamp`, or a `Listing`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sighting<S> {
    /// Which file or folder.
    pub path: PathBuf,
    /// As it is now; none if it is gone.
    pub stamp: Option<S>,
}

/// Looks at one file or folder. Ends when dropped.
#[derive(Debug)]
pub struct Watcher<S> {
    shared: Arc<Shared<S>>,
}

#[derive(Debug)]
struct Shared<S> {
    state: Mutex<State<S>>,
    changed: Condvar,
}

#[derive(Debug)]
struct State<S> {
    /// As it is known.
    known: Option<Sighting<S>>,
    /// Otherwise than known, until somebody takes it.
    news: Option<Sighting<S>>,
    closed: bool,
}

impl<S: Clone + PartialEq + Send + 'static> Watcher<S> {
    /// Starts the thread. `stamp_of` looks; `wake` is called when what it sees is otherwise than known.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(stamp_of: fn(&Path) -> Option<S>, wake: impl Fn() + Send + 'static) -> std::io::Result<Self> {
        let state = State { known: None, news: None, closed: false };
        let shared = Arc::new(Shared { state: Mutex::new(state), changed: Condvar::new() });
        let its_own = Arc::clone(&shared);
        thread::Builder::new().name("watcher".into()).spawn(move || look(&its_own, stamp_of, &wake))?;
        Ok(Self { shared })
    }

    /// From now on looks there, at once and then every now and then; none for nothing.
    pub fn watch(&self, known: Option<(&Path, Option<&S>)>) {
        let mut state = self.shared.lock();
        let same = match (&state.known, known) {
            (Some(old), Some((path, stamp))) => old.path == path && old.stamp.as_ref() == stamp,
            (None, None) => true,
            _ => false,
        };
        if !same {
            state.known = known.map(|(path, stamp)| Sighting { path: path.into(), stamp: stamp.cloned() });
            state.news = None;
            self.shared.changed.notify_one();
        }
    }

    /// What is seen, if it is otherwise than known.
    pub fn news(&self) -> Option<Sighting<S>> {
        self.shared.lock().news.take()
    }
}

impl<S> Drop for Watcher<S> {
    fn drop(&mut self) {
        self.shared.lock().closed = true;
        self.shared.changed.notify_one();
    }
}

impl<S> Shared<S> {
    /// Each holder leaves a whole state, so a poisoned lock does too.
    fn lock(&self) -> MutexGuard<'_, State<S>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits so long, or until something is changed.
    fn wait<'a>(&self, state: MutexGuard<'a, State<S>>, time: Duration) -> MutexGuard<'a, State<S>> {
        self.changed.wait_timeout(state, time).unwrap_or_else(PoisonError::into_inner).0
    }
}

fn look<S: Clone + PartialEq>(shared: &Shared<S>, stamp_of: fn(&Path) -> Option<S>, wake: &dyn Fn()) {
    let mut state = shared.lock();
    let mut before: Option<Sighting<S>> = None;
    while !state.closed {
        let Some(known) = state.known.clone() else {
            state = shared.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
            continue;
        };
        // A look may take long on a distant disk; the window must not wait for it.
        drop(state);
        let now = Sighting { stamp: stamp_of(&known.path), path: known.path.clone() };
        state = shared.lock();
        if state.known.as_ref() != Some(&known) {
            continue;
        }
        if now == known || state.news.as_ref() == Some(&now) {
            state = shared.wait(state, BETWEEN_LOOKS);
        } else if before.as_ref() == Some(&now) {
            state.news = Some(now);
            wake();
        } else {
            before = Some(now);
            state = shared.wait(state, UNTIL_SETTLED);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage::{Listing, Stamp};
    use std::fs;
    use std::sync::mpsc::channel;

    #[test]
    fn a_change_is_seen_and_a_known_file_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        fs::write(&path, "one").expect("writable");
        let (tell, woken) = channel();
        let watcher = Watcher::start(Stamp::of, move || {
            let _ = tell.send(());
        })
        .expect("a thread");
        let known = Stamp::of(&path);
        fs::write(&path, "another").expect("writable");
        watcher.watch(Some((&path, known.as_ref())));
        woken.recv().expect("it is seen");
        let seen = watcher.news().expect("once");
        assert_eq!((seen.stamp, watcher.news()), (Stamp::of(&path), None));
        fs::remove_file(&path).expect("there");
        watcher.watch(Some((&path, seen.stamp.as_ref())));
        woken.recv().expect("it is seen");
        assert_eq!(watcher.news().expect("once").stamp, None);
    }

    #[test]
    fn a_folder_is_seen_by_the_files_in_it() {
        let home = tempfile::tempdir().expect("a folder");
        let folder = home.path().join("plugins");
        let (tell, woken) = channel();
        let of = |folder: &Path| Some(Listing::of(folder, "rhai"));
        let watcher = Watcher::start(of, move || {
            let _ = tell.send(());
        })
        .expect("a thread");
        let mut known = Listing::of(&folder, "rhai");
        assert_eq!(known.paths().count(), 0, "a folder that is not there is an empty one");
        let put = |name: &str, text: &str| fs::write(folder.join(name), text).expect("writable");
        fs::create_dir(&folder).expect("writable");
        let changes: [(&dyn Fn(), &[&str]); 4] = [
            (&|| put("b.rhai", "1"), &["b.rhai"]),
            (&|| ["a.RHAI", "c.txt"].iter().for_each(|name| put(name, "")), &["a.RHAI", "b.rhai"]),
            (&|| put("b.rhai", "12"), &["a.RHAI", "b.rhai"]),
            (&|| fs::remove_file(folder.join("b.rhai")).expect("there"), &["a.RHAI"]),
        ];
        for (change, names) in changes {
            change();
            watcher.watch(None);
            watcher.watch(Some((&folder, Some(&known))));
            woken.recv().expect("it is seen");
            known = watcher.news().and_then(|seen| seen.stamp).expect("once");
            let seen: Vec<_> = known.paths().map(|path| path.file_name().expect("a name").to_owned()).collect();
            assert_eq!(seen, names);
        }
    }
}
