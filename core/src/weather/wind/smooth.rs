//! When several curves together are smooth, and when they begin anew: what pieces are fitted between.
//!
//! Curves that repeat begin anew together after a common period, if they have one that is not too long. Those that have
//! none go on for many rounds, up to where they miss each other by least, and are begun anew there: a jump of the wind to
//! where it would have been within a small part of a period, long after all keys are over.

use crate::weather::Curve;

/// Of how many values a curve is the mean where it is a blur.
const PHASES: usize = 32;

/// Between which times `N` curves are smooth.
#[derive(Debug)]
pub(super) struct Smooth<'a, const N: usize> {
    curves: [&'a Curve; N],
    /// In order, from second 0 to where all hold, or all begin anew.
    pub(super) breaks: Vec<f64>,
    /// From where to the last break they go on and on, if they do.
    pub(super) loops_from_s: Option<f64>,
    /// Of each curve, when it comes round too often for its keys to be breaks.
    blurs: [Vec<[f64; 2]>; N],
    /// Of each curve that ever is a blur, its values over a period.
    phases: [Vec<f64>; N],
}

impl<'a, const N: usize> Smooth<'a, N> {
    pub(super) fn of(curves: [&'a Curve; N]) -> Self {
        let end_s = curves.iter().map(|curve| curve.ends_s()[1]).fold(0.0, f64::max);
        let common_s = common_period_s(&curves);
        let last_s = end_s + common_s.unwrap_or(0.0);
        let mut breaks = vec![0.0, end_s, last_s];
        let blurs = curves.map(|curve| {
            let mut blurs = curve.breaks_s([0.0, end_s], &mut breaks);
            blurs.extend(curve.breaks_s([end_s, last_s], &mut breaks));
            breaks.extend(blurs.iter().flatten());
            blurs
        });
        breaks.sort_by(f64::total_cmp);
        breaks.dedup();
        let phases = std::array::from_fn(|i| if blurs[i].is_empty() { Vec::new() } else { phases(curves[i], i) });
        Self { curves, breaks, loops_from_s: common_s.map(|_| end_s), blurs, phases }
    }

    /// What `f` makes of the curves' values at `time_s`. Where a curve is a blur, that is the mean over its period.
    pub(super) fn at<const M: usize>(&self, time_s: f64, f: impl Fn([f64; N]) -> [f64; M]) -> [f64; M] {
        let is_in = |[from, to]: &[f64; 2]| (*from..*to).contains(&time_s);
        let blurred = self.blurs.each_ref().map(|blurs| blurs.iter().any(is_in));
        let values: [f64; N] = std::array::from_fn(|i| if blurred[i] { 0.0 } else { self.curves[i].at(time_s, 0) });
        if !blurred.contains(&true) {
            return f(values);
        }
        let mut sum = [0.0; M];
        for phase in 0..PHASES {
            let some = f(std::array::from_fn(|i| if blurred[i] { self.phases[i][phase] } else { values[i] }));
            sum = std::array::from_fn(|m| sum[m] + some[m] / PHASES as f64);
        }
        sum
    }
}

/// The values of `curve`, the `i`th, over its period, in another order than those of others: what it is has nothing to do
/// with what they are.
fn phases(curve: &Curve, i: usize) -> Vec<f64> {
    // Odd ones go through all phases once.
    const STRIDES: [usize; 3] = [1, 13, 21];
    let [first, last] = curve.ends_s();
    let phase = |k: usize| ((k * STRIDES[i % 3]) % PHASES) as f64 + 0.5;
    // What swings has all its values on the way there.
    (0..PHASES).map(|k| curve.at(first + (last - first) * phase(k) / PHASES as f64, 0)).collect()
}

/// After what time all `curves` begin anew, at least about; none if all hold.
fn common_period_s(curves: &[&Curve]) -> Option<f64> {
    let periods_s: Vec<f64> = curves.iter().filter_map(|curve| curve.period_s()).collect();
    let longest = periods_s.iter().copied().reduce(f64::max)?;
    // So many that none is a blur on the way.
    let rounds = curves.iter().filter(|curve| curve.period_s().is_some()).map(|curve| {
        let [first, last] = curve.ends_s();
        libm::floor((curve.most_rounds() - 2.0) * (last - first) / longest)
    });
    let most = rounds.fold(f64::from(u16::MAX), f64::min).max(1.0) as u32;
    let missed = |times: u32| {
        let misses = periods_s.iter().map(|period| {
            let rounds = longest * f64::from(times) / period;
            let off = (rounds - libm::round(rounds)).abs();
            // Of times that were rounded when they were written down.
            if off < 1e-12 * rounds { 0.0 } else { off }
        });
        misses.fold(0.0, f64::max)
    };
    if let Some(times) = (1..=most).find(|times| missed(*times) == 0.0) {
        return Some(longest * f64::from(times));
    }
    // The later it begins anew, the better; but all on the way is fitted again at each step of a drag of a key.
    let most = (most / 5).max(1);
    let best = (most.div_ceil(2)..=most).min_by(|a, b| missed(*a).total_cmp(&missed(*b)));
    Some(longest * f64::from(best.unwrap_or(1)))
}
