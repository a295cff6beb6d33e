//! The values in sight of the curves: as many as there are, until a hand zooms or pans; *Fit* shows all again.

use super::span::Span;
use cloudwright_core::scene::TrackId;
use std::collections::BTreeMap;

/// Of the values, what stays free above and below, as a share.
const ROOM: f64 = 0.12;
/// As close as it gets, and as far, of values from top to bottom.
const HEIGHTS: [f64; 2] = [1e-9, 1e12];

/// Of each curve, the lowest and the highest value in sight.
#[derive(Debug, Default)]
pub(super) struct Values {
    ends: BTreeMap<TrackId, [f64; 2]>,
    /// A hand has zoomed or panned: they stay, whatever the curves do.
    by_hand: bool,
}

impl Values {
    /// All values show again.
    pub(super) fn fit(&mut self) {
        *self = Self::default();
    }

    /// For curves of the same property, whose values lie between `natural`: what is kept of any of them, or some more
    /// than all. In a drag all stays: what is dragged is not to run from the pointer.
    pub(super) fn of(&self, same: &[TrackId], natural: [f64; 2], drags: bool) -> [f64; 2] {
        let kept = same.iter().find_map(|id| self.ends.get(id)).filter(|_| drags || self.by_hand);
        kept.copied().unwrap_or_else(|| with_room(natural))
    }

    /// These are in sight. What a hand has set of others is kept, for when they show again.
    pub(super) fn keep(&mut self, shown: impl Iterator<Item = (TrackId, [f64; 2])>) {
        if !self.by_hand {
            self.ends.clear();
        }
        self.ends.extend(shown);
    }

    /// Zooms by `factor` about a height from 0 at the bottom to 1 at the top, then moves all up by a share of the height.
    pub(super) fn change(&mut self, factor: f64, about: f64, up: f64) {
        if !(factor.is_finite() && factor > 0.0 && about.is_finite() && up.is_finite()) || (factor, up) == (1.0, 0.0) {
            return;
        }
        self.by_hand = !self.ends.is_empty();
        for ends in self.ends.values_mut() {
            let [low, high] = *ends;
            let middle = low + (high - low) * about;
            let height = (high - low) * factor;
            let new = [low, high].map(|end| middle + (end - middle) * factor - up * height);
            let is_sound = new[1] - new[0] > HEIGHTS[0].max(new[0].abs() * 1e-9) && height < HEIGHTS[1];
            if is_sound && new.iter().all(|end| end.abs() < HEIGHTS[1]) {
                *ends = new;
            }
        }
    }
}

fn with_room([low, high]: [f64; 2]) -> [f64; 2] {
    let room = if high > low { (high - low) * ROOM } else { (high.abs() * 0.1).max(0.5) };
    [low - room, high + room]
}

/// Of the plot, where a wheel turns the values and not the time, points from the left.
pub(super) const AXIS: f32 = 46.0;

/// Whether a place is over the numbers at the left.
pub(super) fn over_axis(x: f32, span: &Span) -> bool {
    x < span.x.min + AXIS
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_zoom_about_the_pointer_and_come_back() {
        let (a, b) = (TrackId(1), TrackId(2));
        let mut values = Values::default();
        assert_eq!(values.of(&[a], [0.0, 100.0], false), [-12.0, 112.0]);
        values.keep([(a, [0.0, 100.0]), (b, [-1.0, 1.0])].into_iter());
        assert_eq!(values.of(&[a], [0.0, 100.0], false), [-12.0, 112.0], "they follow the curve");
        assert_eq!(values.of(&[a], [0.0, 900.0], true), [0.0, 100.0], "not in a drag");
        values.change(0.5, 0.25, 0.0);
        assert_eq!(values.of(&[a], [0.0, 100.0], false), [12.5, 62.5], "25 stays where it is");
        assert_eq!(values.of(&[b], [0.0, 0.0], false), [-0.75, 0.25]);
        values.change(1.0, 0.0, 0.1);
        assert_eq!(values.of(&[a], [0.0, 100.0], false), [7.5, 57.5], "what is seen goes up");
        // Another curve shows meanwhile; one of the same property has the same scale.
        values.keep([(b, [-3.0, 3.0])].into_iter());
        assert_eq!(values.of(&[TrackId(3), a], [0.0, 1.0], false), [7.5, 57.5]);
        for _ in 0..2000 {
            values.change(3.0, 0.3, 0.7);
        }
        values.change(f64::NAN, 0.0, f64::INFINITY);
        let [low, high] = values.of(&[a], [0.0, 100.0], false);
        assert!(low.is_finite() && high.is_finite() && high > low);
        for _ in 0..2000 {
            values.change(0.3, 0.3, 0.0);
        }
        let [low, high] = values.of(&[a], [0.0, 100.0], false);
        assert!(high > low);
        values.fit();
        assert_eq!(values.of(&[a], [0.0, 100.0], false), [-12.0, 112.0]);
    }
}
