//! The front against its definition, and what is read off it.

use super::example;
use cloudwright::chart::front::{Beaten, Gain, beaten, cheapest_within, front};
use cloudwright::chart::report::MethodFigures;
use proptest::prelude::*;

/// The definition, word by word.
fn oracle(points: &[Option<[f64; 2]>]) -> Vec<bool> {
    let known: Vec<_> = points.iter().map(|p| p.filter(|p| p[0].is_finite() && p[1].is_finite())).collect();
    let beats = |a: &[f64; 2], b: &[f64; 2]| a[0] <= b[0] && a[1] <= b[1] && (a[0] < b[0] || a[1] < b[1]);
    known.iter().map(|p| p.is_some_and(|p| !known.iter().flatten().any(|other| beats(other, &p)))).collect()
}

/// Few different values, so that ties are common, and what is no number.
fn figure() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (0..6_u8).prop_map(f64::from),
        2 => 0.0..10.0_f64,
        1 => prop_oneof![Just(-0.0), Just(f64::NAN), Just(f64::INFINITY), Just(f64::NEG_INFINITY), Just(1e-300)],
    ]
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn front_is_its_definition(points in prop::collection::vec(prop::option::weighted(0.9, [figure(), figure()]), 0..14)) {
        prop_assert_eq!(front(&points), oracle(&points));
    }

    /// Whatever the figures: no panic, the better one is another one, the factor is no less than 1.
    #[test]
    fn beaten_by_another(points in prop::collection::vec(prop::option::weighted(0.9, [figure(), figure()]), 1..8)) {
        for place in 0..=points.len() {
            if let Some(Beaten { by, factor, .. }) = beaten(&points, place) {
                prop_assert!(by != place && by < points.len());
                prop_assert!(factor >= 1.0, "{factor}");
            }
        }
    }
}

#[test]
fn beaten_by_whom() {
    let points =
        [Some([10.0, 0.01]), Some([80.0, 0.01]), Some([10.5, 0.05]), None, Some([9.8, 0.000_01]), Some([500.0, 0.0])];
    let check = |place, want| assert_eq!(beaten(&points, place).map(|b| (b.by, b.gain, b.factor.round())), want);
    // Errors below a thousandth are one error: ten times as true as 0.01, not a thousand times.
    check(0, Some((4, Gain::Truth, 10.0)));
    // 80 ms against 9.8: 8 times as quick, but 10 times as true.
    check(1, Some((4, Gain::Truth, 10.0)));
    check(2, Some((4, Gain::Truth, 50.0)));
    check(3, None);
    check(4, None);
    // The truth pays for what no one would see.
    check(5, Some((4, Gain::Speed, 51.0)));
    check(6, None);
    // Times within a tenth are the same time.
    for (other_cost, want) in [(10.9, Some(5.0)), (11.1, None)] {
        let points = [Some([10.0, 0.05]), Some([other_cost, 0.01])];
        assert_eq!(beaten(&points, 0).map(|beaten| beaten.factor), want, "{other_cost}");
    }
}

#[test]
fn cheapest_that_keeps_a_tolerance() {
    let mut methods = example::report().methods;
    let check = |methods: &[MethodFigures], tolerance, want: Option<&str>| {
        assert_eq!(cheapest_within(methods, tolerance).map(|method| method.name.as_str()), want, "{tolerance}");
    };
    for (tolerance, want) in [
        // 8-bit blending is cheaper, but known to fail.
        (0.5, Some("gpu")),
        (0.034, Some("gpu")),
        (0.02, Some("gpu")),
        (0.007, Some("shipped fast")),
        (0.0, Some("truth")),
        (-1.0, None),
        (f64::NAN, None),
    ] {
        check(&methods, tolerance, want);
    }
    for method in &mut methods {
        method.cost.frame_ms = None;
    }
    check(&methods, 1.0, None);
    check(&[], 1.0, None);
}
