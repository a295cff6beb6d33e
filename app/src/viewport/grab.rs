//! The selection follows the pointer from a key on, without a button: Blender's G, R and S.
//!
//! X, Y and Z keep it to an axis, of a single box its own; with Shift to the plane across. Figures say how much instead of
//! the pointer. A click or Enter ends it, Esc or the right button takes it back. All of it is one open gesture.

use super::drag::Drag;
use super::overlay;
use super::screen::Screen;
use super::targets::{Act, Targets};
use crate::state::{Action, Reading, Tool};
use crate::theme;
use egui::{Event, InputState, Key, Painter, PointerButton, Pos2, Response, Stroke, Ui, vec2};
use glam::DVec3;
use std::f64::consts::{PI, TAU};

/// Of an axis' line on each side of the pivot: as far as one looks, metres a metre of distance.
const AXIS_REACH: f64 = 20.0;
/// Nearer to the pivot, the pointer's way from it says nothing about a scale, points.
const LEAST_ARM: f32 = 12.0;
/// Longer numbers nobody means.
const MOST_FIGURES: usize = 12;

/// What follows the pointer.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Grabbed {
    /// The place.
    Place,
    /// The turn.
    Turn,
    /// The size.
    Size,
}

impl Grabbed {
    /// The tool whose targets it works on.
    fn tool(self) -> Tool {
        match self {
            Self::Place => Tool::Move,
            Self::Turn => Tool::Rotate,
            Self::Size => Tool::Scale,
        }
    }
}

/// Nothing, or a grab from its key on.
#[derive(Default)]
pub(super) enum Grab {
    #[default]
    None,
    /// The key was pressed.
    Wanted(Grabbed),
    Held(Box<Held>),
    /// It was ended by a button that is still down.
    Ended,
}

pub(super) struct Held {
    grabbed: Grabbed,
    drag: Drag,
    from: Pos2,
    /// Where the pointer was last.
    last: Pos2,
    /// The pointer has been in the picture. From a menu, it begins where the pointer comes in.
    has_come_in: bool,
    /// How far the pointer has gone around the pivot, radians.
    around: f64,
    keep_to: KeepTo,
    /// What was typed.
    typed: String,
}

/// Which ways it may go.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum KeepTo {
    All,
    Axis(usize),
    /// All but this axis.
    Plane(usize),
}

/// What the pointer and keys say in a frame.
struct Input {
    at: Option<Pos2>,
    done: bool,
    dropped: bool,
    snaps: bool,
}

impl Grab {
    /// Begins as soon as the viewport is drawn.
    pub(super) fn want(&mut self, grabbed: Grabbed) {
        if matches!(self, Self::None) {
            *self = Self::Wanted(grabbed);
        }
    }

    /// Whether the pointer is its own.
    pub(super) fn is_on(&self) -> bool {
        !matches!(self, Self::None)
    }

    /// Whether keys are its own. Not of one that has ended: its viewport may be out of sight before the button is let go.
    pub(super) fn has_keys(&self) -> bool {
        matches!(self, Self::Wanted(_) | Self::Held(_))
    }

    /// Whether the gesture stays open though no button is down.
    pub(super) fn holds_gesture(&self) -> bool {
        matches!(self, Self::Held(_))
    }

    /// Lets the selection follow. Whether it has pointer and keys.
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        response: &Response,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) -> bool {
        match std::mem::take(self) {
            Self::None => return false,
            Self::Wanted(grabbed) => *self = begin(grabbed, ui, response, screen, reading),
            Self::Held(held) => *self = held.go_on(ui, painter, screen, reading, actions),
            Self::Ended if ui.input(|input| input.pointer.any_down()) => *self = Self::Ended,
            Self::Ended => {}
        }
        true
    }
}

fn begin(grabbed: Grabbed, ui: &Ui, response: &Response, screen: &Screen, reading: &Reading<'_>) -> Grab {
    let Some(targets) = Targets::of(grabbed.tool(), reading) else { return Grab::None };
    response.request_focus();
    ui.ctx().request_repaint();
    let at = ui.input(|input| input.pointer.latest_pos()).unwrap_or(screen.rect.center());
    Grab::Held(Box::new(Held {
        grabbed,
        drag: Drag::new(targets),
        from: at,
        last: at,
        has_come_in: screen.rect.contains(at),
        around: 0.0,
        keep_to: KeepTo::All,
        typed: String::new(),
    }))
}

impl Held {
    fn go_on(
        mut self: Box<Self>,
        ui: &Ui,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) -> Grab {
        let input = ui.input(|input| {
            self.read_keys(input);
            let done = input.pointer.primary_pressed() || input.key_pressed(Key::Enter);
            let dropped = input.key_pressed(Key::Escape) || input.pointer.button_pressed(PointerButton::Secondary);
            let snaps = reading.view.snap.on != input.modifiers.command;
            Input { at: input.pointer.latest_pos(), done, dropped, snaps }
        });
        if input.dropped {
            actions.push(Action::DropGesture);
            return Grab::Ended;
        }
        let at = input.at.unwrap_or(self.last);
        if !self.has_come_in {
            (self.from, self.last) = (at, at);
            self.has_come_in = screen.rect.contains(at);
        }
        if let Some(pivot) = self.pivot(screen) {
            self.around += turned_between(self.last - pivot, at - pivot);
        }
        self.last = at;
        self.drag.let_go();
        let act = match self.act(at, input.snaps, screen, reading) {
            Act::Move(by) if input.snaps && self.typed.is_empty() => Act::Move(self.drag.snapped(by, screen, reading)),
            act => act,
        };
        self.drag.follow(act, reading, actions);
        if input.done {
            return Grab::Ended;
        }
        self.paint_axes(painter, screen);
        self.drag.paint_met(painter, screen);
        overlay::label(painter, at + vec2(16.0, 16.0), &self.words());
        Grab::Held(self)
    }

    /// Axes and figures; all other keys are left alone.
    fn read_keys(&mut self, input: &InputState) {
        for event in &input.events {
            let Event::Key { key, pressed: true, modifiers, .. } = event else { continue };
            let axis = [Key::X, Key::Y, Key::Z].iter().position(|axis| axis == key);
            if let Some(axis) = axis {
                let wanted = if modifiers.shift { KeepTo::Plane(axis) } else { KeepTo::Axis(axis) };
                self.keep_to = if self.keep_to == wanted { KeepTo::All } else { wanted };
            } else {
                type_key(&mut self.typed, *key);
            }
        }
    }

    fn pivot(&self, screen: &Screen) -> Option<Pos2> {
        screen.project(screen.relative(self.drag.targets.pivot))
    }

    /// One of the axes, in the world.
    fn axis(&self, axis: usize) -> DVec3 {
        self.drag.targets.turn * DVec3::AXES[axis]
    }

    fn act(&self, at: Pos2, snaps: bool, screen: &Screen, reading: &Reading<'_>) -> Act {
        let snap = reading.view.snap;
        let stepped = |value: f64, step: f64| if snaps && step > 0.0 { (value / step).round() * step } else { value };
        let typed: Option<f64> = self.typed.parse().ok();
        match self.grabbed {
            Grabbed::Place => {
                let along = |axis: usize| match typed {
                    Some(metres) => self.axis(axis) * metres,
                    None => self.axis(axis) * self.along(axis, at, screen),
                };
                Act::Move(match (self.keep_to, typed) {
                    (KeepTo::Axis(axis), _) => along(axis),
                    // As in Blender, a number alone is along the first axis.
                    (KeepTo::All, Some(_)) => along(0),
                    (KeepTo::Plane(axis), Some(_)) => along(if axis == 0 { 1 } else { 0 }),
                    (keep_to, None) => self.across(keep_to, at, screen),
                })
            }
            Grabbed::Turn => {
                let forward = screen.view.forward.as_dvec3();
                let upright = self.drag.targets.stay_upright();
                let axis = match self.keep_to {
                    _ if upright => DVec3::Y,
                    KeepTo::Axis(axis) | KeepTo::Plane(axis) => self.axis(axis),
                    KeepTo::All => -forward,
                };
                // On the screen y goes down, so that the pointer goes around clockwise.
                let by_hand = -self.around * if axis.dot(forward) > 0.0 { -1.0 } else { 1.0 };
                let by_hand = stepped(by_hand, snap.angle_deg.to_radians());
                Act::Turn(axis, typed.map_or(by_hand, f64::to_radians))
            }
            Grabbed::Size => {
                let arm = |at: Pos2| self.pivot(screen).map_or(LEAST_ARM, |pivot| at.distance(pivot).max(LEAST_ARM));
                let by_hand = stepped(f64::from(arm(at) / arm(self.from)), snap.scale);
                let by = typed.unwrap_or(by_hand).abs().max(1e-3);
                // What is no single box has one size.
                let keep_to = if self.drag.targets.is_single_box() { self.keep_to } else { KeepTo::All };
                let grows = |axis: usize| match keep_to {
                    KeepTo::All => true,
                    KeepTo::Axis(only) => axis == only,
                    KeepTo::Plane(not) => axis != not,
                };
                Act::Stretch(DVec3::from([0, 1, 2].map(|axis| if grows(axis) { by } else { 1.0 })))
            }
        }
    }

    /// How far the pointer has gone along an axis, metres. An axis that is seen from its end is gone along up the screen.
    fn along(&self, axis: usize, at: Pos2, screen: &Screen) -> f64 {
        let pivot = self.drag.targets.pivot;
        let [from, to] = [self.from, at].map(|at| screen.along(at, pivot, self.axis(axis)));
        match from.zip(to) {
            Some((from, to)) => to - from,
            None => f64::from(self.from.y - at.y) * screen.metres_per_point(pivot),
        }
    }

    /// How far it has gone in the plane that it is kept to, or across the view, metres in the world.
    fn across(&self, keep_to: KeepTo, at: Pos2, screen: &Screen) -> DVec3 {
        let pivot = self.drag.targets.pivot;
        let view = &screen.view;
        let way = (at - self.from) * screen.metres_per_point(pivot) as f32;
        let freely = (view.right * way.x - view.up * way.y).as_dvec3();
        let KeepTo::Plane(axis) = keep_to else { return freely };
        let normal = self.axis(axis);
        let meet = |at: Pos2| {
            let ray = screen.ray(at).as_dvec3();
            let depth = (pivot - view.eye).dot(normal) / ray.dot(normal);
            (depth > 0.0 && depth.is_finite()).then(|| ray * depth)
        };
        let grazes = view.forward.as_dvec3().dot(normal).abs() < 0.05;
        match meet(self.from).zip(meet(at)).filter(|_| !grazes) {
            Some((from, to)) => to - from,
            None => freely - normal * freely.dot(normal),
        }
    }

    /// Lines through the pivot along which it may go.
    fn paint_axes(&self, painter: &Painter, screen: &Screen) {
        let targets = &self.drag.targets;
        let reach = targets.pivot.distance(screen.view.eye) * AXIS_REACH;
        let axes: &[usize] = match self.keep_to {
            KeepTo::All => &[],
            KeepTo::Axis(axis) => &[[0], [1], [2]][axis],
            KeepTo::Plane(axis) => &[[1, 2], [0, 2], [0, 1]][axis],
        };
        for axis in axes {
            let color = [theme::AXIS_X, theme::AXIS_Y, theme::AXIS_Z][*axis];
            let ends = [-reach, reach].map(|by| screen.relative(targets.pivot + self.axis(*axis) * by));
            if let Some(line) = screen.line(ends[0], ends[1]) {
                let stroke = Stroke::new(1.5, color);
                painter.line_segment(line, theme::casing(stroke));
                painter.line_segment(line, stroke);
            }
        }
    }

    /// What it has come to, by which keys.
    fn words(&self) -> String {
        let what = match self.grabbed {
            Grabbed::Place => "Move",
            Grabbed::Turn => "Rotate",
            Grabbed::Size => "Scale",
        };
        let kept = match self.keep_to {
            KeepTo::All => "",
            KeepTo::Axis(axis) => [" along x", " along y", " along z"][axis],
            KeepTo::Plane(axis) => [" across x", " across y", " across z"][axis],
        };
        let typed = if self.typed.is_empty() { String::new() } else { format!(" [{}]", self.typed) };
        let come_to = self.drag.readout().map_or_else(String::new, |text| format!(": {text}"));
        format!("{what}{kept}{typed}{come_to}")
    }
}

/// Adds a key to a number that is typed, if that makes one.
fn type_key(typed: &mut String, key: Key) {
    const FIGURES: [Key; 10] =
        [Key::Num0, Key::Num1, Key::Num2, Key::Num3, Key::Num4, Key::Num5, Key::Num6, Key::Num7, Key::Num8, Key::Num9];
    let figure = FIGURES.iter().position(|figure| *figure == key);
    match (key, figure) {
        (_, Some(figure)) if typed.len() < MOST_FIGURES => *typed += &figure.to_string(),
        (Key::Period | Key::Comma, _) if !typed.contains('.') && typed.len() < MOST_FIGURES => typed.push('.'),
        // Turns the sign, wherever it is typed.
        (Key::Minus, _) => match typed.strip_prefix('-') {
            Some(rest) => *typed = rest.into(),
            None => typed.insert(0, '-'),
        },
        (Key::Backspace, _) => drop(typed.pop()),
        _ => {}
    }
}

/// From one way to another, radians clockwise on the screen, at most half a turn.
fn turned_between(from: egui::Vec2, to: egui::Vec2) -> f64 {
    if from == egui::Vec2::ZERO || to == egui::Vec2::ZERO {
        return 0.0;
    }
    (f64::from(to.angle() - from.angle()) + PI).rem_euclid(TAU) - PI
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_make_a_number() {
        for (keys, number) in [
            (&[Key::Num1, Key::Num2, Key::Period, Key::Num5][..], Some(12.5)),
            (&[Key::Minus, Key::Num4], Some(-4.0)),
            (&[Key::Num4, Key::Minus, Key::Minus], Some(4.0)),
            (&[Key::Num4, Key::Num2, Key::Backspace], Some(4.0)),
            (&[Key::Comma, Key::Comma, Key::Num5], Some(0.5)),
            (&[Key::Minus], None),
            (&[Key::Q], None),
            (&[Key::Num9; 40], Some(999_999_999_999.0)),
        ] {
            let mut typed = String::new();
            keys.iter().for_each(|key| type_key(&mut typed, *key));
            assert_eq!(typed.parse().ok(), number, "{typed}");
        }
    }

    #[test]
    fn goes_around_without_a_seam() {
        let way = |degrees: f32| egui::Vec2::angled(degrees.to_radians());
        for (from, to, by) in [(10.0, 30.0, 20.0), (170.0, -170.0, 20.0), (-170.0, 170.0, -20.0)] {
            assert!((turned_between(way(from), way(to)).to_degrees() - by).abs() < 1e-3);
        }
        assert_eq!(turned_between(egui::Vec2::ZERO, way(1.0)), 0.0);
    }
}
