//! The sky's dome and the sun's disc.

use super::NightSky;
use crate::color::Rgb;
use crate::math::smoothstep;
use glam::Vec3;
use hw_skymodel::rgb::{SkyParams, SkyState};

/// The model's radiance times this is the scene's unit at sky gain 1: noon's blue then lies beside a white cloud.
const SCENE_UNIT: f32 = 0.045;
/// Sine of the elevation that the dome's formulas are given at the horizon, where they have an edge; from there they come
/// to the true one smoothly.
pub const HORIZON_SINE: f32 = 0.03;
/// Share of the sky's radiance that is kept at the sun itself, and the cosine of the angle from it, 55°, from which it
/// begins to be less than all.
pub const GLOW_KEPT: f32 = 0.60;
/// See [`GLOW_KEPT`].
pub const GLOW_FROM_COSINE: f32 = 0.573_576;
/// Cosines of the angle from the sun's middle between which its disc fades out (0.30° and 0.24°).
pub const SUN_DISC_COSINES: [f32; 2] = [0.999_986_3, 0.999_991_2];
/// The disc's radiance in units of the directional light, of a high sun and at sunset. The true ratio would be some 10⁴, of
/// which a display shows white; a low sun is dim enough to be seen red.
const SUN_DISC_GAIN: f32 = 40.0;
const LOW_SUN_DISC: Rgb = Rgb::new(3.2, 1.9, 0.8);
/// Sine of the elevation, 10°, from which it is a high one's.
const HIGH_SUN_SINE: f32 = 0.173_648;

/// Sky and sun at one moment.
#[derive(Debug, Clone, PartialEq)]
pub struct Dome {
    /// The model's nine parameters A to I, for red, green and blue.
    pub parameters: [[f32; 9]; 3],
    /// Scales the distribution, with grade, twilight and gain.
    pub scale: Rgb,
    /// From the eye to the sun, unit; as the lights have it, also below the horizon.
    pub sun_direction: Vec3,
    /// Radiance of the sun's disc; black below the horizon.
    pub sun_disc: Rgb,
    /// Where the distribution has its peak: the sun, or the horizon below which it set.
    pub glow_direction: Vec3,
    /// What the night adds; none by day.
    pub night: Option<NightSky>,
}

impl Dome {
    /// The sky, without a night, over ground of reflectance `albedo`. `turbidity` and `albedo` are clamped to the model's
    /// ranges, 1 to 10 and 0 to 1.
    pub fn new(sun_direction: Vec3, turbidity: f32, albedo: Rgb, gain: f32, directional_max: Rgb) -> Self {
        let elevation_deg = libm::asinf(sun_direction.y.clamp(-1.0, 1.0)).to_degrees();
        let params = SkyParams {
            elevation: elevation_deg.clamp(LOWEST_DEG, 90.0).to_radians().min(std::f32::consts::FRAC_PI_2),
            turbidity: if turbidity.is_finite() { turbidity.clamp(1.0, 10.0) } else { 2.5 },
            albedo: albedo.to_array().map(|a| if a.is_finite() { a.clamp(0.0, 1.0) } else { 0.0 }),
        };
        // The parameters are within the model's ranges by now; black is the answer should it think otherwise.
        let (parameters, radiances) = SkyState::new(&params).map(|state| state.raw()).unwrap_or(([0.0; 27], [0.0; 3]));
        let scale = Rgb::new(radiances[0], radiances[1], radiances[2]) * grade(elevation_deg) * twilight(elevation_deg);
        let level = Vec3::new(sun_direction.x, sun_direction.y.max(0.0), sun_direction.z);
        Self {
            parameters: std::array::from_fn(|c| std::array::from_fn(|i| parameters[9 * c + i])),
            scale: scale * (SCENE_UNIT * gain),
            sun_direction,
            sun_disc: directional_max * disc_gain(sun_direction.y),
            glow_direction: crate::math::unit_or(level, Vec3::Y),
            night: None,
        }
    }

    /// Radiance of sky and sun in a unit `direction`, without what lights the night holds. Below the horizon it stays what it
    /// is there.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        let disc = smoothstep(SUN_DISC_COSINES[0], SUN_DISC_COSINES[1], cosine_between(direction, self.sun_direction));
        self.sky(direction) + self.sun_disc * disc
    }

    /// Radiance of the sky at the horizon below or above `direction` (any length): what haze turns things to, so that far
    /// ground meets the sky without a line.
    pub fn horizon(&self, direction: Vec3) -> Rgb {
        self.sky(Vec3::new(direction.x, 0.0, direction.z))
    }

    /// Mean radiance of the sky above the horizon, without the sun's disc: of 512 directions even over the half sphere, on a
    /// spiral of the golden angle.
    pub fn mean_above_horizon(&self) -> Rgb {
        const LOOKS: u32 = 512;
        let look = |i: u32| {
            let (up, turn) = ((f64::from(i) + 0.5) / f64::from(LOOKS), f64::from(i) * 2.399_963_229_728_653);
            let level = (1.0 - up * up).sqrt();
            self.sky(Vec3::new((libm::cos(turn) * level) as f32, up as f32, (libm::sin(turn) * level) as f32))
        };
        (0..LOOKS).map(look).fold(Rgb::BLACK, |sum, color| sum + color) * (1.0 / LOOKS as f32)
    }

    /// The sky alone.
    fn sky(&self, direction: Vec3) -> Rgb {
        let (cos_theta, cos_gamma) = self.angles(direction);
        self.distribution(cos_theta, cos_gamma)
    }

    fn distribution(&self, cos_theta: f32, cos_gamma: f32) -> Rgb {
        let gamma = libm::acosf(cos_gamma);
        let channel = |c: usize| {
            let p = &self.parameters[c];
            around_zenith(p, cos_theta) * (around_sun(p, gamma, cos_gamma) + p[7] * cos_theta.sqrt())
        };
        let day = self.scale * glow_kept(cos_gamma) * Rgb::new(channel(0), channel(1), channel(2));
        self.with_night(day, cos_theta)
    }

    /// The air's own glow joins the day's.
    fn with_night(&self, day: Rgb, cos_theta: f32) -> Rgb {
        self.night.map_or(day, |night| day + night.glow(cos_theta))
    }

    /// Cosines of the angles from the zenith and from the sun, for a direction lifted from the horizon.
    fn angles(&self, direction: Vec3) -> (f32, f32) {
        let up = lifted(direction.y);
        let level = Vec3::new(direction.x, 0.0, direction.z);
        let lifted = crate::math::unit_or(level, Vec3::X) * (1.0 - up * up).max(0.0).sqrt() + Vec3::Y * up;
        (up, lifted.dot(self.glow_direction).clamp(-1.0, 1.0))
    }
}

/// Of the angle between two unit vectors. The plain dot product of nearly equal ones has no bits left for a disc half a
/// degree wide.
fn cosine_between(a: Vec3, b: Vec3) -> f32 {
    1.0 - 0.5 * (a - b).length_squared()
}

/// The sine of an elevation, kept from the formulas' edge at the horizon by a soft maximum: a hard one shows as a line. Below
/// the horizon, of which the formulas know nothing, it stays.
fn lifted(sine: f32) -> f32 {
    let sine = sine.max(0.0);
    (0.5 * (sine + (sine * sine + 4.0 * HORIZON_SINE * HORIZON_SINE).sqrt())).min(1.0)
}

/// What the sun's disc has of the directional light, by the sine of its elevation.
fn disc_gain(sine: f32) -> Rgb {
    let high = smoothstep(0.0, HIGH_SUN_SINE, sine);
    LOW_SUN_DISC.mix(Rgb::grey(SUN_DISC_GAIN), high * high) * smoothstep(-0.005, 0.005, sine)
}

/// How much of the model is kept around the sun: less over the third of a picture that it would have brighter than white,
/// where a camera would close its iris; the same share within some 20°, so that the sky rises towards the sun.
fn glow_kept(cos_gamma: f32) -> f32 {
    let near = ((cos_gamma - GLOW_FROM_COSINE) / (1.0 - GLOW_FROM_COSINE)).max(0.0);
    let rest = 1.0 - near * near;
    1.0 - (1.0 - GLOW_KEPT) * (1.0 - rest * rest)
}

/// 1 + A·exp(B / (cos θ + 0.01)).
fn around_zenith(p: &[f32; 9], cos_theta: f32) -> f32 {
    1.0 + p[0] * libm::expf(p[1] / (cos_theta + 0.01))
}

/// C + D·exp(E γ) + F·cos² γ + G·χ(γ): all that depends on the angle from the sun.
fn around_sun(p: &[f32; 9], gamma: f32, cos_gamma: f32) -> f32 {
    let cos2 = cos_gamma * cos_gamma;
    let base = 1.0 + p[8] * p[8] - 2.0 * p[8] * cos_gamma;
    p[2] + p[3] * libm::expf(p[4] * gamma) + p[5] * cos2 + p[6] * (1.0 + cos2) / (base * base.sqrt())
}

/// Arc cosine within 7·10⁻⁵ rad (Abramowitz and Stegun, 4.4.45): branch-free, for a whole picture.
fn acos_near(x: f32) -> f32 {
    let a = x.abs();
    let near = (1.0 - a).max(0.0).sqrt() * (1.570_728_8 + a * (-0.212_114_4 + a * (0.074_261_0 + a * -0.018_729_3)));
    if x < 0.0 { std::f32::consts::PI - near } else { near }
}

/// The sun's elevation in degrees, and what the model's red, green and blue are multiplied with there.
///
/// The model's data leave out ozone, whose Chappuis band takes yellow and green out of long paths, so its low sun is
/// brown and its dusk green. And its sky falls by a factor of five from noon to dusk where an artist's tables, and a
/// camera's exposure, fall by two. Chosen by eye against photographs of clear evenings.
const GRADE: [(f32, Rgb); 4] = [
    (2.5, Rgb::new(1.30, 1.42, 2.90)),
    (8.0, Rgb::new(1.05, 1.12, 1.75)),
    (20.0, Rgb::new(1.06, 1.08, 1.22)),
    (45.0, Rgb::new(1.08, 1.00, 0.97)),
];
/// The lowest sun whose sky is taken from the model.
const LOWEST_DEG: f32 = GRADE[0].0;

fn grade(elevation_deg: f32) -> Rgb {
    let above = GRADE.iter().position(|(key, _)| *key > elevation_deg);
    match above {
        Some(0) => GRADE[0].1,
        None => GRADE[GRADE.len() - 1].1,
        Some(i) => {
            let ((from, a), (to, b)) = (GRADE[i - 1], GRADE[i]);
            a.mix(b, (elevation_deg - from) / (to - from))
        }
    }
}

/// What is left of the last sky when the sun is lower: half at sunset, a twelfth by the end of civil twilight (−6°), ever
/// bluer, until the night's own glow outshines it at some −12°. In truth it falls far faster, and an eye that grows used to the
/// dark with it; an artist's tables fall as this does.
fn twilight(elevation_deg: f32) -> Rgb {
    let light = libm::expf(0.28 * (elevation_deg - LOWEST_DEG).min(0.0) + 0.02 * elevation_deg.min(0.0));
    let blue = smoothstep(0.0, 8.0, -elevation_deg);
    Rgb::grey(1.0).mix(Rgb::new(0.50, 0.72, 1.15), blue) * light
}

/// The dome's formulas in two tables, for a picture on the CPU: the radiance is a product of a part that depends on
/// the elevation and a sum that depends on the angle from the sun, so nothing is lost but the tables' step.
#[derive(Debug, Clone)]
pub struct DomeTables {
    dome: Dome,
    /// `around_zenith` and `p[7]·√cos θ` over √cos θ.
    elevation: Vec<[Rgb; 2]>,
    /// `around_sun` over γ/π.
    sun_angle: Vec<Rgb>,
}

impl DomeTables {
    const STEPS: usize = 1024;

    /// The tables for a dome.
    pub fn new(dome: &Dome) -> Self {
        let channels = |f: &dyn Fn(&[f32; 9]) -> f32| {
            Rgb::new(f(&dome.parameters[0]), f(&dome.parameters[1]), f(&dome.parameters[2]))
        };
        let at = |i: usize| i as f32 / Self::STEPS as f32;
        let elevation = (0..=Self::STEPS + 1).map(|i| {
            let root = at(i);
            let scaled = dome.scale * channels(&|p| around_zenith(p, root * root));
            [scaled, channels(&|p| p[7] * root)]
        });
        let sun_angle = (0..=Self::STEPS + 1).map(|i| {
            let gamma = at(i).min(1.0) * std::f32::consts::PI;
            channels(&|p| around_sun(p, gamma, libm::cosf(gamma)))
        });
        Self { dome: dome.clone(), elevation: elevation.collect(), sun_angle: sun_angle.collect() }
    }

    /// As [`Dome::radiance`], within 0.2 %.
    pub fn radiance(&self, direction: Vec3) -> Rgb {
        let cos_sun = cosine_between(direction, self.dome.sun_direction);
        let sky = self.sky(direction);
        if cos_sun < SUN_DISC_COSINES[0] {
            return sky;
        }
        sky + self.dome.sun_disc * smoothstep(SUN_DISC_COSINES[0], SUN_DISC_COSINES[1], cos_sun)
    }

    /// As [`Dome::horizon`], within 0.2 %.
    pub fn horizon(&self, direction: Vec3) -> Rgb {
        self.sky(Vec3::new(direction.x, 0.0, direction.z))
    }

    fn sky(&self, direction: Vec3) -> Rgb {
        let (cos_theta, cos_gamma) = self.dome.angles(direction);
        self.distribution(cos_theta, cos_gamma)
    }

    fn distribution(&self, cos_theta: f32, cos_gamma: f32) -> Rgb {
        let split = |x: f32| {
            let step = x * Self::STEPS as f32;
            (step as usize, step - (step as usize) as f32)
        };
        let (i, t) = split(cos_theta.sqrt());
        let (from, to) = (&self.elevation[i], &self.elevation[i + 1]);
        let (j, s) = split(acos_near(cos_gamma) * std::f32::consts::FRAC_1_PI);
        let sun = self.sun_angle[j].mix(self.sun_angle[j + 1], s);
        let day = from[0].mix(to[0], t) * glow_kept(cos_gamma) * (sun + from[1].mix(to[1], t));
        self.dome.with_night(day, cos_theta)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dome(elevation_deg: f32) -> Dome {
        let e = elevation_deg.to_radians();
        Dome::new(Vec3::new(0.0, e.sin(), -e.cos()), 2.5, Rgb::grey(0.1), 1.0, Rgb::grey(0.6))
    }

    #[test]
    fn tables_hold_the_formulas() {
        for elevation_deg in [-4.0, 0.0, 3.0, 20.0, 60.0, 90.0] {
            let dome = dome(elevation_deg);
            let tables = DomeTables::new(&dome);
            for i in 0..2000_u32 {
                let [x, y, z, _] = crate::random::draw(1, 2, i, 0).map(|b| crate::random::unit(b) as f32 * 2.0 - 1.0);
                let direction = Vec3::new(x, y, z).normalize();
                let (exact, fast) = (dome.radiance(direction), tables.radiance(direction));
                for (e, f) in exact.to_array().into_iter().zip(fast.to_array()) {
                    // Linear interpolation over 1/1024 of functions whose second derivative stays below some 10³ of
                    // their value: h²/8 · 10³ ≈ 10⁻⁴; 0.2 % covers the steepest part at the horizon.
                    assert!((e - f).abs() <= 0.002 * e.abs() + 1e-5, "{elevation_deg}° {direction}: {e} {f}");
                }
            }
        }
    }

    /// Towards the sun the sky gets brighter all the way, at any hour.
    #[test]
    fn the_sky_rises_towards_the_sun() {
        for elevation_deg in [2.5_f32, 8.0, 15.0, 28.0, 45.0] {
            let dome = dome(elevation_deg);
            // Upwards from the sun.
            let at = |away_deg: f32| {
                let up = (elevation_deg + away_deg).to_radians();
                dome.sky(Vec3::new(0.0, up.sin(), -up.cos())).luminance()
            };
            for step in 1..60 {
                let away = 0.5 * step as f32;
                assert!(at(away) < at(away - 0.5), "{elevation_deg}°, {away}° away: {} {}", at(away), at(away - 0.5));
            }
        }
    }

    /// Far ground turns to the colour that the sky has at the horizon, and the sky has no edge there.
    #[test]
    fn ground_and_sky_meet_without_a_line() {
        let dome = dome(3.0);
        for azimuth_deg in [0.0_f32, 5.0, 40.0, 180.0] {
            let (sin, cos) = azimuth_deg.to_radians().sin_cos();
            let at = |up: f32| dome.sky(Vec3::new(sin, up, -cos).normalize()).g;
            let ground = dome.horizon(Vec3::new(sin, -0.2, -cos)).g;
            assert!((ground / at(0.0) - 1.0).abs() < 1e-5, "{azimuth_deg}°: {ground}");
            for step in 1..60 {
                let up = step as f32 * 0.002;
                let bend = at(up + 0.002) + at(up - 0.002) - 2.0 * at(up);
                assert!(bend.abs() < 0.004 * at(up), "{azimuth_deg}°, sine {up}: {bend} of {}", at(up));
            }
        }
    }

    #[test]
    fn agrees_with_the_crates_own_evaluation() {
        let params = SkyParams { elevation: 0.5, turbidity: 2.5, albedo: [0.1; 3] };
        let state = SkyState::new(&params).expect("in range");
        let dome = dome(0.5_f32.to_degrees());
        let direction = Vec3::new(0.9, 0.6, 0.4).normalize();
        let theirs =
            state.radiance(direction.y.acos(), direction.dot(dome.sun_direction).acos(), hw_skymodel::rgb::Channel::G);
        let ours = dome.radiance(direction).g / SCENE_UNIT / grade(0.5_f32.to_degrees()).g;
        // At so great an elevation the soft maximum lifts by its least: h²/sin, a thousandth.
        assert!((ours / theirs - 1.0).abs() < 5e-3, "{ours} {theirs}");
    }

    #[test]
    fn no_seam_at_sunset_and_no_nan_at_any_elevation() {
        for tenth in -900..=900_i32 {
            let radiance = dome(tenth as f32 * 0.1).radiance(Vec3::new(0.0, 0.1, -1.0).normalize());
            assert!(radiance.to_array().iter().all(|c| c.is_finite() && *c >= 0.0), "{tenth}");
        }
    }
}
