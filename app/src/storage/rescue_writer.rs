//! Keeps unsaved work on disk as it changes, off the frame.
//!
//! A thread owns the editor's recovery slot and writes what it was given last into it: the first change at once, a later
//! one after a rest, so that a run of changes is written twice a second and none of them waits longer than that. What
//! can't be written is told about at once and tried again. A program that is told to end makes its
//! [last call](RescueWriter::last_call): what still rests is written then.

use super::{Folders, RecoverySlot, Rescue, Stamp, StorageError};
use cloudwright_core::document::Past;
use cloudwright_core::formats::scene_file;
use cloudwright_core::scene::Scene;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Between two writes; as long as the last one took, if that is longer, so that no more than half of the time is spent.
const REST: Duration = Duration::from_millis(500);
/// After one that failed.
const REST_AFTER_FAILURE: Duration = Duration::from_secs(2);
/// A program that is told to end waits so long for a disk that doesn't answer.
const PATIENCE: Duration = Duration::from_secs(30);

/// Of what can be undone, so much is kept with it.
const MOST_PAST_BYTES: usize = 32 << 20;

/// A scene that its file doesn't hold.
#[derive(Debug, Clone)]
pub struct Unsaved {
    /// All of it.
    pub scene: Arc<Scene>,
    /// Its file, if it has one.
    pub path: Option<PathBuf>,
    /// The file as it was last read or written here.
    pub known: Option<Stamp>,
    /// What can be undone.
    pub past: Past,
}

impl Unsaved {
    /// Whether this is a rescue of that scene, whose file is that one.
    pub fn is_of(&self, scene: &Arc<Scene>, path: Option<&Path>, known: Option<Stamp>) -> bool {
        Arc::ptr_eq(&self.scene, scene) && self.path.as_deref() == path && self.known == known
    }
}

/// The thread that keeps one editor's unsaved work. When dropped it ends after the last write.
#[derive(Debug)]
pub struct RescueWriter {
    shared: Arc<Shared>,
    news: Receiver<Result<(), StorageError>>,
    thread: Option<JoinHandle<()>>,
}

#[derive(Debug, Default)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

#[derive(Debug, Default)]
struct State {
    /// What the slot is to hold next. The latest wins.
    wanted: Option<Wanted>,
    /// Slots in whose work this editor goes on, in order: each takes the place of the one before.
    taken_over: Vec<RecoverySlot>,
    is_working: bool,
    /// Whether rests are left out.
    in_a_hurry: bool,
    is_closed: bool,
}

#[derive(Debug)]
enum Wanted {
    Work(Unsaved),
    /// What could not be written the last time.
    Again(Unsaved),
    Nothing,
}

impl RescueWriter {
    /// Starts the thread, for a slot in `folders`. `wake` is called when there are [news](Self::news).
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(folders: Folders, wake: impl Fn() + Send + 'static) -> std::io::Result<Self> {
        let shared = Arc::new(Shared::default());
        let (sender, news) = channel();
        let its_own = Arc::clone(&shared);
        let thread = thread::Builder::new().name("rescue".into()).spawn(move || {
            Thread { shared: its_own, folders, slot: None, is_failing: false, news: sender, wake }.serve();
        })?;
        Ok(Self { shared, news, thread: Some(thread) })
    }

    /// From now on this is what a crash would lose.
    pub fn keep(&self, unsaved: Unsaved) {
        self.shared.change(|state| state.wanted = Some(Wanted::Work(unsaved)));
    }

    /// There is nothing to lose any more.
    pub fn clear(&self) {
        self.shared.change(|state| state.wanted = Some(Wanted::Nothing));
    }

    /// Goes on with what another editor left, in its slot; what this one kept so far goes.
    pub fn take_over(&self, slot: RecoverySlot) {
        self.shared.change(|state| {
            state.wanted = None;
            state.taken_over.push(slot);
        });
    }

    /// Why the work can't be kept, once for each change; and, after that, that it is kept again.
    pub fn news(&self) -> Option<Result<(), StorageError>> {
        self.news.try_recv().ok()
    }

    /// Whether something is still to be written, but for what can't be.
    pub fn is_busy(&self) -> bool {
        self.shared.lock().is_busy()
    }

    /// What a program calls that is told to end: has what is unsaved written without a rest, and waits for it.
    pub fn last_call(&self) -> impl Fn() + Send + use<> {
        let shared = Arc::clone(&self.shared);
        move || {
            shared.change(|state| state.in_a_hurry = true);
            let state = shared.lock();
            drop(shared.changed.wait_timeout_while(state, PATIENCE, |state| !state.is_done()));
        }
    }

    /// Waits for what is still to be written. What is asked for after this is not done.
    pub fn finish(&mut self) {
        self.shared.change(|state| (state.in_a_hurry, state.is_closed) = (true, true));
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

impl Drop for RescueWriter {
    fn drop(&mut self) {
        self.finish();
    }
}

impl State {
    fn is_done(&self) -> bool {
        self.wanted.is_none() && self.taken_over.is_empty() && !self.is_working
    }

    fn is_busy(&self) -> bool {
        !self.is_done() && !matches!(self.wanted, Some(Wanted::Again(_)))
    }
}

impl Shared {
    /// Each holder leaves a whole state, so a poisoned lock does too.
    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut State)) {
        change(&mut self.lock());
        self.changed.notify_all();
    }

    /// The next thing to do, when there is one: work not before `rested`. None when all is done and the owner is gone.
    fn next(&self, rested: Instant) -> Option<Task> {
        self.change(|state| state.is_working = false);
        let mut state = self.lock();
        loop {
            let rest = match state.wanted {
                Some(Wanted::Work(_) | Wanted::Again(_)) if !state.in_a_hurry => {
                    rested.saturating_duration_since(Instant::now())
                }
                _ => Duration::ZERO,
            };
            let task = if !state.taken_over.is_empty() {
                Some(Task::TakeOver(std::mem::take(&mut state.taken_over)))
            } else if rest.is_zero() {
                state.wanted.take().map(Task::Have)
            } else {
                None
            };
            if task.is_some() {
                state.is_working = true;
                return task;
            }
            if state.is_closed && state.wanted.is_none() {
                return None;
            }
            state = if rest.is_zero() {
                self.changed.wait(state).unwrap_or_else(PoisonError::into_inner)
            } else {
                self.changed.wait_timeout(state, rest).unwrap_or_else(PoisonError::into_inner).0
            };
        }
    }

    /// Has it tried again, unless there is something newer, or no time.
    fn put_back(&self, unsaved: Unsaved) {
        let mut state = self.lock();
        if !state.in_a_hurry {
            state.wanted.get_or_insert(Wanted::Again(unsaved));
        }
    }
}

enum Task {
    TakeOver(Vec<RecoverySlot>),
    Have(Wanted),
}

struct Thread<Wake> {
    shared: Arc<Shared>,
    folders: Folders,
    /// Claimed when it is first needed.
    slot: Option<RecoverySlot>,
    is_failing: bool,
    news: Sender<Result<(), StorageError>>,
    wake: Wake,
}

impl<Wake: Fn()> Thread<Wake> {
    fn serve(mut self) {
        let mut rested = Instant::now();
        while let Some(task) = self.shared.next(rested) {
            match task {
                Task::TakeOver(slots) => slots.into_iter().for_each(|slot| self.hold(Some(slot))),
                Task::Have(Wanted::Nothing) => self.hold(None),
                Task::Have(Wanted::Work(unsaved)) => rested = self.keep(unsaved, true),
                Task::Have(Wanted::Again(unsaved)) => rested = self.keep(unsaved, false),
            }
        }
    }

    /// Another slot in place of this editor's, which is cleared.
    fn hold(&mut self, slot: Option<RecoverySlot>) {
        self.is_failing = false;
        if let Some(before) = std::mem::replace(&mut self.slot, slot) {
            before.clear();
        }
    }

    /// Writes it, and tells what is news. When the next may be written.
    fn keep(&mut self, unsaved: Unsaved, is_new: bool) -> Instant {
        let begin = Instant::now();
        let written = self.write(&unsaved);
        let was_failing = std::mem::replace(&mut self.is_failing, written.is_err());
        let (rest, is_news) = match written {
            Ok(()) => (REST.max(begin.elapsed()), was_failing),
            Err(_) => (REST_AFTER_FAILURE, is_new),
        };
        if self.is_failing {
            self.shared.put_back(unsaved);
        }
        if is_news && self.news.send(written).is_ok() {
            (self.wake)();
        }
        Instant::now() + rest
    }

    fn write(&mut self, unsaved: &Unsaved) -> Result<(), StorageError> {
        let slot = match self.slot.take() {
            Some(slot) => slot,
            None => RecoverySlot::claim(&self.folders)?,
        };
        let slot = self.slot.insert(slot);
        // Numbers that JSON can't say are refused by every edit.
        let Ok(text) = scene_file::write(&unsaved.scene) else { return Ok(()) };
        let past = unsaved.past.write(MOST_PAST_BYTES);
        Rescue::new(unsaved.path.as_deref(), unsaved.known, text, past).write(slot.file())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::storage::orphans;
    use std::fs;

    fn unsaved(name: &str) -> Unsaved {
        Unsaved {
            scene: Arc::new(Scene { name: name.into(), ..Scene::default() }),
            path: None,
            known: None,
            past: Past::default(),
        }
    }

    /// Names of the scenes that are kept in a folder.
    fn kept(home: &Path) -> Vec<String> {
        let entries = fs::read_dir(home.join("state/recovery")).into_iter().flatten();
        let paths = entries.flatten().map(|entry| entry.path());
        let rescues = paths.filter(|path| path.extension().is_some_and(|ending| ending == "rescue"));
        let scene = |path: PathBuf| scene_file::read(Rescue::read(&path).expect("whole").scene.as_bytes());
        rescues.map(|path| scene(path).expect("sound").name).collect()
    }

    fn wait(writer: &RescueWriter) {
        while writer.is_busy() {
            thread::yield_now();
        }
    }

    /// A second, and what a busy machine may add.
    const AT_THE_LATEST: Duration = Duration::from_secs(3);

    #[test]
    fn a_run_of_changes_is_kept_as_it_goes() {
        let home = tempfile::tempdir().expect("a folder");
        let writer = RescueWriter::start(Folders::within(home.path()), || ()).expect("a thread");
        let begin = Instant::now();
        let mut asked: Vec<(String, Instant)> = Vec::new();
        while begin.elapsed() < AT_THE_LATEST + REST {
            asked.push((asked.len().to_string(), Instant::now()));
            writer.keep(unsaved(&asked[asked.len() - 1].0));
            thread::sleep(Duration::from_millis(20));
            let kept: usize = kept(home.path()).first().map_or(0, |name| name.parse().expect("a number"));
            let missing = asked.get(kept + 1).map_or(Duration::ZERO, |(_, since)| since.elapsed());
            assert!(missing < AT_THE_LATEST, "{kept} of {} after {missing:?}", asked.len());
        }
        wait(&writer);
        assert_eq!(kept(home.path()), [asked[asked.len() - 1].0.clone()]);
        writer.clear();
        wait(&writer);
        assert_eq!(fs::read_dir(home.path().join("state/recovery")).expect("there").count(), 0);
    }

    #[test]
    fn the_last_call_leaves_out_the_rest() {
        let home = tempfile::tempdir().expect("a folder");
        let writer = RescueWriter::start(Folders::within(home.path()), || ()).expect("a thread");
        writer.keep(unsaved("first"));
        wait(&writer);
        writer.keep(unsaved("last"));
        writer.last_call()();
        assert_eq!(kept(home.path()), ["last"]);
    }

    #[test]
    fn what_cannot_be_kept_is_told_once_a_change_and_tried_again() {
        let home = tempfile::tempdir().expect("a folder");
        let state = home.path().join("state");
        fs::write(&state, "a file where a folder should be").expect("writable");
        let (tell, woken) = channel();
        let wake = move || {
            let _ = tell.send(());
        };
        let writer = RescueWriter::start(Folders::within(home.path()), wake).expect("a thread");
        writer.keep(unsaved("first"));
        woken.recv_timeout(AT_THE_LATEST).expect("at once");
        assert!(writer.news().expect("told").is_err());
        fs::remove_file(&state).expect("there");
        woken.recv().expect("it is tried again");
        assert!(writer.news().expect("told").is_ok() && writer.news().is_none());
        assert_eq!(kept(home.path()), ["first"]);
    }

    #[test]
    fn work_that_is_taken_over_goes_on_in_its_slot() {
        let home = tempfile::tempdir().expect("a folder");
        let folders = Folders::within(home.path());
        let start = || RescueWriter::start(folders.clone(), || ()).expect("a thread");
        let crashed = start();
        crashed.keep(unsaved("theirs"));
        drop(crashed);
        let writer = start();
        writer.keep(unsaved("ours"));
        wait(&writer);
        let orphan = orphans(&folders).remove(0);
        writer.take_over(orphan.slot);
        wait(&writer);
        assert_eq!(kept(home.path()), ["theirs"], "where it always was");
        assert!(orphans(&folders).is_empty(), "it is held");
        writer.keep(unsaved("theirs, and more"));
        drop(writer);
        assert_eq!(kept(home.path()), ["theirs, and more"]);
        assert_eq!(orphans(&folders).len(), 1);
    }
}
