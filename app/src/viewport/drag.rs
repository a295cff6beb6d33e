//! A drag of the selection, whether by a gizmo or by keys: what it has come to, as edits and in words.

use super::targets::{Act, Targets};
use crate::state::{Action, Reading, TimelineChange};
use glam::DVec3;

/// A drag from its beginning.
pub(super) struct Drag {
    pub(super) targets: Targets,
    /// What was done last; none while nothing was.
    act: Option<Act>,
}

impl Drag {
    pub(super) fn new(targets: Targets) -> Self {
        Self { targets, act: None }
    }

    /// Asks for what brings the targets where `act` says.
    pub(super) fn follow(&mut self, act: Act, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let nothing = match act {
            Act::Move(by) => by == DVec3::ZERO,
            Act::Turn(_, angle) => angle == 0.0,
            Act::Stretch(by) => by == DVec3::ONE,
        };
        if nothing && self.act.is_none() {
            return;
        }
        self.act = Some(act);
        let name = match act {
            Act::Move(_) => "Move",
            Act::Turn(..) => "Rotate",
            Act::Stretch(_) => "Scale",
        };
        let mut edits = self.targets.edits(act, reading.session.scene());
        let keyed = super::keyed_clouds::edits(&self.targets, act, reading, &mut edits);
        actions.extend(keyed.map(|targets| Action::Timeline(TimelineChange::Unkeyed(targets))));
        actions.push(Action::Change { name, edits, live: true });
    }

    /// What the hand has done so far, for beside the pointer: "120.0 m · x 100.0 y 0.0 z 66.3"; none before it did anything.
    pub(super) fn readout(&self) -> Option<String> {
        self.act.map(|act| readout(act, self.targets.turn.conjugate() * direction(act)))
    }
}

/// What an act is along, in the world.
fn direction(act: Act) -> DVec3 {
    match act {
        Act::Move(by) => by,
        Act::Turn(axis, _) => axis,
        Act::Stretch(by) => by,
    }
}

/// `along` is the act's direction along the axes that are dragged.
fn readout(act: Act, along: DVec3) -> String {
    match act {
        Act::Move(by) => {
            let [x, y, z] = along.to_array().map(signless_zero);
            format!("{:.1} m · x {x:.1} y {y:.1} z {z:.1}", by.length())
        }
        Act::Turn(_, angle) => format!("{:.1}°", signless_zero(angle.to_degrees())),
        Act::Stretch(by) if by.x == by.y && by.y == by.z => format!("× {:.3}", by.x),
        Act::Stretch(by) => format!("× {:.3} · {:.3} · {:.3}", by.x, by.y, by.z),
    }
}

/// No "−0.0".
fn signless_zero(number: f64) -> f64 {
    if number.abs() < 0.05 { 0.0 } else { number }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reads_as_people_say_it() {
        let by = DVec3::new(30.0, -0.001, -40.0);
        assert_eq!(readout(Act::Move(by), by), "50.0 m · x 30.0 y 0.0 z -40.0");
        assert_eq!(readout(Act::Turn(DVec3::Y, -0.25_f64.to_radians()), DVec3::Y), "-0.2°");
        assert_eq!(readout(Act::Stretch(DVec3::splat(1.5)), DVec3::ONE), "× 1.500");
        assert_eq!(readout(Act::Stretch(DVec3::new(2.0, 1.0, 1.0)), DVec3::ONE), "× 2.000 · 1.000 · 1.000");
    }
}
