//! The native window and its graphics device.

use super::{Editor, NativeDialogs, Start};
use crate::renderer::RendererChoice;
use cloudwright_render::Gpu;
use eframe::egui_wgpu::{WgpuSetup, WgpuSetupCreateNew};
use eframe::wgpu;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Opens the editor's window and stays until it is closed.
///
/// # Errors
/// If there is no display, or no adapter that can draw in a window.
pub fn open_window(scene: Option<&Path>, renderer: RendererChoice) -> Result<(), eframe::Error> {
    let options = eframe::NativeOptions {
        viewport: egui::ViewportBuilder::default()
            .with_title("Cloudwright")
            .with_app_id("cloudwright")
            .with_inner_size([1280.0, 800.0])
            .with_min_inner_size([800.0, 500.0]),
        renderer: eframe::Renderer::Wgpu,
        wgpu_options: eframe::egui_wgpu::WgpuConfiguration {
            wgpu_setup: WgpuSetup::CreateNew(device_setup()),
            ..Default::default()
        },
        ..Default::default()
    };
    let scene: Option<PathBuf> = scene.map(Into::into);
    eframe::run_native(
        "Cloudwright",
        options,
        Box::new(move |creation| {
            let device = creation.wgpu_render_state.clone();
            let start = Start { scene, renderer, device, file_dialogs: Box::new(NativeDialogs) };
            Ok(Box::new(Editor::new(&creation.egui_ctx, start)))
        }),
    )
}

/// What the clouds' renderer needs: eframe's own choice asks for no timestamps.
fn device_setup() -> WgpuSetupCreateNew {
    WgpuSetupCreateNew {
        power_preference: wgpu::PowerPreference::HighPerformance,
        device_descriptor: Arc::new(Gpu::device_descriptor),
        ..WgpuSetupCreateNew::without_display_handle()
    }
}
