//! Models on the CPU: boards against their closed form, real meshes fast against plain.

use cloudwright_core::color::Rgb;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::method;
use cloudwright_core::model_in_view::{Meshes, ModelInView};
use cloudwright_core::raster::models::plain::PlacedModels;
use cloudwright_core::raster::{fast, plain, truth};
use cloudwright_core::rules::{Blending, Rasterizer, Rules};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_tests::boards::{Board, place, ray};
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::{DVec3, Quat, Vec3};

const SIZE: [u32; 2] = [215, 120];

/// A frame of `scene` from its camera, level to the north, with these models, by `rules`.
fn among<T>(scene: &Scene, models: Vec<ModelInView>, rules: Rules, check: impl FnOnce(&Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    let camera = Camera { heading_deg: 0.0, pitch_deg: 0.0, ..scene.cameras[0].clone() };
    let sight = Sight { rules, ..Sight::still(&camera, SIZE) };
    let frame = Frame::new(scene, &derived, Atlas::built_in(), &sight);
    check(&Frame { models, ..frame })
}

fn apart(a: Rgb, b: Rgb) -> f32 {
    let apart = |(a, b): (f32, f32)| if (a - b).is_nan() { f32::INFINITY } else { (a - b).abs() };
    a.to_array().into_iter().zip(b.to_array()).map(apart).fold(0.0, f32::max)
}

fn largest(got: &LinearPicture, wanted: &LinearPicture, counts: impl Fn(usize) -> bool) -> f32 {
    let pixels = got.pixels.iter().zip(&wanted.pixels).enumerate().filter(|(i, _)| counts(*i));
    pixels.map(|(_, (got, wanted))| apart(*got, *wanted)).fold(0.0, f32::max)
}

/// Clouds' bound in raster.rs, and the sky between nodes, 0.5 % of the brightest there is, about 2.
const FAST_IS_PLAIN: f32 = 2e-3 + 1e-2;

/// Before, within and behind a cloud 900 m away, and far behind it. The rays through its edge are left out.
#[test]
fn a_board_has_its_closed_form() {
    let scene = heap(40);
    for depth_m in [400.0, 850.0, 900.0, 960.0, 3000.0] {
        let board = Board::at(depth_m, 0.2);
        among(&scene, vec![board.model()], Rules::SHIPPED, |frame| {
            let wanted = board.among_clouds(frame);
            let edge = 1.0 * frame.view.pixel() * depth_m;
            let counts = |i: usize| board.within(ray(frame, i)).abs() > edge;
            let drawn = [
                ("plain", plain::linear_picture(frame), 1e-4),
                ("fast", fast::linear_picture_by(frame, Blending::AS_PLAIN), FAST_IS_PLAIN),
                ("one by one", fast::linear_picture_one_by_one(frame, Blending::AS_PLAIN), 1e-2),
            ];
            for (name, drawn, most) in drawn {
                let apart = largest(&drawn, &wanted, counts);
                assert!(apart <= most, "{name} at {depth_m} m: {apart}");
            }
            let without = plain::linear_picture(&Frame { models: Vec::new(), ..frame.clone() });
            assert!(largest(&without, &wanted, counts) > 0.02, "at {depth_m} m the board shows");
        });
    }
}

/// Where a sprite of one alpha meets a board, every renderer shows as much of it as lies before the board.
#[test]
fn a_sprite_shows_as_far_as_it_lies_before_a_model() {
    let (depth, half) = (100.0_f32, 30.0_f32);
    let scene = single_sprites(&[(DVec3::new(0.0, 0.0, -f64::from(depth)), f64::from(2.0 * half))]);
    let by = |rasterizer| Rules { rasterizer, samples_side: 1, ..Rules::SHIPPED };
    let renderers = [
        (by(Rasterizer::Plain), 1e-4),
        (by(Rasterizer::Fast(Blending::AS_PLAIN)), 2e-3),
        // What it blends has other mip levels by a hair, and 8 bits.
        (by(Rasterizer::Truth), 4e-2),
        (by(Rasterizer::EightBits), 4e-2),
    ];
    for (rules, most) in renderers {
        for behind in [-0.9_f32, -0.5, 0.0, 0.5, 0.9, 2.0] {
            let board = Board::at(depth + behind * half, 0.4);
            let (alone, with) = among(&scene, vec![board.model()], rules, |frame| {
                let drawn = draw::drawn(frame, &Watch::default()).expect("on the CPU");
                let clouds = draw::drawn(&Frame { models: Vec::new(), ..frame.clone() }, &Watch::default());
                let alone = clouds.expect("on the CPU").clouds;
                assert_eq!(drawn.clouds, alone, "{rules:?}: clouds alone know no models");
                (alone.unwrap_or_else(|| plain::clouds(frame)), drawn.linear)
            });
            among(&scene, vec![board.model()], rules, |frame| {
                let middle = (SIZE[1] / 2 * SIZE[0] + SIZE[0] / 2) as usize;
                let cloud = alone.pixels[middle];
                assert!(cloud.a > 0.3, "there is a cloud: {}", cloud.a);
                let share = (0.5 + 0.5 * behind).clamp(0.0, 1.0);
                let wanted = (cloud * share).over(board.shows(frame, ray(frame, middle)));
                let apart = apart(with.pixels[middle], wanted);
                assert!(apart <= most, "{:?}, {behind} behind: off by {apart}", rules.rasterizer);
            });
        }
    }
}

/// The aircraft that ships, beside, within and around the eye, in any attitude, and two of them in either order.
#[test]
fn meshes_fast_are_meshes_plain() {
    let aircraft = |from_eye: [f32; 3], turn: [f32; 3], scale: f32| ModelInView {
        mesh: Meshes::built_in(),
        from_eye: Vec3::from_array(from_eye),
        turn: Quat::from_euler(glam::EulerRot::YXZ, turn[0], turn[1], turn[2]),
        scale,
        sunlit: 1.0,
    };
    let near = aircraft([2.0, -1.0, -25.0], [0.6, 0.2, 0.4], 1.0);
    let cases = [
        ("near", vec![near.clone()]),
        ("far and tiny", vec![aircraft([300.0, 80.0, -2500.0], [2.0, 0.0, 0.0], 4.0)]),
        ("within the cloud", vec![aircraft([0.0, 10.0, -900.0], [1.0, 0.3, 0.0], 12.0)]),
        ("around the eye", vec![aircraft([0.3, -0.35, 0.1], [0.0; 3], 1.0)]),
        ("at the picture's edge", vec![aircraft([-16.0, 4.0, -22.0], [4.0, 1.0, 2.0], 1.0)]),
        ("through the near plane", vec![aircraft([0.0, 0.0, -0.1], [1.5, 0.1, 0.0], 1.0)]),
        ("behind the eye", vec![aircraft([0.0, 0.0, 30.0], [0.0; 3], 1.0)]),
        ("two", vec![near.clone(), aircraft([0.0, 0.0, -40.0], [1.0, 0.0, 0.0], 2.0)]),
        ("two, the other first", vec![aircraft([0.0, 0.0, -40.0], [1.0, 0.0, 0.0], 2.0), near]),
        ("flat as a sheet", vec![aircraft([0.0, 0.0, -20.0], [0.0; 3], 0.0)]),
    ];
    let scene = heap(20);
    for (name, models) in cases {
        among(&scene, models, Rules::SHIPPED, |frame| {
            let (fast, plain) = (fast::linear_picture_by(frame, Blending::AS_PLAIN), plain::linear_picture(frame));
            let off = fast.pixels.iter().zip(&plain.pixels).filter(|(a, b)| apart(**a, **b) > FAST_IS_PLAIN).count();
            // A ray in 32 bits may pass an edge on the other side: of rays through edges one in thousands.
            assert!(off <= 3, "{name}: {off} pixels are off");
            let placed = PlacedModels::new(frame);
            let shown = (0..fast.pixels.len()).filter(|i| {
                let [x, y] = place(frame, *i).map(|place| place as f32 + 0.5);
                placed.nearest(x, y).is_some()
            });
            let is_seen = !["behind the eye", "flat as a sheet"].contains(&name);
            assert_eq!(shown.count() > 0, is_seen, "{name}");
        });
    }
}

/// The truth's samples fill a pixel as far as the board does.
#[test]
fn the_truth_smooths_edges() {
    let mut scene = heap(1);
    scene.clouds.clear();
    let board = Board::at(500.0, 0.2);
    among(&scene, vec![board.model()], method::truth().rules, |frame| {
        let drawn = truth::linear_picture(frame, 4, &Watch::default());
        // The board's right edge, in the picture's middle row.
        let edge = 0.2 / frame.view.pixel() + 0.5 * frame.view.width as f32;
        let at = (frame.view.height / 2 * frame.view.width + edge as u32) as usize;
        let (board, sky) = (board.shows(frame, ray(frame, at - 1)), drawn.pixels[at + 1]);
        let filled = (drawn.pixels[at].b - sky.b) / (board.b - sky.b);
        // Four columns of samples: each stands for a quarter.
        assert!((filled - edge.fract()).abs() <= 0.125 + 0.01, "{filled} of the pixel, not {}", edge.fract());
        assert!(apart(drawn.pixels[at - 1], board) < 0.01);
    });
}

#[test]
fn same_bytes_on_any_number_of_threads() {
    let scene = heap(20);
    let board = Board::at(900.0, 0.1);
    let aircraft = ModelInView {
        mesh: Meshes::built_in(),
        from_eye: Vec3::new(0.0, 0.0, -20.0),
        turn: Quat::IDENTITY,
        scale: 1.0,
        sunlit: 1.0,
    };
    let draw = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| among(&scene, vec![board.model(), aircraft.clone()], Rules::SHIPPED, fast::picture))
    };
    let one = draw(1);
    for threads in [2, 3, 7] {
        assert!(draw(threads) == one, "{threads} threads");
    }
}
