//! Which methods no other one beats: the Pareto front, and what can be read off it.
//!
//! A method is on the front if none is at most as dear and at most as wrong, and better in one of the two. Methods with
//! the same two figures stay on it together; one without figures is never on it. The idea is Vilfredo Pareto's (1896).

use super::report::{MethodFigures, Report};

/// Costs within this factor are one cost: medians of wall times are no steadier.
const SAME_COST: f64 = 1.1;
/// Mean FLIP that no one would see: less is no better.
const UNSEEN_ERROR: f64 = 0.001;

/// Of points (cost, error), less being better in both; none for what was not measured.
pub fn front(points: &[Option<[f64; 2]>]) -> Vec<bool> {
    let known = |point: &Option<[f64; 2]>| point.filter(|[cost, error]| cost.is_finite() && error.is_finite());
    let mut by_cost: Vec<(usize, [f64; 2])> =
        points.iter().enumerate().filter_map(|(i, point)| Some((i, known(point)?))).collect();
    // Adding 0 makes −0 an equal of 0 for the total order too.
    let key = |[cost, error]: [f64; 2]| [cost + 0.0, error + 0.0];
    by_cost.sort_by(|(_, a), (_, b)| {
        let ([a_cost, a_error], [b_cost, b_error]) = (key(*a), key(*b));
        a_cost.total_cmp(&b_cost).then(a_error.total_cmp(&b_error))
    });
    let mut on_front = vec![false; points.len()];
    let mut last = [f64::NEG_INFINITY, f64::INFINITY];
    for (i, point) in by_cost {
        if point[1] < last[1] {
            last = point;
        }
        on_front[i] = point == last;
    }
    on_front
}

impl Report {
    /// Sets [`MethodFigures::on_front`] by frame time and mean FLIP.
    pub fn mark_front(&mut self) {
        let points: Vec<_> = self.methods.iter().map(MethodFigures::choice).collect();
        for (method, on_front) in self.methods.iter_mut().zip(front(&points)) {
            method.on_front = on_front;
        }
    }
}

/// The corners of the front as a stepped line, from `top`, where errors end, to `right`, where costs do; of `best`, the
/// places on a sheet of what is on the front. A method is as wrong as it is until the next one's cost is paid.
pub fn outline(mut best: Vec<[f64; 2]>, top: f64, right: f64) -> Vec<[f64; 2]> {
    best.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let Some(first) = best.first() else { return best };
    let mut corners = vec![[first[0], top]];
    for point in &best {
        let last = corners[corners.len() - 1];
        corners.extend([[point[0], last[1]], *point]);
    }
    corners.push([right, corners[corners.len() - 1][1]]);
    corners.dedup();
    corners
}

/// The cheapest method that one can choose whose mean FLIP is at most `tolerance`; the truer of two that cost the same.
pub fn cheapest_within(methods: &[MethodFigures], tolerance: f64) -> Option<&MethodFigures> {
    let within = methods.iter().filter_map(|method| {
        let [cost, error] = method.choice()?;
        (error <= tolerance).then_some((method, [cost, error]))
    });
    within.min_by(|(_, a), (_, b)| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1]))).map(|(method, _)| method)
}

/// How a method is beaten by another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Beaten {
    /// Place of the better one.
    pub by: usize,
    /// In what the better one is better.
    pub gain: Gain,
    /// How many times; at least 1, infinite if the better one has no error or no cost at all.
    pub factor: f64,
}

/// What is gained by taking a better method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Gain {
    /// It is as quick, and its error is smaller.
    Truth,
    /// It is as true, and its cost is smaller.
    Speed,
}

/// By which of `points` the one at `index` is beaten most; none if by none, or if it has no figures.
pub fn beaten(points: &[Option<[f64; 2]>], index: usize) -> Option<Beaten> {
    let [cost, error] = (*points.get(index)?)?;
    let seen = |error: f64| error.max(UNSEEN_ERROR);
    let ratio = |ours: f64, theirs: f64| if theirs > 0.0 { ours / theirs } else { f64::INFINITY };
    let mut worst: Option<Beaten> = None;
    for (by, [other_cost, other_error]) in points.iter().enumerate().filter_map(|(by, point)| Some((by, (*point)?))) {
        let (truer, quicker) = (seen(other_error) < seen(error), other_cost < cost);
        let gains = [
            (truer && other_cost <= cost * SAME_COST, Gain::Truth, ratio(error, seen(other_error))),
            (quicker && seen(other_error) <= seen(error), Gain::Speed, ratio(cost, other_cost)),
        ];
        for (_, gain, factor) in gains.into_iter().filter(|(holds, ..)| *holds) {
            if worst.is_none_or(|worst| factor > worst.factor) {
                worst = Some(Beaten { by, gain, factor });
            }
        }
    }
    worst
}
