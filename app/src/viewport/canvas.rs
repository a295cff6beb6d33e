//! The picture with the lens before it: what is drawn by which method, and what each remembers of the view's way.
//!
//! The truth sees a view as the shipped rules remember it. A method that goes by others needs a memory of its own beside
//! that one, and the memory by the truth's rules goes on through all changes of method.

use super::lens::LensSource;
use super::memory::{Memory, ViewAt};
use super::picture::PictureSource;
use crate::renderer::RendererChoice;
use crate::state::{Lens, Reading};
use cloudwright_core::detail::Detail;
use cloudwright_core::method;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::sight::Sight;
use eframe::egui_wgpu::RenderState;
use egui::{Color32, Painter, Rect, Ui, pos2};
use std::time::Duration;

/// What is drawn in the viewport, under marks and handles.
pub(super) struct Canvas {
    picture: PictureSource,
    lens: LensSource,
    /// By the truth's rules.
    true_memory: Memory,
    /// By the method's, if it goes by others.
    own_memory: Option<Memory>,
}

impl Canvas {
    pub(super) fn new(context: &egui::Context, choice: RendererChoice, device: Option<RenderState>) -> Self {
        Self {
            picture: PictureSource::new(context, choice, device),
            lens: LensSource::new(context),
            true_memory: Memory::new(method::truth().rules),
            own_memory: None,
        }
    }

    /// The view is put elsewhere.
    pub(super) fn begin_anew(&mut self) {
        self.true_memory.begin_anew();
        self.own_memory = None;
    }

    /// Which renderer draws.
    pub(super) fn renderer_name(&self) -> String {
        self.picture.renderer_name()
    }

    /// Whether the window has a device that draws.
    pub(super) fn has_device(&self) -> bool {
        self.picture.own_rules().rasterizer == Rasterizer::Gpu
    }

    /// How high the lower right corner is covered, points.
    pub(super) fn legend_height(lens: Lens) -> f32 {
        super::lens::legend_height(lens)
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
    /// lets a slow renderer draw less. How marks at all sprites are to see them.
    pub(super) fn show(
        &mut self,
        ui: &mut Ui,
        painter: &Painter,
        rect: Rect,
        at: &ViewAt<'_>,
        quick: bool,
        reading: &Reading<'_>,
    ) -> Sight {
        let (session, view) = (reading.session, reading.view);
        let detail = if view.all_sprites { Detail::FULL } else { Detail::AUTOMATIC };
        let own = || Rules { detail, ..self.picture.own_rules().sorted(view.sorting) };
        let rules = view.method.map_or_else(own, |method| method.rules);
        let truth = self.true_memory.sight(&method::truth().rules, at, reading);
        let sight = if rules.remember_as(&truth.rules) {
            self.own_memory = None;
            Sight { rules, ..truth.clone() }
        } else {
            self.own_memory.get_or_insert_with(|| Memory::new(rules)).sight(&rules, at, reading)
        };
        match view.lens {
            Lens::Picture => self.lens.put_away(),
            _ if quick => self.lens.wait(),
            lens => self.lens.ask(lens, session, sight.clone(), truth),
        }
        self.picture.ask(session, sight.clone(), quick);
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
        sight
    }
}
