//! How one flies: while the right button is held, the mouse turns the head and keys give the direction.
//!
//! W and S fly where one looks, A and D sideways, E and Q up and down; the wheel sets the speed, Shift is fast and Ctrl
//! slow. [`Flight`] has the inertia: after the button is let go, the view glides to rest. The same keys are commands, so
//! they are kept from them until they are let go.

use super::fly::{Flight, Steering};
use super::hud::Readout;
use super::navigation::Navigation;
use cloudwright_core::camera::View;
use egui::{Event, InputState, Key, MouseWheelUnit, PointerButton, Response, Ui, Vec2};
use glam::{DVec2, DVec3};

/// Of the head's turn, a point of dragging. Less than when orbiting: here the whole world moves.
const DEG_PER_POINT: f64 = 0.2;
/// A notch of a wheel that counts in points.
const POINTS_PER_NOTCH: f32 = 50.0;
/// Times the speed, while Shift is held.
const FAST: f64 = 4.0;
/// Times the speed, while Ctrl is held.
const SLOW: f64 = 0.25;

const FORWARD: [Key; 2] = [Key::W, Key::S];
const RIGHT: [Key; 2] = [Key::D, Key::A];
const UP: [Key; 2] = [Key::E, Key::Q];

/// Flying by mouse and keys.
#[derive(Debug, Default)]
pub(super) struct FlyControl {
    flight: Flight,
    /// The button went down in the picture, and is down.
    is_held: bool,
    /// Since then something was done: a click alone does nothing.
    has_begun: bool,
    has_keys: bool,
}

impl FlyControl {
    /// Whether the button is down.
    pub(super) fn is_held(&self) -> bool {
        self.is_held
    }

    /// Whether the keys are the flight's: while the button is down, and until keys that were held with it are
    /// let go.
    pub(super) fn has_keys(&self) -> bool {
        self.has_keys
    }

    /// Whether the view flies or glides.
    pub(super) fn is_flying(&self) -> bool {
        self.has_begun || self.flight.moves()
    }

    /// How fast it is to go, metres a second.
    pub(super) fn speed_m_s(&self) -> f64 {
        self.flight.speed_m_s()
    }

    /// The instruments, while it flies.
    pub(super) fn readout(&self, navigation: &Navigation) -> Option<Readout> {
        let speed_m_s = self.flight.velocity_m_s().length();
        self.is_flying().then(|| Readout::of(navigation.camera(), speed_m_s))
    }

    /// At once, and until the button is pressed anew.
    pub(super) fn stop(&mut self) {
        self.flight.stop();
        self.is_held = false;
        self.has_begun = false;
    }

    /// A frame of flight, which `may_begin` if no other gesture is going on. The next frame is asked for only while it
    /// moves.
    pub(super) fn fly(&mut self, navigation: &mut Navigation, ui: &Ui, response: &Response, may_begin: bool) {
        let (pressed, down, escape, dt_s) = ui.input(|input| {
            let pointer = &input.pointer;
            let pressed = pointer.button_pressed(PointerButton::Secondary) && !pointer.primary_down();
            (pressed, pointer.secondary_down(), input.key_pressed(Key::Escape), f64::from(input.stable_dt))
        });
        if pressed && may_begin && response.contains_pointer() {
            self.is_held = true;
            // Letters are for flying now, whatever field they went to.
            response.request_focus();
        }
        if !down {
            self.is_held = false;
            self.has_begun = false;
        }
        if escape && self.is_flying() {
            self.stop();
        }
        let keys_down = ui.input(|input| [FORWARD, RIGHT, UP].as_flattened().iter().any(|key| input.key_down(*key)));
        self.has_keys = self.is_held || (self.has_keys && (down || keys_down));
        let steering = if self.is_held { self.steering(navigation, ui, response) } else { Steering::default() };
        if !self.is_flying() {
            return;
        }
        // One flies where one is, not far behind it.
        navigation.set_orthographic(false);
        let step = self.flight.advance(dt_s, &steering);
        navigation.turn_head(step.turn_deg);
        navigation.fly(step.way_m);
        if self.flight.moves() {
            ui.ctx().request_repaint();
        }
    }

    fn steering(&mut self, navigation: &Navigation, ui: &Ui, response: &Response) -> Steering {
        let view = View::new(navigation.camera(), 1, 1);
        let dragged = response.dragged_by(PointerButton::Secondary);
        let (moved, notches, along, pace) = ui.input(|input| {
            let held = |[plus, minus]: [Key; 2]| f64::from(input.key_down(plus)) - f64::from(input.key_down(minus));
            let along = view.forward.as_dvec3() * held(FORWARD) + view.right.as_dvec3() * held(RIGHT);
            let moved = if dragged { input.pointer.delta() } else { Vec2::ZERO };
            (moved, notches(input), along + DVec3::Y * held(UP), pace(input))
        });
        self.flight.change_speed(f64::from(notches));
        self.has_begun |= dragged || notches != 0.0 || along != DVec3::ZERO;
        Steering {
            velocity_m_s: along.normalize_or_zero() * (self.flight.speed_m_s() * pace),
            turn_deg: DVec2::new(f64::from(moved.x), f64::from(-moved.y)) * DEG_PER_POINT,
        }
    }
}

fn pace(input: &InputState) -> f64 {
    match (input.modifiers.shift, input.modifiers.ctrl) {
        (true, false) => FAST,
        (false, true) => SLOW,
        _ => 1.0,
    }
}

/// Of the wheel in this frame. Read from the events: with Shift or Ctrl, what they are gathered into is no scrolling.
fn notches(input: &InputState) -> f32 {
    let turned = input.events.iter().map(|event| match event {
        Event::MouseWheel { unit: MouseWheelUnit::Point, delta, .. } => delta.y / POINTS_PER_NOTCH,
        Event::MouseWheel { delta, .. } => delta.y,
        _ => 0.0,
    });
    turned.sum()
}
