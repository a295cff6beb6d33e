//! Flight: the view's velocity and the turn of its head, both with inertia.
//!
//! The velocity relaxes towards the wanted one, and a turn is made over a moment; both are integrated exactly, not by
//! explicit steps, so the path is the same at any frame rate and nothing overshoots after a slow frame.

use crate::state::MAX_STEP_S;
use glam::{DVec2, DVec3};

/// In this time the velocity's difference from the wanted one shrinks to 1/e: an aircraft's ease, and yet at hand.
const INERTIA_S: f64 = 0.3;
/// The same for what is left of a turn: enough to take the jerks out of a hand.
const HEAD_INERTIA_S: f64 = 0.05;
/// Slower is at rest, metres a second: what would be left of the way is 15 mm.
const REST_M_S: f64 = 0.05;
/// A smaller turn that is left is none, degrees: half a pixel of a large picture.
const REST_DEG: f64 = 0.01;

/// Metres a second, before Shift and Ctrl.
const SPEED_M_S: [f64; 2] = [1.0, 1000.0];
const FIRST_SPEED_M_S: f64 = 60.0;
/// Of speed, a notch of the wheel.
const SPEED_STEP: f64 = 1.25;

/// A flight: how fast it goes, and how fast it is to go.
#[derive(Debug, Clone)]
pub(super) struct Flight {
    velocity_m_s: DVec3,
    /// Of heading and pitch, still to be made.
    turn_left_deg: DVec2,
    speed_m_s: f64,
}

/// What mouse and keys ask for in one frame.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Steering {
    /// In the world.
    pub(super) velocity_m_s: DVec3,
    /// Of heading and pitch, more than was wanted before.
    pub(super) turn_deg: DVec2,
}

/// What one frame brings.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Step {
    /// In the world.
    pub(super) way_m: DVec3,
    /// Of heading and pitch.
    pub(super) turn_deg: DVec2,
}

impl Default for Flight {
    fn default() -> Self {
        Self { velocity_m_s: DVec3::ZERO, turn_left_deg: DVec2::ZERO, speed_m_s: FIRST_SPEED_M_S }
    }
}

impl Flight {
    /// How fast it is to go, metres a second.
    pub(super) fn speed_m_s(&self) -> f64 {
        self.speed_m_s
    }

    /// Sets how fast it is to go by notches of the wheel.
    pub(super) fn change_speed(&mut self, notches: f64) {
        let [least, greatest] = SPEED_M_S;
        self.speed_m_s = (self.speed_m_s * SPEED_STEP.powf(notches)).clamp(least, greatest);
    }

    /// How fast it goes now.
    pub(super) fn velocity_m_s(&self) -> DVec3 {
        self.velocity_m_s
    }

    /// Whether a frame would bring anything even if no hand wants it.
    pub(super) fn moves(&self) -> bool {
        self.velocity_m_s != DVec3::ZERO || self.turn_left_deg != DVec2::ZERO
    }

    /// At once.
    pub(super) fn stop(&mut self) {
        self.velocity_m_s = DVec3::ZERO;
        self.turn_left_deg = DVec2::ZERO;
    }

    /// Goes on for `dt_s`; a stall counts as one step.
    pub(super) fn advance(&mut self, dt_s: f64, steering: &Steering) -> Step {
        let dt_s = dt_s.clamp(0.0, MAX_STEP_S);
        let kept = (-dt_s / INERTIA_S).exp();
        let excess = self.velocity_m_s - steering.velocity_m_s;
        self.velocity_m_s = steering.velocity_m_s + excess * kept;
        let mut way_m = steering.velocity_m_s * dt_s + excess * (INERTIA_S * (1.0 - kept));
        let all = self.turn_left_deg + steering.turn_deg;
        self.turn_left_deg = all * (-dt_s / HEAD_INERTIA_S).exp();
        if steering.velocity_m_s == DVec3::ZERO && self.velocity_m_s.length() < REST_M_S {
            // All the rest at once, so that the end is the same however many frames there were.
            way_m += self.velocity_m_s * INERTIA_S;
            self.velocity_m_s = DVec3::ZERO;
        }
        if self.turn_left_deg.length() < REST_DEG {
            self.turn_left_deg = DVec2::ZERO;
        }
        Step { way_m, turn_deg: all - self.turn_left_deg }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where one is after two seconds of flight and three of gliding, at `rate` frames a second.
    fn fly(rate: u32) -> (DVec3, DVec2) {
        let mut flight = Flight::default();
        let (mut place, mut turned) = (DVec3::ZERO, DVec2::ZERO);
        for frame in 0..5 * rate {
            let wanted = if frame < 2 * rate { DVec3::new(0.0, 12.0, -90.0) } else { DVec3::ZERO };
            // The same hand's way, in one frame or in many.
            let turn = if frame < rate { DVec2::new(30.0, -8.0) / f64::from(rate) } else { DVec2::ZERO };
            let step = flight.advance(1.0 / f64::from(rate), &Steering { velocity_m_s: wanted, turn_deg: turn });
            place += step.way_m;
            turned += step.turn_deg;
        }
        // Of 91 m/s, e^(−3/0.3) leaves 4 mm a second.
        assert!(!flight.moves(), "at rest");
        (place, turned)
    }

    #[test]
    fn the_path_is_the_same_at_any_frame_rate() {
        let (place, turned) = fly(60);
        // In closed form: what is lost while gathering speed is gained while gliding, so it is the steering times its time.
        let wanted = DVec3::new(0.0, 24.0, -180.0);
        assert!(place.distance(wanted) < 1e-9, "{place}");
        assert!(turned.distance(DVec2::new(30.0, -8.0)) < 1e-9, "{turned}");
        for rate in [10, 240] {
            let other = fly(rate);
            assert!(other.0.distance(place) < 1e-9 && other.1.distance(turned) < 1e-9, "{other:?} at {rate}");
        }
    }

    #[test]
    fn it_never_overshoots_nor_jumps() {
        let steering = Steering { velocity_m_s: DVec3::X * 60.0, ..Steering::default() };
        for dt_s in [0.0, 0.001, 0.25, 3600.0, -1.0] {
            let mut flight = Flight::default();
            let step = flight.advance(dt_s, &steering);
            assert!((0.0..=60.0).contains(&flight.velocity_m_s().x), "{dt_s}");
            assert!((0.0..=60.0 * MAX_STEP_S).contains(&step.way_m.x), "a stall counts as one step: {dt_s}");
        }
        let mut flight = Flight::default();
        flight.advance(0.1, &Steering { turn_deg: DVec2::X, ..steering });
        assert!(flight.moves());
        flight.stop();
        assert!(!flight.moves());
        assert_eq!(flight.advance(0.1, &Steering::default()), Step::default());
    }

    #[test]
    fn the_wheel_stays_within_the_range() {
        let mut flight = Flight::default();
        flight.change_speed(2.0);
        assert!((flight.speed_m_s() - 93.75).abs() < 1e-9);
        flight.change_speed(1e6);
        assert_eq!(flight.speed_m_s(), 1000.0);
        flight.change_speed(-1e6);
        assert_eq!(flight.speed_m_s(), 1.0);
    }
}
