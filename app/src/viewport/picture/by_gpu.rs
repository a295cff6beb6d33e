//! Pictures from the window's own device, in a texture that egui shows without a copy.

use crate::renderer::gpu_name;
use crate::state::Session;
use cloudwright_core::frame::Frame;
use cloudwright_core::sight::Sight;
use cloudwright_render::{Gpu, GpuRenderer, RenderError};
use eframe::egui_wgpu::RenderState;
use eframe::wgpu::FilterMode;
use egui::TextureId;
use std::time::{Duration, Instant};

pub(super) struct ByGpu {
    window: RenderState,
    gpu: Gpu,
    renderer: GpuRenderer,
    name: String,
    texture: Option<TextureId>,
    time: Option<Duration>,
}

impl ByGpu {
    /// None if the device refuses the shaders.
    pub(super) fn new(window: RenderState) -> Option<Self> {
        let gpu = Gpu::from_parts(window.device.clone(), window.queue.clone(), window.adapter.get_info());
        let renderer = GpuRenderer::new(&gpu).ok()?;
        Some(Self { name: gpu_name(&gpu), window, gpu, renderer, texture: None, time: None })
    }

    pub(super) fn is_software(&self) -> bool {
        self.gpu.is_software()
    }

    pub(super) fn name(&self) -> &str {
        &self.name
    }

    pub(super) fn time(&self) -> Option<Duration> {
        self.time
    }

    pub(super) fn texture(&self) -> Option<TextureId> {
        self.texture
    }

    pub(super) fn draw(&mut self, session: &Session, sight: &Sight) -> Result<(), RenderError> {
        let begun = Instant::now();
        let (scene, derived, beside) = session.to_draw();
        let frame = Frame::new(&scene, &derived, beside.sheet(), sight);
        let view = self.renderer.draw(&self.gpu, &frame)?;
        let mut egui = self.window.renderer.write();
        let device = &self.window.device;
        match self.texture {
            Some(id) => egui.update_egui_texture_from_wgpu_texture(device, view, FilterMode::Linear, id),
            None => self.texture = Some(egui.register_native_texture(device, view, FilterMode::Linear)),
        }
        self.time = Some(begun.elapsed());
        Ok(())
    }
}

impl Drop for ByGpu {
    fn drop(&mut self) {
        if let Some(id) = &self.texture {
            self.window.renderer.write().free_texture(id);
        }
    }
}
