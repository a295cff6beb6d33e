//! How far long work has come, and how long it will still take.
//!
//! The pace is that of the last while: what was there already, and is only looked at, would make all else seem quick.
//! It is read off the bar itself from frame to frame, so that whatever works needs no clock.

use crate::theme;
use crate::units::time_left;
use egui::{Id, ProgressBar, Response, Ui};
use std::collections::VecDeque;

/// As long as the pace is taken over, seconds; longer where steps are few.
const WHILE_S: f64 = 20.0;
/// Steps that tell a pace at least, if there were so many.
const STEPS: usize = 8;
/// Sooner, nothing is said, seconds.
const PATIENCE_S: f64 = 1.0;
/// A bar that was not shown for so long is another one, seconds.
const PAUSE_S: f64 = 3.0;

/// Steps of the work, each with the time at which it was seen, seconds, and the share that was done then.
#[derive(Debug, Clone, Default, PartialEq)]
struct Pace {
    steps: VecDeque<(f64, f32)>,
    seen_s: f64,
}

impl Pace {
    fn see(&mut self, now_s: f64, share: f32) {
        let is_another = self.steps.back().is_some_and(|(_, last)| share < *last) || now_s - self.seen_s > PAUSE_S;
        if is_another {
            self.steps.clear();
        }
        self.seen_s = now_s;
        if self.steps.back().is_none_or(|(_, last)| share > *last) {
            self.steps.push_back((now_s, share));
        }
        while self.steps.len() > STEPS && self.steps.front().is_some_and(|(at_s, _)| now_s - at_s > WHILE_S) {
            self.steps.pop_front();
        }
    }

    /// Seconds until all is done; none as long as nobody knows.
    fn left_s(&self) -> Option<f64> {
        let ((from_s, from), (to_s, to)) = (*self.steps.front()?, *self.steps.back()?);
        if self.seen_s - from_s < PATIENCE_S || to <= from || to_s <= from_s {
            return None;
        }
        let a_second = f64::from(to - from) / (to_s - from_s);
        Some((f64::from(1.0 - to) / a_second - (self.seen_s - to_s)).max(0.0))
    }
}

/// A bar of what is done, 0 to 1, by that name, and beside it how long the rest will take.
pub(crate) fn work_bar(ui: &mut Ui, name: &str, share: f32) -> Response {
    let bar = ui.add(ProgressBar::new(share).desired_width(theme::PROGRESS_WIDTH).show_percentage());
    let id = Id::unique("pace of work").with(name);
    let mut pace: Pace = ui.data(|data| data.get_temp(id)).unwrap_or_default();
    pace.see(ui.input(|input| input.time), share);
    let left = pace.left_s().map(time_left);
    ui.data_mut(|data| data.insert_temp(id, pace));
    ui.ctx().accesskit_node_builder(bar.id, |node| node.set_label(name));
    if let Some(left) = left {
        ui.label(left);
    }
    bar
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_there_already_tells_no_pace() {
        let mut pace = Pace::default();
        assert_eq!(pace.left_s(), None);
        // Half of the film was there, and is found in a moment; then each of fifty frames takes two seconds.
        for step in 0..=50 {
            pace.see(f64::from(step) * 0.01, step as f32 * 0.01);
        }
        assert_eq!(pace.left_s(), None, "too early to tell");
        for frame in 1..=20 {
            pace.see(0.5 + f64::from(frame) * 2.0, 0.5 + frame as f32 * 0.01);
        }
        let left = pace.left_s().expect("known by now");
        assert!((left - 60.0).abs() < 1.0, "{left}");
        // It goes on between two steps.
        pace.see(41.5, 0.7);
        assert!((pace.left_s().expect("known") - left + 1.0).abs() < 0.01);
        pace.see(42.5, 0.0);
        assert_eq!(pace.left_s(), None, "other work");
    }
}
