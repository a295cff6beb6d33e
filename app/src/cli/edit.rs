//! `cloudwright [SCENE]`: the editor's window.

use super::failure::Failure;
use crate::editor;
use crate::renderer::RendererChoice;
use std::path::Path;

const HINT: &str = "without a display, `cloudwright render SCENE -o PNG` draws a scene";

pub(super) fn run(scene: Option<&Path>, renderer: Option<RendererChoice>) -> Result<(), Failure> {
    if !has_display() {
        return Err(Failure::could_not("there is no display to open the editor on", HINT));
    }
    editor::open_window(scene, renderer).map_err(|error| {
        let reason = match error {
            // Its own words name a line in its source.
            eframe::Error::Winit(_) | eframe::Error::WinitEventLoop(_) => "the display can't be reached".into(),
            other => other.to_string(),
        };
        Failure::could_not(format!("the editor's window can't be opened: {reason}"), HINT)
    })
}

/// Elsewhere than on X11 and Wayland there always is one to try.
fn has_display() -> bool {
    let set = |name: &str| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    !cfg!(all(unix, not(target_os = "macos"))) || set("DISPLAY") || set("WAYLAND_DISPLAY") || set("WAYLAND_SOCKET")
}
