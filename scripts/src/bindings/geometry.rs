//! Directions as vectors, headings and turns, and curves that a parameter gives. Headings are degrees clockwise from
//! north; north is −z, east is x.

use super::convert::{items, list, number, of_places, of_vector, vector};
use super::{Answer, Usage};
use crate::error::Said;
use crate::limits::LIST_ITEMS;
use glam::{DQuat, DVec3};
use rhai::{Array, Dynamic, Engine, Map};

pub(super) const USAGE: &[Usage] = &[
    ("subtract", "subtract(a, b)", "The way from b to a."),
    ("dot", "dot(a, b)", "The dot product of two vectors."),
    ("cross", "cross(a, b)", "Their cross product."),
    ("normalize", "normalize(v)", "The vector of length 1 in its direction."),
    ("towards", "towards(heading_deg)", "The level vector of length 1 to that heading: 0 is north, 90 east."),
    ("heading_of", "heading_of(v)", "The heading in which a vector points, 0 to 360."),
    ("turned", "turned(v, 90)", "A vector or place turned clockwise about the vertical, as seen from above."),
    ("orientation", "orientation(90)", "The turn to that heading as a box's `orientation`."),
    ("look", "look(from, to)", "heading_deg and pitch_deg of a camera at one place that looks to another, as a map."),
    ("line", "line(from, to, 10)", "So many places on the way from one to the other, both included."),
    ("clamp", "clamp(x, 0, 1)", "x, or the nearer end of the range."),
    (
        "curve_at",
        "curve_at(parameters.profile, 0.3)",
        "A curve's y at that x: straight between its points, level beyond.",
    ),
];

fn of(vector: DVec3) -> Dynamic {
    of_vector(vector.to_array())
}

fn two(a: &Dynamic, b: &Dynamic) -> Result<(DVec3, DVec3), Said> {
    Ok((vector("the first", a)?.into(), vector("the second", b)?.into()))
}

fn sin_cos(deg: f64) -> (f64, f64) {
    libm::sincos(deg.to_radians())
}

fn heading_deg(v: DVec3) -> f64 {
    // What points straight up or down has none: north.
    let deg = if v.x == 0.0 && v.z == 0.0 { 0.0 } else { libm::atan2(v.x, -v.z).to_degrees() };
    deg.rem_euclid(360.0)
}

fn normalize(v: &Dynamic) -> Result<Dynamic, Said> {
    let v = DVec3::from(vector("the vector", v)?);
    v.try_normalize().map(of).ok_or_else(|| Said::script("the vector has no length", "and so no direction"))
}

fn line(from: &Dynamic, to: &Dynamic, count: &Dynamic) -> Result<Array, Said> {
    let (from, to) = two(from, to)?;
    let count = items("the count", count)?;
    if count * 4 > LIST_ITEMS {
        return Err(Said::limit(format!("{count} places are too many"), format!("{} at most", LIST_ITEMS / 4)));
    }
    let share = |i: usize| if count > 1 { i as f64 / (count - 1) as f64 } else { 0.5 };
    Ok(of_places((0..count).map(|i| from.lerp(to, share(i)).to_array())))
}

/// One point of a curve.
fn point(value: &Dynamic) -> Result<[f64; 2], Said> {
    match list("a point of the curve", value)?.as_slice() {
        [x, y] => Ok([number("x", x)?, number("y", y)?]),
        _ => Err(Said::script("a point of the curve is no list of two numbers", "[x, y]")),
    }
}

fn curve_at(curve: &Dynamic, x: f64) -> Result<f64, Said> {
    let points = list("the curve", curve)?.iter().map(point).collect::<Result<Vec<_>, _>>()?;
    let after = points.iter().position(|[to, _]| *to > x);
    match (after, points.as_slice()) {
        (_, []) => Err(Said::script("the curve has no points", "[[x, y], …]")),
        (Some(0), [[_, y], ..]) | (None, [.., [_, y]]) => Ok(*y),
        (Some(after), points) => {
            let ([from_x, from], [to_x, to]) = (points[after - 1], points[after]);
            let share = (x - from_x) / (to_x - from_x);
            Ok(from * (1.0 - share) + to * share)
        }
    }
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_fn("subtract", |a: Dynamic, b: Dynamic| -> Answer<Dynamic> {
        let (a, b) = two(&a, &b)?;
        Ok(of(a - b))
    });
    engine.register_fn("dot", |a: Dynamic, b: Dynamic| -> Answer<f64> {
        let (a, b) = two(&a, &b)?;
        Ok(a.dot(b))
    });
    engine.register_fn("cross", |a: Dynamic, b: Dynamic| -> Answer<Dynamic> {
        let (a, b) = two(&a, &b)?;
        Ok(of(a.cross(b)))
    });
    engine.register_fn("normalize", |v: Dynamic| -> Answer<Dynamic> { Ok(normalize(&v)?) });
    engine.register_fn("towards", |heading: Dynamic| -> Answer<Dynamic> {
        let (sin, cos) = sin_cos(number("the heading", &heading)?);
        Ok(of_vector([sin, 0.0, -cos]))
    });
    engine.register_fn("heading_of", |v: Dynamic| -> Answer<f64> { Ok(heading_deg(vector("the vector", &v)?.into())) });
    engine.register_fn("turned", |v: Dynamic, by: Dynamic| -> Answer<Dynamic> {
        let ([x, y, z], (sin, cos)) = (vector("the vector", &v)?, sin_cos(number("the angle", &by)?));
        Ok(of_vector([cos * x - sin * z, y, sin * x + cos * z]))
    });
    engine.register_fn("orientation", |heading: Dynamic| -> Answer<Array> {
        // Clockwise from above is the other way round about +y.
        let (sin, cos) = sin_cos(-0.5 * number("the heading", &heading)?);
        Ok(DQuat::from_xyzw(0.0, sin, 0.0, cos).to_array().map(Dynamic::from_float).to_vec())
    });
    engine.register_fn("look", |from: Dynamic, to: Dynamic| -> Answer<Map> {
        let (from, to) = two(&from, &to)?;
        let way = to - from;
        let pitch_deg = libm::atan2(way.y, libm::hypot(way.x, way.z)).to_degrees();
        Ok(Map::from([("heading_deg".into(), heading_deg(way).into()), ("pitch_deg".into(), pitch_deg.into())]))
    });
    engine.register_fn("line", |from: Dynamic, to: Dynamic, count: Dynamic| -> Answer<Array> {
        Ok(line(&from, &to, &count)?)
    });
    engine.register_fn("clamp", |x: Dynamic, low: Dynamic, high: Dynamic| -> Answer<f64> {
        let [x, low, high] = [number("x", &x)?, number("the lower end", &low)?, number("the upper end", &high)?];
        Ok(x.min(high).max(low))
    });
    engine.register_fn("curve_at", |curve: Dynamic, x: Dynamic| -> Answer<f64> {
        Ok(curve_at(&curve, number("x", &x)?)?)
    });
}
