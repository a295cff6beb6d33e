//! Errors in linear light and in opacity against closed forms.

use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::image::{Layer, LinearPicture};
use cloudwright_core::measure::{
    LinearError, OpacityError, PixelMap, SizesDiffer, linear_error, linear_error_map, opacity_error,
};

fn picture(width: u32, height: u32, pixel: impl Fn(u32) -> Rgb) -> LinearPicture {
    LinearPicture { width, height, pixels: (0..width * height).map(pixel).collect() }
}

fn layer(width: u32, height: u32, alpha: impl Fn(u32) -> f32) -> Layer {
    let pixel = |i| Premultiplied { a: alpha(i), ..Premultiplied::CLEAR };
    Layer { width, height, pixels: (0..width * height).map(pixel).collect() }
}

/// Differences that f32 holds exactly, so that all figures are exact but for the root.
#[test]
fn linear_errors() {
    let black = |i| if i == u32::MAX { Rgb::grey(1.0) } else { Rgb::BLACK };
    let check = |name: &str, pixel: &dyn Fn(u32) -> Rgb, [rmse, largest, p999]: [f64; 3]| {
        let got = linear_error(&picture(100, 20, black), &picture(100, 20, pixel)).expect("of one size");
        assert!((got.rmse - rmse).abs() <= 1e-12 || got.rmse == rmse, "{name}: {got:?}");
        assert_eq!([got.largest, got.p999].map(f64::from), [largest, p999], "{name}: {got:?}");
    };
    check("equal", &black, [0.0; 3]);
    check("one channel everywhere", &|_| Rgb::new(0.0, -0.5, 0.0), [(0.25_f64 / 3.0).sqrt(), 0.5, 0.5]);
    // 2 of 2,000 pixels are the worst 0.1 %, a third is not.
    let few = |count: u32| move |i: u32| Rgb::grey(if i % 700 == 99 && i / 700 < count { 2.0 } else { 0.0 });
    check("two pixels", &few(2), [(2.0 * 4.0 / 2000.0_f64).sqrt(), 2.0, 0.0]);
    check("three pixels", &few(3), [(3.0 * 4.0 / 2000.0_f64).sqrt(), 2.0, 2.0]);
    check(
        "no number",
        &|i| Rgb::new(0.0, 0.0, if i == 7 { f32::NAN } else { 0.0 }),
        [f64::INFINITY, f64::INFINITY, 0.0],
    );
    check(
        "infinite",
        &|i| Rgb::grey(if i == 7 { f32::NEG_INFINITY } else { 0.0 }),
        [f64::INFINITY, f64::INFINITY, 0.0],
    );
    let wild = picture(3, 1, |i| Rgb::grey([f32::NAN, f32::INFINITY, 1e30][i as usize]));
    assert_eq!(linear_error(&wild, &wild), Ok(LinearError::default()), "equal, numbers or not");
}

#[test]
fn maps_show_where() {
    let map = linear_error_map(
        &picture(2, 2, |i| Rgb::new(i as f32, 0.0, 1.0)),
        &picture(2, 2, |i| Rgb::new(0.0, 0.5, 1.0 + i as f32 * 0.25)),
    );
    assert_eq!(map, Ok(PixelMap { width: 2, height: 2, values: vec![0.5, 1.0, 2.0, 3.0] }));
}

#[test]
fn opacity() {
    let [clear, sheet] = [layer(4, 2, |_| 0.0), layer(4, 2, |i| if i < 2 { 0.75 } else { 0.25 })];
    assert_eq!(opacity_error(&clear, &sheet), Ok(OpacityError { largest: 0.75, mean: 0.375 }));
    assert_eq!(opacity_error(&sheet, &sheet), Ok(OpacityError::default()));
    let colored = layer(4, 2, |_| 0.0);
    let colored = Layer { pixels: vec![Premultiplied { r: 1.0, ..Premultiplied::CLEAR }; 8], ..colored };
    assert_eq!(opacity_error(&clear, &colored), Ok(OpacityError::default()), "colour is no opacity");
}

#[test]
fn sizes_must_agree_and_none_is_nothing() {
    let differ = SizesDiffer { sizes: [[2, 3], [3, 2]] };
    assert_eq!(linear_error(&picture(2, 3, |_| Rgb::BLACK), &picture(3, 2, |_| Rgb::BLACK)), Err(differ));
    assert_eq!(opacity_error(&layer(2, 3, |_| 0.0), &layer(3, 2, |_| 0.0)), Err(differ));
    let nothing = picture(0, 0, |_| Rgb::BLACK);
    assert_eq!(linear_error(&nothing, &nothing), Ok(LinearError::default()));
    assert_eq!(opacity_error(&layer(0, 0, |_| 0.0), &layer(0, 0, |_| 0.0)), Ok(OpacityError::default()));
}

#[test]
fn same_figures_on_any_number_of_threads() {
    // A third has no end in binary, so another order of sums would show.
    let [a, b] =
        [1.0_f32, 3.0].map(|by| picture(997, 311, move |i| Rgb::new(i as f32 / by, 1.0 / by, (i % 13) as f32 / 3.0)));
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| linear_error(&a, &b))
    };
    let one = on(1);
    assert!([2, 3, 7].into_iter().all(|threads| on(threads) == one));
}
