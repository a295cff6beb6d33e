//! Pictures from a worker thread, at the resolution asked for; the latest request wins.

use crate::editor::Session;
use crate::opening::{self, SceneAtlas};
use crate::renderer::{RenderError, Renderer};
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::scene::{Camera, Scene};
use egui::{Color32, ColorImage, TextureHandle, TextureId, TextureOptions};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// A frame to draw, with all it needs.
struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    atlas: SceneAtlas,
    camera: Camera,
    hour: f64,
    size: [u32; 2],
}

struct Answer {
    picture: Result<Picture, RenderError>,
    time: Duration,
}

pub(super) struct ByCpu {
    context: egui::Context,
    /// None if the system gives no thread: then there is no picture, but still an editor that can save.
    worker: Option<Latest<Request, Answer>>,
    name: String,
    texture: Option<TextureHandle>,
    time: Option<Duration>,
}

impl ByCpu {
    pub(super) fn new(context: &egui::Context) -> Self {
        let wake = context.clone();
        let worker = Latest::start("pictures", |request| draw(&request), move || wake.request_repaint()).ok();
        Self { context: context.clone(), worker, name: Renderer::Cpu.name(), texture: None, time: None }
    }

    /// Why the CPU draws although a GPU was meant to.
    pub(super) fn explain(&mut self, error: &cloudwright_render::RenderError) {
        self.name = format!("{} ({error})", Renderer::Cpu.name());
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn time(&self) -> Option<Duration> {
        self.time
    }

    pub(super) fn ask(&mut self, session: &Session, camera: &Camera, hour: f64, size: [u32; 2]) {
        if let Some(worker) = &self.worker {
            let (scene, derived, atlas) = session.to_draw();
            worker.ask(Request { scene, derived, atlas, camera: camera.clone(), hour, size });
        }
    }

    pub(super) fn texture(&mut self) -> Option<TextureId> {
        let answer = self.worker.as_ref().and_then(Latest::newest);
        if let Some(Answer { picture: Ok(picture), time }) = answer {
            self.show(&picture);
            self.time = Some(time);
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
    let Request { scene, derived, atlas, camera, hour, size } = request;
    let frame = Frame::new(scene, derived, opening::sheet(atlas), camera, *hour, *size);
    Answer { picture: Renderer::Cpu.picture(&frame, 1), time: begun.elapsed() }
}
