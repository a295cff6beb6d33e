//! The colours of error maps.

use cloudwright::chart::heat::{color, picture};

/// Entries of matplotlib's table, times 255 and rounded; the way between two of ours misses it by 3 at most.
#[test]
fn colors_are_those_of_magma() {
    for (entry, want) in [
        (0, [0, 0, 4]),
        (7, [3, 3, 15]),
        (22, [17, 12, 47]),
        (67, [86, 20, 125]),
        (100, [137, 40, 129]),
        (128, [183, 55, 121]),
        (157, [227, 78, 101]),
        (200, [253, 152, 105]),
        (232, [254, 211, 149]),
        (247, [252, 238, 176]),
        (255, [252, 253, 191]),
    ] {
        let got = color(entry as f32 / 255.0);
        assert!(got.iter().zip(&want).all(|(a, b): (&u8, &u8)| a.abs_diff(*b) <= 3), "{entry}: {got:?}, not {want:?}");
    }
}

#[test]
fn maps_of_any_numbers() {
    let (none, worst) = ([0, 0, 4, 255], [252, 253, 191, 255]);
    let check = |errors: &[f32], brightest, want: &[[u8; 4]]| {
        assert_eq!(picture([2, 2], errors, brightest).pixels, want, "{errors:?} up to {brightest}");
    };
    check(&[0.0, 0.5, 1.0, f32::NAN], 0.5, &[none, worst, worst, worst]);
    check(&[-1.0, f32::INFINITY], 1.0, &[none, worst, none, none]);
    check(&[0.5, 0.5, 0.5, 0.5, 0.5], 0.5, &[worst; 4]);
    check(&[0.0; 4], 0.0, &[none; 4]);
}
