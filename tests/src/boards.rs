//! A board that faces the eye at a known depth: what it shows has a closed form, and so has how sprites are blended over
//! it.

use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::model_in_view::ModelInView;
use cloudwright_core::model_mesh::{ModelMesh, ModelVertex};
use cloudwright_core::raster::prepare;
use cloudwright_core::sky::haze_share;
use glam::{Quat, Vec3};
use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

/// Of the sky's light, what comes to a face that looks level: half-way between that to the top and the ground's 0.45
/// (core/src/raster/models/, models.wgsl).
const SKY_TO_A_WALL: f32 = 0.725;

/// A square board whose front looks south, to a camera that looks level to the north, in the middle of the picture.
#[derive(Debug, Clone, Copy)]
pub struct Board {
    /// From the eye, metres.
    pub depth_m: f32,
    /// Metres.
    pub half_side_m: f32,
    /// The share of the light that it gives back.
    pub color: Rgb,
}

impl Board {
    /// One whose sides fill `share` of 2 at distance 1.
    pub fn at(depth_m: f32, share: f32) -> Self {
        Self { depth_m, half_side_m: share * depth_m, color: Rgb::new(0.6, 0.3, 0.1) }
    }

    /// A square metre that lies flat, made larger and set upright by the model's place.
    pub fn model(&self) -> ModelInView {
        let corner = |x, z| ModelVertex { position: Vec3::new(x, 0.0, z), normal: Vec3::Y, color: self.color };
        let [a, b, c, d] = [corner(-0.5, 0.5), corner(0.5, 0.5), corner(0.5, -0.5), corner(-0.5, -0.5)];
        ModelInView {
            mesh: Arc::new(ModelMesh::new(vec![a, b, c, a, c, d])),
            from_eye: Vec3::NEG_Z * self.depth_m,
            turn: Quat::from_rotation_x(FRAC_PI_2),
            scale: 2.0 * self.half_side_m,
            sunlit: 1.0,
        }
    }

    /// How far within the board the ray meets its plane, metres; outside if negative.
    pub fn within(&self, ray: Vec3) -> f32 {
        self.half_side_m - (ray * self.depth_m).truncate().abs().max_element()
    }

    /// Its colour along a ray.
    pub fn shows(&self, frame: &Frame<'_>, ray: Vec3) -> Rgb {
        let (light, point) = (&frame.now.light, ray * self.depth_m);
        let sun = light.directional_max * light.direction.dot(Vec3::Z).max(0.0);
        let lit = self.color * (sun + light.ambient_max.rgb * SKY_TO_A_WALL);
        let hazed = haze_share(point.length(), frame.background.haze_length_m);
        lit.mix(frame.background.dome.horizon(point), hazed)
    }

    /// Sky, ground and board, and over them the sprites: each for itself, back to front.
    pub fn among_clouds(&self, frame: &Frame<'_>) -> LinearPicture {
        let (width, height) = (frame.view.width, frame.view.height);
        let (footprint, background) = (frame.view.pixel(), frame.behind());
        let behind = |i: usize| {
            let ray = ray(frame, i);
            let on_board = self.within(ray) > 0.0;
            if on_board { self.shows(frame, ray) } else { background.color(ray, footprint) }
        };
        let mut pixels: Vec<Rgb> = (0..(width * height) as usize).map(behind).collect();
        for (drawn, shown) in frame.list.sprites.iter().zip(prepare(frame)) {
            let sprite = &frame.clouds[drawn.cloud as usize].sprites[drawn.sprite as usize];
            let half_depth = 0.5 * sprite.width.min(sprite.height);
            for (i, pixel) in pixels.iter_mut().enumerate() {
                let [x, y] = place(frame, i).map(|place| place as f32 + 0.5);
                let Some((fragment, depth)) = shown.fragment(frame.atlas, x, y, |_| shown.mip) else { continue };
                let before = (0.5 + 0.5 * (self.depth_m - depth) / half_depth).clamp(0.0, 1.0);
                let share = if self.within(ray(frame, i)) > 0.0 { before } else { 1.0 };
                let Premultiplied { r, g, b, a } = fragment;
                *pixel = Premultiplied { r: r * share, g: g * share, b: b * share, a: a * share }.over(*pixel);
            }
        }
        LinearPicture { width, height, pixels }
    }
}

/// Column and row of a picture's pixel.
pub fn place(frame: &Frame<'_>, i: usize) -> [u32; 2] {
    [i as u32 % frame.view.width, i as u32 / frame.view.width]
}

/// The ray through the middle of a picture's pixel.
pub fn ray(frame: &Frame<'_>, i: usize) -> Vec3 {
    let [x, y] = place(frame, i);
    frame.view.ray(x as f32 + 0.5, y as f32 + 0.5)
}
