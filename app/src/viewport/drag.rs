//! A drag of the selection, whether by a gizmo or by keys: what it has come to, as edits and in words.

use super::onto::{Met, Planes};
use super::screen::Screen;
use super::targets::{Act, Targets};
use crate::state::{Action, Reading, TimelineChange};
use egui::Painter;
use glam::DVec3;

/// A drag from its beginning.
pub(super) struct Drag {
    pub(super) targets: Targets,
    /// What was done last; none while nothing was.
    act: Option<Act>,
    /// What it may snap onto along each axis, with how far the targets reach along it, from when that was first asked for.
    onto: Option<[(Planes, Vec<f64>); 3]>,
    /// The faces that it lies in.
    met: Vec<Met>,
}

/// Less is no move along an axis, metres.
const LEAST_MOVE_M: f64 = 1e-6;

impl Drag {
    pub(super) fn new(targets: Targets) -> Self {
        Self { targets, act: None, onto: None, met: Vec::new() }
    }

    /// Where the hand has moved the targets if that snaps: along each axis onto another box, else by steps.
    pub(super) fn snapped(&mut self, by: DVec3, screen: &Screen, reading: &Reading<'_>) -> DVec3 {
        let (targets, turn) = (&self.targets, self.targets.turn);
        let onto = self.onto.get_or_insert_with(|| {
            let moves = |cloud, model, each| targets.moves(cloud, model, each);
            DVec3::AXES.map(|axis| {
                let axis = turn * axis;
                let planes = Planes::across(axis, moves, screen, reading);
                (planes, targets.reaches(axis, reading.session.scene()))
            })
        });
        let step_m = reading.view.snap.step_m;
        self.met.clear();
        let mut along = turn.conjugate() * by;
        for (by_m, (planes, reaches)) in along.as_mut().iter_mut().zip(onto) {
            if by_m.abs() < LEAST_MOVE_M {
                continue;
            }
            let own = reaches.iter().map(|reach| reach + *by_m);
            match planes.nearest(own, targets.pivot + by, screen) {
                Some(met) => {
                    *by_m += met.by_m;
                    self.met.push(met);
                }
                None if step_m > 0.0 => *by_m = (*by_m / step_m).round() * step_m,
                None => {}
            }
        }
        turn * along
    }

    /// Nothing snaps any more.
    pub(super) fn let_go(&mut self) {
        self.met.clear();
    }

    /// Shows what it lies in.
    pub(super) fn paint_met(&self, painter: &Painter, screen: &Screen) {
        self.met.iter().for_each(|met| met.paint(painter, screen));
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
