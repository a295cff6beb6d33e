//! How much of the sky clouds hide, as an observer sees it from below: in oktas, as weather reports say it.
//!
//! The upper half of a cube around the observer is drawn, clouds alone, and each pixel weighs by the solid angle that
//! it takes. A low wall of clouds hides more than a map of it would show; that is what an observer sees and reports
//! too (WMO-No. 8, *Guide to Instruments*, part I, chapter 15).
//!
//! Two shares are measured. *Covered* is where a cloud can be seen at all: an observer counts thin cirrus as cloud
//! whatever shines through. An eye tells cloud from sky down to an optical depth of some 0.03 (Sassen, Griffin, Dodd
//! 1989), which is an opacity of 0.03. Oktas are counted of it. *Hidden* is the opacity's own mean, the share of the
//! sky's light that does not get through: what a model of light would ask for.

use crate::frame::Frame;
use crate::raster::fast::clouds;
use crate::rules::Blending;
use crate::scene::Camera;
use glam::DVec3;

/// From this opacity on a cloud can be told from the sky.
pub const VISIBLE_OPACITY: f32 = 0.03;

/// What clouds take of the sky, as seen from one place.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Coverage {
    /// Share of the sky, by solid angle, where clouds are at least [`VISIBLE_OPACITY`] opaque; 0 to 1.
    pub covered: f64,
    /// Mean opacity over the sky's solid angle; 0 to 1.
    pub hidden: f64,
}

impl Coverage {
    /// Eighths of the sky covered, 0 to 8, as the WMO rounds them (code table 2700): 0 only if there is no cloud at all,
    /// 8 only if there is no gap.
    pub fn oktas(&self) -> u8 {
        if self.covered <= 0.0 {
            0
        } else if self.covered >= 1.0 {
            8
        } else {
            libm::round(self.covered * 8.0).clamp(1.0, 7.0) as u8
        }
    }
}

/// Measures the sky over `observer` (metres in the world) from `least_elevation_deg` above the horizon on: 0 for the
/// whole dome, more where a scene's clouds end before the horizon. Above 89° counts as 89°, below 0° as 0°.
///
/// `frame` makes the frame that a camera sees in a size of pixels; each face of the cube is `face_px` pixels wide
/// (taken into 8 to 4,096).
pub fn coverage<'a>(
    observer: DVec3,
    least_elevation_deg: f64,
    face_px: u32,
    frame: impl Fn(&Camera, [u32; 2]) -> Frame<'a>,
) -> Coverage {
    let side = face_px.clamp(8, 4096);
    let least_sine = libm::sin(least_elevation_deg.clamp(0.0, 89.0).to_radians()) as f32;
    let (mut covered, mut hidden, mut sky) = (0.0, 0.0, 0.0);
    for (heading_deg, pitch_deg) in [(0.0, 90.0), (0.0, 0.0), (90.0, 0.0), (180.0, 0.0), (270.0, 0.0)] {
        let camera = Camera { heading_deg, pitch_deg, field_of_view_deg: 90.0, ..Camera::free(observer) };
        let frame = frame(&camera, [side, side]);
        for (pixel, i) in clouds(&frame, Blending::AS_PLAIN).pixels.iter().zip(0_u32..) {
            let ray = frame.view.ray((i % side) as f32 + 0.5, (i / side) as f32 + 0.5);
            let distance = ray.length();
            // The rays end on a plane at distance 1, seen at a slant: d²ω = d²A cos/distance² = d²A/distance³.
            let solid_angle = f64::from(1.0 / (distance * distance * distance));
            if ray.y <= least_sine * distance {
                continue;
            }
            sky += solid_angle;
            hidden += solid_angle * f64::from(pixel.a);
            if pixel.a >= VISIBLE_OPACITY {
                covered += solid_angle;
            }
        }
    }
    // The sums are of the same parts, so nothing and all come out as 0 and 1.
    if sky > 0.0 { Coverage { covered: covered / sky, hidden: hidden / sky } } else { Coverage::default() }
}
