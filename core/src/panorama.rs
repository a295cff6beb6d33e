//! All that an eye sees around it: six sides of a cube, and a map of latitude and longitude that is made of them.
//!
//! Each side is an ordinary picture of 90°. What would tell one from the next where they meet is shared by all
//! ([`View::of_panorama`]): by which up sprites straight above and below the eye are turned, and how fine their tiles
//! are. The map samples the sides, which are drawn a little beyond their edges for that.

use crate::camera::View;
use crate::color::Rgb;
use crate::image::LinearPicture;
use crate::scene::Camera;
use glam::Vec3;
use rayon::prelude::*;

/// Where a side of the cube lies.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// +x.
    East,
    /// −x.
    West,
    /// +y; south is at its top, as for a camera that looks north and then up.
    Up,
    /// −y; north is at its top.
    Down,
    /// +z.
    South,
    /// −z.
    North,
}

impl Side {
    /// In the order of the axes, the positive one first.
    pub const ALL: [Self; 6] = [Self::East, Self::West, Self::Up, Self::Down, Self::South, Self::North];

    /// In files' names.
    pub fn name(self) -> &'static str {
        match self {
            Self::East => "east",
            Self::West => "west",
            Self::Up => "up",
            Self::Down => "down",
            Self::South => "south",
            Self::North => "north",
        }
    }

    /// `camera`, turned to this side.
    pub fn camera(self, camera: &Camera) -> Camera {
        let (heading_deg, pitch_deg) = match self {
            Self::East => (90.0, 0.0),
            Self::West => (270.0, 0.0),
            Self::Up => (0.0, 90.0),
            Self::Down => (0.0, -90.0),
            Self::South => (180.0, 0.0),
            Self::North => (0.0, 0.0),
        };
        Camera { heading_deg, pitch_deg, roll_deg: 0.0, field_of_view_deg: 90.0, ..camera.clone() }
    }
}

/// One picture of a panorama.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Facet {
    /// Which way it looks.
    pub side: Side,
    /// How many pixels of the picture lie beyond the side, at each of its edges.
    pub margin: u32,
}

impl Facet {
    /// What is seen from where `camera` is in a square of `size` pixels, margins included, and `scale` pixels for each of
    /// them.
    pub fn view(self, camera: &Camera, size: u32, scale: u32) -> View {
        let inner = size.saturating_sub(2 * self.margin).max(1);
        let turned = View::new(&self.side.camera(camera), size * scale, size * scale);
        View { tan_half_height: size as f32 / inner as f32, of_panorama: Some(View::new(camera, 1, 1).up), ..turned }
    }
}

/// Pixels that a map's sides are drawn beyond their edges: what lies between two pixels is known at the edge too.
const MARGIN: u32 = 2;
/// A pixel of the map is the mean of as many samples each way.
const SAMPLES: usize = 2;

/// Six sides with their margins.
#[derive(Debug, Clone)]
pub struct Surroundings {
    sides: Vec<(View, LinearPicture)>,
}

impl Surroundings {
    /// For a map `width` pixels wide: `draw` draws each facet, a square of so many pixels, seen from where `camera` is.
    ///
    /// # Errors
    /// Those of `draw`.
    pub fn for_map<E>(
        width: u32,
        camera: &Camera,
        mut draw: impl FnMut(Facet, u32) -> Result<LinearPicture, E>,
    ) -> Result<Self, E> {
        let size = Self::side_of_map(width);
        let side = |side| {
            let facet = Facet { side, margin: MARGIN };
            Ok((facet.view(camera, size, 1), draw(facet, size)?))
        };
        Ok(Self { sides: Side::ALL.into_iter().map(side).collect::<Result<_, E>>()? })
    }

    /// How large the sides for such a map are, pixels: in the middle of one they are a little finer than the map.
    pub fn side_of_map(width: u32) -> u32 {
        (width / 2).max(1) + 2 * MARGIN
    }

    /// What is seen in a `direction` (any length but 0).
    pub fn color(&self, direction: Vec3) -> Rgb {
        let direction = direction.normalize();
        let ahead = |(view, _): &&(View, LinearPicture)| view.depth(direction);
        let side = self.sides.iter().max_by(|a, b| ahead(a).total_cmp(&ahead(b)));
        let found = side.and_then(|(view, picture)| Some((picture, view.project(direction)?)));
        found.map_or(Rgb::BLACK, |(picture, at)| between_pixels(picture, at.x - 0.5, at.y - 0.5))
    }

    /// The map, half as high as it is `width`, as OpenEXR has it: south (+z) in the middle, east (+x) a quarter to the
    /// left, straight up at the top.
    pub fn map(&self, width: u32) -> LinearPicture {
        let (width, height) = (width.max(2), (width / 2).max(1));
        let samples = |length: u32| -> Vec<f32> {
            let count = length as usize * SAMPLES;
            (0..count).map(|i| (i as f32 + 0.5) / count as f32).collect()
        };
        let sin_cos = |angle: f32| (libm::sinf(angle), libm::cosf(angle));
        let turn = std::f32::consts::TAU;
        let longitudes: Vec<_> = samples(width).into_iter().map(|u| sin_cos(turn * (0.5 - u))).collect();
        let latitudes: Vec<_> = samples(height).into_iter().map(|v| sin_cos(0.5 * turn * (0.5 - v))).collect();
        let row = |latitudes: &[(f32, f32)]| -> Vec<Rgb> {
            let pixel = |longitudes: &[(f32, f32)]| {
                let mut sum = Rgb::BLACK;
                for (up, level) in latitudes {
                    for (sin, cos) in longitudes {
                        sum = sum + self.color(Vec3::new(sin * level, *up, cos * level));
                    }
                }
                sum * (1.0 / (SAMPLES * SAMPLES) as f32)
            };
            longitudes.chunks(SAMPLES).map(pixel).collect()
        };
        let pixels = latitudes.par_chunks(SAMPLES).flat_map_iter(row).collect();
        LinearPicture { width, height, pixels }
    }
}

/// Linear between the four pixels around (x, y), which counts from the middle of the first.
fn between_pixels(picture: &LinearPicture, x: f32, y: f32) -> Rgb {
    let place = |t: f32, length: u32| {
        let t = t.clamp(0.0, (length - 1) as f32);
        let before = (t as u32).min(length.saturating_sub(2));
        (before, t - before as f32)
    };
    let ((column, across), (row, down)) = (place(x, picture.width), place(y, picture.height));
    let at = |x: u32, y: u32| {
        let (x, y) = (x.min(picture.width - 1), y.min(picture.height - 1));
        picture.pixels[(y * picture.width + x) as usize]
    };
    let line = |row| at(column, row).mix(at(column + 1, row), across);
    line(row).mix(line(row + 1), down)
}
