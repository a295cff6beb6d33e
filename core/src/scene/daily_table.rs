//! A value over the day: keys at hours, linear between them, cyclic across midnight.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// One key.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DailyKey<T> {
    /// Local civil hours in [0, 24). Of a key that goes by the sun, about when: it tells morning from evening, and holds where
    /// the sun is set by hand.
    pub hour: f64,
    /// Elevation of the sun, degrees, at which the key stands in place of its hour.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub sun_deg: Option<f64>,
    /// The value at that hour.
    pub value: T,
}

/// Keys in rising order of hour; at least one, no two at one hour (the checks see to it).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct DailyTable<T> {
    /// The keys.
    pub keys: Vec<DailyKey<T>>,
}

impl<T: Copy + Default> DailyTable<T> {
    /// The same value all day.
    pub fn constant(value: T) -> Self {
        Self { keys: vec![DailyKey { hour: 0.0, sun_deg: None, value }] }
    }

    /// A table from hours and values.
    pub fn new(keys: impl IntoIterator<Item = (f64, T)>) -> Self {
        Self { keys: keys.into_iter().map(|(hour, value)| DailyKey { hour, sun_deg: None, value }).collect() }
    }

    /// The value at `hour` (any number; taken modulo 24), by `mix(from, to, t)` between the keys around it.
    ///
    /// One key is a constant; no key gives the default. Between keys (t0, c0) and (t1, c1) the share of c0 is
    /// (t1 − t)/(t1 − t0) (W); before the first and after the last key it runs across midnight.
    pub fn at(&self, hour: f64, mix: impl Fn(T, T, f32) -> T) -> T {
        let (Some(first), Some(last)) = (self.keys.first(), self.keys.last()) else {
            return T::default();
        };
        let hour = hour.rem_euclid(24.0);
        let after = self.keys.iter().position(|key| key.hour > hour);
        let (from, to, since, span) = match after {
            Some(i) if i > 0 => {
                let from = &self.keys[i - 1];
                (from, &self.keys[i], hour - from.hour, self.keys[i].hour - from.hour)
            }
            _ => (last, first, (hour - last.hour).rem_euclid(24.0), first.hour + 24.0 - last.hour),
        };
        let t = if span > 0.0 { (since / span) as f32 } else { 0.0 };
        mix(from.value, to.value, t)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn runs_across_midnight() {
        let table = DailyTable::new([(6.0, 0.0_f32), (18.0, 12.0)]);
        for (hour, want) in
            [(6.0, 0.0), (12.0, 6.0), (18.0, 12.0), (0.0, 6.0), (21.0, 9.0), (3.0, 3.0), (27.0, 3.0), (-3.0, 9.0)]
        {
            let got = table.at(hour, |a, b, t| a + (b - a) * t);
            assert!((got - want).abs() < 1e-5, "at {hour} h: {got}, want {want}");
        }
    }

    #[test]
    fn degenerate_tables_have_answers() {
        let mix = |a: f32, b: f32, t: f32| a + (b - a) * t;
        assert_eq!(DailyTable::constant(3.0).at(17.0, mix), 3.0);
        assert_eq!(DailyTable { keys: vec![] }.at(1.0, mix), 0.0);
    }
}
