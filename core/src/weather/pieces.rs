//! A vector over time as polynomials, piece by piece, from second 0 on: what can be integrated in closed form.
//!
//! The wind is a product of a speed and of a direction's sine, which has no integral of its own for smooth keys. So
//! what is to be integrated is written, once and on the edit clock, as polynomials of degree 7 on pieces small enough to
//! be within a share of 10⁻¹¹ of it; from there on everything is exact. After the last piece it is constant, or goes through
//! the pieces of its period again.

/// One more than the polynomials' degree.
pub(super) const POWERS: usize = 8;
/// How far a piece may be off, as a share of the largest value.
const TOLERANCE: f64 = 1e-11;
/// More than these are never made; what is left then is as near as it comes.
const MOST_PIECES: usize = 40_000;

/// Coefficients of one piece, of the powers of the share that is over.
pub type Polynomials<const N: usize> = [[f64; POWERS]; N];

/// Vectors of `N` numbers over time.
#[derive(Debug, Clone)]
pub struct Pieces<const N: usize> {
    /// Where each piece begins, and where the last one ends; seconds, from 0.
    pub starts: Vec<f64>,
    pub pieces: Vec<Polynomials<N>>,
    /// The pieces from this one on come again and again; none: what follows the last is constant.
    pub loops_from: Option<usize>,
    /// What it is after the last piece, if that is constant.
    pub beyond: [f64; N],
}

/// Where in the pieces a time lies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct At {
    /// The piece; one more than there are for the constant after the last.
    pub piece: usize,
    /// Seconds since the piece began.
    pub since_s: f64,
    /// How often the loop is over.
    pub rounds: f64,
}

impl<const N: usize> Pieces<N> {
    /// `f` from 0 to the last of `breaks`, which rise from 0 and between which `f` is smooth. If it loops, it does from
    /// `loops_from_s`, one of the breaks, to the last.
    pub fn fit(f: impl Fn(f64) -> [f64; N], breaks: &[f64], loops_from_s: Option<f64>) -> Self {
        let mut fitted = Self { starts: vec![0.0], pieces: Vec::new(), loops_from: None, beyond: [0.0; N] };
        let scale = scale(&f, breaks);
        for pair in breaks.windows(2) {
            if loops_from_s == Some(pair[0]) {
                fitted.loops_from = Some(fitted.pieces.len());
            }
            fitted.add(&f, [pair[0], pair[1]], &scale, 0);
        }
        fitted.beyond = f(breaks.last().copied().unwrap_or(0.0));
        fitted
    }

    fn add(&mut self, f: &impl Fn(f64) -> [f64; N], [from_s, to_s]: [f64; 2], scale: &[f64; N], depth: u32) {
        const DEEPEST: u32 = 20;
        let piece = interpolated(|share| f(from_s + share * (to_s - from_s)));
        let is_near = || {
            (0..=POWERS).all(|i| {
                let share = (i as f64 + 0.25) / (POWERS as f64 + 0.5);
                let exact = f(from_s + share * (to_s - from_s));
                (0..N).all(|n| (value(&piece[n], share) - exact[n]).abs() <= TOLERANCE * scale[n])
            })
        };
        let middle_s = 0.5 * (from_s + to_s);
        if depth >= DEEPEST || self.pieces.len() >= MOST_PIECES || middle_s <= from_s || middle_s >= to_s || is_near() {
            self.pieces.push(piece);
            self.starts.push(to_s);
        } else {
            self.add(f, [from_s, middle_s], scale, depth + 1);
            self.add(f, [middle_s, to_s], scale, depth + 1);
        }
    }

    /// Where `time_s` lies; what is before 0 is at 0.
    pub fn find(&self, time_s: f64) -> At {
        let mut time_s = if time_s > 0.0 { time_s } else { 0.0 };
        let (end_s, mut rounds) = (self.end_s(), 0.0);
        if time_s >= end_s
            && let Some(from) = self.loops_from
        {
            let (from_s, period) = (self.starts[from], end_s - self.starts[from]);
            rounds = libm::floor((time_s - from_s) / period);
            time_s = (time_s - rounds * period).clamp(from_s, end_s);
            if time_s >= end_s {
                (time_s, rounds) = (from_s, rounds + 1.0);
            }
        }
        let piece = self.starts.partition_point(|start| *start <= time_s).saturating_sub(1);
        At { piece, since_s: time_s - self.starts[piece], rounds }
    }

    pub fn end_s(&self) -> f64 {
        self.starts.last().copied().unwrap_or(0.0)
    }

    pub fn width_s(&self, piece: usize) -> f64 {
        self.starts[piece + 1] - self.starts[piece]
    }

    /// The value there.
    pub fn value(&self, at: At) -> [f64; N] {
        match self.pieces.get(at.piece) {
            Some(piece) => std::array::from_fn(|n| value(&piece[n], at.since_s / self.width_s(at.piece))),
            None => self.beyond,
        }
    }
}

fn value(powers: &[f64; POWERS], share: f64) -> f64 {
    powers.iter().rev().fold(0.0, |sum, power| sum * share + power)
}

/// The largest values to be met, by a look at each stretch.
fn scale<const N: usize>(f: &impl Fn(f64) -> [f64; N], breaks: &[f64]) -> [f64; N] {
    let mut largest = [1e-30_f64; N];
    for pair in breaks.windows(2) {
        for i in 0..8 {
            let values = f(pair[0] + (pair[1] - pair[0]) * (f64::from(i) + 0.5) / 8.0);
            largest = std::array::from_fn(|n| largest[n].max(values[n].abs()));
        }
    }
    largest
}

/// The polynomial through `f` at Chebyshev's nodes on [0, 1], by Newton's divided differences.
fn interpolated<const N: usize>(f: impl Fn(f64) -> [f64; N]) -> Polynomials<N> {
    let nodes: [f64; POWERS] =
        std::array::from_fn(|i| 0.5 - 0.5 * libm::cos(std::f64::consts::PI * (i as f64 + 0.5) / POWERS as f64));
    let values = nodes.map(f);
    std::array::from_fn(|n| {
        let mut differences = values.map(|value| value[n]);
        for order in 1..POWERS {
            for i in (order..POWERS).rev() {
                differences[i] = (differences[i] - differences[i - 1]) / (nodes[i] - nodes[i - order]);
            }
        }
        // Horner's rule on the Newton form, as powers.
        let mut powers = [0.0; POWERS];
        for i in (0..POWERS).rev() {
            for k in (1..POWERS).rev() {
                powers[k] = powers[k - 1] - nodes[i] * powers[k];
            }
            powers[0] = differences[i] - nodes[i] * powers[0];
        }
        powers
    })
}
