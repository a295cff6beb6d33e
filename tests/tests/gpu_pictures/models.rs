//! Models among the clouds: a board that faces the eye at a known depth has a colour in closed form, and each sprite is
//! blended over it by the share of its depth that lies before the board.

use super::{BACKGROUND, CLOUDS_LARGEST, CLOUDS_MEAN, Outcome, ensure, place};
use cloudwright_core::color::{Premultiplied, Rgb};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::model_in_view::{Meshes, ModelInView};
use cloudwright_core::model_mesh::{ModelMesh, ModelVertex};
use cloudwright_core::raster::prepare;
use cloudwright_core::sky::haze_share;
use cloudwright_render::{Gpu, GpuRenderer};
use cloudwright_tests::gpu::cases;
use glam::{Quat, Vec3};
use std::f32::consts::FRAC_PI_2;
use std::sync::Arc;

/// The name of each test and what it checks.
pub const TESTS: [(&str, fn(&Gpu, &mut GpuRenderer) -> Outcome); 4] = [
    ("a_model_before_within_and_behind_clouds", among_clouds),
    ("the_nearer_model_hides_the_farther", nearer_hides),
    ("clouds_alone_know_no_models", clouds_alone),
    ("an_aircraft_around_the_eye_is_drawn", around_the_eye),
];

/// Of the sky's light, what comes to a face that looks level: half-way between that to the top and the ground's 0.45
/// (models.wgsl).
const SKY_TO_A_WALL: f32 = 0.725;

/// A board whose front looks south, to a camera that looks north.
#[derive(Clone, Copy)]
struct Board {
    depth_m: f32,
    half_side_m: f32,
    color: Rgb,
}

impl Board {
    /// A square metre that lies flat, made larger and set upright by the model's place.
    fn model(&self) -> ModelInView {
        let corner = |x, z| ModelVertex { position: Vec3::new(x, 0.0, z), normal: Vec3::Y, color: self.color };
        let [a, b, c, d] = [corner(-0.5, 0.5), corner(0.5, 0.5), corner(0.5, -0.5), corner(-0.5, -0.5)];
        ModelInView {
            mesh: Arc::new(ModelMesh::new(vec![a, b, c, a, c, d])),
            from_eye: Vec3::NEG_Z * self.depth_m,
            turn: Quat::from_rotation_x(FRAC_PI_2),
            scale: 2.0 * self.half_side_m,
        }
    }

    /// How far within the board the ray meets its plane, metres; outside if negative.
    fn within(&self, ray: Vec3) -> f32 {
        self.half_side_m - (ray * self.depth_m).truncate().abs().max_element()
    }

    fn shows(&self, frame: &Frame<'_>, ray: Vec3) -> Rgb {
        let (light, point) = (&frame.now.light, ray * self.depth_m);
        let sun = light.directional_max * light.sun_direction.dot(Vec3::Z).max(0.0);
        let lit = self.color * (sun + light.ambient_max.rgb * SKY_TO_A_WALL);
        let hazed = haze_share(point.length(), frame.background.haze_length_m);
        lit.mix(frame.background.dome.horizon(point), hazed)
    }
}

const BOARD: Board = Board { depth_m: 0.0, half_side_m: 0.0, color: Rgb::new(0.6, 0.3, 0.1) };

/// Gives `check` the frame of the case that looks level to the north, at clouds 1,800 m and 4,300 m away.
fn level_north(check: impl FnOnce(&Frame<'_>) -> Outcome) -> Outcome {
    let all = cases();
    let case = all.iter().find(|case| case.name == "noon_beside").ok_or("there is no such case")?;
    case.with_frame(check)
}

fn among_clouds(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        for depth_m in [400.0, 1750.0, 3000.0, 9000.0] {
            let board = Board { depth_m, half_side_m: 0.15 * depth_m, ..BOARD };
            let with_board = Frame { models: vec![board.model()], ..frame.clone() };
            let (want, got) = (wanted(frame, board), renderer.linear_picture(gpu, &with_board)?);
            let (mut sum, mut count) = (0.0, 0);
            for (i, (want, got)) in want.pixels.iter().zip(&got.pixels).enumerate() {
                let edge = 1.5 * frame.view.pixel() * depth_m;
                if board.within(ray(frame, i)).abs() < edge {
                    continue;
                }
                for (want, got) in want.to_array().into_iter().zip(got.to_array()) {
                    let off = (want - got).abs();
                    (sum, count) = (sum + off, count + 1);
                    let close = off <= CLOUDS_LARGEST + BACKGROUND * want;
                    ensure(close, &format!("at {depth_m} m, pixel {:?}: {got} for {want}", place(frame, i)))?;
                }
            }
            let mean = sum / count as f32;
            ensure(mean <= CLOUDS_MEAN, &format!("at {depth_m} m: off by {mean} in the mean"))?;
        }
        Ok(())
    })
}

/// Sky and board, and over them the sprites: each for itself, back to front.
fn wanted(frame: &Frame<'_>, board: Board) -> LinearPicture {
    let (width, height) = (frame.view.width, frame.view.height);
    let footprint = frame.view.pixel();
    let behind = |i: usize| {
        let ray = ray(frame, i);
        let on_board = board.within(ray) > 0.0;
        if on_board { board.shows(frame, ray) } else { frame.background.color(ray, footprint) }
    };
    let mut pixels: Vec<Rgb> = (0..(width * height) as usize).map(behind).collect();
    for (drawn, shown) in frame.list.sprites.iter().zip(prepare(frame)) {
        let sprite = &frame.clouds[drawn.cloud as usize].sprites[drawn.sprite as usize];
        let half_depth = 0.5 * sprite.width.min(sprite.height);
        for (i, pixel) in pixels.iter_mut().enumerate() {
            let [x, y] = place(frame, i).map(|place| place as f32 + 0.5);
            let Some((fragment, depth)) = shown.fragment(frame.atlas, x, y, |_| shown.mip) else { continue };
            let on_board = board.within(ray(frame, i)) > 0.0;
            let share = if on_board { (0.5 + 0.5 * (board.depth_m - depth) / half_depth).clamp(0.0, 1.0) } else { 1.0 };
            let Premultiplied { r, g, b, a } = fragment;
            *pixel = Premultiplied { r: r * share, g: g * share, b: b * share, a: a * share }.over(*pixel);
        }
    }
    LinearPicture { width, height, pixels }
}

fn ray(frame: &Frame<'_>, i: usize) -> Vec3 {
    let [x, y] = place(frame, i);
    frame.view.ray(x as f32 + 0.5, y as f32 + 0.5)
}

/// In either order, and a metre apart at a kilometre.
fn nearer_hides(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        let near = Board { depth_m: 999.0, half_side_m: 100.0, color: Rgb::new(0.1, 0.7, 0.2) };
        let far = Board { depth_m: 1000.0, half_side_m: 200.0, color: Rgb::new(0.8, 0.1, 0.1) };
        let mut seen = Vec::new();
        for boards in [[near, far], [far, near]] {
            let both = Frame { models: boards.map(|board| board.model()).to_vec(), ..frame.clone() };
            seen.push(renderer.linear_picture(gpu, &both)?);
        }
        ensure(seen[0] == seen[1], "the order of models shows")?;
        let edge = 2.0 * frame.view.pixel() * far.depth_m;
        for (i, got) in seen[0].pixels.iter().enumerate() {
            let (in_near, in_far) = (near.within(ray(frame, i)), far.within(ray(frame, i)));
            if in_near > edge {
                ensure(got.g > got.r, &format!("the farther shows at {:?}", place(frame, i)))?;
            } else if in_near < -edge && in_far > edge {
                ensure(got.r > got.g, &format!("nothing shows at {:?}", place(frame, i)))?;
            }
        }
        Ok(())
    })
}

fn clouds_alone(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        let board = Board { depth_m: 500.0, half_side_m: 300.0, ..BOARD };
        let with_board = Frame { models: vec![board.model()], ..frame.clone() };
        let [without, with] = [renderer.clouds(gpu, frame)?, renderer.clouds(gpu, &with_board)?];
        ensure(without == with, "a model left a mark on the clouds")?;
        ensure(!renderer.sprites_pass_time(gpu, &with_board)?.duration.is_zero(), "no time")
    })
}

/// The eye in the pilot's seat: triangles before, behind and through the near plane.
fn around_the_eye(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        let from_eye = Vec3::new(0.3, -0.35, 0.1);
        let aircraft = ModelInView { mesh: Meshes::built_in(), from_eye, turn: Quat::IDENTITY, scale: 1.0 };
        let cockpit = Frame { models: vec![aircraft], ..frame.clone() };
        let (outside, inside) = (renderer.linear_picture(gpu, frame)?, renderer.linear_picture(gpu, &cockpit)?);
        ensure(outside != inside, "nothing of the aircraft shows")?;
        ensure(inside.pixels.iter().all(|pixel| pixel.to_array().iter().all(|c| c.is_finite())), "not a number")
    })
}
