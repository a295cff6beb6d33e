//! The truth against closed forms.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::method;
use cloudwright_core::raster::{fast, prepare, truth};
use cloudwright_core::rules::{HazeRule, Rules};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

fn draw(scene: &Scene, size: [u32; 2], side: u32, atlas: &Atlas) -> LinearPicture {
    let derived = Derived::new(scene);
    let frame = Frame::new(scene, &derived, atlas, &Sight::still(&scene.cameras[0], size));
    truth::linear_picture(&frame, side, &Watch::default())
}

/// An atlas whose tiles have one alpha in the middle half of their sides, and are clear around it: so far from the
/// edge that no level's border takes any.
fn even_atlas(alpha: u8) -> Atlas {
    let inside = |t: usize| (32..96).contains(&(t % 128));
    let texel = |i: usize| [255, 255, 255, if inside(i % 512) && inside(i / 512) { alpha } else { 0 }];
    Atlas::from_sheet(&(0..512 * 512).map(texel).collect::<Vec<_>>())
}

/// Through the middle of n sprites of opacity a, 1 − (1 − a)ⁿ is hidden, whatever their order.
#[test]
fn opacity_of_a_stack() {
    let positions: Vec<(DVec3, f64)> =
        (0..9).map(|i| (DVec3::new(0.0, 0.0, -100.0 - 7.0 * f64::from(i)), 60.0)).collect();
    let mut scene = single_sprites(&positions);
    for level in &mut scene.models[0].color_levels {
        level.color.a = 0.5;
    }
    // Without light and haze, the clouds are black and the picture is the sky times what gets through.
    scene.sky.haze_length_m = 1e9;
    scene
        .sky
        .ambient
        .keys
        .iter_mut()
        .for_each(|key| (key.value.rgb.r, key.value.rgb.g, key.value.rgb.b) = (0.0, 0.0, 0.0));
    scene.sky.directional.keys.iter_mut().for_each(|key| (key.value.r, key.value.g, key.value.b) = (0.0, 0.0, 0.0));
    let size = [65, 65];
    let with = draw(&scene, size, 2, &even_atlas(51));
    scene.clouds.clear();
    let without = draw(&scene, size, 2, &even_atlas(51));
    let middle = 32 * 65 + 32;
    let through = with.pixels[middle].b / without.pixels[middle].b;
    // 51/255 · 0.5 = 0.1 each.
    assert!((through - 0.9_f32.powi(9)).abs() < 1e-4, "{through}");
}

/// Two quads that cross: left of the crossing one is nearer, right of it the other. The truth shows both in front, the
/// fast way also, and only one where it blends whole sprites.
#[test]
fn crossing_sprites_are_ordered_along_each_ray() {
    let mut scene = single_sprites(&[(DVec3::new(-8.0, 0.0, -60.0), 80.0), (DVec3::new(8.0, 0.0, -60.0), 80.0)]);
    // One is white, the other black: their own groups take no and all light.
    scene.models[0].color_levels.iter_mut().for_each(|level| level.color.rgb = Default::default());
    for (cloud_box, c) in scene.models[0].boxes.iter_mut().zip([0.0, 1.0]) {
        (cloud_box.light.c_min, cloud_box.light.c_med, cloud_box.light.c_max) = (c, c, c);
    }
    let size = [101, 101];
    let truth = draw(&scene, size, 1, &even_atlas(255));
    let row = 50 * 101;
    let (left, right) = (truth.pixels[row + 40].g, truth.pixels[row + 60].g);
    assert!((left - right).abs() > 0.3, "left {left}, right {right}");
    let derived = Derived::new(&scene);
    let atlas = even_atlas(255);
    let mut frame = Frame::new(&scene, &derived, &atlas, &Sight::still(&scene.cameras[0], size));
    let fast = fast::linear_picture(&frame);
    for at in [row + 40, row + 60] {
        assert!((fast.pixels[at].g - truth.pixels[at].g).abs() < 0.01, "{} {}", fast.pixels[at].g, truth.pixels[at].g);
    }
    frame.rules = frame.rules.sorted(Sorting::Crossfade);
    let sorted = draw::linear(&frame, &Watch::default()).expect("drawn fast");
    let (left, right) = (sorted.pixels[row + 40].g, sorted.pixels[row + 60].g);
    assert!((left - right).abs() < 0.05, "one order for whole sprites: left {left}, right {right}");
}

/// With one sample a pixel and sprites apart in depth, the sorted renderer is the truth but for its mip level.
#[test]
fn sorted_is_true_where_nothing_crosses() {
    let scene = single_sprites(&[(DVec3::new(-3.0, 1.0, -100.0), 60.0), (DVec3::new(4.0, -2.0, -300.0), 150.0)]);
    let derived = Derived::new(&scene);
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(&scene.cameras[0], [120, 120]));
    let (truth, sorted) = (truth::linear_picture(&frame, 1, &Watch::default()), fast::linear_picture(&frame));
    let worst = truth.pixels.iter().zip(&sorted.pixels).map(|(a, b)| (a.g - b.g).abs()).fold(0.0, f32::max);
    assert!(worst < 0.02, "{worst}");
}

/// A pixel's ray meets a sprite's plane where the projection of the plane's points says.
#[test]
fn texture_coordinates_invert_the_projection() {
    let scene = heap(30);
    let derived = Derived::new(&scene);
    let frame = Frame::new(
        &scene,
        &derived,
        Atlas::built_in(),
        &Sight { moment: Moment::at_hour(12.0), ..Sight::still(&scene.cameras[0], [640, 360]) },
    );
    let view: &View = &frame.view;
    for (drawn, on_screen) in frame.list.sprites.iter().zip(prepare(&frame)) {
        let at = view.project(drawn.center).expect("before the camera") - on_screen.anchor;
        let denominator = on_screen.denominator.at(at.x, at.y);
        let (u, v) = (on_screen.u.at(at.x, at.y) / denominator, on_screen.v.at(at.x, at.y) / denominator);
        assert!((u - 0.5).abs() < 1e-4 && (v - 0.5).abs() < 1e-4, "{u} {v}");
        assert!((on_screen.depth / denominator / view.depth(drawn.center) - 1.0).abs() < 1e-4);
        for (corner, (u_want, v_want)) in
            on_screen.outline.expect("whole").into_iter().zip([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
        {
            let at = corner - on_screen.anchor;
            let denominator = on_screen.denominator.at(at.x, at.y);
            assert!((on_screen.u.at(at.x, at.y) / denominator - u_want).abs() < 1e-3);
            assert!((on_screen.v.at(at.x, at.y) / denominator - v_want).abs() < 1e-3);
        }
    }
}

/// A sprite straight ahead lies across the view, so a ray meets it at its own length times the view depth: the haze there is
/// known, and less of it lies before the middle than before the corners.
#[test]
fn haze_a_fragment_is_that_of_each_ray() {
    let mut scene = single_sprites(&[(DVec3::new(0.0, 0.0, -500.0), 900.0)]);
    scene.sky.inside_density = 0.0;
    let camera = Camera { field_of_view_deg: 80.0, ..scene.cameras[0].clone() };
    let derived = Derived::new(&scene);
    let drawn = |haze, length_m: f32| {
        let rules = Rules { haze, ..method::truth().rules };
        let sight = Sight { rules, ..Sight::still(&camera, [24, 16]) };
        let mut frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
        frame.background.haze_length_m = length_m;
        let (_, clouds) = truth::picture_and_clouds(&frame, 1, &Watch::default());
        (clouds, frame.background.dome.clone(), frame.view)
    };
    let (clear, ..) = drawn(HazeRule::ASprite, 1e12);
    let (hazed, dome, view) = drawn(HazeRule::AFragment, 1000.0);
    let (by_sprite, ..) = drawn(HazeRule::ASprite, 1000.0);
    let mut apart = 0.0_f32;
    for (at, ((clear, got), single)) in clear.pixels.iter().zip(&hazed.pixels).zip(&by_sprite.pixels).enumerate() {
        let ray = view.ray((at % 24) as f32 + 0.5, (at / 24) as f32 + 0.5);
        let share = 1.0 - (-0.5 * ray.length()).exp();
        let horizon = dome.horizon(ray);
        let want = [(clear.r, horizon.r), (clear.g, horizon.g), (clear.b, horizon.b)]
            .map(|(light, horizon)| light * (1.0 - share) + horizon * share * clear.a);
        let got_light = [got.r, got.g, got.b];
        assert!(
            got_light.iter().zip(want).all(|(got, want)| (got - want).abs() < 2e-4) && got.a == clear.a,
            "{at}: {got:?}, not {want:?}"
        );
        apart = apart.max((got.g - single.g).abs());
    }
    assert!(apart > 5e-3, "one haze for all of it is another: {apart}");
}
