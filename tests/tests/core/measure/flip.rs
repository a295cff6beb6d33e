//! ꟻLIP against the published tool, against plain sums, and where it has a defined answer.

use super::flip_plain;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, SizesDiffer, flip};
use cloudwright_core::random::draw;
use cloudwright_tests::root;
use std::fs;

fn read(name: &str) -> Picture {
    let file = fs::File::open(root().join("tests/flip").join(name)).expect("a picture of a pair");
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().expect("a PNG");
    let mut bytes = vec![0; reader.output_buffer_size().expect("of a known size")];
    let info = reader.next_frame(&mut bytes).expect("a whole PNG");
    Picture { width: info.width, height: info.height, pixels: bytes.as_chunks().0.to_vec() }
}

/// Mean, 99th percentile and largest error of the checked-in pairs, as tests/flip_reference.py has them from the
/// published tool.
///
/// Both sum in f32: two passes of 21 terms, each rounded to 2⁻²⁵ of its sum, leave some √42 · 2⁻²⁵ ≈ 2·10⁻⁷ of a
/// channel. Errors follow colours by at most 0.95 for 1/25 of the range (0.4 of the largest difference to the power
/// 1/0.7, in lightness), and features' roots are steeper where pictures are nearly equal, but then errors are near 0:
/// together some 5·10⁻⁶, and the tool's figures are rounded to 10⁻⁶. What was agreed is 10⁻³ in the mean.
#[test]
fn agrees_with_the_published_tool() {
    let figures = fs::read(root().join("tests/flip/figures.json")).expect("the tool's figures");
    let figures: serde_json::Value = serde_json::from_slice(&figures).expect("JSON");
    let pairs = figures["pairs"].as_object().expect("pairs");
    assert_eq!(pairs.len(), 5);
    for (name, wanted) in pairs {
        let map = flip(&read(&format!("{name}_reference.png")), &read(&format!("{name}_test.png")), PIXELS_PER_DEGREE)
            .expect("of one size");
        for (figure, got) in
            [("mean", map.mean()), ("p99", f64::from(map.percentile(0.99))), ("largest", f64::from(map.largest()))]
        {
            let wanted = wanted[figure].as_f64().expect("a number");
            assert!((got - wanted).abs() < 1e-5, "{name}: {figure} {got}, the tool says {wanted}");
        }
    }
}

/// A picture of `colors` at random.
fn speckled(seed: u64, width: u32, height: u32, colors: &[[u8; 3]]) -> Picture {
    let pixel = |i: u32| {
        let [r, g, b] = colors[draw(seed, 1, i, 0)[0] as usize % colors.len()];
        [r, g, b, 255]
    };
    Picture { width, height, pixels: (0..width * height).map(pixel).collect() }
}

fn even(width: u32, height: u32, [r, g, b]: [u8; 3]) -> Picture {
    Picture { width, height, pixels: vec![[r, g, b, 255]; (width * height) as usize] }
}

/// Each pixel against sums over squares in f64.
///
/// Roundings leave some √42 · 2⁻²⁵ ≈ 2·10⁻⁷ of luminance. Where a feature really is 0, its root turns that into 4.5·10⁻⁴,
/// by which the exponent of c^(1 − f) is off: the error by at most 4.5·10⁻⁴ · |c ln c| ≤ 4.5·10⁻⁴/e = 1.7·10⁻⁴.
#[test]
fn is_what_the_paper_says() {
    let wild: Vec<[u8; 3]> =
        (0..40).map(|i| draw(3, 2, i, 0)).map(|[r, g, b, _]| [r as u8, g as u8, b as u8]).collect();
    let primary = [[255, 0, 0], [0, 255, 0], [0, 0, 255], [255, 255, 255], [0, 0, 0]];
    let soft = [[120, 130, 140], [121, 131, 139], [122, 132, 145]];
    let pair = |a, b, width, height| [speckled(1, width, height, a), speckled(2, width, height, b)];
    for (name, [reference, test], pixels_per_degree) in [
        ("wild", pair(&wild, &wild, 37, 29), PIXELS_PER_DEGREE),
        ("primaries", pair(&primary, &primary, 33, 20), PIXELS_PER_DEGREE),
        ("soft", pair(&soft, &soft, 16, 31), PIXELS_PER_DEGREE),
        ("against black", pair(&wild, &primary[4..], 20, 20), PIXELS_PER_DEGREE),
        ("one pixel", pair(&primary[..1], &primary[1..2], 1, 1), PIXELS_PER_DEGREE),
        ("one row", pair(&wild, &soft, 90, 1), PIXELS_PER_DEGREE),
        ("one column", pair(&wild, &soft, 1, 90), PIXELS_PER_DEGREE),
        ("more than a band", pair(&wild, &soft, 18, 150), 30.0),
        ("near", pair(&wild, &soft, 40, 30), 10.0),
        ("far", pair(&wild, &soft, 30, 20), 150.0),
        ("green for blue", [even(9, 9, [0, 255, 0]), even(9, 9, [0, 0, 255])], PIXELS_PER_DEGREE),
    ] {
        let got = flip(&reference, &test, pixels_per_degree).expect("of one size");
        let wanted = flip_plain::flip(&reference, &test, pixels_per_degree);
        assert_eq!(got.values.len(), wanted.len());
        let apart = |(got, wanted): (&f32, &f64)| (f64::from(*got) - wanted).abs();
        let worst = got.values.iter().zip(&wanted).map(apart).fold(0.0, f64::max);
        assert!(worst < 2e-4, "{name}: a pixel is off by {worst}");
    }
}

#[test]
fn ends_of_the_range() {
    let [black, white] = [[0; 3], [255; 3]].map(|color| even(50, 40, color));
    let mean = |a, b, pixels_per_degree| flip(a, b, pixels_per_degree).expect("of one size").mean();
    for pixels_per_degree in [PIXELS_PER_DEGREE, 1.0, 0.0, -3.0, f64::NAN, 1e9] {
        assert_eq!(mean(&white, &white, pixels_per_degree), 0.0, "{pixels_per_degree}");
        // Black and white are 100 steps of lightness apart. Green is (87.73, −75.62, 72.98) and blue (32.30, 25.57, −34.84),
        // which is 55.43 + √(101.19² + 107.82²) = 203.30 apart. (100/203.30)^0.7 = 0.6086 is above the common 0.4: the error
        // is 0.95 + 0.05 · 0.2086/0.6 = 0.96738.
        let apart = mean(&black, &white, pixels_per_degree);
        assert!((apart - 0.96738).abs() < 2e-5, "{pixels_per_degree}: {apart}");
    }
    let none = even(0, 0, [0; 3]);
    assert_eq!(flip(&none, &none, PIXELS_PER_DEGREE).map(|map| map.mean()), Ok(0.0));
    let error = flip(&even(3, 2, [0; 3]), &even(2, 3, [0; 3]), PIXELS_PER_DEGREE).expect_err("sizes differ");
    assert_eq!(error, SizesDiffer { sizes: [[3, 2], [2, 3]] });
    assert!(error.to_string().contains("3 × 2 and 2 × 3"), "{error}");
}

#[test]
fn same_bytes_on_any_number_of_threads() {
    let colors = [[10, 200, 90], [250, 240, 30], [0, 0, 0]];
    let (reference, test) = (speckled(1, 70, 300, &colors), speckled(2, 70, 300, &colors));
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| flip(&reference, &test, PIXELS_PER_DEGREE).expect("of one size"))
    };
    let one = on(1);
    for threads in [2, 3, 7] {
        assert!(on(threads) == one, "{threads} threads");
    }
}
