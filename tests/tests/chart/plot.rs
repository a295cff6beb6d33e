//! Drawings hold together whatever the figures.

use super::example::EXAMPLES;
use super::markup::{count, elements};
use cloudwright::chart::Family;
use cloudwright::chart::svg::{Mark, Plot, Shape};
use proptest::prelude::*;

fn marks(figures: &[[f64; 2]]) -> Vec<Mark<'static>> {
    let mark = |(i, at): (usize, &[f64; 2])| {
        let example = &EXAMPLES[i % EXAMPLES.len()];
        Mark { name: example.name, family: example.family, at: *at, link: format!("#{i}") }
    };
    figures.iter().enumerate().map(mark).collect()
}

fn draw(marks: &[Mark<'_>], shape: Shape, tolerance: Option<f64>) -> String {
    let plot = Plot {
        title: "a & b",
        cost_title: "frame time, ms",
        error_title: "FLIP, mean",
        less_error: "truer",
        marks,
        tolerance,
    };
    assert_eq!(plot.svg(shape), plot.svg(shape), "the same input gives the same bytes");
    assert!(plot.file(shape).contains("<style>"));
    plot.svg(shape)
}

/// All is there, nothing is no number, and every mark lies on the sheet.
fn check(figures: &[[f64; 2]], tolerance: Option<f64>) {
    let marks = marks(figures);
    for shape in [Shape::Wide, Shape::Narrow] {
        let svg = draw(&marks, shape, tolerance);
        let elements = elements(&svg);
        assert_eq!(count(&elements, "a"), figures.len());
        assert_eq!(count(&elements, "title"), figures.len());
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{figures:?}:\n{svg}");
        let numbers = |name: &str| -> Vec<f64> {
            let attribute = format!(" {name}=\"");
            let values = svg.split(&attribute).skip(1).filter_map(|rest| rest.split('"').next());
            values.map(|value| value.parse().expect("a number")).collect()
        };
        let (width, height) = if shape == Shape::Wide { (960.0, 540.0) } else { (360.0, 470.0) };
        for (names, limit) in [(["x", "x1", "x2", "cx"], width), (["y", "y1", "y2", "cy"], height)] {
            for x in names.iter().flat_map(|name| numbers(name)) {
                assert!((-0.5..=limit + 0.5).contains(&x), "{x} of {figures:?}, {shape:?}");
            }
        }
    }
}

#[test]
fn any_figures() {
    let examples: Vec<[f64; 2]> = EXAMPLES.iter().map(|example| [example.figures[0], example.figures[1]]).collect();
    for figures in [
        &examples[..],
        &[],
        &[[0.0, 0.0]],
        &[[1.0, 1.0]; 12],
        &[[0.0, 0.3], [0.0, 0.0], [7.0, 0.0]],
        &[[1e-300, 1e300], [1e300, 1e-300]],
        &[[5e-324, 5e-324], [f64::MAX, f64::MAX]],
    ] {
        for tolerance in [None, Some(0.02), Some(0.0), Some(f64::NAN), Some(1e9)] {
            check(figures, tolerance);
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn figures_of_all_sizes(powers in prop::collection::vec([-12.0..12.0_f64, -12.0..12.0], 0..12)) {
        check(&powers.iter().map(|power| power.map(|p| 10.0_f64.powf(p))).collect::<Vec<_>>(), Some(0.02));
    }
}

#[test]
fn legend_and_tolerance_are_of_what_is_there() {
    let marks = marks(&[[1.0, 0.1], [2.0, 0.01]]);
    for (tolerance, shown) in [(None, false), (Some(0.02), true), (Some(0.9), false)] {
        assert_eq!(draw(&marks, Shape::Wide, tolerance).contains("tolerance 0.02"), shown, "{tolerance:?}");
    }
    let svg = draw(&marks, Shape::Wide, None);
    assert!(svg.contains(Family::Shipped.name()) && !svg.contains(Family::Failing.name()));
    assert!(svg.contains("a &amp; b"));
}

/// Names are worst-case wide here; on the two sizes of the example none may lie over another one.
#[test]
fn narrow_and_wide_have_a_mark_for_each() {
    let examples: Vec<[f64; 2]> = EXAMPLES.iter().map(|example| [example.figures[0], example.figures[1]]).collect();
    let marks = marks(&examples);
    for shape in [Shape::Wide, Shape::Narrow] {
        let svg = draw(&marks, shape, None);
        for example in &EXAMPLES {
            assert!(svg.contains(&format!(">{}</text>", example.name)), "{}", example.name);
        }
    }
}
