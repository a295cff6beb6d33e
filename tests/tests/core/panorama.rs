//! Panoramas: no seam where sides meet, and in every direction what an ordinary camera sees there.

use cloudwright_core::color::{Rgb, srgb_from_linear};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::LinearPicture;
use cloudwright_core::panorama::{Facet, Side, Surroundings};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::tone::tone_curve;
use cloudwright_core::watch::Watch;
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::heap;
use glam::{DVec3, Vec3};

struct Place {
    scene: Scene,
    derived: Derived,
    camera: Camera,
}

impl Place {
    fn new(scene: Scene, camera: Camera) -> Self {
        Self { derived: Derived::new(&scene), scene, camera }
    }

    fn draw(&self, sight: &Sight) -> LinearPicture {
        let frame = Frame::new(&self.scene, &self.derived, Atlas::built_in(), sight);
        draw::linear(&frame, &Watch::default()).expect("drawn fast")
    }

    fn facet(&self, facet: Facet, size: u32) -> LinearPicture {
        self.draw(&Sight { facet: Some(facet), ..Sight::still(&self.camera, [size; 2]) })
    }

    fn around(&self, width: u32) -> Surroundings {
        let draw = |facet, size| Ok::<_, ()>(self.facet(facet, size));
        Surroundings::for_map(width, &self.camera, draw).expect("drawn")
    }
}

/// Under clouds, among them, inside one, and below the middle of one.
fn places() -> Vec<(&'static str, Place)> {
    let shipped = |name: &str| authoring::SCENES.iter().find(|(at, _)| *at == name).expect("it ships").1();
    let main = |scene: Scene| {
        let camera = scene.cameras[0].clone();
        Place::new(scene, camera)
    };
    let inside = Camera { heading_deg: 30.0, ..Camera::free(DVec3::new(10.0, 1010.0, 5.0)) };
    let below = Camera { pitch_deg: 50.0, ..Camera::free(DVec3::new(0.0, 700.0, 0.0)) };
    vec![
        ("overcast", main(shipped("overcast"))),
        ("fair_weather", main(shipped("fair_weather"))),
        ("inside", Place::new(heap(40), inside)),
        ("below", Place::new(heap(40), below)),
    ]
}

/// In steps of 8 bits on a display.
fn steps_apart(a: Rgb, b: Rgb) -> f32 {
    let shown = |color: Rgb| color.to_array().map(|c| 255.0 * srgb_from_linear(tone_curve(c)));
    shown(a).into_iter().zip(shown(b)).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max)
}

/// Of differences that are sorted: their mean, and the least of the largest hundredth.
fn mean_and_worst(apart: &mut [f32]) -> [f32; 2] {
    apart.sort_by(f32::total_cmp);
    [apart.iter().sum::<f32>() / apart.len() as f32, apart[apart.len() * 99 / 100]]
}

/// Two sides that overlap show the same in the pixels along the edge that they share.
#[test]
fn sides_meet_without_a_seam() {
    const SIZE: u32 = 200;
    for (name, place) in places() {
        let sides = Side::ALL.map(|side| {
            let facet = Facet { side, margin: 4 };
            (facet.view(&place.camera, SIZE, 1), place.facet(facet, SIZE))
        });
        let (mut apart, mut near) = (Vec::new(), Vec::new());
        for (i, (view, picture)) in sides.iter().enumerate() {
            for (j, (other_view, other)) in sides.iter().enumerate() {
                // A pixel of the one that the other, too, has in its margin.
                for at in 0..SIZE * SIZE {
                    let (x, y) = (at % SIZE, at / SIZE);
                    let direction = view.ray(x as f32 + 0.5, y as f32 + 0.5);
                    let Some(there) = other_view.project(direction) else { continue };
                    let inside = |t: f32| (0.0..SIZE as f32).contains(&t);
                    if i >= j || !inside(there.x) || !inside(there.y) {
                        continue;
                    }
                    let there = there.y as u32 * SIZE + there.x as u32;
                    let seen = other.pixels[there as usize];
                    apart.push(steps_apart(picture.pixels[at as usize], seen));
                    let beside = |by: u32| steps_apart(seen, other.pixels[((there + by) % (SIZE * SIZE)) as usize]);
                    near.push(0.5 * (beside(1) + beside(SIZE)));
                }
            }
        }
        let [mean, worst] = mean_and_worst(&mut apart);
        // Pixels of two sides are not at quite the same place: what is half a pixel apart, down and across, differs by half
        // of what neighbours do; and half a step is rounding.
        let [near_mean, near_worst] = mean_and_worst(&mut near);
        assert!(apart.len() > 5_000, "{name}: the sides overlap");
        assert!(
            mean < near_mean + 0.5 && worst < near_worst + 0.5,
            "{name}: {mean} steps on the mean, {worst}; neighbours {near_mean}, {near_worst}"
        );
    }
}

#[test]
fn a_direction_shows_what_a_camera_sees_there() {
    const WIDTH: u32 = 1024;
    for (name, place) in places() {
        let around = place.around(WIDTH);
        // Pixels of some 0.1°, a fifth of a degree in the panorama's.
        let size = [160, 120];
        // By as much as neighbouring pixels differ, at most.
        for (heading_deg, pitch_deg) in [(0.0, 0.0), (45.0, 35.0), (200.0, -30.0), (135.0, 5.0)] {
            let camera =
                Camera { heading_deg, pitch_deg, roll_deg: 0.0, field_of_view_deg: 25.0, ..place.camera.clone() };
            let seen = place.draw(&Sight::still(&camera, size));
            let view = cloudwright_core::camera::View::new(&camera, size[0], size[1]);
            let apart = seen.pixels.iter().zip(0_u32..).map(|(color, i)| {
                let ray = view.ray((i % size[0]) as f32 + 0.5, (i / size[0]) as f32 + 0.5);
                steps_apart(*color, around.color(ray))
            });
            let [mean, worst] = mean_and_worst(&mut apart.collect::<Vec<_>>());
            assert!(mean < 1.5 && worst < 12.5, "{name} at {heading_deg}°, {pitch_deg}°: {mean} on the mean, {worst}");
        }
    }
}

#[test]
fn the_map_has_no_edge_and_lies_as_it_says() {
    for (name, place) in places() {
        let around = place.around(256);
        let map = around.map(256);
        assert_eq!([map.width, map.height], [256, 128]);
        let pixel = |x: u32, y: u32| map.pixels[(y * 256 + x % 256) as usize];
        let across = |x: u32| (0..128).map(|y| steps_apart(pixel(x, y), pixel(x + 1, y))).sum::<f32>() / 128.0;
        let usual = (0..255).map(across).fold(0.0, f32::max);
        assert!(across(255) <= usual, "{name}: {} from the last column to the first, {usual} else", across(255));
        // Where a quarter of the way lies which direction, on the horizon and straight up.
        for (x, y, direction) in [
            (128, 64, Vec3::Z),
            (64, 64, Vec3::X),
            (192, 64, Vec3::NEG_X),
            (0, 64, Vec3::NEG_Z),
            (17, 0, Vec3::Y),
            (99, 127, Vec3::NEG_Y),
        ] {
            let near = |[dx, dy]: [u32; 2]| pixel((x + dx + 255) % 256, (y + dy).clamp(1, 128) - 1);
            let around_there = [[0, 0], [1, 0], [0, 1], [1, 1]].map(near);
            let closest = around_there.map(|color| steps_apart(color, around.color(direction)));
            // The ground's blotches are as small as the map's pixels.
            assert!(closest.into_iter().fold(f32::MAX, f32::min) < 12.0, "{name} {direction}: {closest:?}");
        }
    }
}
