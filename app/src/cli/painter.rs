//! A renderer that tells what it is, and gives way to the CPU where the user has left the choice to us.

use super::say;
use crate::renderer::{RenderError, Renderer, RendererChoice};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;

/// Draws the frames of one run.
pub(super) struct Painter {
    renderer: Renderer,
    choice: RendererChoice,
    /// Whether it has been said that the CPU leaves aircraft out.
    has_told: bool,
}

impl Painter {
    /// The renderer of that kind, by name on the terminal.
    pub(super) fn new(choice: RendererChoice) -> Result<Self, RenderError> {
        let painter = Self { renderer: Renderer::new(choice)?, choice, has_told: false };
        say(&format!("renderer: {}", painter.renderer.name()));
        Ok(painter)
    }

    /// `frame` with `side` × `side` of its pixels to one of the picture's.
    pub(super) fn picture(&mut self, frame: &Frame<'_>, side: u32) -> Result<Picture, RenderError> {
        if matches!(self.renderer, Renderer::Cpu) && !self.has_told {
            self.has_told = tell_what_is_left_out(frame);
        }
        match self.renderer.picture(frame, side) {
            Err(error) if self.choice == RendererChoice::Auto && !matches!(self.renderer, Renderer::Cpu) => {
                say(&format!("renderer: CPU, because {error}"));
                self.renderer = Renderer::Cpu;
                self.picture(frame, side)
            }
            done => done,
        }
    }
}

/// That the CPU draws no models, if there are any.
pub(super) fn tell_what_is_left_out(frame: &Frame<'_>) -> bool {
    let has_models = !frame.models.is_empty();
    if has_models {
        say("aircraft are left out: only a GPU draws them");
    }
    has_models
}
