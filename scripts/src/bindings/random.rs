//! Random streams: the core's counter-based numbers, so that the same seed gives the same on every machine.

use super::convert::{count, items, number, whole};
use super::{Answer, Usage};
use crate::error::Said;
use cloudwright_core::random::{draw, unit};
use rhai::{Array, Dynamic, Engine};
use std::cell::Cell;
use std::rc::Rc;

pub(super) const USAGE: &[Usage] = &[
    (
        "random",
        "let r = random(parameters.seed), or random(seed, 2)",
        "A stream of numbers, which functions that it is handed to go on with; another one has another number.",
    ),
    ("unit", "r.unit()", "The next number between 0 and 1."),
    ("units", "r.units(200)", "The next so many, as a list."),
    ("between", "r.between(800, 1200)", "The next number between two."),
    ("integer", "r.integer(1, 6)", "The next whole number from the first to the second, both included."),
    ("pick", "r.pick(list)", "One of a list."),
    ("drawn", "r.drawn()", "How many numbers were drawn so far."),
];

/// Seed and number of the stream, and how many were drawn. A copy, such as a function gets, goes on with the same stream.
#[derive(Debug, Clone)]
struct Stream {
    seed: u64,
    stream: u64,
    drawn: Rc<Cell<u64>>,
}

impl Stream {
    fn bits(&mut self) -> u64 {
        let drawn = self.drawn.get();
        let [a, b, ..] = draw(self.seed, self.stream, drawn as u32, (drawn >> 32) as u32);
        self.drawn.set(drawn.wrapping_add(1));
        u64::from(a) << 32 | u64::from(b)
    }

    fn unit(&mut self) -> f64 {
        unit((self.bits() >> 32) as u32)
    }

    /// From 0 to below `count`, which is not 0. No more uneven than one part in 2⁶⁴ of `count`.
    fn below(&mut self, count: u64) -> u64 {
        ((u128::from(self.bits()) * u128::from(count)) >> 64) as u64
    }

    fn integer(&mut self, from: &Dynamic, to: &Dynamic) -> Result<i64, Said> {
        let (from, to) = (whole("the smallest", from)?, whole("the largest", to)?);
        let Some(span) = to.checked_sub(from).and_then(|span| u64::try_from(span).ok()) else {
            return Err(Said::script(
                format!("there is no whole number from {from} to {to}"),
                "smallest before largest",
            ));
        };
        // The span is below 2⁶³, and so is what is added.
        Ok(from.saturating_add(i64::try_from(self.below(span + 1)).unwrap_or(0)))
    }
}

fn stream(seed: &Dynamic, stream: u64) -> Answer<Stream> {
    Ok(Stream { seed: count("the seed", seed)?, stream, drawn: Rc::default() })
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_type_with_name::<Stream>("Random");
    engine.register_fn("random", |seed: Dynamic| stream(&seed, 0));
    engine.register_fn("random", |seed: Dynamic, number: Dynamic| stream(&seed, count("the stream", &number)?));
    engine.register_fn("unit", Stream::unit);
    engine.register_fn("units", |stream: &mut Stream, count: Dynamic| -> Answer<Array> {
        let count = items("the count", &count)?;
        Ok((0..count).map(|_| Dynamic::from_float(stream.unit())).collect())
    });
    engine.register_fn("between", |stream: &mut Stream, from: Dynamic, to: Dynamic| -> Answer<f64> {
        let (from, to) = (number("the smallest", &from)?, number("the largest", &to)?);
        let unit = stream.unit();
        Ok(from * (1.0 - unit) + to * unit)
    });
    engine.register_fn("integer", |stream: &mut Stream, from: Dynamic, to: Dynamic| -> Answer<i64> {
        Ok(stream.integer(&from, &to)?)
    });
    engine.register_fn("drawn", |stream: &mut Stream| -> i64 { stream.drawn.get().try_into().unwrap_or(i64::MAX) });
    engine.register_fn("pick", |stream: &mut Stream, list: Array| -> Answer<Dynamic> {
        if list.is_empty() {
            return Err(Said::script("there is nothing to pick from", "the list is empty").into());
        }
        let index = stream.below(list.len() as u64) as usize;
        Ok(list.into_iter().nth(index).unwrap_or_default())
    });
}
