//! Numbers and vectors. The functions of angles and powers are libm's, the same on every machine.

use super::convert::{number, of_vector, vector};
use super::{Answer, Usage};
use crate::error::{Said, did_you_mean};
use rhai::{Array, Dynamic, Engine};

pub(super) const USAGE: &[Usage] = &[
    ("lerp", "lerp(a, b, 0.25)", "From a at 0 to b at 1; of numbers, vectors or colours."),
    ("ease", "ease(\"in_out\", x)", "0 to 1 over 0 to 1: linear, in, out or in_out."),
    ("smoothstep", "smoothstep(a, b, x)", "0 below a, 1 above b, smooth between."),
    ("pow", "pow(x, y)", "x to the power of y."),
    ("add", "add(a, b)", "The sum of two vectors."),
    ("scale", "scale(v, 2.0)", "A vector times a number."),
    ("length", "length(v)", "The length of a vector."),
    ("distance", "distance(a, b)", "How far two places lie apart."),
];

const EASES: [&str; 4] = ["linear", "in", "out", "in_out"];

fn smooth(x: f64) -> f64 {
    let x = x.clamp(0.0, 1.0);
    x * x * (3.0 - 2.0 * x)
}

fn ease(name: &str, x: f64) -> Result<f64, Said> {
    let x = x.clamp(0.0, 1.0);
    Ok(match name {
        "linear" => x,
        "in" => x * x,
        "out" => 1.0 - (1.0 - x) * (1.0 - x),
        "in_out" => smooth(x),
        _ => {
            let near = did_you_mean(name, EASES);
            let hint = if near.is_empty() { format!("they are {}", EASES.join(", ")) } else { near };
            return Err(Said::script(format!("there is no easing “{name}”"), hint));
        }
    })
}

fn length(v: [f64; 3]) -> f64 {
    let [x, y, z] = v;
    (x * x + y * y + z * z).sqrt()
}

fn lerp(a: &Dynamic, b: &Dynamic, t: &Dynamic) -> Result<Dynamic, Said> {
    let t = number("the share", t)?;
    let mix = |a: f64, b: f64| a * (1.0 - t) + b * t;
    if a.read_lock::<Array>().is_some() {
        let (a, b) = (vector("the first", a)?, vector("the second", b)?);
        return Ok(of_vector([0, 1, 2].map(|i| mix(a[i], b[i]))));
    }
    Ok(Dynamic::from_float(mix(number("the first", a)?, number("the second", b)?)))
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_fn("lerp", |a: Dynamic, b: Dynamic, t: Dynamic| -> Answer<Dynamic> { Ok(lerp(&a, &b, &t)?) });
    engine.register_fn("ease", |name: &str, x: Dynamic| -> Answer<f64> { Ok(ease(name, number("the share", &x)?)?) });
    engine.register_fn("smoothstep", |a: Dynamic, b: Dynamic, x: Dynamic| -> Answer<f64> {
        let [a, b, x] = [number("the first", &a)?, number("the second", &b)?, number("the third", &x)?];
        Ok(if a == b { f64::from(u8::from(x >= a)) } else { smooth((x - a) / (b - a)) })
    });
    engine.register_fn("pow", |x: Dynamic, y: Dynamic| -> Answer<f64> {
        Ok(libm::pow(number("the base", &x)?, number("the power", &y)?))
    });
    engine.register_fn("add", |a: Dynamic, b: Dynamic| -> Answer<Dynamic> {
        let (a, b) = (vector("the first", &a)?, vector("the second", &b)?);
        Ok(of_vector([0, 1, 2].map(|i| a[i] + b[i])))
    });
    engine.register_fn("scale", |v: Dynamic, by: Dynamic| -> Answer<Dynamic> {
        let (v, by) = (vector("the vector", &v)?, number("the factor", &by)?);
        Ok(of_vector(v.map(|x| x * by)))
    });
    engine.register_fn("length", |v: Dynamic| -> Answer<f64> { Ok(length(vector("the vector", &v)?)) });
    engine.register_fn("distance", |a: Dynamic, b: Dynamic| -> Answer<f64> {
        let (a, b) = (vector("the first", &a)?, vector("the second", &b)?);
        Ok(length([0, 1, 2].map(|i| a[i] - b[i])))
    });
    portable(engine);
}

/// In the place of the engine's own, which are the system's.
fn portable(engine: &mut Engine) {
    const OF_ONE: [(&str, fn(f64) -> f64); 15] = [
        ("sin", libm::sin),
        ("cos", libm::cos),
        ("tan", libm::tan),
        ("sinh", libm::sinh),
        ("cosh", libm::cosh),
        ("tanh", libm::tanh),
        ("asin", libm::asin),
        ("acos", libm::acos),
        ("atan", libm::atan),
        ("asinh", libm::asinh),
        ("acosh", libm::acosh),
        ("atanh", libm::atanh),
        ("exp", libm::exp),
        ("ln", libm::log),
        ("log", libm::log10),
    ];
    for (name, function) in OF_ONE {
        engine.register_fn(name, move |x: f64| function(x));
        engine.register_fn(name, move |x: i64| function(x as f64));
    }
    engine.register_fn("atan", |y: f64, x: f64| libm::atan2(y, x));
    engine.register_fn("hypot", |x: f64, y: f64| libm::hypot(x, y));
    engine.register_fn("log", |x: f64, base: f64| libm::log(x) / libm::log(base));
}
