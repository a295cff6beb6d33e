//! The integral of pieces over time, exact: sums up to the beginning of each, and one piece's closed form.

use super::pieces::{POWERS, Pieces};

/// A vector over time and its integral from second 0 on.
#[derive(Debug, Clone)]
pub struct Sums<const N: usize> {
    pieces: Pieces<N>,
    /// Up to where each piece begins, and the last ends.
    sums: Vec<[f64; N]>,
}

impl<const N: usize> Sums<N> {
    pub fn new(pieces: Pieces<N>) -> Self {
        let mut sums = vec![[0.0; N]];
        for (at, piece) in pieces.pieces.iter().enumerate() {
            let (width_s, sum) = (pieces.width_s(at), sums[at]);
            sums.push(std::array::from_fn(|n| sum[n] + integral(&piece[n], width_s, width_s)));
        }
        Self { pieces, sums }
    }

    /// From second 0 to `time_s`; none of what was before 0.
    pub fn at(&self, time_s: f64) -> [f64; N] {
        let at = self.pieces.find(time_s);
        let Some(piece) = self.pieces.pieces.get(at.piece) else {
            return std::array::from_fn(|n| self.sums[at.piece][n] + self.pieces.beyond[n] * at.since_s);
        };
        let width_s = self.pieces.width_s(at.piece);
        let round = |n: usize| match self.pieces.loops_from {
            Some(from) if at.rounds > 0.0 => (self.sums[self.sums.len() - 1][n] - self.sums[from][n]) * at.rounds,
            _ => 0.0,
        };
        std::array::from_fn(|n| self.sums[at.piece][n] + round(n) + integral(&piece[n], at.since_s, width_s))
    }
}

/// Over the first `since_s` seconds of a piece of `width_s`.
fn integral(powers: &[f64; POWERS], since_s: f64, width_s: f64) -> f64 {
    let share = since_s / width_s;
    let sum = powers.iter().enumerate().rev().fold(0.0, |sum, (k, power)| sum * share + power / (k + 1) as f64);
    sum * since_s
}
