//! What a pixel shows of a texture is blurred by the pixel's own square, and by no more.

use cloudwright_core::method::{Method, named};
use cloudwright_core::scene::Camera;
use cloudwright_tests::suite::studio::{ahead, half_atlas, plates, studio};
use cloudwright_tests::suite::{Look, ROUNDING, Stage};
use glam::DVec3;
use std::borrow::Cow;

/// So many that the levels are whole: 8 texels are 1/√3 of a pixel, 2 are 1/√3 of the truth's samples.
const TEXELS_A_PIXEL: f64 = 8.0 * 1.732_050_807_568_877_2;
const DISTANCE_M: f64 = 200_000.0;
const SIDE_M: f64 = 2000.0;
const PIXEL_M: f64 = TEXELS_A_PIXEL * SIDE_M / 128.0;
const SIZE: [u32; 2] = [9, 3];
/// Places of the edge within a texel of the level, and of a texel within a pixel.
const PHASES: [usize; 2] = [8, 16];

/// Second moment, pixels², of what blurs an upright edge, over all places that it may have.
fn blur(method: &Method) -> f64 {
    let scene = studio(&[plates(1.0, [ahead(DISTANCE_M, SIDE_M, 1.0)])]);
    let field_of_view_deg = 2.0 * (0.5 * f64::from(SIZE[1]) * PIXEL_M / DISTANCE_M).atan().to_degrees();
    let mut sum = 0.0;
    let shifts = || (0..PHASES[1]).map(|phase| phase as f64 / PHASES[1] as f64);
    let camera = |shift: f64| Camera { field_of_view_deg, ..Camera::free(DVec3::X * shift * PIXEL_M) };
    for texel in 0..PHASES[0] {
        let looks = shifts().map(|shift| Look { camera: camera(shift), clock_s: 0.0, drawn: true }).collect();
        let still = Stage::still(scene.clone(), Cow::Owned(half_atlas(64 + texel)), camera(0.0));
        let stage = Stage { size: SIZE, looks, ..still };
        for (shift, drawn) in shifts().zip(stage.draw(&method.rules).expect("on the CPU")) {
            let clouds = drawn.clouds.as_ref().expect("it has opacity");
            let edge = f64::from(SIZE[0]) / 2.0 + texel as f64 / TEXELS_A_PIXEL - shift;
            let middle_row = &clouds.pixels[SIZE[0] as usize..2 * SIZE[0] as usize];
            for (x, pixel) in middle_row.iter().enumerate() {
                let away = x as f64 + 0.5 - edge;
                // Farther off is the plate's own end, and nothing of the edge: all filters are within a pixel and a half.
                if away.abs() < 2.0 {
                    let sharp = if away >= 0.0 { 1.0 } else { 0.0 };
                    sum += 2.0 * away * (sharp - f64::from(pixel.a));
                }
            }
        }
    }
    sum / (PHASES[0] * PHASES[1]) as f64
}

/// A box of width 1 has the second moment 1/12. Sums over places stand for integrals of parabolas: they are off by the
/// square of a step, 1/8 of 1/√3 pixel, at most; roundings add up over the four pixels that an edge touches.
#[test]
fn an_edge_is_blurred_by_a_pixel() {
    let bound = (0.125_f64 / 3.0_f64.sqrt()).powi(2) + 4.0 * 2.0 * 2.0 * ROUNDING;
    for name in ["truth", "fast", "plain"] {
        let blur = blur(named(name).expect("in the table"));
        assert!((blur - 1.0 / 12.0).abs() < bound, "{name}: {blur}");
    }
}

/// The finest level alone has next to no filter of its own.
#[test]
fn the_finest_level_is_not_blurred() {
    let blur = blur(named("no-mips").expect("in the table"));
    assert!(blur < 0.01, "{blur}");
}
