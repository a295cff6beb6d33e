//! A scene's coverage by clouds: which of them, from where, and from which elevation on.

use super::{Coverage, coverage};
use crate::derived::Derived;
use crate::draw_list::Hidden;
use crate::frame::Frame;
use crate::scene::{CloudId, Scene};
use crate::sight::Sight;
use crate::sprites::{Atlas, PlacedCloud};
use crate::weather::Moment;
use glam::DVec3;

/// Whose sky, and which clouds in it.
#[derive(Debug, Clone, PartialEq)]
pub struct Observer {
    /// Where the eye is, metres in the world; none: [`EYE_M`] above the ground under the middle of what the clouds span.
    pub from: Option<DVec3>,
    /// Nothing lower is looked at, degrees above level; 0 to 89.
    pub least_elevation_deg: f64,
    /// When.
    pub moment: Moment,
}

/// An observer's eye above the ground, metres.
pub const EYE_M: f64 = 2.0;
/// Side of the faces of the cube that is looked at, pixels: coarse pixels of sky, of which 20,000 are seen. What a
/// picture eight times as fine says is within 0.1 oktas of it.
const FACE_PX: u32 = 64;

impl Observer {
    /// From which elevation a scene's sky is measured if nothing is said of it: lower down, most scenes end before their
    /// sky does. Above are five sixths of the dome.
    pub const LEAST_ELEVATION_DEG: f64 = 10.0;
}

impl Default for Observer {
    fn default() -> Self {
        Self { from: None, least_elevation_deg: Self::LEAST_ELEVATION_DEG, moment: Moment::default() }
    }
}

/// What those clouds of `scene`, whose `derived` is, that `meant` chooses take of the observer's sky. The tiles are the
/// built-in ones, whatever the scene's are.
pub fn sky_cover(
    scene: &Scene,
    derived: &Derived,
    observer: &Observer,
    meant: impl Fn(&PlacedCloud) -> bool,
) -> Coverage {
    let (meant, others): (Vec<_>, Vec<_>) = derived.clouds().iter().partition(|cloud| meant(cloud));
    if meant.is_empty() {
        return Coverage::default();
    }
    let hidden: std::collections::BTreeSet<CloudId> = others.iter().map(|cloud| cloud.id).collect();
    let from = observer.from.unwrap_or_else(|| under(scene, &meant));
    coverage(from, observer.least_elevation_deg, FACE_PX, |camera, size| {
        let hidden = Hidden { clouds: hidden.clone(), ..Hidden::default() };
        let sight = Sight { moment: observer.moment, hidden, ..Sight::still(camera, size) };
        Frame::new(scene, derived, Atlas::built_in(), &sight)
    })
}

/// On the ground, under the middle of what the clouds' centres span.
fn under(scene: &Scene, clouds: &[&PlacedCloud]) -> DVec3 {
    let middles = clouds.iter().map(|cloud| cloud.origin + cloud.center.as_dvec3());
    let span = middles.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |[low, high], at| [low.min(at), high.max(at)]);
    let middle = 0.5 * (span[0] + span[1]);
    let ground_m = scene.ground.as_ref().map_or(0.0, |ground| ground.altitude_m);
    DVec3::new(middle.x, ground_m + EYE_M, middle.z)
}
