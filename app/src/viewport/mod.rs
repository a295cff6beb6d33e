//! The viewport: the picture, what is drawn over it, and the hands on it.
//!
//! The camera here is the editor's own; a saved camera changes only when the user says so. The picture comes from
//! [`picture`], which draws off the frame; boxes, marks and handles are painted over it at once. The primary button
//! belongs to the tool, the middle one turns and moves the view ([`steer`]), the right one flies ([`pilot`]).

mod bounds;
mod box_tool;
mod cameras;
mod faces;
mod fly;
mod gizmo;
mod hud;
mod level_handles;
mod marks;
mod marquee;
mod navigation;
mod overlay;
mod pick;
mod picture;
mod pilot;
mod plane;
mod screen;
mod steer;
mod targets;
mod way;
mod wireframe;

use crate::editor::{Action, Choose, Selection, Session, Tool};
use crate::panel::Reading;
use crate::renderer::RendererChoice;
use box_tool::BoxTool;
use cloudwright_core::camera::View;
use cloudwright_core::scene::Camera;
use eframe::egui_wgpu::RenderState;
use egui::{Color32, CursorIcon, Painter, Rect, Response, Sense, Ui, pos2};
use faces::Faces;
use gizmo::GizmoHands;
use glam::DVec3;
use marks::Marks;
use marquee::Marquee;
use navigation::Navigation;
use pick::{Clicks, Picked};
use picture::{PictureSource, Shot};
use pilot::Pilot;
use screen::Screen;
use std::time::Duration;
use way::Way;

/// How the scene is looked at.
pub(crate) struct Viewport {
    navigation: Navigation,
    pilot: Pilot,
    way: Way,
    picture: PictureSource,
    marks: Marks,
    clicks: Clicks,
    marquee: Marquee,
    gizmo: GizmoHands,
    faces: Faces,
    box_tool: BoxTool,
}

impl Viewport {
    /// Draws with `device`, the window's own, if the choice and the device allow it.
    pub(crate) fn new(
        context: &egui::Context,
        session: &Session,
        choice: RendererChoice,
        device: Option<RenderState>,
    ) -> Self {
        let mut viewport = Self {
            navigation: Navigation::new(Camera::free(DVec3::ZERO), 1.0),
            pilot: Pilot::default(),
            way: Way::default(),
            picture: PictureSource::new(context, choice, device),
            marks: Marks::default(),
            clicks: Clicks::default(),
            marquee: Marquee::default(),
            gizmo: GizmoHands::default(),
            faces: Faces::default(),
            box_tool: BoxTool::default(),
        };
        viewport.see(session);
        viewport
    }

    /// Looks through the scene's first camera, or at all of it.
    pub(crate) fn see(&mut self, session: &Session) {
        match session.scene().cameras.first() {
            Some(camera) => self.look_through(camera, session),
            None => self.frame(&Selection::default(), session),
        }
    }

    /// Sees what `camera` sees; turns about the nearest cloud before it.
    pub(crate) fn look_through(&mut self, camera: &Camera, session: &Session) {
        let view = View::new(camera, 1, 1);
        let depth = session.derived().clouds().iter().map(|cloud| {
            let center = (cloud.origin - view.eye).as_vec3() + cloud.center;
            f64::from(view.depth(center))
        });
        let nearest = depth.filter(|depth| *depth > 1.0).reduce(f64::min);
        self.pilot.stop();
        self.way.begin_anew();
        self.navigation = Navigation::new(camera.clone(), nearest.unwrap_or(2000.0));
    }

    /// Brings a selection into view; all clouds for nothing.
    pub(crate) fn frame(&mut self, selection: &Selection, session: &Session) {
        if let Some((center, radius)) = bounds::bounds(selection, session) {
            self.pilot.stop();
            self.way.begin_anew();
            self.navigation.frame(center, radius);
        }
    }

    /// The camera of the view.
    pub(crate) fn camera(&self) -> &Camera {
        self.navigation.camera()
    }

    /// The point that the view turns about: new things come here.
    pub(crate) fn looked_at(&self) -> DVec3 {
        self.navigation.pivot().round()
    }

    /// Which renderer draws.
    pub(crate) fn renderer_name(&self) -> &str {
        self.picture.renderer_name()
    }

    /// What the last picture took.
    pub(crate) fn picture_time(&self) -> Option<Duration> {
        self.picture.time()
    }

    /// How often the last picture's pixels were blended over, in the mean, where that is known.
    pub(crate) fn overdraw(&self) -> Option<f32> {
        self.picture.overdraw()
    }

    /// Whether a tool goes on with its gesture though no button is down.
    pub(crate) fn holds_gesture(&self) -> bool {
        self.box_tool.holds_gesture()
    }

    /// Whether keys steer a flight and are no commands.
    pub(crate) fn has_keys(&self) -> bool {
        self.pilot.has_keys()
    }

    pub(crate) fn show(&mut self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("Viewport"));
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        let is_free = !self.gizmo.is_held() && !self.marquee.is_on();
        let may_fly = is_free && !self.holds_gesture();
        self.pilot.fly(&mut self.navigation, ui, &response, may_fly);
        if is_free && !self.pilot.is_held() {
            let screen = Screen::new(self.camera(), rect);
            steer::steer(&mut self.navigation, ui, &response, &screen, reading);
        }
        let screen = Screen::new(self.camera(), rect);
        let painter = ui.painter_at(rect);
        self.paint_picture(ui, &response, &painter, reading);
        self.marks.paint(&painter, &screen, reading);
        wireframe::paint(&painter, &screen, reading.session.scene(), reading.view);
        cameras::paint(&painter, &screen, reading);
        self.work(ui, &response, &painter, &screen, reading, actions);
        level_handles::show(ui, rect, &screen.view, reading, actions);
        if self.pilot.is_held() {
            overlay::flying_hint(&painter, rect, &reading.units.speed().text(self.pilot.speed_m_s()));
        } else {
            overlay::hint(&painter, rect, reading.view.tool, self.holds_gesture());
        }
        if let Some(readout) = self.pilot.readout(&self.navigation) {
            readout.show(ui, rect, reading.units);
        }
        overlay::show(ui, rect, reading, actions);
    }

    fn paint_picture(&mut self, ui: &Ui, response: &Response, painter: &Painter, reading: &Reading<'_>) {
        let session = reading.session;
        let by_hand = (response.dragged() && !self.marquee.is_on()) || self.pilot.is_flying();
        let quick = by_hand || session.document().is_open() || reading.time_play.is_on();
        let pixels = (response.rect.size() * ui.pixels_per_point()).round();
        let size = [pixels.x as u32, pixels.y as u32];
        let hidden = reading.view.hidden_in(session.scene());
        let camera = self.navigation.camera().clone();
        let history = self.way.follow(&camera, session.derived()).clone();
        let shot = Shot { camera, hour: reading.hour(), size, hidden, history };
        self.picture.ask(session, shot, quick);
        match self.picture.texture() {
            Some(texture) => {
                let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                painter.image(texture, response.rect, whole, Color32::WHITE);
            }
            None => {
                painter.rect_filled(response.rect, 0.0, ui.visuals().extreme_bg_color);
            }
        }
    }

    /// The tools: who gets the primary button is decided when it goes down.
    fn work(
        &mut self,
        ui: &Ui,
        response: &Response,
        painter: &Painter,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        if reading.view.tool == Tool::Box {
            let looked_at = self.looked_at();
            if response.hovered() {
                ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            }
            self.box_tool.show(ui, response, painter, screen, looked_at, reading, actions);
            return;
        }
        self.box_tool.leave();
        let on_face = self.faces.show(ui, painter, screen, reading, actions);
        let gizmo_has_pointer = self.gizmo.show(ui, response, painter, screen, reading, actions);
        let (modifiers, pressed) = ui.input(|input| (input.modifiers, input.pointer.primary_pressed()));
        if pressed
            && response.contains_pointer()
            && !gizmo_has_pointer
            && !modifiers.alt
            && let Some(at) = response.interact_pointer_pos().or(response.hover_pos())
        {
            self.marquee.begin(at);
        }
        self.marquee.show(ui, painter, screen, reading, actions);
        let clicked = response.clicked().then(|| response.interact_pointer_pos()).flatten();
        if let Some(at) = clicked.or(on_face)
            && !gizmo_has_pointer
            && !modifiers.alt
        {
            self.click(at, marquee::how(modifiers, Choose::Toggle), screen, reading, actions);
        }
    }

    fn click(
        &mut self,
        at: egui::Pos2,
        how: Choose,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        let picked = if how == Choose::Only {
            self.clicks.pick(at, screen, self.navigation.camera(), reading)
        } else {
            let under = pick::under(at, screen, reading);
            under.get(pick::first(&under, reading)).copied()
        };
        match picked {
            Some(Picked { item, through }) => actions.push(Action::Select { items: vec![item], through, how }),
            None if how == Choose::Only => actions.push(Action::Select { items: Vec::new(), through: None, how }),
            None => {}
        }
    }
}
