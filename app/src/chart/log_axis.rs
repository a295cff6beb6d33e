//! A logarithmic axis with a rail for nothing.
//!
//! A logarithmic scale has no place for 0, and the truth's error is 0. So what is 0, or too small to share a scale with
//! the rest, stands on a rail below the axis. Ticks are 1, 2 and 5 times powers of ten, as far as their numbers fit.

use crate::chart::text;

/// What is smaller than the largest value by more than this goes to the rail.
const LARGEST_SPAN: f64 = 1e5;
/// Smaller still is nothing, and its inverse is the end of all scales: products and decades stay numbers.
const LEAST: f64 = 1e-300;
/// Ends of an axis lie beyond its values by this factor.
const AIR: f64 = 1.15;

/// From values to places on a sheet, in pixels or any other unit; places may run either way.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LogAxis {
    low: f64,
    high: f64,
    low_px: f64,
    high_px: f64,
    /// Where the rail is, if a value needs one.
    rail: Option<Rail>,
}

#[derive(Debug, Clone, PartialEq)]
struct Rail {
    at_px: f64,
    label: String,
}

/// A line of the grid.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Tick {
    pub at_px: f64,
    /// Empty where there is no room for one.
    pub label: String,
}

impl LogAxis {
    /// For `values`, all finite, from `start_px` (small) to `end_px` (large); a rail takes `rail_px` of that.
    pub fn new(values: &[f64], [start_px, end_px]: [f64; 2], rail_px: f64) -> Self {
        let values: Vec<f64> = values.iter().map(|value| value.min(1.0 / LEAST)).collect();
        let largest = values.iter().copied().fold(0.0, f64::max);
        let fits = |x: &f64| *x >= LEAST.max(largest / LARGEST_SPAN);
        let smallest = values.iter().copied().filter(fits).fold(f64::INFINITY, f64::min);
        let on_rail: Vec<f64> = values.iter().copied().filter(|x| !fits(x)).collect();
        // All 0: a scale without values, for the looks.
        let [smallest, largest] = if smallest.is_finite() { [smallest, largest] } else { [0.001, 0.1] };
        let (low, high) = (round_down(smallest / AIR), round_up(largest * AIR));
        let towards_end = (end_px - start_px).signum();
        let rail = (!on_rail.is_empty()).then(|| Rail {
            at_px: start_px + towards_end * rail_px * 0.3,
            label: if on_rail.iter().all(|x| *x == 0.0) {
                "0".into()
            } else {
                format!("< {}", text::round_number(low))
            },
        });
        let low_px = if rail.is_some() { start_px + towards_end * rail_px } else { start_px };
        Self { low, high, low_px, high_px: end_px, rail }
    }

    /// Where `value` stands.
    pub fn at(&self, value: f64) -> f64 {
        if value < self.low {
            return self.rail.as_ref().map_or(self.low_px, |rail| rail.at_px);
        }
        let t = (value.min(self.high) / self.low).log10() / (self.high / self.low).log10();
        self.low_px + t * (self.high_px - self.low_px)
    }

    /// Where the scale begins: beside the rail if there is one.
    pub fn low_px(&self) -> f64 {
        self.low_px
    }

    /// Whether `value` has a place on the scale itself.
    pub fn shows(&self, value: f64) -> bool {
        value >= self.low && value <= self.high
    }

    /// The rail's place and label.
    pub fn rail(&self) -> Option<Tick> {
        self.rail.as_ref().map(|rail| Tick { at_px: rail.at_px, label: rail.label.clone() })
    }

    /// The scale's lines; numbers stand at least `label_px` apart.
    pub fn ticks(&self, label_px: f64) -> Vec<Tick> {
        let decade_px = (self.high_px - self.low_px).abs() / (self.high / self.low).log10();
        // Of 1, 2 and 5 the narrowest gaps are from 1 to 2 and from 5 to 10: log10(2) of a decade.
        let every = decade_px * 2.0_f64.log10() >= label_px;
        let steps: Vec<f64> = steps(self.low).take_while(|step| *step <= self.high * 1.000_001).collect();
        let decades = steps.iter().filter(|step| is_decade(**step)).count();
        let labelled = |step: f64| every || decades < 2 || is_decade(step);
        let tick = |step: f64| Tick {
            at_px: self.at(step),
            label: if labelled(step) { text::round_number(step) } else { String::new() },
        };
        steps.into_iter().map(tick).collect()
    }
}

/// 1, 2 and 5 times powers of ten from the first that is not below `low`.
fn steps(low: f64) -> impl Iterator<Item = f64> {
    let decade = low.log10().floor() as i32;
    (decade..=f64::MAX_10_EXP)
        .flat_map(|n| [1, 2, 5].map(|digit| step(digit, n)))
        .skip_while(move |step| *step < low * 0.999_999)
}

/// By way of text, so that 2e-5 is the number nearest to it and not some product.
fn step(digit: u8, decade: i32) -> f64 {
    format!("{digit}e{decade}").parse().unwrap_or(f64::INFINITY)
}

fn is_decade(step: f64) -> bool {
    (step.log10() - step.log10().round()).abs() < 1e-6
}

fn round_up(x: f64) -> f64 {
    steps(x).next().unwrap_or(x)
}

fn round_down(x: f64) -> f64 {
    let decade = x.log10().floor() as i32;
    [5, 2, 1].map(|digit| step(digit, decade)).into_iter().find(|step| *step <= x * 1.000_001).unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(values: &[f64], ends: [f64; 2], rail: Option<&str>) {
        let axis = LogAxis::new(values, [0.0, 400.0], 40.0);
        assert_eq!([axis.low, axis.high], ends, "{values:?}");
        assert_eq!(axis.rail().map(|rail| rail.label).as_deref(), rail, "{values:?}");
        let places: Vec<f64> = values.iter().map(|value| axis.at(*value)).collect();
        assert!(places.iter().all(|px| (0.0..=400.0).contains(px)), "{values:?}: {places:?}");
        for (value, px) in values.iter().zip(&places) {
            let on_rail = axis.rail().is_some_and(|rail| rail.at_px == *px);
            assert_eq!(on_rail, !axis.shows(*value), "{value} of {values:?}");
        }
        let ticks = axis.ticks(30.0);
        assert!(ticks.len() >= 2 && ticks.windows(2).all(|pair| pair[0].at_px < pair[1].at_px), "{ticks:?}");
        assert!(ticks.iter().filter(|tick| !tick.label.is_empty()).count() >= 2, "{ticks:?}");
    }

    #[test]
    fn ends_and_rails() {
        check(&[3.0, 40.0], [2.0, 50.0], None);
        check(&[0.0, 0.004, 0.2], [0.002, 0.5], Some("0"));
        check(&[7.0], [5.0, 10.0], None);
        check(&[1.0], [0.5, 2.0], None);
        check(&[], [0.0005, 0.2], None);
        check(&[0.0, 0.0], [0.0005, 0.2], Some("0"));
        // More than five decades apart: the small one leaves the scale.
        check(&[1e-9, 0.01, 0.1], [0.005, 0.2], Some("< 0.005"));
        check(&[1e-290], [5e-291, 2e-290], None);
        check(&[1e-301], [0.0005, 0.2], Some("< 0.0005"));
        check(&[1e299], [5e298, 2e299], None);
    }

    #[test]
    fn numbers_that_would_touch_are_left_out() {
        let axis = LogAxis::new(&[0.01, 100.0], [400.0, 0.0], 40.0);
        let labels: Vec<String> =
            axis.ticks(40.0).into_iter().map(|tick| tick.label).filter(|l| !l.is_empty()).collect();
        assert_eq!(labels, ["0.01", "0.1", "1", "10", "100"]);
    }
}
