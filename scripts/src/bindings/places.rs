//! Places on the plane, as whole lists of [x, 0, z], metres, around the middle.

use super::convert::{self, count, items, map, number, of_vector};
use super::{Answer, Usage};
use crate::error::Said;
use crate::limits::LIST_ITEMS;
use cloudwright_core::random::{draw, unit};
use rhai::{Array, Dynamic, Engine};
use std::collections::BTreeMap;

pub(super) const USAGE: &[Usage] = &[
    ("grid", "grid(8, 5, 1500)", "Columns and rows so many metres apart."),
    ("ring", "ring(12, 4000)", "So many on a circle of that radius, clockwise from north."),
    (
        "scatter",
        "scatter(seed, 40, 20000, 12000, 1500)",
        "Up to so many within a width (east) and a depth (south), none nearer to another than the last number; fewer if they do not fit.",
    ),
    (
        "sorted_by",
        "sorted_by(list, \"rank\")",
        "A list of maps in rising order of the numbers that they have under a name; what has equal ones stays in its order.",
    ),
];

/// Darts thrown for each place that is wanted.
const DARTS: u32 = 24;

fn list(places: impl IntoIterator<Item = [f64; 2]>) -> Array {
    places.into_iter().map(|[x, z]| of_vector([x, 0.0, z])).collect()
}

fn grid(columns: &Dynamic, rows: &Dynamic, apart: &Dynamic) -> Result<Array, Said> {
    let (columns, rows) = (items("columns", columns)?, items("rows", rows)?);
    let apart = number("the distance", apart)?;
    if columns.saturating_mul(rows) > LIST_ITEMS {
        return Err(Said::limit(format!("{columns} × {rows} places are too many"), format!("{LIST_ITEMS} at most")));
    }
    let at = |index: usize, count: usize| (index as f64 - 0.5 * (count as f64 - 1.0)) * apart;
    Ok(list((0..rows).flat_map(|row| (0..columns).map(move |column| [at(column, columns), at(row, rows)]))))
}

fn ring(count: &Dynamic, radius: &Dynamic) -> Result<Array, Said> {
    let (count, radius) = (items("the count", count)?, number("the radius", radius)?);
    let at = |index: usize| {
        let (sin, cos) = libm::sincos(std::f64::consts::TAU * index as f64 / count as f64);
        [radius * sin, -radius * cos]
    };
    Ok(list((0..count).map(at)))
}

/// Darts on a plane with a lattice of cells as wide as two may be near, so that each looks at nine.
fn scatter(seed: u64, wanted: usize, size: [f64; 2], apart: f64) -> Vec<[f64; 2]> {
    let cell = |place: [f64; 2]| place.map(|x| (x / apart.max(1e-3)).floor() as i64);
    let mut cells: BTreeMap<[i64; 2], Vec<[f64; 2]>> = BTreeMap::new();
    let mut found = Vec::new();
    let darts = u32::try_from(wanted).unwrap_or(u32::MAX).saturating_mul(DARTS);
    for dart in 0..darts {
        if found.len() == wanted {
            break;
        }
        let bits = draw(seed, 0, dart, 0);
        let place = [0, 1].map(|i| (unit(bits[i]) - 0.5) * size[i]);
        let [i, j] = cell(place);
        let near = |di: i64, dj: i64| cells.get(&[i.saturating_add(di), j.saturating_add(dj)]).into_iter().flatten();
        let mut neighbours = (-1..=1).flat_map(|di| (-1..=1).flat_map(move |dj| near(di, dj)));
        let is_near = |[x, z]: &[f64; 2]| {
            let (dx, dz) = (x - place[0], z - place[1]);
            dx * dx + dz * dz < apart * apart
        };
        if apart == 0.0 || !neighbours.any(is_near) {
            cells.entry([i, j]).or_default().push(place);
            found.push(place);
        }
    }
    found
}

fn sorted_by(list: &Dynamic, name: &str) -> Result<Array, Said> {
    let rank = |(i, each): (usize, Dynamic)| {
        let what = format!("number {i} of the list");
        let rank = map(&what, &each)?.get(name).map(|rank| number(&format!("its {name}"), rank));
        let rank = rank.ok_or_else(|| Said::script(format!("{what} has no `{name}`"), "each map has it"))?;
        Ok((rank?, each))
    };
    let given = convert::list("the list", list)?;
    let mut ranked = given.into_iter().enumerate().map(rank).collect::<Result<Vec<_>, Said>>()?;
    ranked.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    Ok(ranked.into_iter().map(|(_, each)| each).collect())
}

pub(super) fn register(engine: &mut Engine) {
    engine.register_fn("sorted_by", |list: Dynamic, name: &str| -> Answer<Array> { Ok(sorted_by(&list, name)?) });
    engine.register_fn("grid", |columns: Dynamic, rows: Dynamic, apart: Dynamic| -> Answer<Array> {
        Ok(grid(&columns, &rows, &apart)?)
    });
    engine.register_fn("ring", |count: Dynamic, radius: Dynamic| -> Answer<Array> { Ok(ring(&count, &radius)?) });
    engine.register_fn(
        "scatter",
        |seed: Dynamic, wanted: Dynamic, width: Dynamic, depth: Dynamic, apart: Dynamic| -> Answer<Array> {
            let (seed, wanted) = (count("the seed", &seed)?, items("the count", &wanted)?);
            let size = [number("the width", &width)?, number("the depth", &depth)?];
            let apart = number("the distance", &apart)?;
            if size.iter().any(|x| *x < 0.0) || apart < 0.0 {
                return Err(Said::script("a width, a depth or a distance is below 0", "metres").into());
            }
            Ok(list(scatter(seed, wanted, size, apart)))
        },
    );
}
