//! Slow work off the window's frame. The latest request wins.
//!
//! One thread takes the newest request, works, answers and wakes the window. A request that came and was replaced
//! while the thread worked is never started, so a drag can ask at every frame.

mod in_order;

pub use in_order::InOrder;

use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// A thread that answers the latest of its requests. Ends when dropped, after the work in hand.
#[derive(Debug)]
pub struct Latest<Request, Answer> {
    slot: Arc<Slot<Request>>,
    answers: Receiver<Answer>,
}

#[derive(Debug)]
struct Slot<Request> {
    state: Mutex<State<Request>>,
    changed: Condvar,
}

#[derive(Debug)]
struct State<Request> {
    waiting: Option<Request>,
    closed: bool,
}

impl<Request> Slot<Request> {
    /// Nothing can break between the lock and its release, so a poisoned lock holds a whole state.
    fn lock(&self) -> MutexGuard<'_, State<Request>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The next request; none when the owner is gone.
    fn take(&self) -> Option<Request> {
        let mut state = self.lock();
        loop {
            if state.closed {
                return None;
            }
            if let Some(request) = state.waiting.take() {
                return Some(request);
            }
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
    }
}

impl<Request: Send + 'static, Answer: Send + 'static> Latest<Request, Answer> {
    /// Starts the thread. `work` answers one request; `wake` is called after each answer.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub fn start(
        name: &str,
        work: impl FnMut(Request) -> Answer + Send + 'static,
        wake: impl Fn() + Send + 'static,
    ) -> std::io::Result<Self> {
        let slot =
            Arc::new(Slot { state: Mutex::new(State { waiting: None, closed: false }), changed: Condvar::new() });
        let (sender, answers) = channel();
        let shared = Arc::clone(&slot);
        thread::Builder::new().name(name.into()).spawn(move || serve(&shared, &sender, work, wake))?;
        Ok(Self { slot, answers })
    }

    /// As [`Latest::start`], for much work: in a pool of its own, of all cores but one, which is the window's.
    ///
    /// # Errors
    /// If the system gives no thread.
    pub(crate) fn start_beside_the_window(
        name: &'static str,
        mut work: impl FnMut(Request) -> Answer + Send + 'static,
        wake: impl Fn() + Send + 'static,
    ) -> std::io::Result<Self> {
        let pool = pool_beside_the_window(name);
        let work = move |request| match &pool {
            Some(pool) => pool.install(|| work(request)),
            None => work(request),
        };
        Self::start(name, work, wake)
    }

    /// Asks; a request that still waits is replaced.
    pub fn ask(&self, request: Request) {
        self.slot.lock().waiting = Some(request);
        self.slot.changed.notify_one();
    }

    /// The newest answer since the last call.
    pub fn newest(&self) -> Option<Answer> {
        self.answers.try_iter().last()
    }

    /// The same, but waits until `is_it` the one that is wanted, though no longer than `most`.
    pub(crate) fn newest_within(&self, most: Duration, is_it: impl Fn(&Answer) -> bool) -> Option<Answer> {
        let begun = Instant::now();
        let mut newest = self.newest();
        while !newest.as_ref().is_some_and(&is_it) {
            let Some(left) = most.checked_sub(begun.elapsed()) else { break };
            match self.answers.recv_timeout(left) {
                Ok(answer) => newest = Some(answer),
                Err(_) => break,
            }
        }
        newest
    }
}

/// All cores but one, which is the window's. None if the system gives no threads.
pub(crate) fn pool_beside_the_window(name: &'static str) -> Option<rayon::ThreadPool> {
    let cores = thread::available_parallelism().map_or(1, usize::from);
    let threads = cores.saturating_sub(1).max(1);
    rayon::ThreadPoolBuilder::new().num_threads(threads).thread_name(move |i| format!("{name} {i}")).build().ok()
}

fn serve<Request, Answer>(
    slot: &Slot<Request>,
    answers: &Sender<Answer>,
    mut work: impl FnMut(Request) -> Answer,
    wake: impl Fn(),
) {
    while let Some(request) = slot.take() {
        if answers.send(work(request)).is_err() {
            return;
        }
        wake();
    }
}

impl<Request, Answer> Drop for Latest<Request, Answer> {
    fn drop(&mut self) {
        self.slot.lock().closed = true;
        self.slot.changed.notify_one();
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_latest_request_wins() {
        let (gate, opened) = channel::<()>();
        let (tell, woken) = channel::<()>();
        let worker = Latest::start(
            "test",
            move |request: u32| {
                let _ = opened.recv();
                request
            },
            move || {
                let _ = tell.send(());
            },
        )
        .expect("a thread");
        worker.ask(1);
        // The thread may or may not have taken 1 already; 2 is replaced before it can start only if it has.
        while worker.slot.lock().waiting.is_some() {
            thread::yield_now();
        }
        worker.ask(2);
        worker.ask(3);
        for _ in 0..2 {
            gate.send(()).expect("the thread lives");
            woken.recv().expect("an answer");
        }
        assert_eq!(worker.newest(), Some(3));
        assert_eq!(worker.newest(), None);
    }
}
