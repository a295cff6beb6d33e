//! The viewport: the picture, what is drawn over it, and the hands on it.
//!
//! The camera here is the editor's own; a saved camera changes only when the user says so. The picture comes from
//! [`picture`], which draws off the frame; boxes are painted over it at once.

mod level_handles;
mod navigation;
mod pick;
mod picture;
mod wireframe;

use crate::editor::{Action, Choose, Selection, Session};
use crate::panel::Reading;
use crate::renderer::RendererChoice;
use crate::theme;
use cloudwright_core::camera::View;
use cloudwright_core::scene::Camera;
use eframe::egui_wgpu::RenderState;
use egui::{
    Align2, Color32, EventFilter, FontId, Key, Modifiers, PointerButton, Rect, Response, Sense, Ui, pos2, vec2,
};
use glam::{DVec3, Vec3};
use navigation::Navigation;
use picture::PictureSource;
use std::time::Duration;

/// How the scene is looked at.
pub(crate) struct Viewport {
    navigation: Navigation,
    picture: PictureSource,
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
            picture: PictureSource::new(context, choice, device),
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
        self.navigation = Navigation::new(camera.clone(), nearest.unwrap_or(2000.0));
    }

    /// Brings a selection into view; all clouds for nothing.
    pub(crate) fn frame(&mut self, selection: &Selection, session: &Session) {
        if let Some((center, radius)) = pick::bounds(selection, session) {
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

    pub(crate) fn show(&mut self, ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
        let session = reading.session;
        let (rect, response) = ui.allocate_exact_size(ui.available_size(), Sense::click_and_drag());
        ui.ctx().accesskit_node_builder(response.id, |node| node.set_label("Viewport"));
        // In points: navigation and outlines don't care how fine the picture is.
        let view = |camera: &Camera| View::new(camera, rect.width() as u32, rect.height() as u32);
        self.navigate(ui, &response, &view(self.navigation.camera()), session);
        let view = view(self.navigation.camera());
        if response.clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            let ray = ray_at(&view, rect, at);
            let picked = pick::pick(&view, ray, reading);
            let items = picked.map(|(item, _)| item).into_iter().collect();
            actions.push(Action::Select { items, through: picked.map(|(_, cloud)| cloud), how: Choose::Only });
        }
        let quick = response.dragged() || session.document().is_open() || reading.time_play.is_on();
        let pixels = (rect.size() * ui.pixels_per_point()).round();
        let size = [pixels.x as u32, pixels.y as u32];
        self.picture.ask(session, self.navigation.camera(), reading.hour(), size, quick);
        let painter = ui.painter_at(rect);
        match self.picture.texture() {
            Some(texture) => {
                let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                painter.image(texture, rect, whole, Color32::WHITE);
            }
            None => {
                painter.rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
            }
        }
        wireframe::paint(&painter, rect, &view, session.scene(), reading.view);
        level_handles::show(ui, rect, &view, reading, actions);
        hint(&painter, rect);
    }

    fn navigate(&mut self, ui: &Ui, response: &Response, view: &View, session: &Session) {
        let shift = ui.input(|input| input.modifiers.shift);
        let by = |button| response.dragged_by(button);
        let moved = response.drag_delta();
        if by(PointerButton::Secondary) || (shift && (by(PointerButton::Primary) || by(PointerButton::Middle))) {
            self.navigation.pan(moved, view);
        } else if by(PointerButton::Primary) || by(PointerButton::Middle) {
            self.navigation.orbit(moved);
        }
        if response.hovered()
            && let Some(at) = response.hover_pos()
        {
            let turned = ui.input(|input| input.smooth_scroll_delta().y + 100.0 * (input.zoom_delta() - 1.0));
            if turned != 0.0 {
                let ray = ray_at(view, response.rect, at);
                let depth = pick::depth(view, ray, session).unwrap_or(self.navigation.distance() as f32);
                self.navigation.zoom(turned, ray * depth);
            }
        }
        if response.clicked() || response.drag_started() {
            response.request_focus();
        }
        // The keyboard's way, for who has no wheel.
        if response.has_focus() {
            let arrows = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
            ui.memory_mut(|memory| memory.set_focus_lock_filter(response.id, arrows));
            let step = |plus: Key, minus: Key| {
                ui.input_mut(|input| {
                    f32::from(input.consume_key(Modifiers::NONE, plus))
                        - f32::from(input.consume_key(Modifiers::NONE, minus))
                })
            };
            let turn = vec2(step(Key::ArrowRight, Key::ArrowLeft), step(Key::ArrowDown, Key::ArrowUp)) * 20.0;
            self.navigation.orbit(turn);
            let closer = step(Key::Plus, Key::Minus) * 50.0;
            if closer != 0.0 {
                self.navigation.zoom(closer, view.forward * self.navigation.distance() as f32);
            }
        }
    }
}

/// Through a point of the window; as long as [`View::ray`] says.
fn ray_at(view: &View, rect: Rect, at: egui::Pos2) -> Vec3 {
    view.ray(at.x - rect.left(), at.y - rect.top())
}

fn hint(painter: &egui::Painter, rect: Rect) {
    const TEXT: &str = "drag: turn   shift or right drag: move   wheel: nearer   F: frame";
    let at = rect.left_bottom() + vec2(theme::VIEWPORT_MARGIN, -theme::VIEWPORT_MARGIN);
    let galley = painter.layout_no_wrap(TEXT.into(), FontId::proportional(11.0), theme::VIEWPORT_TEXT);
    let text_rect = Align2::LEFT_BOTTOM.anchor_size(at, galley.size());
    painter.rect_filled(text_rect.expand2(vec2(6.0, 3.0)), 4.0, theme::VIEWPORT_SHADE);
    painter.galley(text_rect.min, galley, theme::VIEWPORT_TEXT);
}
