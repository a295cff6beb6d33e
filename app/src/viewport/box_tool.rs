//! The box tool: drag a footprint at the base altitude, let go, pull the height, click.
//!
//! From the first point of the drag to the click it is one open gesture, so the cloud grows under the hand and is one
//! undo step. The box goes into the selected cloud's model, or into a new cloud around it. Enter finishes, or puts a box
//! where the view looks; Esc drops it at any stage.

mod drawn;
mod surface;

use super::marquee::LEAST_DRAG;
use super::screen::Screen;
use super::{overlay, plane, wireframe};
use crate::state::{Action, Choose, Item, Reading, box_of};
use drawn::{Drawn, Made, Target};
use egui::{Key, Modifiers, Painter, Pos2, Response, Ui, vec2};
use glam::DVec3;
use surface::{At, DEPTH_SHARE, Surface};

/// What the history calls it, before the box's name.
const NAME: &str = "Draw";

/// The tool between its clicks.
#[derive(Debug, Default)]
pub(super) struct BoxTool {
    drawing: Option<Drawing>,
}

#[derive(Debug)]
struct Drawing {
    drawn: Drawn,
    surface: Surface,
    stage: Stage,
}

#[derive(Debug, Clone, Copy)]
enum Stage {
    /// The button went down there.
    Footprint(Pos2),
    /// The button was let go there, when the box had this height.
    Height(Pos2, f64),
}

/// What pointer and keys do in this frame.
struct Input {
    at: Option<Pos2>,
    pressed: bool,
    down: bool,
    enter: bool,
    escape: bool,
    /// Metres; none to draw freely.
    snap_m: Option<f64>,
}

impl BoxTool {
    /// Whether the gesture stays open though no button is down.
    pub(super) fn holds_gesture(&self) -> bool {
        matches!(self.drawing, Some(Drawing { stage: Stage::Height(..), .. }))
    }

    /// Another tool was chosen: what is drawn stays as it is.
    pub(super) fn leave(&mut self) {
        self.drawing = None;
    }

    /// Draws as pointer and keys say. `looked_at` is where Enter puts a box.
    #[allow(clippy::too_many_arguments, reason = "each is another kind of thing")]
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        response: &Response,
        painter: &Painter,
        screen: &Screen,
        looked_at: DVec3,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        let input = read_input(ui, response, reading);
        let lost = |drawing: &Drawing| drawing.drawn.made.is_some() && !reading.session.document().is_open();
        if input.escape || self.drawing.as_ref().is_some_and(lost) {
            self.drawing = None;
            return;
        }
        let base_m = reading.view.base_altitude_m(reading.session.scene());
        match self.drawing.take() {
            None => self.begin(&input, screen, base_m, looked_at, reading, actions),
            Some(drawing) => self.drawing = drawing.go_on(&input, screen, reading, actions),
        }
        self.paint(&input, painter, screen, looked_at, reading);
    }

    fn begin(
        &mut self,
        input: &Input,
        screen: &Screen,
        base_m: f64,
        looked_at: DVec3,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        if input.enter {
            let mut drawn = Drawn::new(Target::of(reading), DVec3 { y: base_m, ..looked_at });
            drawn.stand_about(looked_at);
            finish(drawn, reading, actions);
        } else if input.pressed
            && let Some(at) = input.at
            && let Some((surface, from)) = Surface::at(at, screen, base_m, looked_at, drawn_at(reading))
        {
            let mut drawn = Drawn::new(Target::of(reading), from);
            surface.drag(&mut drawn, from, input.snap_m);
            self.drawing = Some(Drawing { drawn, surface, stage: Stage::Footprint(at) });
        }
    }

    fn paint(&self, input: &Input, painter: &Painter, screen: &Screen, looked_at: DVec3, reading: &Reading<'_>) {
        let base_m = reading.view.base_altitude_m(reading.session.scene());
        let Some(at) = input.at.filter(|at| screen.rect.contains(*at)) else { return };
        let drawn = self.drawing.as_ref().map(|drawing| &drawing.drawn);
        let point = match drawn {
            Some(drawn) => Some(drawn.to),
            None => Surface::at(at, screen, base_m, looked_at, drawn_at(reading)).map(|(_, point)| point),
        };
        let Some(point) = point else {
            overlay::label(painter, at + vec2(16.0, 16.0), "The base altitude is out of sight here");
            return;
        };
        let made = drawn.and_then(|drawn| drawn.made);
        let scene = reading.session.scene();
        if let Some((cloud, each)) =
            made.and_then(|made| scene.cloud(made.cloud).zip(box_of(scene, made.model, made.id)))
        {
            wireframe::paint_selected(painter, screen, cloud, each);
        }
        let space = drawn.map_or_else(|| Target::of(reading).space(), |drawn| drawn.target.space());
        plane::paint_patch(painter, screen, &space, point, input.snap_m.unwrap_or(0.0));
        let text = match drawn {
            Some(drawn) => {
                let size = drawn.size_m();
                let depth = format!("depth {:.0} % of the width", DEPTH_SHARE * 100.0);
                let why = match self.drawing.as_ref().and_then(|drawing| drawing.surface.upright_at()) {
                    Some(At::Edge) => format!(" · base seen from its edge: {depth}"),
                    Some(At::Cloud) => format!(" · at the selected cloud: {depth}"),
                    None => String::new(),
                };
                format!("{:.0} × {:.0} × {:.0} m{why}", size.x, size.y, size.z)
            }
            None => format!("base {} m", base_m.round()),
        };
        overlay::label(painter, at + vec2(16.0, 16.0), &text);
    }
}

impl Drawing {
    /// The next step; none when it is done or dropped.
    fn go_on(
        mut self,
        input: &Input,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) -> Option<Self> {
        let Some(at) = input.at else { return Some(self) };
        let before = self.drawn.clone();
        match self.stage {
            Stage::Footprint(from) => {
                let is_drag = at.distance(from) >= LEAST_DRAG;
                if is_drag && let Some(to) = self.surface.under(at, screen) {
                    self.surface.drag(&mut self.drawn, to, input.snap_m);
                }
                if !input.down {
                    if !is_drag || self.drawn.made.is_none() && before == self.drawn {
                        if self.drawn.made.is_some() {
                            actions.push(Action::DropGesture);
                        }
                        return None;
                    }
                    self.stage = Stage::Height(at, self.drawn.height_m);
                }
            }
            Stage::Height(from, height_m) => {
                let pulled = pulled_m(screen, self.drawn.to, from, at);
                self.drawn.pull_to(height_m + pulled, input.snap_m);
                if input.pressed || input.enter {
                    finish(self.drawn, reading, actions);
                    return None;
                }
            }
        }
        if before != self.drawn {
            let edits = self.drawn.edits(reading.session.scene());
            actions.push(Action::Change { name: NAME, edits, live: true });
        }
        Some(self)
    }
}

/// The middle and the reach of the cloud that is drawn into, if there is anything of it yet.
fn drawn_at(reading: &Reading<'_>) -> Option<(DVec3, f64)> {
    let Target::Cloud(cloud) = Target::of(reading) else { return None };
    let placed = reading.session.placed(cloud.id).filter(|placed| !placed.sprites.is_empty())?;
    Some((placed.origin + placed.center.as_dvec3(), f64::from(placed.reach)))
}

fn finish(mut drawn: Drawn, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let edits = drawn.edits(reading.session.scene());
    actions.push(Action::Change { name: NAME, edits, live: false });
    if let Some(Made { model, cloud, id }) = drawn.made {
        actions.push(Action::Select { items: vec![Item::Box(model, id)], through: Some(cloud), how: Choose::Only });
    }
}

/// How far the pointer was pulled up along the vertical through a corner, metres. Seen from above, where that is a
/// point, by its way up the screen.
fn pulled_m(screen: &Screen, corner: DVec3, from: Pos2, to: Pos2) -> f64 {
    let [a, b] = [from, to].map(|at| screen.along(at, corner, DVec3::Y));
    match a.zip(b) {
        Some((a, b)) if screen.view.forward.y.abs() < 0.95 => b - a,
        _ => f64::from(from.y - to.y) * screen.metres_per_point(corner),
    }
}

fn read_input(ui: &Ui, response: &Response, reading: &Reading<'_>) -> Input {
    let (focused, dialog) = ui.memory(|memory| (memory.focused(), memory.top_modal_layer().is_some()));
    let may_type = !dialog && focused.is_none_or(|id| id == response.id);
    let snap = reading.view.snap;
    ui.input_mut(|input| Input {
        at: input.pointer.latest_pos().filter(|_| !dialog),
        pressed: response.contains_pointer() && input.pointer.primary_pressed() && !input.modifiers.alt,
        down: input.pointer.primary_down(),
        enter: may_type && input.consume_key(Modifiers::NONE, Key::Enter),
        escape: input.key_pressed(Key::Escape),
        snap_m: (snap.on != input.modifiers.command).then_some(snap.step_m).filter(|step| *step > 0.0),
    })
}
