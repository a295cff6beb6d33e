//! One sky many times side by side, for what only shows when there is much of it.

use cloudwright_core::scene::{CloudId, Scene};
use glam::DVec3;

/// How far apart the copies of the inner deck of `overcast` are laid, metres.
const PITCH_M: f64 = 4000.0;

/// The forty clouds of `overcast`'s inner deck `side` × `side` times, so that the one whose cameras and paths there are
/// has as many to all sides as can be. The copies share their models and sprites.
pub fn overcasts(side: u32) -> Scene {
    let (_, make) = super::authoring::SCENES.iter().find(|(name, _)| *name == "overcast").expect("it ships");
    let mut scene = make();
    let inner = |position: DVec3| position.x.abs().max(position.z.abs()) < 0.55 * PITCH_M;
    let clouds: Vec<_> = scene.clouds.iter().filter(|cloud| inner(cloud.position)).cloned().collect();
    let from = -i64::from(side) / 2;
    let places = (from..from + i64::from(side)).flat_map(|x| (from..from + i64::from(side)).map(move |z| (x, z)));
    let copies = places.flat_map(|(x, z)| {
        let offset = DVec3::new(x as f64, 0.0, z as f64) * PITCH_M;
        clouds.iter().map(move |cloud| (cloud.clone(), offset))
    });
    let laid_out = copies.zip(1..).map(|((mut cloud, offset), number)| {
        cloud.id = CloudId(number);
        cloud.position += offset;
        cloud
    });
    scene.clouds = laid_out.collect();
    scene
}
