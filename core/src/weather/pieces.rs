//! A vector over time as polynomials, piece by piece, from second 0 on: what can be integrated in closed form.
//!
//! The wind is a product of a speed and of a direction's sine, which has no integral of its own for smooth keys. So
//! what is to be integrated is written, once and on the edit clock, as polynomials of degree 7 on pieces small enough to
//! be within a share of 10⁻¹¹ of it; from there on everything is exact. After the last piece it is constant, or goes through
//! the pieces of its period again. What swings too quickly to be fitted is a blur: its mean.

/// One more than the polynomials' degree.
pub(super) const POWERS: usize = 8;
/// How far a piece may be off, as a share of the largest value.
const TOLERANCE: f64 = 1e-11;
/// What is off by less, and no less on half of the stretch, is off by the rounding of times and angles: far from second 0
/// seconds have fewer digits. Where a slope breaks within a stretch, halves that are as far off may be taken for that;
/// they are short then, for it is off by the product of their width and the slope's step.
const ROUNDED: f64 = 1e-7;
/// What is off by more is a blur.
const BLURRED: f64 = 1e-5;
/// Beside one for each stretch, no more than these are made.
const MOST_PIECES: usize = 40_000;
/// The furthest time, seconds: some 30,000 years.
const FURTHEST_S: f64 = 1e12;

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
        let stretches = breaks.len().saturating_sub(1);
        let mut fitting = Fitting { f, nodes: Nodes::new(), scale: 0.0, made: Vec::new(), end: 0 };
        fitting.scale = fitting.largest(breaks);
        let (mut starts, mut loops_from) = (vec![0.0], None);
        // None takes what others may need.
        let share = (MOST_PIECES / stretches.max(1)).max(256);
        for pair in breaks.windows(2) {
            if loops_from_s == Some(pair[0]) {
                loops_from = Some(fitting.made.len());
            }
            let most = MOST_PIECES + stretches;
            fitting.end = most.min(fitting.made.len() + share);
            fitting.add([pair[0], pair[1]], f64::INFINITY, 0);
        }
        let beyond = (fitting.f)(breaks.last().copied().unwrap_or(0.0));
        starts.extend(fitting.made.iter().map(|(to_s, _)| *to_s));
        let pieces = fitting.made.into_iter().map(|(_, piece)| piece).collect();
        Self { starts, pieces, loops_from, beyond }
    }

    /// Where `time_s` lies; what is before 0, or no number, is at 0, and what is beyond all time is at its end.
    pub fn find(&self, time_s: f64) -> At {
        let mut time_s = if time_s > 0.0 { time_s.min(FURTHEST_S) } else { 0.0 };
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

/// Pieces in the making.
struct Fitting<F, const N: usize> {
    f: F,
    nodes: Nodes,
    /// The largest value to be met.
    scale: f64,
    /// Where each ends, and what it is.
    made: Vec<(f64, Polynomials<N>)>,
    /// Once there are so many, none is halved.
    end: usize,
}

impl<F: Fn(f64) -> [f64; N], const N: usize> Fitting<F, N> {
    /// By a look at each stretch.
    fn largest(&self, breaks: &[f64]) -> f64 {
        let mut largest = 1e-30_f64;
        for pair in breaks.windows(2) {
            for i in 0..8 {
                let values = (self.f)(pair[0] + (pair[1] - pair[0]) * (f64::from(i) + 0.5) / 8.0);
                largest = values.iter().fold(largest, |largest, value| largest.max(value.abs()));
            }
        }
        largest
    }

    /// `whole_off`: how far the stretch was off of which this is half.
    fn add(&mut self, [from_s, to_s]: [f64; 2], whole_off: f64, depth: u32) {
        const DEEPEST: u32 = 20;
        let at = |share: f64| (self.f)(from_s + share * (to_s - from_s));
        let values = self.nodes.at.map(at);
        let mut piece: Polynomials<N> = std::array::from_fn(|n| self.nodes.through(values.map(|values| values[n])));
        let mut off = 0.0_f64;
        for i in 0..=POWERS {
            let share = (i as f64 + 0.25) / (POWERS as f64 + 0.5);
            let exact = at(share);
            off = (0..N).fold(off, |off, n| off.max((value(&piece[n], share) - exact[n]).abs() / self.scale));
        }
        let is_rounding = off <= ROUNDED && off > 0.6 * whole_off;
        let middle_s = 0.5 * (from_s + to_s);
        let may_be_halved = depth < DEEPEST && self.made.len() < self.end && middle_s > from_s && middle_s < to_s;
        if off > TOLERANCE && !is_rounding && may_be_halved {
            self.add([from_s, middle_s], off, depth + 1);
            self.add([middle_s, to_s], off, depth + 1);
            return;
        }
        if off > BLURRED {
            // A polynomial through what it does not follow overshoots; a mean stays among the values.
            piece = std::array::from_fn(|n| {
                let mut constant = [0.0; POWERS];
                constant[0] = values.iter().zip(self.nodes.weights).map(|(values, weight)| values[n] * weight).sum();
                constant
            });
        }
        self.made.push((to_s, piece));
    }
}

/// Chebyshev's nodes on [0, 1].
struct Nodes {
    at: [f64; POWERS],
    /// Fejér's weights of a mean: all above 0, and together 1.
    weights: [f64; POWERS],
}

impl Nodes {
    fn new() -> Self {
        let angle = |i: usize| std::f64::consts::PI * (i as f64 + 0.5) / POWERS as f64;
        let weight = |i: usize| {
            let term = |j: usize| libm::cos(2.0 * j as f64 * angle(i)) / (4 * j * j - 1) as f64;
            (1.0 - 2.0 * (1..=POWERS / 2).map(term).sum::<f64>()) / POWERS as f64
        };
        Self { at: std::array::from_fn(|i| 0.5 - 0.5 * libm::cos(angle(i))), weights: std::array::from_fn(weight) }
    }

    /// The polynomial through `values` there, by Newton's divided differences.
    fn through(&self, values: [f64; POWERS]) -> [f64; POWERS] {
        let (nodes, mut differences) = (&self.at, values);
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
    }
}
