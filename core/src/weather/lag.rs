//! What follows a vector over time with a lag, exact: d' = (u − d)/τ.
//!
//! It begins at second 0 where it would be if u had always been as it is then. On a piece where u is a polynomial, d is a
//! decaying exponential and a sum of moments G_k(z) = z ∫ e^(−z (1 − y)) y^k dy, y from 0 to 1, with z the piece's
//! seconds in τ. So d is asked for at any time without those between; explicit steps, which blow up beyond 2τ, are among
//! the ways that fail.

use super::pieces::{POWERS, Pieces};

/// Shorter lags are none, seconds.
const LEAST_LAG_S: f64 = 1e-6;

/// A vector that follows another.
#[derive(Debug, Clone)]
pub struct Lagged<const N: usize> {
    /// u.
    pieces: Pieces<N>,
    /// τ, seconds; 0 for none.
    lag_s: f64,
    /// d where each piece begins, and the last ends. From the loop on: what there would be of it, had it been 0 where
    /// the loop begins.
    starts: Vec<[f64; N]>,
    /// d where the loop begins for the first time.
    at_loop: [f64; N],
}

impl<const N: usize> Lagged<N> {
    pub fn new(pieces: Pieces<N>, lag_s: f64) -> Self {
        let lag_s = if lag_s > LEAST_LAG_S { lag_s } else { 0.0 };
        let mut starts = vec![pieces.value(pieces.find(0.0))];
        let mut at_loop = [0.0; N];
        if lag_s > 0.0 {
            for (at, piece) in pieces.pieces.iter().enumerate() {
                if pieces.loops_from == Some(at) {
                    at_loop = std::mem::replace(&mut starts[at], [0.0; N]);
                }
                let width_s = pieces.width_s(at);
                starts.push(followed(starts[at], piece, width_s, width_s, lag_s));
            }
        }
        Self { pieces, lag_s, starts, at_loop }
    }

    /// d at `time_s`; before second 0 it is as at 0.
    pub fn at(&self, time_s: f64) -> [f64; N] {
        let (at, lag_s) = (self.pieces.find(time_s), self.lag_s);
        if lag_s == 0.0 {
            return self.pieces.value(at);
        }
        let start = self.starts[at.piece];
        let Some(piece) = self.pieces.pieces.get(at.piece) else {
            let left = libm::exp(-at.since_s / lag_s);
            return std::array::from_fn(|n| self.pieces.beyond[n] + (start[n] - self.pieces.beyond[n]) * left);
        };
        let followed = followed(start, piece, at.since_s, self.pieces.width_s(at.piece), lag_s);
        let Some(from) = self.pieces.loops_from.filter(|from| *from <= at.piece) else { return followed };
        // Where round n of the loop begins: aⁿ d₀ + (1 + a + … + aⁿ⁻¹) b.
        let period_s = self.pieces.end_s() - self.pieces.starts[from];
        let rounds = libm::expm1(-at.rounds * period_s / lag_s) / libm::expm1(-period_s / lag_s);
        let kept = libm::exp(-at.rounds * period_s / lag_s);
        let left = libm::exp(-(self.pieces.starts[at.piece] - self.pieces.starts[from] + at.since_s) / lag_s);
        let of_round = self.starts[self.starts.len() - 1];
        std::array::from_fn(|n| followed[n] + (kept * self.at_loop[n] + rounds * of_round[n]) * left)
    }
}

/// d after `since_s` seconds of a piece of `width_s` on which u is `piece`, if it was `start` where that began.
fn followed<const N: usize>(
    start: [f64; N],
    piece: &[[f64; POWERS]; N],
    since_s: f64,
    width_s: f64,
    lag_s: f64,
) -> [f64; N] {
    let (share, z) = (since_s / width_s, since_s / lag_s);
    let (left, moments) = (libm::exp(-z), moments(z));
    std::array::from_fn(|n| {
        let (mut sum, mut power_of_share) = (0.0, 1.0);
        for (power, moment) in piece[n].iter().zip(moments) {
            sum += power * moment * power_of_share;
            power_of_share *= share;
        }
        start[n] * left + sum
    })
}

/// G_0(z) to G_7(z).
fn moments(z: f64) -> [f64; POWERS] {
    let mut moments = [0.0; POWERS];
    if z > 10.0 {
        // By parts, from 1 − e^(−z) on: each step makes errors smaller where z is larger than k.
        moments[0] = -libm::expm1(-z);
        for k in 1..POWERS {
            moments[k] = 1.0 - k as f64 / z * moments[k - 1];
        }
        return moments;
    }
    // z e^(−z) Σ z^j / (j! (k + 1 + j)): positive terms alone.
    let mut term = z * libm::exp(-z);
    for j in 0..64 {
        for (k, moment) in moments.iter_mut().enumerate() {
            *moment += term / (k + 1 + j) as f64;
        }
        term *= z / (j + 1) as f64;
    }
    moments
}
