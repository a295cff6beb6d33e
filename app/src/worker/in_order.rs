//! Slow work off the window's frame, of which nothing may be left out: one job after the other.

use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::{self, JoinHandle};

type Job<Answer> = Box<dyn FnOnce() -> Answer + Send>;

/// A thread that does all its jobs in the order in which they came. When dropped it ends after the last one.
#[derive(Debug)]
pub struct InOrder<Answer: Send + 'static> {
    /// None when the system gave no thread: each job is then done at once.
    jobs: Option<Sender<Job<Answer>>>,
    answer: Sender<Answer>,
    answers: Receiver<Answer>,
    thread: Option<JoinHandle<()>>,
    waiting_count: usize,
}

impl<Answer: Send + 'static> InOrder<Answer> {
    /// Starts the thread. `wake` is called after each answer.
    pub fn start(name: &str, wake: impl Fn() + Send + 'static) -> Self {
        let (jobs, orders) = channel::<Job<Answer>>();
        let (answer, answers) = channel();
        let sender = answer.clone();
        let work = move || {
            for job in orders {
                if sender.send(job()).is_ok() {
                    wake();
                }
            }
        };
        let thread = thread::Builder::new().name(name.into()).spawn(work).ok();
        Self { jobs: thread.is_some().then_some(jobs), answer, answers, thread, waiting_count: 0 }
    }

    /// Has `job` done after all that were asked for before.
    pub fn ask(&mut self, job: impl FnOnce() -> Answer + Send + 'static) {
        self.waiting_count += 1;
        let undone = match &self.jobs {
            Some(jobs) => jobs.send(Box::new(job)).err().map(|back| back.0),
            None => Some(Box::new(job) as Job<Answer>),
        };
        if let Some(job) = undone {
            // The receiver lives as long as this does.
            let _ = self.answer.send(job());
        }
    }

    /// The next answer, in the order of the jobs.
    pub fn next_answer(&mut self) -> Option<Answer> {
        let answer = self.answers.try_recv().ok()?;
        self.waiting_count -= 1;
        Some(answer)
    }

    /// Waits for all jobs. What is asked for after this is done at once.
    pub fn finish(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }

    /// Whether answers are still to come.
    pub fn is_busy(&self) -> bool {
        self.waiting_count > 0
    }
}

impl<Answer: Send + 'static> Drop for InOrder<Answer> {
    fn drop(&mut self) {
        self.finish();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicUsize, Ordering};

    #[test]
    fn all_jobs_are_done_in_order_even_after_the_end() {
        let done = Arc::new(AtomicUsize::new(0));
        let (tell, woken) = channel();
        let mut jobs = InOrder::start("test", move || {
            let _ = tell.send(());
        });
        let (open, gate) = channel::<()>();
        jobs.ask(move || {
            let _ = gate.recv();
            0
        });
        for n in 1..10 {
            let done = Arc::clone(&done);
            jobs.ask(move || {
                done.fetch_add(1, Ordering::SeqCst);
                n
            });
        }
        assert!(jobs.is_busy() && jobs.next_answer().is_none());
        open.send(()).expect("it waits");
        woken.recv().expect("an answer");
        assert_eq!(jobs.next_answer(), Some(0));
        drop(jobs);
        assert_eq!(done.load(Ordering::SeqCst), 9);
    }
}
