//! Pictures from a worker thread, at the resolution asked for; the latest request wins.

use super::Shot;
use crate::editor::Session;
use crate::opening::Beside;
use crate::renderer::{RenderError, Renderer};
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::overdraw;
use cloudwright_core::scene::Scene;
use egui::{Color32, ColorImage, TextureHandle, TextureId, TextureOptions};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A frame to draw, with all it needs.
struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    shot: Shot,
    coarseness: u32,
}

struct Answer {
    picture: Result<Picture, RenderError>,
    time: Duration,
    coarseness: u32,
    /// Sprites blended on a pixel, in the mean; none while a gesture goes on.
    overdraw: Option<f32>,
}

pub(super) struct ByCpu {
    context: egui::Context,
    /// None if the system gives no thread: then there is no picture, but still an editor that can save.
    worker: Option<Latest<Request, Answer>>,
    name: String,
    texture: Option<TextureHandle>,
    last: Option<(Duration, u32)>,
    overdraw: Option<f32>,
}

impl ByCpu {
    pub(super) fn new(context: &egui::Context) -> Self {
        let wake = context.clone();
        let worker = Latest::start("pictures", |request| draw(&request), move || wake.request_repaint()).ok();
        Self { context: context.clone(), worker, name: Renderer::Cpu.name(), texture: None, last: None, overdraw: None }
    }

    /// Why the CPU draws although a GPU was meant to.
    pub(super) fn explain(&mut self, error: &cloudwright_render::RenderError) {
        self.name = format!("{} ({error})", Renderer::Cpu.name());
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn time(&self) -> Option<Duration> {
        self.last.map(|(time, _)| time)
    }

    /// What the last picture took, and how coarse it was.
    pub(super) fn last(&self) -> Option<(Duration, u32)> {
        self.last
    }

    pub(super) fn overdraw(&self) -> Option<f32> {
        self.overdraw
    }

    pub(super) fn ask(&mut self, session: &Session, shot: &Shot, coarseness: u32) {
        if let Some(worker) = &self.worker {
            let (scene, derived, beside) = session.to_draw();
            worker.ask(Request { scene, derived, beside, shot: shot.clone(), coarseness });
        }
    }

    pub(super) fn texture(&mut self) -> Option<TextureId> {
        let answer = self.worker.as_ref().and_then(Latest::newest);
        if let Some(Answer { picture: Ok(picture), time, coarseness, overdraw }) = answer {
            self.show(&picture);
            self.last = Some((time, coarseness));
            self.overdraw = overdraw.or(self.overdraw);
        }
        self.texture.as_ref().map(TextureHandle::id)
    }

    fn show(&mut self, picture: &Picture) {
        let size = [picture.width as usize, picture.height as usize];
        let pixels = picture.pixels.iter().map(|&[r, g, b, _]| Color32::from_rgb(r, g, b)).collect();
        let image = ColorImage::new(size, pixels);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(self.context.load_texture("picture", image, TextureOptions::LINEAR)),
        }
    }
}

fn draw(request: &Request) -> Answer {
    let begun = Instant::now();
    let Request { scene, derived, beside, shot, coarseness } = request;
    let frame = shot.frame(scene, derived, beside);
    let picture = Renderer::Cpu.picture(&frame, 1);
    let time = begun.elapsed();
    // Counted at rest only: it is nothing that a gesture should wait for.
    let overdraw = (*coarseness == 1).then(|| overdraw(&frame).mean_per_pixel as f32);
    Answer { picture, time, coarseness: *coarseness, overdraw }
}
