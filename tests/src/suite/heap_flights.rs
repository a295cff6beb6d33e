//! Flights through one heap: straight through its middle, and the same so slowly that each step is shorter than the miss;
//! grazing; hovering where a sprite locks, with a millimetre of noise; and above and below it, while the head turns.

use super::stage::Stage;
use crate::small_scenes;
use cloudwright_core::derived::Derived;
use cloudwright_core::facing::lock_distance;
use cloudwright_core::random::{draw, unit};
use cloudwright_core::scene::{Camera, Scene, Weather};
use cloudwright_core::sprites::{Atlas, Sprite};
use cloudwright_core::view_history::STEP_S;
use glam::DVec3;
use std::borrow::Cow;

/// Through the middle, `reach_m` before it to as far behind it, in six seconds.
pub fn through(reach_m: f64) -> Stage {
    flight(straight(|heap| (heap.heart + DVec3::Z * reach_m, heap.heart - DVec3::Z * reach_m)))
}

/// The same through a heap that a wind from ahead carries towards the eye, that leans with it and churns.
pub fn stirred() -> Stage {
    let mut stage = through(400.0);
    stage.scene.weather = Weather { wind_from_deg: 0.0, wind_speed_mps: 15.0, turbulence: 1.0, ..Weather::default() };
    stage.looks.iter_mut().enumerate().for_each(|(step, look)| look.clock_s = step as f64 * STEP_S);
    stage
}

/// Past the middle at the height of the outermost sprites.
pub fn grazing() -> Stage {
    flight(straight(|heap| {
        (heap.middle + DVec3::new(-400.0, 130.0, 30.0), heap.middle + DVec3::new(400.0, 110.0, -30.0))
    }))
}

/// At the lock distance of a sprite.
pub fn hovering() -> Stage {
    flight(hover(Heap::new().locks, 0.0))
}

/// From below.
pub fn looking_up() -> Stage {
    flight(hover(Heap::new().middle - DVec3::Y * 250.0, 90.0))
}

/// From above.
pub fn looking_down() -> Stage {
    flight(hover(Heap::new().middle + DVec3::Y * 250.0, -90.0))
}

/// A millimetre at most along each axis.
pub fn noise(step: u32) -> DVec3 {
    let [x, y, z, _] = draw(5, 0, step, 0).map(|bits| unit(bits) - 0.5);
    DVec3::new(x, y, z) * 2e-3
}

/// Eighty sprites are tried.
fn scene() -> Scene {
    small_scenes::heap(40)
}

/// A picture every two seconds.
fn flight(cameras: Vec<Camera>) -> Stage {
    Stage::flight(scene(), Cow::Borrowed(Atlas::built_in()), cameras, |step| step % 120 == 0)
}

/// Where its flights go, metres in the world.
struct Heap {
    middle: DVec3,
    /// As pilots would have it, the middle is where a sprite is: it is missed by half a metre.
    heart: DVec3,
    /// At the lock distance of a sprite.
    locks: DVec3,
}

impl Heap {
    fn new() -> Self {
        let derived = Derived::new(&scene());
        let cloud = &derived.clouds()[0];
        let middle = cloud.origin + cloud.center.as_dvec3();
        let from_middle = |sprite: &&Sprite| sprite.position.distance(cloud.center);
        let nearest = cloud.sprites.iter().min_by(|a, b| from_middle(a).total_cmp(&from_middle(b)));
        let heart = nearest.map_or(middle, |sprite| cloud.origin + sprite.position.as_dvec3());
        let sprite = &cloud.sprites[0];
        let locks = cloud.origin + sprite.position.as_dvec3() + DVec3::Z * f64::from(lock_distance(sprite.radius()));
        Self { middle, heart: heart + DVec3::new(0.4, 0.2, 0.0), locks }
    }
}

fn straight(ends: impl Fn(&Heap) -> (DVec3, DVec3)) -> Vec<Camera> {
    let (from, to) = ends(&Heap::new());
    (0..=360).map(|i| Camera::free(from.lerp(to, f64::from(i) / 360.0))).collect()
}

/// Half a degree of turn a step.
fn hover(position: DVec3, pitch_deg: f64) -> Vec<Camera> {
    let camera = |i| Camera { heading_deg: 0.5 * f64::from(i), pitch_deg, ..Camera::free(position + noise(i)) };
    (0..120).map(camera).collect()
}
