//! A smooth curve through values at given times that never overshoots them.
//!
//! Between two knots runs a cubic Hermite polynomial. Fritsch and Carlson (*Monotone piecewise cubic interpolation*,
//! SIAM Journal on Numerical Analysis 17, 1980) show that it stays within the two values if the slopes at its ends have
//! the chord's sign and at most three times its size. Fritsch and Butland (*A method for constructing local monotone
//! piecewise cubic interpolants*, SIAM Journal on Scientific and Statistical Computing 5, 1984) choose such slopes from the two neighbouring chords alone: their
//! weighted harmonic mean, 0 where they differ in sign.

/// The curve's first derivative at each of `times` (rising, at least two), in which it has the `values`.
pub(super) fn slopes(times: &[f64], values: &[f64]) -> Vec<f64> {
    let (steps, chords): (Vec<f64>, Vec<f64>) = times
        .windows(2)
        .zip(values.windows(2))
        .map(|(t, v)| {
            let step = t[1] - t[0];
            (step, (v[1] - v[0]) / step)
        })
        .unzip();
    let mut slopes: Vec<f64> =
        steps.windows(2).zip(chords.windows(2)).map(|(step, chord)| between(step, chord)).collect();
    let last = chords.len() - 1;
    let beyond = last.saturating_sub(1);
    slopes.insert(0, at_end([steps[0], steps[1.min(last)]], [chords[0], chords[1.min(last)]]));
    slopes.push(at_end([steps[last], steps[beyond]], [chords[last], chords[beyond]]));
    slopes
}

/// Where the chords `before` and `after` meet.
fn between(step: &[f64], chord: &[f64]) -> f64 {
    let ([before, after], [step_before, step_after]) = ([chord[0], chord[1]], [step[0], step[1]]);
    if before * after <= 0.0 {
        return 0.0;
    }
    let (of_before, of_after) = (step_before + 2.0 * step_after, 2.0 * step_before + step_after);
    (of_before + of_after) / (of_before / before + of_after / after)
}

/// At an end, from the chord there and the next one: the slope of the parabola through the three knots, held within
/// what Fritsch and Carlson allow.
fn at_end([step, next_step]: [f64; 2], [chord, next_chord]: [f64; 2]) -> f64 {
    let slope = ((2.0 * step + next_step) * chord - step * next_chord) / (step + next_step);
    let most = 3.0 * chord.abs();
    if slope * chord <= 0.0 { 0.0 } else { slope.max(-most).min(most) }
}

/// A piece between two knots: values and slopes at its ends, and how long it is.
#[derive(Clone, Copy)]
pub(super) struct Piece {
    pub(super) values: [f64; 2],
    pub(super) slopes: [f64; 2],
    pub(super) length: f64,
}

impl Piece {
    /// The value at the share `u` of its length, 0 to 1.
    pub(super) fn at(self, u: f64) -> f64 {
        let Self { values: [from, to], slopes: [leaving, arriving], length } = self;
        let v = 1.0 - u;
        let value = (1.0 + 2.0 * u) * v * v * from
            + u * u * (3.0 - 2.0 * u) * to
            + u * v * length * (v * leaving - u * arriving);
        // It lies between them but for rounding.
        value.max(from.min(to)).min(from.max(to))
    }

    /// The derivative there.
    pub(super) fn slope_at(self, u: f64) -> f64 {
        let Self { values: [from, to], slopes: [leaving, arriving], length } = self;
        let v = 1.0 - u;
        6.0 * u * v * (to - from) / length + v * (1.0 - 3.0 * u) * leaving + u * (3.0 * u - 2.0) * arriving
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn slopes_of_known_curves() {
        for (times, values, want) in [
            (vec![0.0, 2.0], vec![1.0, 5.0], vec![2.0, 2.0]),
            (vec![0.0, 1.0, 3.0], vec![0.0, 1.0, 3.0], vec![1.0, 1.0, 1.0]),
            // A peak is flat on top.
            (vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 0.0], vec![2.0, 0.0, -2.0]),
            // Equal steps: the harmonic mean, 2·1·3/(1 + 3); the parabola's slopes 0 and 4 at the ends.
            (vec![0.0, 1.0, 2.0], vec![0.0, 1.0, 4.0], vec![0.0, 1.5, 4.0]),
            // Beyond three chords there would be an overshoot: (3·1 − 1·(−9))/2 = 6 is held at 3.
            (vec![0.0, 1.0, 2.0], vec![0.0, 1.0, -8.0], vec![3.0, 0.0, -14.0]),
        ] {
            let got = slopes(&times, &values);
            assert!(got.iter().zip(&want).all(|(got, want)| (got - want).abs() < 1e-12), "{got:?} for {want:?}");
        }
    }

    #[test]
    fn the_slope_is_the_values_derivative() {
        let piece = Piece { values: [1.0, 4.0], slopes: [0.5, 6.0], length: 2.0 };
        for i in 1..100 {
            let (u, step) = (f64::from(i) / 100.0, 1e-5);
            let difference = (piece.at(u + step) - piece.at(u - step)) / (2.0 * step * piece.length);
            // A cubic's central difference is off by its third derivative · step²/6.
            assert!((piece.slope_at(u) - difference).abs() < 1e-8, "{u}");
        }
        assert_eq!((piece.slope_at(0.0), piece.slope_at(1.0)), (0.5, 6.0));
    }
}
