//! Coverage of the sky against closed forms of solid angles.

use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::{Coverage, coverage};
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::variants::NO_LOCK;
use cloudwright_tests::small_scenes::single_sprites;
use glam::DVec3;

/// An atlas of tiles of one alpha, but for the border of sixteen texels that stays clear at every level.
fn sheet(alpha: u8) -> Atlas {
    let inside = |t: usize| (16..112).contains(&(t % 128));
    let texel = |i: usize| [255, 255, 255, if inside(i % 512) && inside(i / 512) { alpha } else { 0 }];
    Atlas::from_sheet(&(0..512 * 512).map(texel).collect::<Vec<_>>())
}

fn seen(scene: &Scene, atlas: &Atlas, least_elevation_deg: f64) -> Coverage {
    let derived = Derived::new(scene);
    // Sheets as large as the sky would fade as near ones do.
    let rules = Rules { facing: NO_LOCK, ..Rules::SHIPPED };
    coverage(DVec3::ZERO, least_elevation_deg, 128, |camera, size| {
        Frame::new(scene, &derived, atlas, &Sight { rules, ..Sight::still(camera, size) })
    })
}

/// Sprites that face the observer at 100 m, whose inner 3/4 are opaque.
fn faces(directions: &[DVec3], side: f64) -> Scene {
    single_sprites(&directions.iter().map(|direction| (*direction * 100.0, side)).collect::<Vec<_>>())
}

/// A square of side 2h straight before the eye at distance 1 takes 4·asin(h²/(1 + h²)).
fn square(half: f64) -> f64 {
    4.0 * (half * half / (1.0 + half * half)).asin()
}

/// Clear borders are blurred over one texel of a mip level, and pixels are 1/64 wide: edges are within 1/64 of their
/// places, on a square of half-side h at distance 1 within 8h/64, shares of the dome (2π) within h/50.
fn check(name: &str, scene: &Scene, alpha: u8, least_elevation_deg: f64, covered: f64, within: f64) {
    let got = seen(scene, &sheet(alpha), least_elevation_deg);
    assert!((got.covered - covered).abs() <= within, "{name}: {got:?}, not {covered}");
    let hidden = covered * f64::from(alpha) / 255.0;
    assert!((got.hidden - hidden).abs() <= within, "{name}: {got:?}, not {hidden} hidden");
}

#[test]
fn a_square_takes_its_solid_angle() {
    let dome = 2.0 * std::f64::consts::PI;
    let half = 0.375;
    let share = square(half) / dome;
    check("above", &faces(&[DVec3::Y], 100.0), 255, 0.0, share, half / 50.0);
    check("half as opaque", &faces(&[DVec3::Y], 100.0), 128, 0.0, share, half / 50.0);
    check(
        "aslant, over an edge of the cube",
        &faces(&[DVec3::new(1.0, 1.0, 0.0).normalize()], 100.0),
        255,
        0.0,
        share,
        half / 50.0,
    );
    check("half of it above the horizon", &faces(&[DVec3::NEG_Z], 100.0), 255, 0.0, share / 2.0, half / 50.0);
    check("below the horizon", &faces(&[DVec3::new(0.0, -1.0, -0.2).normalize()], 100.0), 255, 0.0, 0.0, 0.0);
    // Above 60° there is (1 − sin 60°) of the dome; the square, up to 28° from the zenith, lies in it.
    let cone = 1.0 - 60.0_f64.to_radians().sin();
    check("of a cone", &faces(&[DVec3::Y], 100.0), 255, 60.0, share / cone, half / 50.0 / cone);
}

#[test]
fn oktas() {
    // Huge sheets at right angles to the west and the east, the first bowed over the zenith's western half: what lies
    // west of the meridian is half of the sky.
    let west = DVec3::new(-1.0, 0.0, 0.0);
    let half = seen(&faces(&[west], 1e6), &sheet(255), 0.0);
    assert!((half.covered - 0.5).abs() < 0.01, "{half:?}");
    assert_eq!(half.oktas(), 4);
    let whole = seen(&faces(&[west, -west, DVec3::Y], 1e6), &sheet(255), 5.0);
    assert_eq!((whole.covered, whole.oktas()), (1.0, 8), "{whole:?}");
    let thin = seen(&faces(&[west], 1e6), &sheet(13), 0.0);
    assert_eq!(thin.oktas(), 4, "cirrus is cloud: {thin:?}");
    assert!((thin.hidden - 0.5 * 13.0 / 255.0).abs() < 0.01, "{thin:?}");
    let haze = seen(&faces(&[west], 1e6), &sheet(5), 0.0);
    assert_eq!(haze.oktas(), 0, "an opacity of 0.02 is not seen: {haze:?}");
    let mut empty = faces(&[west], 1.0);
    empty.clouds.clear();
    assert_eq!(seen(&empty, &sheet(255), 0.0), Coverage::default());
    assert_eq!(Coverage::default().oktas(), 0);
}

/// WMO code table 2700: 0 and 8 are for nothing and all alone.
#[test]
fn rounding() {
    for (covered, oktas) in
        [(0.0, 0), (1e-9, 1), (0.06, 1), (0.18, 1), (0.19, 2), (0.5, 4), (0.93, 7), (0.999, 7), (1.0, 8)]
    {
        assert_eq!(Coverage { covered, hidden: 0.0 }.oktas(), oktas, "{covered}");
    }
}
