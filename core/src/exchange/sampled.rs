//! Keys for what moves along a curve, as few as keep straight lines between them near it.

/// No two keys are nearer, seconds: what jumps needs no nearer ones.
const NEAREST_S: f64 = 1e-3;
/// Of one curve.
const MOST_KEYS: usize = 20_000;
/// Where between two keys the line is compared with the curve.
const LOOKS: [f64; 3] = [0.25, 0.5, 0.75];

/// Times and values between the first and last of `times_s`, which all become keys. Between neighbours, a quarter, half
/// and three quarters of the way, `between` is as `of` within what `near` allows.
///
/// More than [`MOST_KEYS`] are not made: the curve is then as near as those take it.
pub(in crate::exchange) fn sampled<T: Copy>(
    times_s: &[f64],
    of: impl Fn(f64) -> T,
    between: impl Fn(T, T, f64) -> T,
    near: impl Fn(T, T) -> bool,
) -> Vec<(f64, T)> {
    let mut keys: Vec<(f64, T)> = Vec::new();
    let mut open: Vec<(f64, T)> = times_s.iter().rev().map(|time| (*time, of(*time))).collect();
    keys.extend(open.pop());
    // The nearest of what is open is the next key, or there is one between.
    while let (Some(&(from_s, from)), Some(&(to_s, to))) = (keys.last(), open.last()) {
        let is_near = |share: f64| near(between(from, to, share), of(from_s + (to_s - from_s) * share));
        let full = keys.len() + open.len() >= MOST_KEYS;
        if full || to_s - from_s < 2.0 * NEAREST_S || LOOKS.into_iter().all(is_near) {
            keys.extend(open.pop());
        } else {
            let middle_s = from_s.midpoint(to_s);
            open.push((middle_s, of(middle_s)));
        }
    }
    keys
}

#[cfg(test)]
mod tests {
    use super::*;

    fn keys(end_s: f64, of: fn(f64) -> f64, error: f64) -> Vec<(f64, f64)> {
        sampled(&[0.0, end_s], of, |a, b, share| a + (b - a) * share, |a, b| (a - b).abs() <= error)
    }

    #[test]
    fn straight_lines_need_their_ends_alone() {
        assert_eq!(keys(8.0, |t| 3.0 * t - 1.0, 1e-9), [(0.0, -1.0), (8.0, 23.0)]);
    }

    #[test]
    fn bends_are_met_within_the_tolerance() {
        let error = 1e-3;
        let keys = keys(10.0, f64::sin, error);
        assert!((20..400).contains(&keys.len()), "{}", keys.len());
        // A parabola's line is farthest from it in the middle, where it was looked at; a sine is nearly one there.
        for pair in keys.windows(2) {
            for step in 0..=20 {
                let share = f64::from(step) / 20.0;
                let time = pair[0].0 + (pair[1].0 - pair[0].0) * share;
                let line = pair[0].1 + (pair[1].1 - pair[0].1) * share;
                assert!((line - time.sin()).abs() < 1.05 * error, "at {time}");
            }
        }
    }

    #[test]
    fn jumps_end() {
        let keys = keys(10.0, |t| if t < 3.3 { 0.0 } else { 1000.0 }, 1e-3);
        assert!(keys.len() < 60, "{}", keys.len());
        assert!(keys.windows(2).all(|pair| pair[0].0 < pair[1].0));
    }
}
