//! The native window and its graphics device.

use super::done::unkept;
use super::{Editor, NativeDialogs, Start};
use crate::renderer::RendererChoice;
use crate::signals;
use crate::storage::{Folders, Settings};
use crate::theme;
use cloudwright_render::Gpu;
use eframe::egui_wgpu::{WgpuSetup, WgpuSetupCreateNew};
use eframe::wgpu;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Points.
const DEFAULT_SIZE: [f32; 2] = [1280.0, 800.0];
/// Points.
const MIN_SIZE: [f32; 2] = [800.0, 500.0];
/// No screen is wider or higher, points.
const MAX_SIZE: f32 = 8192.0;

/// Opens the editor's window, drawn as the user prefers unless a `renderer` is asked for, and stays until it is closed.
///
/// # Errors
/// If there is no display, or no adapter that can draw in a window.
pub fn open_window(scene: Option<&Path>, renderer: Option<RendererChoice>) -> Result<(), eframe::Error> {
    let folders = Folders::of_user();
    // Settings that can't be understood are told about in the window.
    let settings = folders.as_ref().map(|folders| Settings::load(folders).0).unwrap_or_default();
    let size = settings.window_size.unwrap_or(DEFAULT_SIZE);
    let renderer = renderer.unwrap_or(settings.renderer);
    let start_page = scene.is_none() && settings.start_page;
    let open = |painter| {
        let options = eframe::NativeOptions {
            viewport: egui::ViewportBuilder::default()
                .with_title("Cloudwright")
                .with_app_id("cloudwright")
                .with_inner_size([0, 1].map(|i| size[i].clamp(MIN_SIZE[i], MAX_SIZE)))
                .with_min_inner_size(MIN_SIZE),
            renderer: painter,
            // Flat colours, and pictures that are of eight bits already: there are no bands to hide.
            dithering: false,
            wgpu_options: eframe::egui_wgpu::WgpuConfiguration {
                wgpu_setup: WgpuSetup::CreateNew(device_setup()),
                ..Default::default()
            },
            ..Default::default()
        };
        let (scene, folders) = (scene.map(PathBuf::from), folders.clone());
        let create: eframe::AppCreator<'_> = Box::new(move |creation| {
            let device = creation.wgpu_render_state.clone();
            let has_folders = folders.is_some();
            let start = Start { scene, start_page, renderer, device, file_dialogs: Box::new(NativeDialogs), folders };
            theme::panels_stand_on_clear(&creation.egui_ctx);
            let mut editor = Editor::new(&creation.egui_ctx, start);
            if !has_folders {
                editor.tell_error(unkept("there is no home folder to keep it in"));
            }
            if let Some(last_call) = editor.last_call() {
                // Without it, half a second's work may be lost.
                let _ = signals::before_the_end(last_call);
            }
            Ok(Box::new(editor))
        });
        eframe::run_native("Cloudwright", options, create)
    };
    match painter(renderer) {
        // Where GL opens no window, a device that is a program may still.
        eframe::Renderer::Glow => open(eframe::Renderer::Glow).or_else(|error| match error {
            eframe::Error::Glutin(_) | eframe::Error::NoGlutinConfigs(..) | eframe::Error::OpenGL(_) => {
                open(eframe::Renderer::Wgpu)
            }
            error => Err(error),
        }),
        wgpu => open(wgpu),
    }
}

/// What paints the window. A device that is a program on the CPU paints many times slower through wgpu than through GL:
/// of egui-wgpu's shader it runs both ways of filtering a texture at each pixel, though one alone is asked for.
fn painter(renderer: RendererChoice) -> eframe::Renderer {
    if renderer == RendererChoice::Gpu || Gpu::is_hardware_here() {
        eframe::Renderer::Wgpu
    } else {
        eframe::Renderer::Glow
    }
}

/// What the clouds' renderer needs: eframe's own choice asks for no timestamps.
fn device_setup() -> WgpuSetupCreateNew {
    WgpuSetupCreateNew {
        power_preference: wgpu::PowerPreference::HighPerformance,
        device_descriptor: Arc::new(Gpu::device_descriptor),
        ..WgpuSetupCreateNew::without_display_handle()
    }
}
