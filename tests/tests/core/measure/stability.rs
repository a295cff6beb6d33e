//! What a method flickers beyond the truth's own change, against closed forms.

use cloudwright_core::color::Rgb;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::measure::{SizesDiffer, Stability, StabilityFigures};

/// Pictures of 100 × 10 pixels, all of one colour but for the first.
fn picture(first: f32, rest: f32) -> LinearPicture {
    let pixel = |i| Rgb::new(0.25, if i == 0 { first } else { rest }, 0.0);
    LinearPicture { width: 100, height: 10, pixels: (0..1000).map(pixel).collect() }
}

/// Frames as (method's first pixel, method's rest, truth's first pixel, truth's rest), and what they come to.
fn check(name: &str, frames: &[[f32; 4]], wanted: StabilityFigures) {
    let mut stability = Stability::new();
    for (index, [method_first, method_rest, truth_first, truth_rest]) in frames.iter().enumerate() {
        let step = stability.add(&picture(*method_first, *method_rest), &picture(*truth_first, *truth_rest));
        assert_eq!(step.expect("of one size").is_some(), index > 0, "{name}");
    }
    let got = stability.figures();
    // A bin of the histogram is 2⁻¹⁰ wide.
    assert!((got.excess_p999 - wanted.excess_p999).abs() <= wanted.excess_p999 / 2048.0, "{name}: {got:?}");
    let means = [got.excess_mean - wanted.excess_mean, got.worst_frame - wanted.worst_frame];
    assert!(means.iter().all(|apart| apart.abs() < 1e-9), "{name}: {got:?}");
    assert_eq!(got.worst_frame_index, wanted.worst_frame_index, "{name}");
}

/// Steps are powers of two, which f32 holds.
#[test]
fn excess_is_change_beyond_the_truth() {
    let none = StabilityFigures::default();
    check("no frame", &[], none);
    check("one frame", &[[9.0, 9.0, 0.0, 0.0]], none);
    check("constantly wrong", &[[0.5, 0.5, 0.0, 0.0]; 5], none);
    check("as the truth", &[[0.0; 4], [0.5; 4], [0.25; 4]], none);
    check("less than the truth", &[[0.0; 4], [0.0, 0.25, 0.5, 0.5], [0.25, 0.0, 0.0, 0.0]], none);
    // One of a thousand pixels is beyond the 99.9th percentile.
    let one = 0.5 / 1000.0;
    let pop = StabilityFigures { excess_mean: one, excess_p999: 0.0, worst_frame: one, worst_frame_index: 1 };
    check("one pixel pops", &[[0.0; 4], [0.5, 0.0, 0.0, 0.0]], pop);
    let pop = StabilityFigures { excess_mean: one / 3.0, ..pop };
    check("and stays", &[[0.0; 4], [0.5, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0], [0.5, 0.0, 0.0, 0.0]], pop);
    let all = StabilityFigures { excess_mean: 0.375, excess_p999: 0.5, worst_frame: 0.5, worst_frame_index: 2 };
    check("all flicker, and the truth moves too", &[[0.0; 4], [0.5, 0.5, 0.25, 0.25], [0.0, 0.0, 0.25, 0.25]], all);
}

#[test]
fn another_size_is_refused_and_left_out() {
    let mut stability = Stability::new();
    let small = LinearPicture { width: 1, height: 1, pixels: vec![Rgb::BLACK] };
    assert_eq!(stability.add(&small, &picture(0.0, 0.0)), Err(SizesDiffer { sizes: [[1, 1], [100, 10]] }));
    assert_eq!(stability.add(&picture(0.0, 0.0), &picture(0.0, 0.0)), Ok(None));
    assert_eq!(stability.add(&small, &small), Err(SizesDiffer { sizes: [[100, 10], [1, 1]] }));
    assert!(stability.add(&picture(1.0, 1.0), &picture(1.0, 1.0)).is_ok_and(|step| step.is_some()));
    assert_eq!(stability.figures(), StabilityFigures::default());
}
