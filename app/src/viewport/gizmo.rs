//! Arrows, rings and cubes on what is selected: the crate transform-gizmo, which knows neither this egui nor this glam.
//!
//! It is handed camera-relative f64 matrices, so that it works as well 1,000 km from the origin, and gives back what
//! the hand has done since the button went down; [`Targets`] makes edits of that. It brings its own emath and glam:
//! numbers cross as arrays.
//!
//! The crate takes what is met within a few points across a ring's plane, which is less than one where the ring is seen
//! from its edge. So it is handed the nearest point of what is drawn in the pointer's stead, if that is within reach.

use super::drag::Drag;
use super::grip::{self, BESIDE, REACH};
use super::overlay;
use super::screen::Screen;
use super::targets::{Act, Targets};
use crate::state::{Action, Reading, Tool};
use crate::theme;
use cloudwright_core::camera::NEAR_M;
use egui::epaint::{Vertex, WHITE_UV};
use egui::{Key, Mesh, Painter, Pos2, Response, Rgba, Shape, Ui, Vec2, pos2, vec2};
use glam::{DQuat, DVec3};
use transform_gizmo::config::TransformPivotPoint;
use transform_gizmo::math::{Pos2 as GizmoPos, Transform};
use transform_gizmo::{
    EnumSet, Gizmo, GizmoConfig, GizmoInteraction, GizmoMode, GizmoOrientation, GizmoResult, GizmoVisuals, Rect, mint,
};

/// The gizmo and what it holds.
#[derive(Default)]
pub(super) struct GizmoHands {
    gizmo: Gizmo,
    held: Option<Held>,
}

/// A drag of one of its parts.
struct Held {
    tool: Tool,
    drag: Drag,
    /// From the pointer to the point of the part that it took.
    aside: Vec2,
}

/// How the pointer stands to the gizmo.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Touch {
    /// It is elsewhere.
    None,
    /// It just misses it: a press there means nothing else.
    Beside,
    /// It has a part of it, or would with a press.
    On,
}

impl GizmoHands {
    /// Whether the hand drags it.
    pub(super) fn is_held(&self) -> bool {
        self.held.is_some()
    }

    /// Draws it where there is something to work on, and asks for what the hand does.
    pub(super) fn show(
        &mut self,
        ui: &Ui,
        response: &Response,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) -> Touch {
        let (at, pressed, down, dropped, modifiers) = ui.input(|input| {
            let pointer = &input.pointer;
            let dropped = input.key_pressed(Key::Escape);
            (pointer.latest_pos(), pointer.primary_pressed(), pointer.primary_down(), dropped, input.modifiers)
        });
        let was_held = self.held.is_some();
        let untouched = if was_held { Touch::On } else { Touch::None };
        if !down || dropped {
            self.held = None;
        }
        let tool = self.held.as_ref().map_or(reading.view.tool, |held| held.tool);
        let idle = match self.held {
            Some(_) => None,
            None => Targets::of(tool, reading).filter(|targets| is_before(screen, targets)),
        };
        let Some(targets) = self.held.as_ref().map(|held| &held.drag.targets).or(idle.as_ref()) else {
            return untouched;
        };
        let Some(modes) = modes(tool, targets) else { return untouched };
        let snap = reading.view.snap;
        let snaps = snap.on != modifiers.command;
        let snap_angle = snaps.then_some(snap.angle_deg.to_radians()).filter(|step| *step > 0.0);
        self.gizmo.update_config(GizmoConfig {
            modes,
            orientation: orientation(targets),
            // Moves snap onto others before they snap to steps, which the crate knows nothing of.
            snapping: snaps && tool != Tool::Move,
            snap_angle: snap.angle_deg.to_radians() as f32,
            snap_scale: snap.scale as f32,
            pixels_per_point: ui.pixels_per_point(),
            visuals: visuals(),
            ..seen(screen, targets.pivot)
        });
        let turn = targets.turn;
        let transform = Transform::from_scale_rotation_translation(
            [1.0; 3],
            mint::Quaternion::from(turn.to_array()),
            (targets.pivot - screen.view.eye).to_array(),
        );
        let over = response.contains_pointer();
        let (aside, beside) = match &self.held {
            Some(held) => (held.aside, true),
            None => at.filter(|_| over).map_or((Vec2::ZERO, false), |at| self.reach(at, &transform)),
        };
        let interaction = GizmoInteraction {
            cursor_pos: at.map_or((f32::MIN, f32::MIN), |at| (at.x + aside.x, at.y + aside.y)),
            hovered: over || self.held.is_some(),
            drag_started: pressed && over && !modifiers.alt && !dropped,
            dragging: down && !dropped,
        };
        let result = self.gizmo.update(interaction, &[transform]);
        if let Some((result, _)) = result {
            if let (None, Some(targets)) = (&self.held, idle) {
                self.held = Some(Held { tool, drag: Drag::new(targets), aside });
            }
            if let Some(held) = &mut self.held {
                held.drag.let_go();
                let act = match act(result, turn, snap_angle) {
                    Act::Move(by) if snaps => Act::Move(held.drag.snapped(by, screen, reading)),
                    act => act,
                };
                held.drag.follow(act, reading, actions);
            }
        }
        let mesh = mesh(&self.gizmo);
        painter.add(Shape::mesh(casing(&mesh)));
        painter.add(Shape::mesh(mesh));
        if let Some(held) = &self.held {
            held.drag.paint_met(painter, screen);
        }
        if let Some((text, at)) = self.held.as_ref().and_then(|held| held.drag.readout()).zip(at) {
            overlay::label(painter, at + vec2(16.0, 16.0), &text);
        }
        let has_pointer = self.gizmo.is_focused() || self.held.is_some();
        if has_pointer {
            ui.ctx().set_cursor_icon(egui::CursorIcon::PointingHand);
        }
        match (has_pointer || was_held, beside) {
            (true, _) => Touch::On,
            (false, true) => Touch::Beside,
            (false, false) => Touch::None,
        }
    }

    /// The way from the pointer to where a press takes a part of the gizmo, if it is within reach; and whether the pointer is
    /// at least beside it.
    fn reach(&mut self, at: Pos2, transform: &Transform) -> (Vec2, bool) {
        let nowhere =
            GizmoInteraction { cursor_pos: (f32::MIN, f32::MIN), hovered: false, drag_started: false, dragging: false };
        // Lays the parts out for this frame.
        self.gizmo.update(nowhere, &[*transform]);
        let Some(rim) = grip::nearest_of(&mesh(&self.gizmo), at) else { return (Vec2::ZERO, false) };
        let way = rim - at;
        if way.length() > BESIDE {
            return (Vec2::ZERO, false);
        }
        // From the rim of what is drawn on to its middle, which is what the crate measures from.
        let steps = (0..=4_u8).map(|step| way + way.normalized() * (f32::from(step) * theme::GIZMO_WIDTH * 0.25));
        let hot = |way: &Vec2| self.gizmo.pick_preview((at.x + way.x, at.y + way.y));
        let within = (way.length() <= REACH).then_some(steps).into_iter().flatten();
        (within.into_iter().find(hot).unwrap_or(Vec2::ZERO), true)
    }
}

/// What the hand has done since the button went down, in the world. `turn` is of the gizmo's axes.
fn act(result: GizmoResult, turn: DQuat, snap_angle: Option<f64>) -> Act {
    let vector = |v: mint::Vector3<f64>| DVec3::new(v.x, v.y, v.z);
    match result {
        GizmoResult::Translation { total, .. } => Act::Move(turn * vector(total)),
        // The crate counts turns as they look on the screen.
        GizmoResult::Rotation { axis, total, is_view_axis, .. } => {
            let axis = if is_view_axis { vector(axis) } else { turn * vector(axis) };
            // It snaps to steps in f32.
            let total = snap_angle.map_or(total, |step| (total / step).round() * step);
            Act::Turn(axis.normalize_or(DVec3::Y), -total)
        }
        GizmoResult::Scale { total } => Act::Stretch(vector(total)),
        GizmoResult::Arcball { .. } => Act::Move(DVec3::ZERO),
    }
}

fn modes(tool: Tool, targets: &Targets) -> Option<EnumSet<GizmoMode>> {
    let round = GizmoMode::RotateX | GizmoMode::RotateY | GizmoMode::RotateZ | GizmoMode::RotateView;
    let along = GizmoMode::ScaleX | GizmoMode::ScaleY | GizmoMode::ScaleZ | GizmoMode::ScaleUniform;
    let planes = GizmoMode::TranslateXY | GizmoMode::TranslateXZ | GizmoMode::TranslateYZ;
    match tool {
        Tool::Move => Some(GizmoMode::TranslateX | GizmoMode::TranslateY | GizmoMode::TranslateZ | planes),
        Tool::Rotate if targets.stay_upright() => Some(GizmoMode::RotateY.into()),
        Tool::Rotate => Some(round),
        Tool::Scale if targets.is_single_box() => Some(along),
        Tool::Scale => Some(GizmoMode::ScaleUniform.into()),
        Tool::Select | Tool::Box => None,
    }
}

/// The world's axes are the gizmo's own where nothing is turned.
fn orientation(targets: &Targets) -> GizmoOrientation {
    if targets.turn == DQuat::IDENTITY { GizmoOrientation::Global } else { GizmoOrientation::Local }
}

fn is_before(screen: &Screen, targets: &Targets) -> bool {
    screen.view.depth(screen.relative(targets.pivot)) > NEAR_M * 2.0
}

/// The view from the eye, with near and far planes about the pivot, where the crate's arithmetic is best.
fn seen(screen: &Screen, pivot: DVec3) -> GizmoConfig {
    let view = &screen.view;
    let row = |axis: glam::Vec3| [f64::from(axis.x), f64::from(axis.y), f64::from(axis.z), 0.0];
    let tan = f64::from(view.tan_half_height);
    let aspect = f64::from(view.width) / f64::from(view.height);
    let depth = f64::from(view.depth(screen.relative(pivot)).max(NEAR_M));
    let (near, far) = (depth * 0.01, depth * 10.0);
    let projection = [
        [1.0 / (tan * aspect), 0.0, 0.0, 0.0],
        [0.0, 1.0 / tan, 0.0, 0.0],
        [0.0, 0.0, -(far + near) / (far - near), -2.0 * far * near / (far - near)],
        [0.0, 0.0, -1.0, 0.0],
    ];
    let rect = screen.rect;
    GizmoConfig {
        view_matrix: mint::RowMatrix4::from([row(view.right), row(view.up), row(-view.forward), [0.0, 0.0, 0.0, 1.0]]),
        projection_matrix: mint::RowMatrix4::from(projection),
        viewport: Rect {
            min: GizmoPos { x: rect.min.x, y: rect.min.y },
            max: GizmoPos { x: rect.max.x, y: rect.max.y },
        },
        pivot_point: TransformPivotPoint::MedianPoint,
        ..GizmoConfig::default()
    }
}

fn visuals() -> GizmoVisuals {
    let color = |color: egui::Color32| transform_gizmo::Color32::from_rgb(color.r(), color.g(), color.b());
    GizmoVisuals {
        x_color: color(theme::AXIS_X),
        y_color: color(theme::AXIS_Y),
        z_color: color(theme::AXIS_Z),
        s_color: color(theme::AXIS_VIEW),
        highlight_color: Some(color(theme::GIZMO_HOVERED)),
        inactive_alpha: 0.9,
        highlight_alpha: 1.0,
        stroke_width: theme::GIZMO_WIDTH,
        gizmo_size: theme::GIZMO_SIZE,
    }
}

fn mesh(gizmo: &Gizmo) -> Mesh {
    let drawn = gizmo.draw();
    let vertices = drawn.vertices.iter().zip(&drawn.colors).map(|([x, y], [r, g, b, a])| Vertex {
        pos: pos2(*x, *y),
        uv: WHITE_UV,
        color: Rgba::from_rgba_premultiplied(*r, *g, *b, *a).into(),
    });
    Mesh { vertices: vertices.collect(), indices: drawn.indices, ..Mesh::default() }
}

/// What goes under it, so that it is seen on bright clouds: its own shadows to four sides.
fn casing(mesh: &Mesh) -> Mesh {
    let mut casing = Mesh::default();
    for side in [vec2(1.0, 0.0), vec2(0.0, 1.0), vec2(-1.0, 0.0), vec2(0.0, -1.0)] {
        let mut shadow = mesh.clone();
        for vertex in &mut shadow.vertices {
            vertex.pos += side * theme::CASING_WIDTH;
            vertex.color = theme::CASING.gamma_multiply_u8(vertex.color.a());
        }
        casing.append(shadow);
    }
    casing
}
