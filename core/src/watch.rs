//! A long computation's line to whoever waits for it: how far it has come, and whether it is still wanted.
//!
//! What is no longer wanted stops at its next look and leaves the rest of its result out, so whoever cancels, or may
//! be cancelled, asks [`Watch::is_cancelled`] before using a result. Shared between threads; without a clock.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

/// How many items pass between two looks.
const STRIDE: u64 = 1024;

/// Progress and an end before time.
#[derive(Debug, Default)]
pub struct Watch {
    done: AtomicU64,
    expected: AtomicU64,
    cancelled: Arc<AtomicBool>,
}

impl Watch {
    /// One that whoever holds `cancelled` may end.
    pub fn cancelled_by(cancelled: Arc<AtomicBool>) -> Self {
        Self { cancelled, ..Self::default() }
    }

    /// Has the computation stop soon. There is no way back.
    pub fn cancel(&self) {
        self.cancelled.store(true, Ordering::Relaxed);
    }

    /// What [`Watch::cancel`] sets, for those who can do no more than set a flag: a signal's handler.
    pub fn cancelled(&self) -> Arc<AtomicBool> {
        Arc::clone(&self.cancelled)
    }

    /// Whether the result, which may lack parts, is to be thrown away.
    pub fn is_cancelled(&self) -> bool {
        self.cancelled.load(Ordering::Relaxed)
    }

    /// For a part of the computation: cancelled with this one, with a progress of its own.
    pub(crate) fn part(&self) -> Self {
        Self { cancelled: self.cancelled(), ..Self::default() }
    }

    /// How much is done, 0 to 1.
    pub fn share(&self) -> f32 {
        let (done, expected) = (self.done.load(Ordering::Relaxed), self.expected.load(Ordering::Relaxed));
        if expected == 0 { 0.0 } else { (done as f32 / expected as f32).min(1.0) }
    }

    /// How much work will be done in all, in any unit.
    pub(crate) fn expect(&self, work: u64) {
        self.expected.store(work, Ordering::Relaxed);
    }

    /// How far it has come, 0 to 1, where that is not a sum of equal parts.
    pub fn reach(&self, share: f32) {
        const PARTS: f32 = 10_000.0;
        self.expect(PARTS as u64);
        self.done.fetch_max((share.clamp(0.0, 1.0) * PARTS) as u64, Ordering::Relaxed);
    }

    /// `items`, each of which is some `work`, until there are no more or the watch is cancelled.
    pub(crate) fn along<I: IntoIterator>(&self, work: u64, items: I) -> Along<'_, I::IntoIter> {
        Along { watch: self, items: items.into_iter(), work, passed: 0 }
    }
}

/// See [`Watch::along`].
pub(crate) struct Along<'a, I> {
    watch: &'a Watch,
    items: I,
    work: u64,
    /// Since progress was last told.
    passed: u64,
}

impl<I> Along<'_, I> {
    fn tell(&mut self) {
        self.watch.done.fetch_add(self.passed * self.work, Ordering::Relaxed);
        self.passed = 0;
    }
}

impl<I> Drop for Along<'_, I> {
    fn drop(&mut self) {
        self.tell();
    }
}

impl<I: Iterator> Iterator for Along<'_, I> {
    type Item = I::Item;

    fn next(&mut self) -> Option<I::Item> {
        if self.passed == STRIDE {
            self.tell();
        }
        if self.passed == 0 && self.watch.is_cancelled() {
            return None;
        }
        let item = self.items.next()?;
        self.passed += 1;
        Some(item)
    }

    fn size_hint(&self) -> (usize, Option<usize>) {
        (0, self.items.size_hint().1)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_stops() {
        let watch = Watch::default();
        watch.expect(30 * STRIDE);
        assert_eq!(watch.along(3, 0..5 * STRIDE).count() as u64, 5 * STRIDE);
        assert!((watch.share() - 0.5).abs() < 1e-6, "{}", watch.share());
        let mut passed = 0;
        for item in watch.along(1, 0..) {
            passed += 1;
            if item == 10 {
                watch.cancel();
            }
        }
        assert_eq!(passed, STRIDE);
        assert_eq!(watch.along(1, 0..).next(), None);
    }
}
