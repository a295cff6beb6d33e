//! What an editor starts with: what was asked for on the command line, and what the system gives.

use super::FileDialogs;
use crate::renderer::RendererChoice;
use crate::storage::Folders;
use eframe::egui_wgpu::RenderState;
use std::path::PathBuf;

/// What an editor starts with.
pub struct Start {
    /// A scene to open; a new one if there is none. Problems of the file are shown in the window.
    pub scene: Option<PathBuf>,
    /// Whether recent scenes and skies to begin with are offered.
    pub start_page: bool,
    /// What draws the viewport.
    pub renderer: RendererChoice,
    /// The window's device.
    pub device: Option<RenderState>,
    /// How file names are asked for.
    pub file_dialogs: Box<dyn FileDialogs>,
    /// Where settings and unsaved work are kept; none to remember nothing.
    pub folders: Option<Folders>,
}
