//! Notices that another program changed a file.
//!
//! A thread looks at time and length of one file every two seconds, and wakes the window only when they differ from
//! what is known. Looking is cheaper than it sounds, works on every disk, and also sees a file that is replaced.

use super::Stamp;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Duration;

const BETWEEN_LOOKS: Duration = Duration::from_secs(2);
/// A file that is being written changes again within this.
const UNTIL_SETTLED: Duration = Duration::from_millis(200);

/// A file as it was seen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Sighting {
    /// Which file.
    pub path: PathBuf,
    /// As it is now; none if it is gone.
    pub stamp: Option<Stamp>,
}

/// Looks at one file. Ends when dropped.
#[derive(Debug)]
pub struct Watcher {
    shared: Arc<Shared>,
}

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    /// The file as it is known.
    known: Option<Sighting>,
    /// The file otherwise than known, until somebody takes it.
    news: Option<Sighting>,
    closed: bool,
}

impl Watcher {
    /// Starts the thread. `wake` is called when the file is otherwise than known.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(wake: impl Fn() + Send + 'static) -> std::io::Result<Self> {
        let shared = Arc::new(Shared::default());
        let its_own = Arc::clone(&shared);
        thread::Builder::new().name("watcher".into()).spawn(move || look(&its_own, &wake))?;
        Ok(Self { shared })
    }

    /// From now on looks at this file, at once and then every now and then; none for nothing.
    pub fn watch(&self, known: Option<(&Path, Option<Stamp>)>) {
        let mut state = self.shared.lock();
        let same = match (&state.known, known) {
            (Some(old), Some((path, stamp))) => old.path == path && old.stamp == stamp,
            (None, None) => true,
            _ => false,
        };
        if !same {
            state.known = known.map(|(path, stamp)| Sighting { path: path.into(), stamp });
            state.news = None;
            self.shared.changed.notify_one();
        }
    }

    /// The file, if it is otherwise than known.
    pub fn news(&self) -> Option<Sighting> {
        self.shared.lock().news.take()
    }
}

impl Drop for Watcher {
    fn drop(&mut self) {
        self.shared.lock().closed = true;
        self.shared.changed.notify_one();
    }
}

impl Shared {
    /// Each holder leaves a whole state, so a poisoned lock does too.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits so long, or until something is changed.
    fn wait<'a>(&self, state: MutexGuard<'a, State>, time: Duration) -> MutexGuard<'a, State> {
        self.changed.wait_timeout(state, time).unwrap_or_else(PoisonError::into_inner).0
    }
}

fn look(shared: &Shared, wake: &dyn Fn()) {
    let mut state = shared.lock();
    let mut before: Option<Sighting> = None;
    while !state.closed {
        let Some(known) = state.known.clone() else {
            state = shared.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
            continue;
        };
        // A look may take long on a distant disk; the window must not wait for it.
        drop(state);
        let now = Sighting { stamp: Stamp::of(&known.path), path: known.path.clone() };
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
    use std::fs;
    use std::sync::mpsc::channel;

    #[test]
    fn a_change_is_seen_and_a_known_file_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.txt");
        fs::write(&path, "one").expect("writable");
        let (tell, woken) = channel();
        let watcher = Watcher::start(move || {
            let _ = tell.send(());
        })
        .expect("a thread");
        let known = Stamp::of(&path);
        fs::write(&path, "another").expect("writable");
        watcher.watch(Some((&path, known)));
        woken.recv().expect("it is seen");
        let seen = watcher.news().expect("once");
        assert_eq!((seen.stamp, watcher.news()), (Stamp::of(&path), None));
        fs::remove_file(&path).expect("there");
        watcher.watch(Some((&path, seen.stamp)));
        woken.recv().expect("it is seen");
        assert_eq!(watcher.news().expect("once").stamp, None);
    }
}
