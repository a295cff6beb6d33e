//! The picture in the viewport: drawn when something changed, and only then, so that an idle window does nothing.
//!
//! On a GPU it is drawn with the window's own device, into a texture that egui shows as it is. The CPU draws on a
//! worker thread ([`by_cpu`]). A GPU that fails (its device lost, a scene too large for it) gives way to the CPU.

mod by_cpu;
mod by_gpu;

use crate::editor::Session;
use crate::renderer::RendererChoice;
use by_cpu::ByCpu;
use by_gpu::ByGpu;
use cloudwright_core::scene::Camera;
use cloudwright_core::version::Version;
use eframe::egui_wgpu::RenderState;
use egui::TextureId;
use std::time::Duration;

/// Larger pictures than any window need not be asked for.
const MAX_SIDE: u32 = 8192;

/// What a picture shows: another key, another picture.
#[derive(PartialEq)]
struct Key {
    revision: Version,
    camera: Camera,
    hour: f64,
    size: [u32; 2],
}

/// Draws the viewport's pictures.
pub(super) struct PictureSource {
    context: egui::Context,
    source: Source,
    asked: Option<Key>,
}

enum Source {
    Cpu(ByCpu),
    Gpu(Box<ByGpu>),
}

impl PictureSource {
    pub(super) fn new(context: &egui::Context, choice: RendererChoice, device: Option<RenderState>) -> Self {
        let gpu = match choice {
            RendererChoice::Cpu => None,
            RendererChoice::Auto => device.and_then(ByGpu::new).filter(|gpu| !gpu.is_software()),
            RendererChoice::Gpu => device.and_then(ByGpu::new),
        };
        let source = gpu.map_or_else(|| Source::Cpu(ByCpu::new(context)), |gpu| Source::Gpu(Box::new(gpu)));
        Self { context: context.clone(), source, asked: None }
    }

    pub(super) fn renderer_name(&self) -> &str {
        match &self.source {
            Source::Cpu(cpu) => cpu.name(),
            Source::Gpu(gpu) => gpu.name(),
        }
    }

    /// What the last picture took: on a GPU, what it took to prepare and send off.
    pub(super) fn time(&self) -> Option<Duration> {
        match &self.source {
            Source::Cpu(cpu) => cpu.time(),
            Source::Gpu(gpu) => gpu.time(),
        }
    }

    /// Has a picture of `size` pixels at `hour` drawn if it would be another than the last one. While a hand moves something,
    /// `quick` lets a slow renderer draw less.
    pub(super) fn ask(&mut self, session: &Session, camera: &Camera, hour: f64, size: [u32; 2], quick: bool) {
        let halved = quick && matches!(self.source, Source::Cpu(_));
        let size = size.map(|side| (if halved { side.div_ceil(2) } else { side }).clamp(1, MAX_SIDE));
        let key = Key { revision: session.revision(), camera: camera.clone(), hour, size };
        if self.asked.as_ref() == Some(&key) {
            return;
        }
        match &mut self.source {
            Source::Cpu(cpu) => cpu.ask(session, camera, hour, size),
            Source::Gpu(gpu) => {
                if let Err(error) = gpu.draw(session, camera, hour, size) {
                    let mut cpu = ByCpu::new(&self.context);
                    cpu.explain(&error);
                    cpu.ask(session, camera, hour, size);
                    self.source = Source::Cpu(cpu);
                }
            }
        }
        self.asked = Some(key);
    }

    /// The newest picture.
    pub(super) fn texture(&mut self) -> Option<TextureId> {
        match &mut self.source {
            Source::Cpu(cpu) => cpu.texture(),
            Source::Gpu(gpu) => gpu.texture(),
        }
    }
}
