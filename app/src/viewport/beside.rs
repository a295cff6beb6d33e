//! Where copies go so that they are seen: beside what they are copies of, and in the picture if that is.

use super::Viewport;
use super::bounds;
use crate::state::{Selection, Session};
use cloudwright_core::camera::View;
use glam::DVec3;

/// Of its sides, so much of the picture's rim is too near to it for a middle to lie there.
const RIM: f32 = 0.06;
/// Of the way to where copies touch nothing: nearer ones lie in part over what they are copies of.
const WAYS: [f64; 3] = [1.0, 0.5, 0.25];
const SIDES: [DVec3; 4] = [DVec3::X, DVec3::NEG_X, DVec3::Z, DVec3::NEG_Z];

impl Viewport {
    /// The middles of what is selected, as it is at `clock_s`.
    pub(crate) fn places(&self, selection: &Selection, session: &Session, clock_s: f64) -> Vec<DVec3> {
        bounds::middles(selection, session, clock_s)
    }

    /// By how much copies of what has its middles at `places` are moved: by `way` metres along x or z, to the first
    /// side on which all that show still do, else half as far or less. `in_world` turns such a move into one in the world.
    pub(crate) fn beside(&self, places: &[DVec3], way: DVec3, in_world: impl Fn(DVec3) -> DVec3) -> DVec3 {
        let Some(view) = self.sight().map(|sight| sight.view()) else { return DVec3::X * way };
        let shown: Vec<DVec3> = places.iter().copied().filter(|place| shows(&view, *place, 0.0)).collect();
        let moves: Vec<DVec3> = WAYS.iter().flat_map(|share| SIDES.map(|side| side * way * *share)).collect();
        let keeps = |rim: f32| {
            let all = |by: &&DVec3| shown.iter().all(|place| shows(&view, *place + in_world(**by), rim));
            moves.iter().find(all).copied()
        };
        keeps(RIM).or_else(|| keeps(0.0)).unwrap_or(DVec3::X * way)
    }
}

/// Whether a place lies in the picture, and not within `rim` of its sides from its edges.
fn shows(view: &View, place: DVec3, rim: f32) -> bool {
    let (width, height) = (view.width as f32, view.height as f32);
    view.project((place - view.eye).as_vec3()).is_some_and(|at| {
        let inside = |along: f32, side: f32| (side * rim..=side * (1.0 - rim)).contains(&along);
        inside(at.x, width) && inside(at.y, height)
    })
}
