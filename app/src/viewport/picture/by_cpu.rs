//! Pictures from a worker thread, at the resolution asked for; the latest request wins.

use super::image;
use crate::opening::Beside;
use crate::state::Session;
use crate::worker::{self, Latest};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::overdraw;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use egui::{TextureHandle, TextureId, TextureOptions};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A frame to draw, with all it needs.
struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    sight: Sight,
    coarseness: u32,
    watch: Arc<Watch>,
}

struct Answer {
    /// None if it is not whole.
    picture: Option<Picture>,
    time: Duration,
    coarseness: u32,
    /// Sprites blended on a pixel, in the mean; none while a gesture goes on.
    overdraw: Option<f32>,
}

pub(super) struct ByCpu {
    context: egui::Context,
    /// None if the system gives no thread: then there is no picture, but still an editor that can save.
    worker: Option<Latest<Request, Answer>>,
    /// Of the newest request.
    watch: Arc<Watch>,
    asked_coarseness: u32,
    texture: Option<TextureHandle>,
    last: Option<(Duration, u32)>,
    overdraw: Option<f32>,
}

impl ByCpu {
    pub(super) fn new(context: &egui::Context) -> Self {
        let wake = context.clone();
        let pool = worker::pool_beside_the_window("pictures");
        let work = move |request: Request| match &pool {
            // What takes long leaves the window its core.
            Some(pool) if request.sight.rules.rasterizer != Rules::SHIPPED.rasterizer => {
                pool.install(|| draw(&request))
            }
            _ => draw(&request),
        };
        let worker = Latest::start("pictures", work, move || wake.request_repaint()).ok();
        let context = context.clone();
        Self { context, worker, watch: Arc::default(), asked_coarseness: 1, texture: None, last: None, overdraw: None }
    }

    /// What the last picture took, and how coarse it was.
    pub(super) fn last(&self) -> Option<(Duration, u32)> {
        self.last
    }

    pub(super) fn overdraw(&self) -> Option<f32> {
        self.overdraw
    }

    pub(super) fn ask(&mut self, session: &Session, sight: &Sight, coarseness: u32) {
        let Some(worker) = &self.worker else { return };
        // What is overtaken is shown all the same, so that a drag shows something; but the whole truth takes too long.
        if self.asked_coarseness == 1 {
            self.watch.cancel();
        }
        (self.watch, self.asked_coarseness) = (Arc::default(), coarseness);
        let (scene, derived, beside) = session.to_draw();
        let (sight, watch) = (sight.clone(), Arc::clone(&self.watch));
        worker.ask(Request { scene, derived, beside, sight, coarseness, watch });
    }

    pub(super) fn texture(&mut self) -> Option<TextureId> {
        let answer = self.worker.as_ref().and_then(Latest::newest);
        if let Some(Answer { picture: Some(picture), time, coarseness, overdraw }) = answer {
            self.show(&picture);
            self.last = Some((time, coarseness));
            self.overdraw = overdraw.or(self.overdraw);
        }
        self.texture.as_ref().map(TextureHandle::id)
    }

    fn show(&mut self, picture: &Picture) {
        let image = image(picture);
        match &mut self.texture {
            Some(texture) => texture.set(image, TextureOptions::LINEAR),
            None => self.texture = Some(self.context.load_texture("picture", image, TextureOptions::LINEAR)),
        }
    }
}

fn draw(request: &Request) -> Answer {
    let begun = Instant::now();
    let Request { scene, derived, beside, sight, coarseness, watch } = request;
    let frame = Frame::new(scene, derived, beside.sheet(), sight);
    let is_whole = || sight.rules.rasterizer != Rasterizer::Truth || !watch.is_cancelled();
    let picture = draw::picture(&frame, watch).filter(|_| is_whole());
    let time = begun.elapsed();
    if picture.is_none() {
        return Answer { picture, time, coarseness: *coarseness, overdraw: None };
    }
    // Counted at rest only: it is nothing that a gesture should wait for.
    let overdraw = (*coarseness == 1).then(|| overdraw(&frame).mean_per_pixel as f32);
    Answer { picture, time, coarseness: *coarseness, overdraw }
}

impl Drop for ByCpu {
    fn drop(&mut self) {
        self.watch.cancel();
    }
}
