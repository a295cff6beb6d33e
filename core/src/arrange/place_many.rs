//! A model placed many times within a rectangle: in rows, or strewn.
//!
//! Strewn places follow Martin Roberts's R2 sequence (*The Unreasonable Effectiveness of Quasirandom Sequences*, 2018),
//! which covers the rectangle evenly at every length, shaken by up to a third of their mean distance, so that no
//! pattern shows.

use super::{Arrangement, Names, Plan, Thing};
use crate::random::{draw, unit};
use crate::scene::{Cloud, CloudId, ModelId, Scene};
use glam::{DVec2, DVec3};

/// No more are placed at once.
pub const MOST_CLOUDS: u32 = 10_000;

/// How the places lie to one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Pattern {
    /// In rows and columns that fill the rectangle, north-west first.
    Grid,
    /// Evenly, but without order.
    Strewn,
}

/// Where a model is placed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Places {
    /// The rectangle's middle, metres in the world.
    pub center: DVec3,
    /// The rectangle's extent to the east and to the north, metres.
    pub extent: DVec2,
    /// How many clouds, at most [`MOST_CLOUDS`].
    pub count: u32,
    /// In which pattern.
    pub pattern: Pattern,
    /// Between the lowest and the highest that may come of it, metres; 0: all stand at the middle's height.
    pub altitude_spread_m: f64,
    /// Smallest and largest scale.
    pub scale: [f64; 2],
    /// Decides all that is left to chance.
    pub seed: u64,
    /// Whether each cloud is turned by chance; else all look north.
    pub random_heading: bool,
}

/// Places `model`; nothing if it is gone, or if the rectangle or the ranges are none.
pub fn model(scene: &Scene, model: ModelId, places: &Places) -> Arrangement {
    let mut plan = Plan::new(scene);
    let Some(model) = scene.model(model).filter(|_| places.are_sound()) else { return plan.done() };
    let mut names = Names::new(scene.clouds.iter().map(|cloud| cloud.name.as_str()));
    let count = places.count.min(MOST_CLOUDS);
    for index in 0..count {
        let in_rectangle = match places.pattern {
            Pattern::Grid => in_grid(index, count, places.extent),
            Pattern::Strewn => strewn(index, count, places.seed),
        };
        let aside = (in_rectangle - 0.5) * places.extent;
        let [turn, rise, growth, _] = draw(places.seed, 0, index, 1).map(unit);
        let [smallest, largest] = places.scale;
        let id = CloudId::new(&mut plan.next_id);
        plan.insert_cloud(Cloud {
            name: names.free(&model.name),
            position: places.center + DVec3::new(aside.x, (rise - 0.5) * places.altitude_spread_m, -aside.y),
            heading_deg: if places.random_heading { 360.0 * turn } else { 0.0 },
            scale: smallest + (largest - smallest) * growth,
            ..Cloud::new(id, model, places.center)
        });
        plan.made.push(Thing::Cloud(id));
    }
    plan.done()
}

impl Places {
    fn are_sound(&self) -> bool {
        let Self { center, extent, altitude_spread_m, scale: [smallest, largest], .. } = *self;
        let ranges = [altitude_spread_m, smallest, largest - smallest];
        center.is_finite()
            && extent.is_finite()
            && extent.min_element() >= 0.0
            && ranges.into_iter().all(|range| range.is_finite() && range >= 0.0)
    }
}

/// The middle of a cell, as shares of the extent from the south-west corner. Cells are as square as the count allows;
/// a last row that is not full is spread over the width.
fn in_grid(index: u32, count: u32, extent: DVec2) -> DVec2 {
    let wanted = (f64::from(count) * extent.x / extent.y).sqrt().round();
    // Without a height there is one row; without either, whatever.
    let columns = if wanted.is_nan() { count } else { wanted.clamp(1.0, f64::from(count)) as u32 };
    let rows = count.div_ceil(columns);
    let (row, column) = (index / columns, index % columns);
    let in_row = if row + 1 == rows { count - row * columns } else { columns };
    DVec2::new((f64::from(column) + 0.5) / f64::from(in_row), 1.0 - (f64::from(row) + 0.5) / f64::from(rows))
}

/// As shares of the extent; what is shaken beyond an edge comes in at the other.
fn strewn(index: u32, count: u32, seed: u64) -> DVec2 {
    // The powers of 1/g, where g³ = g + 1.
    const STEP: DVec2 = DVec2::new(0.754_877_666_246_692_7, 0.569_840_290_998_053_2);
    let chance = |key, index| {
        let [x, y, ..] = draw(seed, key, index, 0);
        DVec2::new(unit(x), unit(y))
    };
    let shaken = (chance(0, index) - 0.5) * (2.0 / 3.0) / f64::from(count).sqrt();
    (chance(1, 0) + STEP * f64::from(index) + shaken).fract_gl()
}

#[cfg(test)]
mod tests {
    use super::super::test_scenes::{applied, two_clouds};
    use super::*;

    fn places(pattern: Pattern, count: u32) -> Places {
        let (center, extent) = (DVec3::new(500.0, 1500.0, -200.0), DVec2::new(8000.0, 2000.0));
        let random_heading = pattern == Pattern::Strewn;
        Places { center, extent, count, pattern, altitude_spread_m: 0.0, scale: [1.0, 1.0], seed: 5, random_heading }
    }

    fn positions(scene: &Scene, places: &Places) -> Vec<DVec3> {
        let arrangement = model(scene, scene.models[0].id, places);
        let after = applied(scene, &arrangement);
        let new = &after.clouds.as_slice()[scene.clouds.len()..];
        assert_eq!(arrangement.made, new.iter().map(|cloud| Thing::Cloud(cloud.id)).collect::<Vec<_>>());
        assert!(new.iter().all(|cloud| cloud.model == scene.models[0].id));
        new.iter().map(|cloud| cloud.position).collect()
    }

    #[test]
    fn a_grid_fills_the_rectangle_with_square_cells() {
        let scene = two_clouds();
        let got = positions(&scene, &places(Pattern::Grid, 16));
        assert_eq!(got[0], DVec3::new(500.0 - 3500.0, 1500.0, -200.0 - 500.0), "north-west first");
        assert_eq!(got[1] - got[0], DVec3::X * 1000.0);
        assert_eq!(got[8] - got[0], DVec3::Z * 1000.0);
        let odd = positions(&scene, &places(Pattern::Grid, 17));
        assert_eq!(odd.len(), 17);
        assert!(odd.iter().all(|at| (at.x - 500.0).abs() <= 4000.0 && (at.z + 200.0).abs() <= 1000.0));
    }

    #[test]
    fn strewn_clouds_keep_their_distance_and_come_out_alike() {
        let scene = two_clouds();
        let square = Places { extent: DVec2::splat(1000.0), ..places(Pattern::Strewn, 100) };
        let got = positions(&scene, &square);
        assert_eq!(got, positions(&scene, &square));
        assert_ne!(got, positions(&scene, &Places { seed: 6, ..square }));
        let nearest = |i: usize| {
            let others = got.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, other)| got[i].distance(*other));
            others.fold(f64::INFINITY, f64::min)
        };
        let mean = (0..100).map(nearest).sum::<f64>() / 100.0;
        // By chance alone it is half of 1000 m/√100; in a grid it is all of it.
        assert!(mean > 65.0, "{mean} m to the nearest");
        assert!(got.iter().all(|at| (at.x - 500.0).abs() <= 500.0 && (at.z + 200.0).abs() <= 500.0));
    }

    #[test]
    fn altitudes_and_scales_fill_their_ranges() {
        let scene = two_clouds();
        let ranges = Places { altitude_spread_m: 400.0, scale: [0.5, 2.0], ..places(Pattern::Strewn, 200) };
        let after = applied(&scene, &model(&scene, scene.models[0].id, &ranges));
        let new = &after.clouds.as_slice()[scene.clouds.len()..];
        let ends = |values: Vec<f64>| values.into_iter().fold([f64::MAX, f64::MIN], |[a, b], v| [a.min(v), b.max(v)]);
        let [low, high] = ends(new.iter().map(|cloud| cloud.position.y - 1500.0).collect());
        assert!((-200.0..-190.0).contains(&low) && (190.0..200.0).contains(&high), "{low} to {high} m");
        let [low, high] = ends(new.iter().map(|cloud| cloud.scale).collect());
        assert!((0.5..0.55).contains(&low) && (1.95..2.0).contains(&high), "{low} to {high}");
    }

    #[test]
    fn degenerate_places() {
        let scene = two_clouds();
        let id = scene.models[0].id;
        for pattern in [Pattern::Grid, Pattern::Strewn] {
            for extent in [DVec2::ZERO, DVec2::new(0.0, 100.0), DVec2::new(100.0, 0.0)] {
                let got = positions(&scene, &Places { extent, ..places(pattern, 7) });
                assert!(got.len() == 7 && got.iter().all(|at| at.is_finite()), "{got:?}");
            }
            let bad = [
                Places { extent: DVec2::new(-1.0, 1.0), ..places(pattern, 7) },
                Places { extent: DVec2::NAN, ..places(pattern, 7) },
                Places { center: DVec3::INFINITY, ..places(pattern, 7) },
                Places { scale: [2.0, 1.0], ..places(pattern, 7) },
                Places { altitude_spread_m: f64::NAN, ..places(pattern, 7) },
                places(pattern, 0),
            ];
            for places in bad {
                assert_eq!(model(&scene, id, &places), Arrangement::default());
            }
            assert_eq!(model(&scene, id, &places(pattern, u32::MAX)).made.len(), MOST_CLOUDS as usize);
            assert_eq!(model(&scene, ModelId(9999), &places(pattern, 3)), Arrangement::default());
        }
    }
}
