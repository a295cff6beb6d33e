//! Random tracks, the same each time.

use cloudwright_core::random::{draw, unit};
use cloudwright_core::scene::{Beyond, KeyValue, Leaves, Track, TrackId, TrackKey};

pub(crate) const BEYOND: [Beyond; 3] = [Beyond::Hold, Beyond::Repeat, Beyond::Swing];

/// Rolls one number after another.
pub(crate) struct Dice {
    seed: u64,
    rolled: u32,
}

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Self { seed, rolled: 0 }
    }

    /// Between 0 and 1.
    pub(crate) fn share(&mut self) -> f64 {
        self.rolled += 1;
        unit(draw(self.seed, 13, self.rolled, 0)[0])
    }

    pub(crate) fn within(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.share()
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.share() * count as f64) as usize
    }

    pub(crate) fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.below(all.len())]
    }

    /// `count` times in rising order, some close to the next and some far from it.
    pub(crate) fn times(&mut self, count: usize) -> Vec<f64> {
        let mut time_s = self.within([-50.0, 50.0]);
        let mut next = || {
            time_s += 10.0_f64.powf(self.within([-2.0, 2.0]));
            time_s
        };
        (0..count).map(|_| next()).collect()
    }

    /// 1 to 9 keys of values in `range`, that leave as they like, now and then with equal neighbours.
    pub(crate) fn track(&mut self, range: [f64; 2], leaves: &[Leaves]) -> Track {
        let count = 1 + self.below(9);
        let mut values = Vec::new();
        for i in 0..count {
            let again = i > 0 && self.share() < 0.2;
            values.push(if again { values[i - 1] } else { self.within(range) });
        }
        let mut track = track(&self.times(count), &values);
        track.keys.iter_mut().for_each(|key| key.leaves = self.one_of(leaves));
        [track.before, track.after] = [self.one_of(&BEYOND), self.one_of(&BEYOND)];
        track
    }
}

/// Smooth, and holding beyond its keys.
pub(crate) fn track(times_s: &[f64], values: &[f64]) -> Track {
    let key = |(time_s, value): (&f64, &f64)| TrackKey::new(*time_s, KeyValue::One(*value));
    Track::new(TrackId(1), "", times_s.iter().zip(values).map(key).collect())
}

pub(crate) fn value(key: &TrackKey) -> f64 {
    key.value.parts()[0]
}
