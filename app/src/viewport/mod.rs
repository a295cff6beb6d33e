//! The viewport: the picture, what is drawn over it, and what pointer and keys do in it.
//!
//! The camera here is the editor's own; a saved camera changes only when the user says so. The picture comes from
//! [`picture`], which draws off the frame; boxes, marks and handles are painted over it at once. The primary button
//! belongs to the tool, the middle one turns and moves the view ([`steer`]), the right one flies ([`fly_control`]).

mod beside;
mod bounds;
mod box_tool;
mod cameras;
mod canvas;
mod compass;
mod drag;
mod faces;
mod fly;
mod fly_control;
mod gizmo;
mod grab;
mod grip;
mod hover;
mod hud;
mod inset;
mod keyed_clouds;
mod lens;
mod level_handles;
mod looking;
mod marks;
mod marquee;
mod memory;
mod menu;
mod navigation;
mod on_board;
mod onto;
mod overlay;
mod parallel;
mod paths;
mod pick;
mod picture;
mod places;
mod plane;
mod props;
mod quad;
mod ruler;
mod screen;
mod side;
mod steer;
mod targets;
mod through;
mod wireframe;

pub(crate) use grab::Grabbed;
pub(crate) use picture::image;

use crate::renderer::RendererChoice;
use crate::state::{Action, Choose, Item, Reading, Session, Tool, ViewChange};
use box_tool::BoxTool;
use canvas::Canvas;
use cloudwright_core::scene::Camera;
use cloudwright_core::sight::Sight;
use eframe::egui_wgpu::RenderState;
use egui::{Align2, CursorIcon, Painter, Response, Sense, Ui, Vec2, vec2};
use faces::Faces;
use fly_control::FlyControl;
use gizmo::{GizmoHands, Touch};
use glam::DVec3;
use grab::Grab;
use hover::Hover;
use hud::Readout;
use inset::Inset;
use marks::Marks;
use marquee::Marquee;
use memory::ViewAt;
use navigation::Navigation;
use on_board::{OnBoard, PathView};
use paths::Paths;
use pick::{Clicks, Picked};
use screen::Screen;
use std::time::Duration;
use through::Through;

/// Of what is measured in the viewport's shape, the longer side by the shorter one.
const LONGEST: f32 = 4.0;

/// How the scene is looked at.
pub(crate) struct Viewport {
    navigation: Navigation,
    fly_control: FlyControl,
    on_board: Option<OnBoard>,
    through: Option<Through>,
    canvas: Canvas,
    inset: Inset,
    marks: Marks,
    paths: Paths,
    clicks: Clicks,
    hover: Hover,
    marquee: Marquee,
    gizmo: GizmoHands,
    grab: Grab,
    faces: Faces,
    box_tool: BoxTool,
    /// Width by height.
    aspect: f32,
    /// What was shown last.
    sight: Option<Sight>,
    /// What is to draw, and the window's own device.
    renderer: RendererChoice,
    device: Option<RenderState>,
    /// Those beside it, while four views are shown.
    sides: Vec<Viewport>,
    /// Whether the pointer was in it last.
    has_pointer: bool,
}

impl Viewport {
    /// Draws with `device`, the window's own, if the choice and the device allow it.
    pub(crate) fn new(
        context: &egui::Context,
        session: &Session,
        choice: RendererChoice,
        device: Option<RenderState>,
    ) -> Self {
        let mut viewport = Self::blank(context, choice, device);
        viewport.see(session);
        viewport
    }

    /// One that looks nowhere yet.
    fn blank(context: &egui::Context, renderer: RendererChoice, device: Option<RenderState>) -> Self {
        Self {
            navigation: Navigation::new(Camera::free(DVec3::ZERO), 1.0),
            fly_control: FlyControl::default(),
            on_board: None,
            through: None,
            canvas: Canvas::new(context, renderer, device.clone()),
            inset: Inset::new(context),
            marks: Marks::default(),
            paths: Paths::default(),
            clicks: Clicks::default(),
            hover: Hover::default(),
            marquee: Marquee::default(),
            gizmo: GizmoHands::default(),
            grab: Grab::default(),
            faces: Faces::default(),
            box_tool: BoxTool::default(),
            aspect: 16.0 / 9.0,
            sight: None,
            renderer,
            device,
            sides: Vec::new(),
            has_pointer: false,
        }
    }

    /// The window's own device and its driver, if it has one.
    pub(crate) fn driver(&self) -> Option<String> {
        self.device.as_ref().map(driver)
    }

    /// Width by height of the picture; of a strip, that of a wider one.
    pub(crate) fn aspect(&self) -> f32 {
        self.aspect
    }

    /// The camera of the view.
    pub(crate) fn camera(&self) -> &Camera {
        self.navigation.camera()
    }

    /// What was shown last, at its full size; nothing before the first frame.
    pub(crate) fn sight(&self) -> Option<&Sight> {
        self.sight.as_ref()
    }

    /// The point that the view turns about: new things come here.
    pub(crate) fn looked_at(&self) -> DVec3 {
        self.navigation.pivot().round()
    }

    /// Which renderer draws.
    pub(crate) fn renderer_name(&self) -> String {
        self.canvas.renderer_name()
    }

    /// Whether the window has a device that draws, whatever is chosen.
    pub(crate) fn has_device(&self) -> bool {
        self.canvas.has_device()
    }

    /// What the last picture took.
    pub(crate) fn picture_time(&self) -> Option<Duration> {
        self.canvas.time()
    }

    /// How often the last picture's pixels were blended over, in the mean, where that is known.
    pub(crate) fn overdraw(&self) -> Option<f32> {
        self.canvas.overdraw()
    }

    /// Whether a tool goes on with its gesture though no button is down.
    pub(crate) fn holds_gesture(&self) -> bool {
        self.own_gesture() || self.sides.iter().any(Self::own_gesture)
    }

    fn own_gesture(&self) -> bool {
        self.box_tool.holds_gesture() || self.grab.holds_gesture()
    }

    /// Whether keys steer a flight or a grab, and are no commands.
    pub(crate) fn has_keys(&self) -> bool {
        self.own_keys() || self.sides.iter().any(Self::own_keys)
    }

    fn own_keys(&self) -> bool {
        self.fly_control.has_keys() || self.grab.has_keys()
    }

    /// The selection follows the pointer from now on, in the view that has it.
    pub(crate) fn grab(&mut self, grabbed: Grabbed) {
        match self.sides.iter_mut().find(|side| side.has_pointer) {
            Some(side) => side.grab.want(grabbed),
            None => self.grab.want(grabbed),
        }
    }

    fn show_one(&mut self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        let (label, pinned) = (self.label(), self.navigation.pinned());
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(label));
        self.has_pointer = response.contains_pointer();
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        let is_free = !self.gizmo.is_held() && !self.marquee.is_on() && !self.grab.is_on();
        let may_fly = is_free && !self.own_gesture() && pinned.is_none();
        // A right button that has flown or ended something is no click.
        let may_ask = may_fly && !self.fly_control.is_flying();
        let path_view = self.take_path_view(reading);
        self.go_with_camera(reading);
        self.navigation.stay_above(reading.session.scene().ground.as_ref().map(|ground| ground.altitude_m));
        self.fly_control.fly(&mut self.navigation, ui, &response, may_fly);
        if is_free && !self.fly_control.is_held() {
            let screen = Screen::new(&self.eye(rect, reading), rect);
            steer::steer(&mut self.navigation, ui, &response, &screen, reading);
        }
        let path_view = self.keep_path_view(path_view);
        self.through = self.through.take().filter(|through| *self.navigation.camera() == through.last);
        let screen = Screen::new(&self.eye(rect, reading), rect);
        let painter = ui.painter_at(rect);
        let sight = self.paint_picture(ui, &response, &painter, path_view.as_ref(), reading);
        if let Some(ground) = reading.session.scene().ground.as_ref().filter(|_| sight.hidden.ground) {
            parallel::paint_ground(&painter, &screen, self.navigation.pivot(), ground.altitude_m);
        }
        if self.is_orthographic() {
            ruler::paint(&painter, &screen, self.navigation.pivot(), reading.units);
        }
        self.marks.paint(&painter, &screen, &sight, reading);
        wireframe::paint(&painter, &screen, reading);
        cameras::paint(&painter, &screen, reading);
        props::paint(&painter, &screen, reading);
        let ridden = self.on_board.as_ref().map(|on_board| on_board.path);
        self.paths.paint(&painter, &screen, ridden, reading);
        if self.through.is_some() {
            through::paint(ui, &painter, rect, self.camera(), reading.picture_size);
        }
        self.work(ui, &response, &painter, &screen, reading, actions);
        // The compass has its corner to itself.
        let compass = compass::place(rect).filter(|_| pinned.is_none());
        let right = compass.map_or(rect.right(), |place| place.left());
        level_handles::show(ui, rect, right, &screen.view, reading, actions);
        if let Some(side) = pinned {
            overlay::plate(ui, rect.left_top() + vec2(14.0, 10.0), Align2::LEFT_TOP, side.name());
            return self.menu(!self.own_gesture(), &response, &screen, reading, actions);
        }
        if self.fly_control.is_held() {
            overlay::flying_hint(&painter, rect, &reading.units.speed().text(self.fly_control.speed_m_s()));
        } else if path_view.is_some() {
            overlay::on_board_hint(&painter, rect);
        } else if self.grab.is_on() {
            overlay::grab_hint(&painter, rect);
        } else {
            overlay::hint(&painter, rect, reading.view.tool, self.own_gesture());
        }
        if reading.is_recording {
            overlay::recording(&painter, rect);
        }
        let along_path = path_view.map(|path_view| Readout::of(&path_view.camera, path_view.speed_m_s));
        if let Some(readout) = along_path.or_else(|| self.fly_control.readout(&self.navigation)) {
            readout.show(ui, rect, reading.units);
        }
        overlay::show(ui, rect, reading, actions);
        let seen_through = self.through.as_ref().map(Through::id);
        let raised = Canvas::legend_height(reading.view.lens);
        self.inset.show(ui, rect, raised, seen_through, reading, actions);
        if let Some(place) = compass {
            let turned = compass::show(ui, place, &screen, self.is_orthographic(), actions);
            if turned != Vec2::ZERO {
                self.leave();
                self.navigation.orbit(turned);
                ui.ctx().request_repaint();
            }
        }
        self.menu(may_ask, &response, &screen, reading, actions);
    }

    /// How marks at sprites are to see them.
    fn paint_picture(
        &mut self,
        ui: &mut Ui,
        response: &Response,
        painter: &Painter,
        path_view: Option<&PathView>,
        reading: &Reading<'_>,
    ) -> Sight {
        let session = reading.session;
        let by_hand = (response.dragged() && !self.marquee.is_on()) || self.fly_control.is_flying();
        let quick = by_hand || session.document().is_open() || reading.time_play.runs() || reading.clock.moves();
        let pixels = (response.rect.size() * ui.pixels_per_point()).round().max(Vec2::ONE);
        self.aspect = (pixels.x / pixels.y).clamp(1.0 / LONGEST, LONGEST);
        let path = self
            .on_board
            .as_ref()
            .filter(|_| path_view.is_some())
            .and_then(|on_board| session.scene().path(on_board.path));
        let place = ViewAt {
            camera: self.eye(response.rect, reading),
            is_orthographic: self.is_orthographic(),
            path,
            size: [pixels.x as u32, pixels.y as u32],
        };
        let sight = self.canvas.show(ui, painter, response.rect, &place, quick, reading);
        self.sight = Some(sight.clone());
        sight
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
        if self.grab.show(ui, response, painter, screen, reading, actions) {
            return;
        }
        if reading.view.tool == Tool::Box {
            let looked_at = self.looked_at();
            if response.hovered() {
                ui.ctx().set_cursor_icon(CursorIcon::Crosshair);
            }
            self.box_tool.show(ui, response, painter, screen, looked_at, reading, actions);
            return;
        }
        self.box_tool.leave();
        // Handles on what the clock moves would be in the picture's way, and run from the hand.
        let has_handles = !reading.clock.plays() || self.gizmo.is_held();
        let on_face = has_handles.then(|| self.faces.show(ui, painter, screen, reading, actions)).flatten();
        let touch =
            if has_handles { self.gizmo.show(ui, response, painter, screen, reading, actions) } else { Touch::None };
        let (modifiers, pressed) = ui.input(|input| (input.modifiers, input.pointer.primary_pressed()));
        self.show_hover(ui, response, painter, screen, touch, reading);
        if pressed
            && response.contains_pointer()
            && touch == Touch::None
            && !modifiers.alt
            && let Some(at) = response.interact_pointer_pos().or(response.hover_pos())
            && !(self.navigation.pinned().is_none() && compass::place(screen.rect).is_some_and(|it| it.contains(at)))
        {
            self.marquee.begin(at);
        }
        self.marquee.show(ui, painter, screen, reading, actions);
        let double = response.double_clicked().then(|| response.interact_pointer_pos()).flatten();
        if let Some((path, Some(index))) = double.and_then(|at| self.paths.under(at, screen)) {
            actions.push(Action::GoToKey(path, index));
            return;
        }
        let clicked = response.clicked().then(|| response.interact_pointer_pos()).flatten();
        if let Some(at) = clicked.or(on_face)
            && touch == Touch::None
            && !modifiers.alt
        {
            self.click(at, marquee::how(modifiers, Choose::Toggle), screen, reading, actions);
        }
    }

    /// What a press would take, where that is not the gizmo, and nothing moves.
    fn show_hover(
        &mut self,
        ui: &Ui,
        response: &Response,
        painter: &Painter,
        screen: &Screen,
        touch: Touch,
        reading: &Reading<'_>,
    ) {
        let at = response.hover_pos().filter(|_| touch == Touch::None && !self.fly_control.is_held());
        let is_busy = ui.input(|input| input.pointer.any_down()) || reading.clock.moves() || self.marquee.is_on();
        let Some(at) = at.filter(|_| !is_busy && self.on_board.is_none()) else { return self.hover.leave() };
        let (paths, clicks, camera) = (&self.paths, &self.clicks, self.navigation.camera());
        let find = || hover::over(paths.under(at, screen), clicks, at, screen, camera, reading);
        self.hover.show(painter, at, screen, camera, reading, find);
    }

    fn click(
        &mut self,
        at: egui::Pos2,
        how: Choose,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        if let Some((path, key)) = self.paths.under(at, screen) {
            actions.push(Action::Select { items: vec![Item::Path(path)], through: None, how });
            actions.push(Action::View(ViewChange::PathKey(key.map(|index| (path, index)))));
            return;
        }
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

fn driver(device: &RenderState) -> String {
    let about = device.adapter.get_info();
    let words = [format!("{} ({:?})", about.name, about.backend), about.driver, about.driver_info];
    words.into_iter().filter(|words| !words.is_empty()).collect::<Vec<_>>().join(", ")
}
