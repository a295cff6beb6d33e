//! What a footprint is drawn on: the level plane at the base altitude, where the pointer finds it at a fair distance and
//! sees it well; else an upright one there, or through the point that the view looks at, on which the hand says how wide
//! the box is.
//!
//! So a box can be drawn anywhere in the picture, also by who flies at the clouds' own height and sees their base
//! as a line: there, a hand that goes sideways would draw a sheet without depth. An upright footprint is as deep as a
//! share of its width, and lies at the base altitude all the same.
//!
//! Who draws over the cloud that the box will belong to means a box at that cloud: if the level plane is met far before or
//! behind it, the box is drawn upright through the cloud's middle.

use super::drawn::Drawn;
use crate::viewport::plane;
use crate::viewport::screen::Screen;
use egui::Pos2;
use glam::DVec3;

/// Nothing is drawn on the level plane at so many times the distance that is looked at: near the horizon, a hand's width
/// would be a country.
const FAR: f64 = 8.0;
/// Nor nearer than this by its distance alone, metres.
const FAIR_M: f64 = 20_000.0;
/// Of an upright footprint's width.
pub(super) const DEPTH_SHARE: f64 = 0.6;
/// Of a cloud's reach: what is drawn farther from its middle is not meant to be at it.
const AT_CLOUD: f64 = 1.25;
/// One that falls less is met at no place that anyone meant: 1 in 1,000.
const LEAST_MET: f64 = 0.001;
/// A plane that falls less on the way from the eye is seen from its edge: 1 in 8.
const LEAST_SLOPE: f64 = 0.125;

/// Where the hand draws.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Surface {
    /// On the plane at this altitude, metres.
    Level(f64),
    /// Across the view.
    Upright {
        /// The altitude of what is drawn, metres.
        base_m: f64,
        /// A point of it.
        through: DVec3,
        /// Away from the eye, level, unit.
        away: DVec3,
        /// Where the drag began.
        from: DVec3,
        /// What it stands at.
        at: At,
    },
}

/// Why a footprint is upright.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum At {
    /// The base is seen from its edge, or out of sight.
    Edge,
    /// It is drawn over the cloud that it will belong to.
    Cloud,
}

impl Surface {
    /// For a drag that begins at `at`, with where it begins; none if both are out of sight. `cloud` is the middle and the
    /// reach of the cloud that the box will belong to, if that is there already.
    pub(super) fn at(
        at: Pos2,
        screen: &Screen,
        base_m: f64,
        looked_at: DVec3,
        cloud: Option<(DVec3, f64)>,
    ) -> Option<(Self, DVec3)> {
        let eye = screen.view.eye;
        let farthest_m = FAIR_M.max(FAR * eye.distance(looked_at));
        let slope = |point: &DVec3| (point.y - eye.y).abs() / point.distance(eye);
        let met = plane::under(at, screen, base_m).filter(|point| point.distance(eye) < farthest_m);
        let met = met.filter(|point| slope(point) >= LEAST_MET);
        let level = met.filter(|point| slope(point) >= LEAST_SLOPE);
        let is_at = |place: DVec3, (middle, reach_m): (DVec3, f64)| {
            DVec3 { y: middle.y, ..place }.distance(middle) <= AT_CLOUD * reach_m
        };
        if let Some(cloud) = cloud.filter(|cloud| !met.is_some_and(|point| is_at(point, *cloud)))
            && let Some((upright, from)) = Self::upright(at, screen, base_m, cloud.0, At::Cloud)
            && is_at(from, cloud)
        {
            return Some((upright, from));
        }
        if let Some(point) = level {
            return Some((Self::Level(base_m), point));
        }
        Self::upright(at, screen, base_m, met.unwrap_or(looked_at), At::Edge)
    }

    /// One across the view, with where a drag that begins at `place` begins.
    fn upright(place: Pos2, screen: &Screen, base_m: f64, through: DVec3, at: At) -> Option<(Self, DVec3)> {
        let forward = screen.view.forward.as_dvec3();
        let away = DVec3 { y: 0.0, ..forward }.try_normalize()?;
        let from = Self::Upright { base_m, through, away, from: DVec3::ZERO, at }.under(place, screen)?;
        Some((Self::Upright { base_m, through, away, from, at }, from))
    }

    /// Why the hand says only how wide the box is, if that is so.
    pub(super) fn upright_at(&self) -> Option<At> {
        match self {
            Self::Level(_) => None,
            Self::Upright { at, .. } => Some(*at),
        }
    }

    /// The place of the footprint under the pointer.
    pub(super) fn under(&self, at: Pos2, screen: &Screen) -> Option<DVec3> {
        match *self {
            Self::Level(base_m) => plane::under(at, screen, base_m),
            Self::Upright { base_m, through, away, .. } => {
                let ray = screen.ray(at).as_dvec3();
                let depth = (through - screen.view.eye).dot(away) / ray.dot(away);
                let place = screen.view.eye + ray * depth;
                (depth > 0.0 && place.is_finite()).then_some(DVec3 { y: base_m, ..place })
            }
        }
    }

    /// Brings the footprint to where the hand is.
    pub(super) fn drag(&self, drawn: &mut Drawn, to: DVec3, snap_m: Option<f64>) {
        match *self {
            Self::Level(_) => drawn.drag_to(to, snap_m),
            Self::Upright { away, from, .. } => {
                let half = away * (from.distance(to) * DEPTH_SHARE * 0.5);
                drawn.from = from - half;
                drawn.drag_to(to + half, snap_m);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use cloudwright_core::scene::Camera;
    use egui::{Rect, pos2};

    #[test]
    fn level_where_it_is_seen_well_and_upright_elsewhere() {
        let eye = DVec3::new(5e5, 700.0, -3e5);
        let screen = Screen::new(&Camera::free(eye), Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        let looked_at = eye - DVec3::Z * 3000.0;
        let begun = |y: f32, base_m: f64| Surface::at(pos2(100.0, y), &screen, base_m, looked_at, None);
        assert_eq!(begun(40.0, 1000.0).map(|(surface, _)| surface), Some(Surface::Level(1000.0)), "above");
        // The base altitude is met a little above the middle, but seen from its edge: the box is drawn there.
        let (surface, from) = begun(92.0, 720.0).expect("drawn upright");
        assert!(surface.upright_at() == Some(At::Edge) && from.y == 720.0 && from.distance(eye) < 3000.0, "{from}");
        for (y, base_m) in [(180.0, 1000.0), (99.9, 1000.0), (100.0, 700.0)] {
            let (surface, from) = begun(y, base_m).expect("it can be drawn everywhere");
            assert!(matches!(surface, Surface::Upright { .. }), "{y}");
            assert!((from - DVec3 { y: base_m, ..looked_at }).length() < 1e-3, "{from}");
            let to = surface.under(pos2(150.0, y), &screen).expect("beside it");
            assert!(to.x > from.x + 100.0 && (to.z - from.z).abs() < 1e-3, "{to}");
        }
    }

    /// A cloud 3,000 m away, 300 m wide; the base is put up to 1,100 m.
    #[test]
    fn over_its_cloud_a_box_is_drawn_at_the_cloud() {
        let eye = DVec3::new(0.0, 900.0, 0.0);
        let screen = Screen::new(&Camera::free(eye), Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        let cloud = (DVec3::new(0.0, 1000.0, -3000.0), 300.0);
        for (at, base_m, wanted) in [
            // Met 800 m before the eye: not meant.
            (pos2(100.0, 60.0), 1100.0, None),
            // Beside the cloud: as drawn.
            (pos2(10.0, 60.0), 1100.0, Some(Surface::Level(1100.0))),
        ] {
            let (surface, from) = Surface::at(at, &screen, base_m, cloud.0, Some(cloud)).expect("drawn");
            match wanted {
                Some(wanted) => assert_eq!(surface, wanted),
                None => {
                    assert_eq!(surface.upright_at(), Some(At::Cloud));
                    assert!((from.z - cloud.0.z).abs() < 1e-3 && from.y == base_m, "{from}");
                }
            }
        }
        let above = Camera { pitch_deg: -90.0, ..Camera::free(DVec3::new(0.0, 4000.0, -3000.0)) };
        let screen = Screen::new(&above, Rect::from_min_max(pos2(0.0, 0.0), pos2(200.0, 200.0)));
        let begun = Surface::at(pos2(100.0, 100.0), &screen, 1100.0, cloud.0, Some(cloud)).expect("drawn");
        assert_eq!(begun.0, Surface::Level(1100.0), "from the top the plane is met at the cloud");
    }
}
