//! The background for a whole picture on the CPU.
//!
//! The sky changes slowly, so it is evaluated at nodes up to 1.7° apart and interpolated between; near the sun
//! and moon, and across the horizon, at every pixel. Stars are found once a view and added where they are. The ground's
//! noise runs over a row at a time in loops without branches.
//! [`Background::color`] is the oracle.

use super::dome::{DomeTables, HORIZON_SINE};
use super::stars::{STARS, Spot, Star};
use super::{Background, GroundLook, haze_share};
use crate::camera::View;
use crate::color::Rgb;
use crate::math::unit_or;
use crate::tone::Planes;
use glam::Vec3;

/// Pixels between nodes.
const STEP: usize = 16;
/// The most pixels that a call may ask for.
pub const MOST: usize = 32;
/// Nodes farther apart than this, radians, would miss the sky's curvature.
const COARSEST_STEP: f32 = 0.03;
/// Sine of the elevation below which the azimuth changes too fast from node to node.
const STEEP_SINE: f32 = -0.95;
/// Within this angle of the sun, radians, its glow has a point.
const SUN_GLOW: f32 = 0.06;
/// And within this of the moon.
const MOON_GLOW: f32 = 0.2;

/// [`Background`] for the pixels of one view.
#[derive(Debug, Clone)]
pub struct BackgroundRows<'a> {
    background: &'a Background,
    dome: DomeTables,
    view: View,
    /// The stars that show in each [`MOST`] rows of the picture.
    stars: Vec<Vec<InPicture>>,
}

/// A star and the pixels within which its spot lies, the ends too.
#[derive(Debug, Clone, Copy)]
struct InPicture {
    star: Star,
    columns: [f32; 2],
    rows: [f32; 2],
}

impl<'a> BackgroundRows<'a> {
    /// For one view.
    pub fn new(background: &'a Background, view: &View) -> Self {
        let mut stars = vec![Vec::new(); view.height.div_ceil(MOST as u32) as usize];
        for star in stars_in_picture(background, view) {
            let band = |row: f32| row as usize / MOST;
            for stars in stars.iter_mut().take(band(star.rows[1]) + 1).skip(band(star.rows[0])) {
                stars.push(star);
            }
        }
        Self { background, dome: DomeTables::new(&background.dome), view: *view, stars }
    }

    /// What lies behind the clouds at the centres of `count` pixels (at most 32) from (`left`, `y`) to the right,
    /// into the first places of `out`; within 0.5 % of [`Background::color`].
    pub fn row(&self, left: u32, y: u32, count: usize, out: &mut Planes<MOST>) {
        let count = count.clamp(1, MOST);
        let direction = |x: usize| self.view.ray((left as usize + x) as f32 + 0.5, y as f32 + 0.5).normalize();
        let (first, last) = (direction(0), direction(count - 1));
        // A row of pixels is a straight line before the eye, so what lies between its ends lies between their heights.
        let (lowest, highest) = (first.y.min(last.y), first.y.max(last.y));
        match &self.background.ground {
            _ if self.view.pixel() * STEP as f32 > COARSEST_STEP => self.exact(&direction, count, out),
            Some(ground) if highest < -1e-4 => self.ground(ground, left, y, &direction, out),
            _ if lowest < 3.0 * HORIZON_SINE => self.exact(&direction, count, out),
            _ => self.sky(&direction, count, out),
        }
        self.add_stars(left, y, count, out);
    }

    fn add_stars(&self, left: u32, y: u32, count: usize, out: &mut Planes<MOST>) {
        let Some(night) = self.background.dome.night else { return };
        let (row, first, last) = (y as f32, left as f32, left as f32 + count as f32 - 1.0);
        for InPicture { star, columns, rows } in self.stars.get(y as usize / MOST).into_iter().flatten() {
            if row < rows[0] || row > rows[1] {
                continue;
            }
            let (mut x, end) = (columns[0].max(first), columns[1].min(last));
            while x <= end {
                let direction = self.view.ray(x + 0.5, row + 0.5).normalize();
                let light = night.star(star, direction, self.view.pixel()).to_array();
                out.iter_mut().zip(light).for_each(|(plane, channel)| plane[x as usize - left as usize] += channel);
                x += 1.0;
            }
        }
    }

    /// Whether the ground lies at the centre of pixel (`x`, `y`).
    pub fn is_ground(&self, x: u32, y: u32) -> bool {
        let direction = || self.view.ray(x as f32 + 0.5, y as f32 + 0.5).normalize();
        self.background.ground.as_ref().is_some_and(|ground| ground.distance(direction()).is_some())
    }

    /// Pixel by pixel.
    fn exact(&self, direction: &impl Fn(usize) -> Vec3, count: usize, out: &mut Planes<MOST>) {
        for x in 0..count {
            let direction = direction(x);
            let ground = self.background.ground.as_ref();
            let color = match ground.and_then(|ground| Some((ground, ground.distance(direction)?))) {
                None => self.above(direction),
                Some((ground, distance)) => {
                    let pixel_m = ground.pixel_m(direction, distance, self.view.pixel());
                    let color = ground.color(direction * distance, pixel_m);
                    color.mix(self.dome.horizon(direction), haze_share(distance, self.background.haze_length_m))
                }
            };
            for (plane, channel) in out.iter_mut().zip(color.to_array()) {
                plane[x] = channel;
            }
        }
    }

    fn sky(&self, direction: &impl Fn(usize) -> Vec3, count: usize, out: &mut Planes<MOST>) {
        if self.is_near_sun(direction(count / 2)) || self.is_near_moon(direction(count / 2)) {
            return self.exact(direction, count, out);
        }
        between_nodes(out, |x| self.above(direction(x)));
    }

    /// The sky, sun and moon.
    fn above(&self, direction: Vec3) -> Rgb {
        let sky = self.dome.radiance(direction);
        self.background.dome.night.map_or(sky, |night| sky + night.moon(direction, self.view.pixel()))
    }

    fn is_near_moon(&self, middle: Vec3) -> bool {
        let closest = MOST as f32 * self.view.pixel() + MOON_GLOW;
        let moon = self.background.dome.night.filter(|night| night.moon > 0.0);
        moon.is_some_and(|night| middle.distance(night.moon_direction) < closest)
    }

    /// Whether a row of pixels around `middle` may hold the sun, or the sky's peak, where it set.
    fn is_near_sun(&self, middle: Vec3) -> bool {
        let dome = &self.background.dome;
        let closest = libm::cosf((MOST as f32 * self.view.pixel() + SUN_GLOW).min(3.0));
        middle.dot(dome.sun_direction) > closest || middle.dot(dome.glow_direction) > closest
    }

    /// Whether what lies behind `count` pixels from (`left`, `y`) to the right is so bright that it shows through where
    /// hardly anything gets through.
    pub fn dazzles(&self, left: u32, y: u32, count: usize) -> bool {
        self.is_near_sun(self.view.ray((left as usize + count / 2) as f32 + 0.5, y as f32 + 0.5).normalize())
    }

    fn ground(
        &self,
        ground: &GroundLook,
        left: u32,
        y: u32,
        direction: &impl Fn(usize) -> Vec3,
        out: &mut Planes<MOST>,
    ) {
        let middle = direction(MOST / 2);
        let above_it = unit_or(Vec3 { y: 0.0, ..middle }, Vec3::X);
        if direction(0).y.min(direction(MOST - 1).y) < STEEP_SINE || self.is_near_sun(above_it) {
            // Straight below the horizon's colour turns with every pixel, and under a low sun it has its peak.
            for x in 0..MOST {
                let color = self.dome.horizon(direction(x)).to_array();
                out.iter_mut().zip(color).for_each(|(plane, channel)| plane[x] = channel);
            }
        } else {
            between_nodes(out, |x| self.dome.horizon(direction(x)));
        }
        let first = self.view.ray(left as f32 + 0.5, y as f32 + 0.5);
        let step = self.view.right * self.view.pixel();
        let row = GroundRow {
            ground,
            first,
            step,
            footprint: self.view.pixel(),
            haze_length_m: self.background.haze_length_m,
        };
        let [brightness, hazed, sunlit] = row.draw();
        let colors =
            ground.dark.to_array().into_iter().zip(ground.bright.to_array()).zip(ground.without_sun.to_array());
        for (plane, ((dark, bright), without_sun)) in out.iter_mut().zip(colors) {
            for x in 0..MOST {
                let color = (dark + brightness[x] * (bright - dark)) * (1.0 + (sunlit[x] - 1.0) * (1.0 - without_sun));
                plane[x] = color + hazed[x] * (plane[x] - color);
            }
        }
    }
}

/// Those whose spots may lie within a view.
fn stars_in_picture(background: &Background, view: &View) -> Vec<InPicture> {
    let Some(night) = background.dome.night.filter(|night| night.stars > 0.0) else { return Vec::new() };
    let (width, height, pixel) = (view.width as f32, view.height as f32, view.pixel());
    let world_from_celestial = night.celestial_from_world.transpose();
    let place = |star: &Star| {
        let direction = world_from_celestial * star.direction;
        let depth = direction.dot(view.forward);
        // At an angle from the middle whose cosine is the depth, a spot is 1/depth² as wide.
        let reach = Spot::new(pixel).radius / (pixel * depth * depth) * 1.1 + 1.0;
        let x = 0.5 * width + direction.dot(view.right) / (depth * pixel);
        let y = 0.5 * height - direction.dot(view.up) / (depth * pixel);
        let within = depth > 0.05 && x > -reach && x < width + reach && y > -reach && y < height + reach;
        let span = |at: f32, end: f32| [(at - reach).floor().max(0.0), (at + reach).ceil().min(end - 1.0)];
        let up = direction.y > -2.0 * Spot::new(pixel).radius;
        (within && up).then(|| InPicture { star: *star, columns: span(x, width), rows: span(y, height) })
    };
    STARS.iter().filter_map(place).collect()
}

/// `value` at every [`STEP`]-th place and linear between.
fn between_nodes(out: &mut Planes<MOST>, value: impl Fn(usize) -> Rgb) {
    let nodes: [[f32; 3]; MOST / STEP + 1] = std::array::from_fn(|node| value(node * STEP).to_array());
    for (c, plane) in out.iter_mut().enumerate() {
        for (node, part) in plane.as_chunks_mut::<STEP>().0.iter_mut().enumerate() {
            let (from, to) = (nodes[node][c], nodes[node + 1][c]);
            for (i, pixel) in part.iter_mut().enumerate() {
                *pixel = from + (to - from) * (i as f32 / STEP as f32);
            }
        }
    }
}

/// A row of pixels that all show the ground.
struct GroundRow<'a> {
    ground: &'a GroundLook,
    /// Ray through the first pixel, and its change a pixel to the right.
    first: Vec3,
    step: Vec3,
    footprint: f32,
    haze_length_m: f32,
}

impl GroundRow<'_> {
    /// The ground's brightness, how far it is hazed, and what reaches it of the directional light, at 32 pixels.
    fn draw(&self) -> [[f32; MOST]; 3] {
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the one instruction set that the function needs was just found.
            #[allow(unsafe_code)]
            return unsafe { self.draw_avx2() };
        }
        self.draw_lanes()
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn draw_avx2(&self) -> [[f32; MOST]; 3] {
        self.draw_lanes()
    }

    /// Written for the compiler to run in lanes: no branch, no call.
    #[inline(always)]
    #[allow(clippy::needless_range_loop)] // four arrays under one index: what the compiler runs in lanes
    fn draw_lanes(&self) -> [[f32; MOST]; 3] {
        let [mut x, mut z, mut pixel_m, mut hazed] = [[0.0; MOST]; 4];
        for i in 0..MOST {
            let along = i as f32;
            let ray_x = self.first.x + along * self.step.x;
            let ray_y = self.first.y + along * self.step.y;
            let ray_z = self.first.z + along * self.step.z;
            // Beyond the row's end a ray may miss the ground; what comes of it is not used.
            let down = (-ray_y).max(1e-9);
            let length = (ray_x * ray_x + ray_y * ray_y + ray_z * ray_z).sqrt();
            let t = self.ground.eye_height / down;
            x[i] = ray_x * t;
            z[i] = ray_z * t;
            pixel_m[i] = t * length * self.footprint * length / down;
            hazed[i] = haze_share(t * length, self.haze_length_m);
        }
        let mut sunlit = [1.0; MOST];
        if let Some(shadow) = &self.ground.shadow {
            for i in 0..MOST {
                sunlit[i] = shadow.reaches(x[i], z[i]);
            }
        }
        [self.ground.brightnesses(x, z, pixel_m), hazed, sunlit]
    }
}
