//! What the methods draw at one moment, for the page: pictures and maps of their errors.

use super::html::Look;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{PIXELS_PER_DEGREE, flip};
use cloudwright_core::method::{Family, METHODS, Method};

/// Pictures of one moment.
#[derive(Debug, Clone)]
pub struct Pictures {
    /// The truth.
    pub truth: Picture,
    of_methods: Vec<OfMethod>,
}

#[derive(Debug, Clone)]
struct OfMethod {
    method: &'static Method,
    picture: Picture,
    /// FLIP of each pixel.
    errors: Vec<f32>,
}

impl Pictures {
    /// Of the truth alone.
    pub fn new(truth: Picture) -> Self {
        Self { truth, of_methods: Vec::new() }
    }

    /// Adds what a method draws.
    pub fn add(&mut self, method: &'static Method, picture: Picture) {
        let errors = flip(&self.truth, &picture, PIXELS_PER_DEGREE).map(|map| map.values).unwrap_or_default();
        self.of_methods.push(OfMethod { method, picture, errors });
    }

    /// As the page takes them: of the truth, whose picture stands at its top, only the words.
    pub fn looks(&self) -> Vec<Look<'_>> {
        let truth = METHODS.iter().filter(|method| method.family == Family::Truth);
        let truth = truth.map(|method| Look {
            name: method.name,
            family: method.family,
            about: method.about,
            picture: None,
            errors: &[],
        });
        let of_methods = self.of_methods.iter().map(|OfMethod { method, picture, errors }| Look {
            name: method.name,
            family: method.family,
            about: method.about,
            picture: Some(picture),
            errors,
        });
        truth.chain(of_methods).collect()
    }
}
