//! What the methods draw at one moment, for the page: pictures and maps of their errors.

use super::html::Look;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip};
use cloudwright_core::method::{METHODS, Method, Renderer};

/// Pictures of one moment.
#[derive(Debug, Clone)]
pub struct Gallery {
    /// The truth.
    pub truth: Picture,
    canvases: Vec<Canvas>,
}

#[derive(Debug, Clone)]
struct Canvas {
    method: &'static Method,
    picture: Picture,
    /// FLIP of each pixel.
    errors: Vec<f32>,
}

impl Gallery {
    /// Of the truth alone.
    pub fn new(truth: Picture) -> Self {
        Self { truth, canvases: Vec::new() }
    }

    /// Adds what a method draws.
    pub fn hang(&mut self, method: &'static Method, picture: Picture) {
        let errors = flip(&self.truth, &picture, PIXELS_PER_DEGREE).map(|map| map.values).unwrap_or_default();
        self.canvases.push(Canvas { method, picture, errors });
    }

    /// As the page takes them: of the truth, whose picture stands at its top, only the words.
    pub fn looks(&self) -> Vec<Look<'_>> {
        let truth = METHODS.iter().filter(|method| method.settings.renderer == Renderer::Truth);
        let truth = truth.map(|method| Look {
            name: method.name,
            family: method.family,
            about: method.about,
            picture: None,
            errors: &[],
        });
        let canvases = self.canvases.iter().map(|Canvas { method, picture, errors }| Look {
            name: method.name,
            family: method.family,
            about: method.about,
            picture: Some(picture),
            errors,
        });
        truth.chain(canvases).collect()
    }
}
