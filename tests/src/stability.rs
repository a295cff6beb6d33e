//! How much a view changes for each metre flown: the figures by which methods of locking and sorting are judged.
//!
//! Four flights through one heap (straight through its middle; the same so slowly that each step is shorter than the miss;
//! grazing; hovering where a sprite locks, with a millimetre of noise) and two hovers that look straight up and down
//! while the head turns. Figures are in units of
//! 1 / lock distance of the sprite that they are of, so that one bound holds for all sizes.

use crate::small_scenes::heap;
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::{Hidden, Sorting};
use cloudwright_core::facing::{FacingRule, Pose, Poses, lock_distance};
use cloudwright_core::frame::{Frame, Sight};
use cloudwright_core::image::LinearPicture;
use cloudwright_core::method::{METHODS, Method, Settings};
use cloudwright_core::model_in_view::Meshes;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::raster::{plain, truth};
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sprites::{Atlas, PlacedCloud, Sprite};
use cloudwright_core::view_history::ViewHistory;
use cloudwright_core::watch::Watch;
use glam::DVec3;

/// A name and a camera for each step of 1/60 s.
pub struct Flight {
    /// For people.
    pub name: &'static str,
    /// Its cameras.
    pub cameras: Vec<Camera>,
}

/// Of the table of methods those that lock or sort in a way of their own, and what is shipped.
pub fn methods() -> Vec<(&'static str, FacingRule, Sorting)> {
    let way = |method: &Method| (method.name, method.settings.facing, method.settings.sorting);
    let differs = |method: &&Method| {
        let Settings { facing, sorting, .. } = method.settings;
        method.settings == Settings::SHIPPED || (facing, sorting) != (FacingRule::Bounded, Sorting::EachFrame)
    };
    METHODS.iter().filter(differs).map(way).collect()
}

/// Largest changes of any sprite in one step, for each metre flown, times its lock distance.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct SpriteChanges {
    /// Of its alpha's factor.
    pub fade: f32,
    /// Of what it faces, as a chord, weighted by how much of it shows.
    pub facing: f32,
    /// Of its up, likewise.
    pub up: f32,
}

/// The scene that is flown through.
pub fn scene() -> Scene {
    heap(40)
}

/// The flights through [`scene`].
pub fn flights() -> Vec<Flight> {
    let at =
        |position: DVec3, heading_deg: f64, pitch_deg: f64| Camera { heading_deg, pitch_deg, ..Camera::free(position) };
    let straight = |from: DVec3, to: DVec3| -> Vec<Camera> {
        (0..=360).map(|i| at(from.lerp(to, f64::from(i) / 360.0), 0.0, 0.0)).collect()
    };
    let noise = |i: u32| {
        let [x, y, z, _] = draw(5, 0, i, 0).map(|bits| unit(bits) - 0.5);
        DVec3::new(x, y, z) * 2e-3
    };
    let hover = |position: DVec3, pitch_deg: f64| -> Vec<Camera> {
        (0..120).map(|i| at(position + noise(i), 0.5 * f64::from(i), pitch_deg)).collect()
    };
    let derived = Derived::new(&scene());
    let cloud = &derived.clouds()[0];
    let middle = cloud.origin + cloud.center.as_dvec3();
    // As pilots would have it, the middle is where a sprite is: it is missed by half a metre.
    let from_middle = |sprite: &&Sprite| sprite.position.distance(cloud.center);
    let nearest = cloud.sprites.iter().min_by(|a, b| from_middle(a).total_cmp(&from_middle(b)));
    let heart = nearest.map_or(middle, |sprite| cloud.origin + sprite.position.as_dvec3()) + DVec3::new(0.4, 0.2, 0.0);
    let sprite = &cloud.sprites[0];
    let locks = cloud.origin + sprite.position.as_dvec3() + DVec3::Z * f64::from(lock_distance(sprite.radius()));
    vec![
        Flight { name: "through", cameras: straight(heart + DVec3::Z * 400.0, heart - DVec3::Z * 400.0) },
        Flight { name: "slowly through", cameras: straight(heart + DVec3::Z * 9.0, heart - DVec3::Z * 9.0) },
        Flight {
            name: "grazing",
            cameras: straight(middle + DVec3::new(-400.0, 130.0, 30.0), middle + DVec3::new(400.0, 110.0, -30.0)),
        },
        Flight { name: "hovering", cameras: hover(locks, 0.0) },
        Flight { name: "looking up", cameras: hover(middle - DVec3::Y * 250.0, 90.0) },
        Flight { name: "looking down", cameras: hover(middle + DVec3::Y * 250.0, -90.0) },
    ]
}

/// What sprites do along `cameras`.
pub fn sprite_changes(scene: &Scene, cameras: &[Camera], rule: FacingRule) -> SpriteChanges {
    let derived = Derived::new(scene);
    let mut history = ViewHistory::new(rule, Sorting::EachFrame);
    let mut before: Option<(DVec3, Vec<Pose>)> = None;
    let mut largest = SpriteChanges::default();
    for camera in cameras {
        let view = View::new(camera, 96, 54);
        history.step(&derived, &view);
        let now = all_poses(&derived, &view, &history);
        if let Some((eye, then)) = &before {
            let metres = view.eye.distance(*eye) as f32;
            let radii = derived.clouds().iter().flat_map(|cloud| cloud.sprites.iter().map(|sprite| sprite.radius()));
            for ((a, b), radius) in then.iter().zip(&now).zip(radii) {
                let each = |change: f32| change / metres * lock_distance(radius);
                let shown = a.fade.min(b.fade);
                largest.fade = largest.fade.max(each((a.fade - b.fade).abs()));
                largest.facing = largest.facing.max(each(shown * a.towards.distance(b.towards)));
                largest.up = largest.up.max(each(shown * a.up.distance(b.up)));
            }
        }
        before = Some((view.eye, now));
    }
    largest
}

fn all_poses(derived: &Derived, view: &View, history: &ViewHistory) -> Vec<Pose> {
    let poses = Poses::new(derived.clouds(), derived.version(), view, &history.facing);
    let of_cloud = |(index, cloud): (usize, &PlacedCloud)| -> Vec<Pose> {
        let offset = (cloud.origin - view.eye).as_vec3();
        let pose = |(sprite, at): (&Sprite, u32)| {
            poses.of_sprite(index, at).copied().unwrap_or_else(|| Pose::facing_eye(offset + sprite.position, view.up))
        };
        cloud.sprites.iter().zip(0..).map(pose).collect()
    };
    derived.clouds().iter().enumerate().flat_map(of_cloud).collect()
}

/// Largest change of any pixel between two frames beyond the largest that the truth makes of it, linear light: every
/// `stride`-th step is a frame.
pub fn pixel_change(scene: &Scene, cameras: &[Camera], (rule, sorting): (FacingRule, Sorting), stride: usize) -> f32 {
    let derived = Derived::new(scene);
    let [mut history, mut true_history] = [(rule, sorting), (FacingRule::Bounded, Sorting::EachFrame)]
        .map(|(rule, sorting)| ViewHistory::new(rule, sorting));
    let mut before: Option<[LinearPicture; 2]> = None;
    let mut largest: f32 = 0.0;
    for (step, camera) in cameras.iter().enumerate() {
        let view = View::new(camera, 48, 27);
        history.step(&derived, &view);
        true_history.step(&derived, &view);
        if step % stride != 0 {
            continue;
        }
        let frame = |history| {
            let hidden = &Hidden::default();
            let sight = Sight {
                camera,
                time_h: scene.time_of_day_h,
                clock_s: 0.0,
                size: [48, 27],
                hidden,
                meshes: &Meshes::default(),
                history,
            };
            Frame::of(scene, &derived, Atlas::built_in(), &sight)
        };
        let now = [
            plain::linear_picture(&frame(&history)),
            truth::linear_picture(&frame(&true_history), 1, &Watch::default()),
        ];
        if let Some(then) = &before {
            let change = |which: usize, i: usize| {
                let (a, b) = (then[which].pixels[i], now[which].pixels[i]);
                (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs())
            };
            let beyond = (0..now[0].pixels.len()).map(|i| change(0, i) - change(1, i));
            largest = beyond.fold(largest, f32::max);
        }
        before = Some(now);
    }
    largest
}
