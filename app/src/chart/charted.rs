//! One method at the subject of a chart: any moment of it, for its figures or for its time.

use super::subject::Subject;
use crate::renderer::{RenderError, Renderer};
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{Layer, LinearPicture, Picture};
use cloudwright_core::measure::Counts;
use cloudwright_core::method::Method;
use cloudwright_core::raster::develop;
use cloudwright_core::rules::Rasterizer;
use cloudwright_core::sight::Sight;
use cloudwright_core::view_history::{Playback, STEP_S};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use cloudwright_render::AdapterChoice;
use std::sync::Arc;
use std::time::Instant;

/// A method at its subject.
#[derive(Debug)]
pub struct Charted<'a> {
    /// By which it draws.
    pub method: &'static Method,
    subject: Subject<'a>,
    /// Along a path.
    flight: Option<Box<Playback>>,
    renderer: Renderer,
    /// Cancelled: pictures need not be whole any more.
    stop: Arc<Watch>,
}

/// What it draws of one moment, as figures need it.
#[derive(Debug, Clone)]
pub struct Drawing {
    /// In linear light, before exposure.
    pub linear: LinearPicture,
    /// As a display shows it.
    pub picture: Picture,
    /// The clouds alone; none where the method has no opacity of its own.
    pub clouds: Option<Layer>,
    /// What drawing all this took.
    pub drawn_ms: f64,
}

/// What a frame took, milliseconds.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Times {
    /// All of it: one step of the view's history, order, and pixels in memory.
    pub frame_ms: f64,
    /// Until nothing is left to do for the CPU but to wait.
    pub cpu_ms: f64,
    /// The sprites by the adapter's own clock.
    pub gpu_ms: Option<f64>,
}

impl<'a> Charted<'a> {
    /// Puts `method` before `subject`; `adapter` is for methods that need one.
    ///
    /// # Errors
    /// If there is no such adapter.
    pub fn new(subject: Subject<'a>, method: &'static Method, adapter: &AdapterChoice) -> Result<Self, RenderError> {
        let flight = subject.path.map(|path| Box::new(Playback::new(path, method.rules)));
        let renderer = match method.rules.rasterizer {
            Rasterizer::Gpu => Renderer::with_adapter(adapter)?,
            _ => Renderer::default(),
        };
        Ok(Self { method, subject, flight, renderer, stop: Arc::default() })
    }

    /// What it draws need not be whole once `stop` is cancelled.
    #[must_use]
    pub fn until(self, stop: &Arc<Watch>) -> Self {
        Self { stop: Arc::clone(stop), ..self }
    }

    /// The adapter, if it needs one.
    pub fn adapter(&self) -> Option<String> {
        self.renderer.adapter_name()
    }

    /// Draws the moment `at_s` for figures.
    ///
    /// # Errors
    /// If the adapter fails.
    pub fn draw(&mut self, at_s: f64) -> Result<Drawing, RenderError> {
        let start = Instant::now();
        let frame = self.frame(at_s);
        let drawn = self.renderer.drawn(&frame, &self.stop)?;
        let picture = develop(&drawn.linear, frame.now.exposure);
        Ok(Drawing { linear: drawn.linear, picture, clouds: drawn.clouds, drawn_ms: ms(start) })
    }

    /// Times the moment `at_s`, as it is drawn in a flight whose frame before it has just been shown.
    ///
    /// # Errors
    /// If the adapter fails.
    pub fn time(&mut self, at_s: f64) -> Result<Times, RenderError> {
        if let Some(flight) = &mut self.flight {
            flight.seek(self.subject.derived, at_s - STEP_S);
        }
        let start = Instant::now();
        let frame = self.frame(at_s);
        let prepared_ms = ms(start);
        self.renderer.picture(&frame, &self.stop)?;
        let frame_ms = ms(start);
        if self.method.rules.rasterizer != Rasterizer::Gpu {
            return Ok(Times { frame_ms, cpu_ms: frame_ms, gpu_ms: None });
        }
        let gpu_ms = self.renderer.sprites_time(&frame)?.map(|time| time.as_secs_f64() * 1e3);
        Ok(Times { frame_ms, cpu_ms: prepared_ms, gpu_ms })
    }

    /// Counts what the moment `at_s` takes.
    pub fn counts(&mut self, at_s: f64) -> Counts {
        draw::counts(&self.frame(at_s))
    }

    fn frame(&mut self, at_s: f64) -> Frame<'a> {
        let Subject { scene, derived, atlas, sight, .. } = self.subject;
        let moment = Moment { clock_s: at_s, ..sight.moment };
        let mut sight = Sight { moment, rules: self.method.rules, ..sight.clone() };
        if let Some(flight) = &mut self.flight {
            let (camera, history) = flight.seek(derived, at_s);
            (sight.camera, sight.history) = (camera, Arc::clone(history));
        }
        // All methods draw clouds alone: the CPU has no aircraft.
        Frame { models: Vec::new(), ..Frame::new(scene, derived, atlas, &sight) }
    }
}

fn ms(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}
