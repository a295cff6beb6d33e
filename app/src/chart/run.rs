//! Measuring: the errors of all methods, stop by stop, then their times, round by round.
//!
//! Errors don't depend on the machine; they are measured once, and what an earlier run measured is kept. Times do: they
//! are taken of all methods in turn, the first round not counted, so that a slow minute hits all alike, and medians
//! count. If one is missing, all are taken anew. The truth is timed as it is drawn for the errors, once at each stop.

use super::charted::{Charted, Drawing, Times};
use super::frame_figures::mean;
use super::pictures::Pictures;
use super::report::{Cost, Figure, FrameCounts, FrameFigures, LeftOut, MethodFigures, Report};
use super::subject::Subject;
use crate::renderer::RenderError;
use cloudwright_core::image::Picture;
use cloudwright_core::method::Family;
use cloudwright_core::rules::Rasterizer;

/// Of the stops along a path, so many at most are timed.
const TIMED: usize = 3;
/// How long the truth draws, in frames of another method: for the progress only.
const TRUTH_WEIGHT: usize = 30;
/// A stop along a path is two frames of another method.
const ERROR_WEIGHT: usize = 2;

/// Hears all that is known after each step; an error ends the run.
pub type Keep<'a, E> = dyn FnMut(&Report) -> Result<(), E> + 'a;

/// A chart that is being made.
pub struct Run<'a> {
    truth: Charted<'a>,
    measured: Vec<Measured<'a>>,
    stops: Vec<Vec<f64>>,
    repeat: usize,
    /// The truth at stops where this run has drawn it.
    truths: Vec<(f64, Picture)>,
    /// All but the methods.
    head: Report,
    /// Hears the share done, 0 to 1.
    progress: &'a dyn Fn(f32),
    done: usize,
    work: usize,
}

/// A method, and what is known of it.
struct Measured<'a> {
    charted: Charted<'a>,
    figures: MethodFigures,
    /// Of each round, at each stop.
    rounds: Vec<Vec<Times>>,
}

impl<'a> Run<'a> {
    /// Of the methods at `charted`, each timed `repeat` times (at least once). `known` is the report's head, and has what
    /// an earlier run measured of some of the methods.
    pub fn new(
        subject: &Subject<'_>,
        truth: Charted<'a>,
        charted: Vec<Charted<'a>>,
        repeat: u32,
        known: Report,
        progress: &'a dyn Fn(f32),
    ) -> Self {
        let begin = |charted: Charted<'a>| {
            let name = charted.method.name;
            let found = known.methods.iter().find(|method| method.name == name).cloned();
            let figures = found.unwrap_or_else(|| MethodFigures { name: name.into(), ..MethodFigures::default() });
            let (settings, known_to_fail) = (charted.method.rules.in_words(), charted.method.family == Family::Failing);
            Measured { charted, figures: MethodFigures { settings, known_to_fail, ..figures }, rounds: Vec::new() }
        };
        let measured: Vec<Measured<'_>> = charted.into_iter().map(begin).collect();
        let (stops, repeat) = (subject.stops(), repeat.max(1) as usize);
        let errors = stops.len() * (TRUTH_WEIGHT + ERROR_WEIGHT * measured.len());
        let work = errors + (1 + (repeat + 1) * TIMED.min(stops.len())) * measured.len();
        let head = Report { methods: Vec::new(), ..known };
        Self { truth, measured, stops, repeat, truths: Vec::new(), head, progress, done: 0, work }
    }

    /// What is known so far.
    pub fn report(&self) -> Report {
        let methods = self.measured.iter().map(|one| one.figures.clone()).collect();
        let mut report = Report { methods, ..self.head.clone() };
        report.mark_front();
        report
    }

    /// Measures what errors and stability are not known yet; `keep` is called after each step.
    ///
    /// # Errors
    /// Those of `keep`. The truth has none, since it needs no adapter.
    pub fn measure_errors<E: From<RenderError>>(&mut self, keep: &mut Keep<'_, E>) -> Result<(), E> {
        for stop in self.stops.clone() {
            let at_s = stop.first().copied().unwrap_or_default();
            let lacks = |one: &Measured<'_>| !one.figures.frames.iter().any(|frame| frame.at_s == at_s);
            let is_lacking = self.measured.iter().any(lacks);
            self.head.unfinished |= is_lacking;
            let truths = if is_lacking { drawings(&mut self.truth, &stop)? } else { Vec::new() };
            self.truths.extend(truths.first().map(|drawn| (at_s, drawn.picture.clone())));
            self.advance(TRUTH_WEIGHT);
            self.each(keep, ERROR_WEIGHT, |one| {
                if lacks(one) {
                    let drawn = if one.is_truth() { truths.clone() } else { drawings(&mut one.charted, &stop)? };
                    one.figures.frames.push(FrameFigures::of(at_s, &drawn, &truths));
                    one.figures.sum_up();
                }
                Ok(())
            })?;
        }
        Ok(())
    }

    /// Measures costs, if one is not known; `keep` is called after each step. What it hears before the first round has
    /// been counted is of the round that warms up.
    ///
    /// # Errors
    /// Those of `keep`.
    pub fn measure_costs<E>(&mut self, keep: &mut Keep<'_, E>) -> Result<(), E> {
        if !self.head.unfinished && self.measured.iter().all(|one| one.figures.cost.frame_ms.is_some()) {
            return Ok(());
        }
        self.head.unfinished = true;
        let firsts: Vec<f64> = self.stops.iter().filter_map(|stop| stop.first().copied()).collect();
        let timed: Vec<f64> = firsts.iter().copied().step_by(firsts.len().div_ceil(TIMED).max(1)).collect();
        for round in 0..=self.repeat {
            for one in &mut self.measured {
                if round <= 1 {
                    one.rounds.clear();
                }
                one.rounds.push(Vec::new());
            }
            for at_s in &timed {
                self.each(keep, 1, |one| one.time(*at_s))?;
            }
        }
        self.each(keep, 1, |one| {
            one.figures.cost.counts = one.counts(&timed);
            Ok(())
        })?;
        self.head.unfinished = false;
        keep(&self.report())
    }

    /// Draws what the page shows: the stop where there is something to see, and methods differ.
    ///
    /// # Errors
    /// None, since the truth needs no adapter.
    pub fn draw(&mut self) -> Result<Pictures, RenderError> {
        let at_s = self.most_telling_s();
        let known = self.truths.iter().position(|(known, _)| *known == at_s);
        let truth = match known {
            Some(index) => self.truths.swap_remove(index).1,
            None => self.truth.draw(at_s)?.picture,
        };
        let mut pictures = Pictures::new(truth);
        self.each(&mut |_| Ok::<(), RenderError>(()), 0, |one| {
            if !one.is_truth() {
                pictures.add(one.charted.method, one.charted.draw(at_s)?.picture);
            }
            Ok(())
        })?;
        Ok(pictures)
    }

    /// The stop with the largest product of contrast and error.
    fn most_telling_s(&self) -> f64 {
        let worth = |at_s: f64| -> f64 {
            let frames = self.measured.iter().flat_map(|one| &one.figures.frames).filter(|frame| frame.at_s == at_s);
            frames.map(|frame| frame.contrast * frame.error.flip_mean.unwrap_or_default()).sum()
        };
        let stops = self.stops.iter().filter_map(|stop| stop.first().copied());
        stops.max_by(|a, b| worth(*a).total_cmp(&worth(*b))).unwrap_or_default()
    }

    /// Does something for each method, of some `weight`, and keeps what is known then; one that fails is left out from
    /// here on.
    fn each<E>(
        &mut self,
        keep: &mut Keep<'_, E>,
        weight: usize,
        mut work: impl FnMut(&mut Measured<'_>) -> Result<(), RenderError>,
    ) -> Result<(), E> {
        let mut index = 0;
        while let Some(one) = self.measured.get_mut(index) {
            match work(one) {
                Ok(()) => index += 1,
                Err(error) => {
                    let name = self.measured.remove(index).figures.name;
                    self.head.left_out.push(LeftOut { name, reason: error.to_string() });
                }
            }
            self.advance(weight);
            keep(&self.report())?;
        }
        Ok(())
    }

    fn advance(&mut self, work: usize) {
        self.done += work;
        (self.progress)(self.done as f32 / self.work.max(1) as f32);
    }
}

impl Measured<'_> {
    /// Whether it is what all are compared with.
    fn is_truth(&self) -> bool {
        self.charted.method.family == Family::Truth
    }

    /// Whether the time of what is drawn for figures will do: it takes too long to be timed for itself.
    fn is_slow(&self) -> bool {
        self.charted.method.rules.rasterizer == Rasterizer::Truth
    }

    fn time(&mut self, at_s: f64) -> Result<(), RenderError> {
        if !self.is_slow() {
            let times = self.charted.time(at_s)?;
            if let Some(round) = self.rounds.last_mut() {
                round.push(times);
            }
        }
        let counts = std::mem::take(&mut self.figures.cost.counts);
        self.figures.cost = Cost { counts, ..self.cost() };
        Ok(())
    }

    /// The median round's mean over its stops.
    fn cost(&self) -> Cost {
        if self.is_slow() {
            let drawn: Vec<f64> = self.figures.frames.iter().filter_map(|frame| frame.drawn_ms).collect();
            return Cost { frame_ms: mean(&drawn), cpu_ms: mean(&drawn), ..Cost::default() };
        }
        let over_rounds = |of: &dyn Fn(&Times) -> Figure| {
            let round = |times: &Vec<Times>| mean(&times.iter().filter_map(of).collect::<Vec<_>>());
            median(self.rounds.iter().filter_map(round).collect())
        };
        Cost {
            frame_ms: over_rounds(&|times| Some(times.frame_ms)),
            cpu_ms: over_rounds(&|times| Some(times.cpu_ms)),
            gpu_ms: over_rounds(&|times| times.gpu_ms),
            counts: FrameCounts::default(),
        }
    }

    /// On average over the stops.
    fn counts(&mut self, timed: &[f64]) -> FrameCounts {
        let counted: Vec<_> = timed.iter().map(|at_s| self.charted.counts(*at_s)).collect();
        let average = |of: &dyn Fn(&cloudwright_core::measure::Counts) -> f64| {
            counted.iter().map(of).sum::<f64>() / counted.len().max(1) as f64
        };
        let whole = |of: &dyn Fn(&cloudwright_core::measure::Counts) -> u64| {
            average(&|counts| of(counts) as f64).round() as u64
        };
        FrameCounts {
            sprites: whole(&|counts| counts.sprites),
            corners_shaded: whole(&|counts| counts.corners_shaded),
            fragments: Some(average(&|counts| counts.fragments as f64)),
            overdraw_mean: Some(average(&|counts| counts.overdraw_mean)),
            overdraw_p99: Some(average(&|counts| f64::from(counts.overdraw_p99))),
            bytes_uploaded: whole(&|counts| counts.bytes_uploaded),
            keys_sorted: whole(&|counts| counts.keys_sorted),
        }
    }
}

fn drawings(charted: &mut Charted<'_>, stop: &[f64]) -> Result<Vec<Drawing>, RenderError> {
    stop.iter().map(|at_s| charted.draw(*at_s)).collect()
}

/// The upper one of two in the middle; none of none.
fn median(mut values: Vec<f64>) -> Figure {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
