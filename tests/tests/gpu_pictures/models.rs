//! Models among the clouds: a board that faces the eye at a known depth has a colour in closed form, and each sprite is
//! blended over it by the share of its depth that lies before the board.

use super::{BACKGROUND, CLOUDS_LARGEST, CLOUDS_MEAN, Outcome, ensure, place};
use cloudwright_core::color::Rgb;
use cloudwright_core::frame::Frame;
use cloudwright_core::model_in_view::{Meshes, ModelInView};
use cloudwright_core::raster::plain;
use cloudwright_render::{Gpu, GpuRenderer};
use cloudwright_tests::boards::{Board, ray};
use cloudwright_tests::gpu::cases;
use glam::{EulerRot, Quat, Vec3};

/// The name of each test and what it checks.
pub const TESTS: [(&str, fn(&Gpu, &mut GpuRenderer) -> Outcome); 5] = [
    ("a_model_before_within_and_behind_clouds", among_clouds),
    ("the_nearer_model_hides_the_farther", nearer_hides),
    ("clouds_alone_know_no_models", clouds_alone),
    ("an_aircraft_around_the_eye_is_drawn", around_the_eye),
    ("an_aircraft_is_drawn_as_by_the_cpu", as_by_the_cpu),
];

/// Gives `check` the frame of the case that looks level to the north, at clouds 1,800 m and 4,300 m away.
fn level_north(check: impl FnOnce(&Frame<'_>) -> Outcome) -> Outcome {
    let all = cases();
    let case = all.iter().find(|case| case.name == "noon_beside").ok_or("there is no such case")?;
    case.with_frame(check)
}

fn among_clouds(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        for depth_m in [400.0, 1750.0, 3000.0, 9000.0] {
            let board = Board::at(depth_m, 0.15);
            let with_board = Frame { models: vec![board.model()], ..frame.clone() };
            let (want, got) = (board.among_clouds(frame), renderer.linear_picture(gpu, &with_board)?);
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
        let board = Board::at(500.0, 0.6);
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
        let aircraft =
            ModelInView { mesh: Meshes::built_in(), from_eye, turn: Quat::IDENTITY, scale: 1.0, sunlit: 1.0 };
        let cockpit = Frame { models: vec![aircraft], ..frame.clone() };
        let (outside, inside) = (renderer.linear_picture(gpu, frame)?, renderer.linear_picture(gpu, &cockpit)?);
        ensure(outside != inside, "nothing of the aircraft shows")?;
        ensure(inside.pixels.iter().all(|pixel| pixel.to_array().iter().all(|c| c.is_finite())), "not a number")
    })
}

/// A GPU moves corners to one in 256 parts of a pixel, so of the pixels through which edges go one in hundreds shows another
/// face; an aircraft that fills a picture of 192 × 128 pixels has some thousands of those.
fn as_by_the_cpu(gpu: &Gpu, renderer: &mut GpuRenderer) -> Outcome {
    level_north(|frame| {
        for (distance_m, scale) in [(14.0, 1.0), (1750.0, 60.0)] {
            let turn = Quat::from_euler(EulerRot::YXZ, 0.7, 0.3, 0.2);
            let (mesh, from_eye) = (Meshes::built_in(), Vec3::new(0.0, -0.5, -distance_m));
            let frame =
                Frame { models: vec![ModelInView { mesh, from_eye, turn, scale, sunlit: 0.6 }], ..frame.clone() };
            let (want, got) = (plain::linear_picture(&frame), renderer.linear_picture(gpu, &frame)?);
            let off = |(want, got): (&Rgb, &Rgb)| {
                let off = want.to_array().into_iter().zip(got.to_array()).map(|(a, b)| (a - b).abs() - BACKGROUND * a);
                off.fold(0.0, f32::max) > CLOUDS_LARGEST
            };
            let count = want.pixels.iter().zip(&got.pixels).filter(|(want, got)| off((want, got))).count();
            ensure(count <= 40, &format!("{count} pixels are off at {distance_m} m"))?;
        }
        Ok(())
    })
}
