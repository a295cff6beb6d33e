//! The picture with the lens before it: what is drawn by which method, and what each remembers of the view's way.
//!
//! The truth sees a view as the shipped rules remember it. A method with other rules, or with fewer sprites, needs a
//! memory of its own beside that one, and the memory by the truth's rules goes on through all changes of method.

use super::brush::{Brush, Place};
use super::lens::LensSource;
use super::picture::{PictureSource, Shot};
use crate::renderer::RendererChoice;
use crate::state::{Lens, Reading};
use cloudwright_core::facing::FacingMemory;
use cloudwright_core::method::{self, Renderer, Settings};
use eframe::egui_wgpu::RenderState;
use egui::{Color32, Painter, Rect, Ui, pos2};
use std::time::Duration;

/// What is drawn in the viewport, under marks and handles.
pub(super) struct Canvas {
    picture: PictureSource,
    lens: LensSource,
    /// By the truth's rules, of all sprites.
    true_brush: Brush,
    /// The method's, if it goes by others or drops sprites.
    own_brush: Option<Brush>,
}

impl Canvas {
    pub(super) fn new(context: &egui::Context, choice: RendererChoice, device: Option<RenderState>) -> Self {
        Self {
            picture: PictureSource::new(context, choice, device),
            lens: LensSource::new(context),
            true_brush: Brush::default(),
            own_brush: None,
        }
    }

    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        self.true_brush.begin_anew();
        self.own_brush = None;
    }

    /// Which renderer draws.
    pub(super) fn renderer_name(&self) -> String {
        self.picture.renderer_name()
    }

    /// Whether the window has a device that draws.
    pub(super) fn has_device(&self) -> bool {
        self.picture.own_settings().renderer == Renderer::Gpu
    }

    /// Whether that draws aircraft too.
    pub(super) fn draws_aircraft(&self) -> bool {
        self.picture.is_by_gpu()
    }

    /// What the last picture took.
    pub(super) fn time(&self) -> Option<Duration> {
        self.picture.time()
    }

    /// How often the last picture's pixels were blended over, in the mean, where that is known.
    pub(super) fn overdraw(&self) -> Option<f32> {
        self.picture.overdraw()
    }

    /// Has drawn what is to be seen in `rect`, and shows what is there of it. While a hand moves something, `quick`
    /// lets a slow renderer draw less. How sprites face the view.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        painter: &Painter,
        rect: Rect,
        place: &Place<'_>,
        quick: bool,
        reading: &Reading<'_>,
    ) -> FacingMemory {
        let (session, view) = (reading.session, reading.view);
        let own = || Settings { sorting: view.sorting, ..self.picture.own_settings() };
        let settings = view.method.map_or_else(own, |method| method.settings);
        let truth = self.true_brush.shot(&method::truth().settings, place, reading);
        let is_alike = settings.history() == method::truth().settings.history() && settings.kept >= 1.0;
        let shot = if is_alike {
            self.own_brush = None;
            Shot { settings, ..truth.clone() }
        } else {
            self.own_brush.get_or_insert_default().shot(&settings, place, reading)
        };
        // Marks are at all sprites, whatever is drawn.
        let facing = if shot.clouds.is_none() { &shot.history } else { &truth.history }.facing.clone();
        match view.lens {
            Lens::Picture => self.lens.put_away(),
            _ if quick => self.lens.wait(),
            lens => self.lens.ask(lens, session, shot.clone(), truth),
        }
        self.picture.ask(session, shot, quick);
        match self.picture.texture() {
            Some(texture) => {
                let whole = Rect::from_min_max(pos2(0.0, 0.0), pos2(1.0, 1.0));
                painter.image(texture, rect, whole, Color32::WHITE);
            }
            None => {
                painter.rect_filled(rect, 0.0, ui.visuals().extreme_bg_color);
            }
        }
        if view.lens != Lens::Picture {
            let name = view.method.map_or("picture", |method| method.name);
            self.lens.show(ui, painter, rect, view.lens, name);
        }
        facing
    }
}
