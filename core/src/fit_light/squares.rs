//! Least squares for a light's pictures: unknowns that are not negative, at each self-shadow, from sums over pixels.
//!
//! A picture is (1 − s)·(C⁰ + Σ xⱼ·Pⱼ⁰) + s·(C¹ + Σ xⱼ·Pⱼ¹), with s the self-shadow and x the unknowns. So the squares of
//! what it differs from a wanted one are known for all s and x from the products of C⁰, P⁰, C¹, P¹ and the wanted one, each
//! summed over the pixels: no picture is drawn while s and x are sought.

/// Sums over pixels of products of what a light's picture is made of.
#[derive(Debug, Clone)]
pub(super) struct Squares {
    unknowns: usize,
    /// Row by row: of C⁰, P⁰, C¹, P¹ and what is wanted.
    products: Vec<f64>,
}

/// Unknowns, and the weighted sum of squares that they leave.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Solution {
    pub(super) unknowns: Vec<f64>,
    pub(super) rest: f64,
}

/// How much an unknown is drawn to what it was, against the mean of what the unknowns show: it decides where pictures say
/// nothing, and hardly elsewhere.
const INERTIA: f64 = 3e-3;
/// Rounds after which the unknowns are as good as found.
const ROUNDS: u32 = 10_000;
/// Of a round in which nothing changes any more.
const STILL: f64 = 1e-9;

impl Squares {
    pub(super) fn new(unknowns: usize) -> Self {
        let width = 2 * (unknowns + 1) + 1;
        Self { unknowns, products: vec![0.0; width * width] }
    }

    fn width(&self) -> usize {
        2 * (self.unknowns + 1) + 1
    }

    /// A pixel: C⁰, P⁰, C¹, P¹ and what is wanted there.
    pub(super) fn add(&mut self, pixel: &[f64], weight: f64) {
        let width = self.width();
        for (row, a) in pixel.iter().enumerate() {
            for (column, b) in pixel.iter().enumerate() {
                self.products[row * width + column] += weight * a * b;
            }
        }
    }

    /// The pixels of `other` too, which has as many unknowns.
    pub(super) fn join(&mut self, other: &Self) {
        self.products.iter_mut().zip(&other.products).for_each(|(sum, more)| *sum += more);
    }

    /// The unknowns at that self-shadow that leave least, and are near `before` where that makes no difference.
    pub(super) fn solve(&self, self_shadow: f64, before: &[f64]) -> Solution {
        let count = self.unknowns;
        let product = |a: usize, b: usize| self.mixed(self_shadow, a, b);
        // Place 0 is C, the unknowns' pictures follow, then what is wanted.
        let wanted = count + 1;
        let inertia = INERTIA * (1..=count).map(|at| product(at, at)).sum::<f64>() / count.max(1) as f64;
        let of = |row: usize, column: usize| product(row + 1, column + 1) + if row == column { inertia } else { 0.0 };
        let matrix: Vec<Vec<f64>> = (0..count).map(|row| (0..count).map(|column| of(row, column)).collect()).collect();
        let right: Vec<f64> =
            (0..count).map(|at| product(at + 1, wanted) - product(at + 1, 0) + inertia * before[at]).collect();
        let unknowns = not_negative(&matrix, &right, before);
        let parts: Vec<f64> = [1.0].into_iter().chain(unknowns.iter().copied()).chain([-1.0]).collect();
        let mut rest = 0.0;
        for (row, a) in parts.iter().enumerate() {
            for (column, b) in parts.iter().enumerate() {
                rest += a * b * product(row, column);
            }
        }
        for (now, before) in unknowns.iter().zip(before) {
            rest += inertia * (now - before) * (now - before);
        }
        Solution { unknowns, rest }
    }

    /// The product of two parts at a self-shadow: 0 is C, then come the P, then what is wanted.
    fn mixed(&self, self_shadow: f64, a: usize, b: usize) -> f64 {
        let half = self.unknowns + 1;
        let places = |part: usize| {
            if part == half {
                [(2 * half, 1.0), (0, 0.0)]
            } else {
                [(part, 1.0 - self_shadow), (part + half, self_shadow)]
            }
        };
        let mut sum = 0.0;
        for (row, share) in places(a) {
            for (column, other) in places(b) {
                sum += share * other * self.products[row * self.width() + column];
            }
        }
        sum
    }
}

/// The x ≥ 0 for which x·matrix·x − 2·right·x is least: one unknown after the other, until none changes (Gauss and Seidel's
/// way; the matrix is symmetric, and positive by its inertia).
fn not_negative(matrix: &[Vec<f64>], right: &[f64], start: &[f64]) -> Vec<f64> {
    let mut unknowns: Vec<f64> = start.iter().map(|value| value.max(0.0)).collect();
    for _ in 0..ROUNDS {
        let mut largest = 0.0_f64;
        for (at, row) in matrix.iter().enumerate() {
            if row[at] <= 0.0 {
                // It shows nowhere.
                continue;
            }
            let others: f64 = row.iter().zip(&unknowns).map(|(a, b)| a * b).sum::<f64>() - row[at] * unknowns[at];
            let new = ((right[at] - others) / row[at]).max(0.0);
            largest = largest.max((new - unknowns[at]).abs());
            unknowns[at] = new;
        }
        if largest < STILL {
            break;
        }
    }
    unknowns
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::random::{draw, unit};

    /// Pictures of dice, and a wanted one that is made of them: what it was made of is found again.
    fn made_of(unknowns: &[f64], self_shadow: f64) -> Squares {
        let mut squares = Squares::new(unknowns.len());
        for pixel in 0..200 {
            let half = unknowns.len() + 1;
            let dice = |at: usize| unit(draw(5, at as u64, pixel, 0)[0]);
            let mut parts: Vec<f64> = (0..2 * half).map(dice).collect();
            let side =
                |from: usize| parts[from] + (0..half - 1).map(|j| unknowns[j] * parts[from + 1 + j]).sum::<f64>();
            let wanted = (1.0 - self_shadow) * side(0) + self_shadow * side(half);
            parts.push(wanted);
            squares.add(&parts, 1.0);
        }
        squares
    }

    #[test]
    fn what_a_picture_was_made_of_is_found_again() {
        let made = [0.4, 0.0, 1.3];
        let squares = made_of(&made, 0.3);
        // Where it begins is what it was made of, so that inertia does not draw it away.
        let Solution { unknowns, rest } = squares.solve(0.3, &made);
        assert!(unknowns.iter().zip(made).all(|(got, want)| (got - want).abs() < 1e-6), "{unknowns:?}");
        assert!(rest.abs() < 1e-6, "{rest}");
        for other in [0.2, 0.4] {
            assert!(squares.solve(other, &made).rest > 1e-3, "another self-shadow leaves more");
        }
        let drawn = squares.solve(0.3, &[5.0; 3]).unknowns;
        // Inertia is 3 thousandths of what an unknown shows, less what others show too: a few hundredths of the way from 5.
        assert!(drawn.iter().zip(made).all(|(got, want)| (got - want).abs() < 0.3), "{drawn:?}");
    }

    /// Of one unknown, C and P alike: least squares want −1, so 0 it is.
    #[test]
    fn no_unknown_is_negative() {
        let mut squares = Squares::new(1);
        squares.add(&[1.0, 1.0, 1.0, 1.0, 0.0], 2.0);
        let solution = squares.solve(0.5, &[0.0]);
        assert_eq!(solution.unknowns, [0.0]);
        assert!((solution.rest - 2.0).abs() < 1e-12);
    }

    #[test]
    fn what_shows_nowhere_stays_as_it_was() {
        let mut squares = Squares::new(2);
        squares.add(&[0.0, 1.0, 0.0, 0.0, 1.0, 0.0, 0.5], 1.0);
        let solution = squares.solve(0.0, &[0.5, 0.7]);
        assert!((solution.unknowns[0] - 0.5).abs() < 1e-9 && (solution.unknowns[1] - 0.7).abs() < 1e-9);
    }
}
