//! Counts against counting by hand, and against what the GPU renderer sends.

use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::measure::{Counts, overdraw, overdraw_map};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_render::layout::sprite_constants;
use cloudwright_tests::small_scenes::{heap, single_sprites};
use glam::DVec3;

fn with_frame<T>(scene: &Scene, size: [u32; 2], f: impl FnOnce(&Frame<'_>) -> T) -> T {
    let derived = Derived::new(scene);
    f(&Frame::new(scene, &derived, Atlas::built_in(), &Sight::still(&scene.cameras[0], size)))
}

#[test]
fn counts_of_a_heap() {
    with_frame(&heap(40), [160, 90], |frame| {
        let counts = Counts::of(frame);
        let sprites = frame.list.sprites.len() as u64;
        assert_eq!([counts.sprites, counts.corners_shaded, counts.keys_sorted], [sprites, 4 * sprites, sprites]);
        let by_area = overdraw(frame);
        // Areas are counts within the roundings at edges, which cancel out over many sprites.
        assert!((counts.fragments as f64 / by_area.fragments - 1.0).abs() < 0.01, "{counts:?}, {by_area:?}");
        assert!((counts.overdraw_mean * 160.0 * 90.0 - counts.fragments as f64).abs() < 1e-6 * counts.fragments as f64);
        let mut map = overdraw_map(frame).values;
        map.sort_unstable_by(f32::total_cmp);
        assert_eq!(counts.overdraw_p99, map[map.len() * 99 / 100 - 1]);
    });
}

/// Two sprites, the smaller before the larger, in a picture of one pixel a metre at their distance.
#[test]
fn overdraw_where_sprites_overlap() {
    // 50° high at 107.2253 m is 100 m.
    let distance = 50.0 / 25.0_f64.to_radians().tan();
    let scene = single_sprites(&[(DVec3::NEG_Z * distance, 60.0), (DVec3::NEG_Z * (distance - 1e-3), 20.0)]);
    with_frame(&scene, [200, 100], |frame| {
        let map = overdraw_map(frame);
        let inside = |i: usize, half: usize| (i % 200).abs_diff(100) < half && (i / 200).abs_diff(50) < half;
        for (i, count) in map.values.iter().enumerate() {
            // Only what lies clearly inside or outside: the edges run along the pixels'.
            match (inside(i, 29), inside(i, 32), inside(i, 9), inside(i, 12)) {
                (_, _, true, _) => assert_eq!(*count, 2.0, "{i}"),
                (true, _, _, false) => assert_eq!(*count, 1.0, "{i}"),
                (_, false, ..) => assert_eq!(*count, 0.0, "{i}"),
                _ => {}
            }
        }
        // 400 of 20,000 pixels have two: more than 1 %.
        assert_eq!(Counts::of(frame).overdraw_p99, 2.0);
    });
}

#[test]
fn nothing_to_draw_costs_nothing() {
    let mut scene = heap(40);
    scene.cameras[0] = Camera { heading_deg: 180.0, ..scene.cameras[0].clone() };
    with_frame(&scene, [64, 36], |frame| {
        let counts = Counts::of(frame);
        // Where the cloud is is sent all the same.
        let none = Counts { bytes_uploaded: 96, bytes_of_clouds: counts.bytes_of_clouds, ..Counts::default() };
        assert_eq!(counts, none);
    });
    scene.clouds.clear();
    with_frame(&scene, [64, 36], |frame| assert_eq!(Counts::of(frame), Counts::default()));
}

/// Bytes as the shader's texels say: a texel is four numbers.
#[test]
fn bytes_are_the_renderers() {
    let texel = |name: &str| {
        let constants = sprite_constants();
        let (_, texels) = constants.iter().find(|(each, _)| *each == name).expect("a constant of the shader");
        *texels as u64 * 16
    };
    with_frame(&heap(40), [160, 90], |frame| {
        let counts = Counts::of(frame);
        let cloud = &frame.clouds[0];
        assert_eq!(frame.clouds.len(), 1);
        let poses = frame.list.poses.len() as u64 * texel("POSE_TEXELS");
        let order = counts.sprites * size_of::<[u32; 3]>() as u64;
        assert_eq!(counts.bytes_uploaded, order + poses + texel("MOMENT_TEXELS"));
        let sprites = cloud.sprites.all().len() as u64 * texel("SPRITE_TEXELS");
        let groups = cloud.groups.len() as u64 * texel("GROUP_TEXELS");
        let casters = cloud.sprites.len() as u64 * size_of::<[u32; 3]>() as u64;
        assert_eq!(counts.bytes_of_clouds, sprites + groups + texel("CLOUD_TEXELS") + casters);
    });
}
