//! The picture in the viewport: asked for when something changed, drawn off the frame, shown when it is there.
//!
//! The CPU draws on a worker thread, at half the resolution while a hand is moving something and in full when it
//! rests; nothing is drawn, and the window isn't repainted, while nothing changes.

use crate::editor::Session;
use crate::opening::{self, SceneAtlas};
use crate::renderer::{RenderError, Renderer, RendererChoice};
use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::scene::{Camera, Scene};
use egui::{Color32, ColorImage, TextureHandle, TextureId, TextureOptions};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// Larger pictures than any window need not be asked for.
const MAX_SIDE: u32 = 8192;

/// A frame to draw, with all it needs.
struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    atlas: SceneAtlas,
    camera: Camera,
    size: [u32; 2],
}

struct Answer {
    picture: Result<Picture, RenderError>,
    time: Duration,
}

/// What a picture shows: another key, another picture.
#[derive(PartialEq)]
struct Key {
    revision: u64,
    camera: Camera,
    size: [u32; 2],
}

/// Draws the viewport's pictures.
pub(super) struct PictureSource {
    context: egui::Context,
    // GPU: an arm that draws into a texture of the window's own device goes beside the worker.
    worker: Option<Latest<Request, Answer>>,
    renderer_name: String,
    asked: Option<Key>,
    texture: Option<TextureHandle>,
    time: Option<Duration>,
}

impl PictureSource {
    pub(super) fn new(context: &egui::Context) -> Self {
        let mut source = Self {
            context: context.clone(),
            worker: None,
            renderer_name: "no renderer".into(),
            asked: None,
            texture: None,
            time: None,
        };
        if let Ok(mut renderer) = Renderer::new(RendererChoice::Cpu) {
            source.renderer_name = renderer.name();
            let wake = context.clone();
            // Without a thread there is no picture, but still an editor that can save.
            source.worker =
                Latest::start("pictures", move |request| draw(&mut renderer, &request), move || wake.request_repaint())
                    .ok();
        }
        source
    }

    pub(super) fn renderer_name(&self) -> &str {
        &self.renderer_name
    }

    pub(super) fn time(&self) -> Option<Duration> {
        self.time
    }

    /// Asks for a picture of `size` pixels if it would be another than the last one; `quick` for half as many.
    pub(super) fn ask(&mut self, session: &Session, camera: &Camera, size: [u32; 2], quick: bool) {
        let size = size.map(|side| (if quick { side.div_ceil(2) } else { side }).clamp(1, MAX_SIDE));
        let key = Key { revision: session.revision(), camera: camera.clone(), size };
        if self.asked.as_ref() == Some(&key) {
            return;
        }
        let (scene, derived, atlas) = session.to_draw();
        if let Some(worker) = &self.worker {
            worker.ask(Request { scene, derived, atlas, camera: camera.clone(), size });
        }
        self.asked = Some(key);
    }

    /// The newest picture.
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

fn draw(renderer: &mut Renderer, request: &Request) -> Answer {
    let begun = Instant::now();
    let Request { scene, derived, atlas, camera, size } = request;
    let frame = Frame::new(scene, derived, opening::sheet(atlas), camera, scene.time_of_day_h, *size);
    Answer { picture: renderer.picture(&frame, 1), time: begun.elapsed() }
}
