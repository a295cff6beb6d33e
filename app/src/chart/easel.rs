//! A subject and a method that draws it: any moment, for its figures or for its time.

use super::subject::{Eye, Subject};
use crate::renderer::{RenderError, gpu_name};
use cloudwright_core::derived::Derived;
use cloudwright_core::flight::Playback;
use cloudwright_core::frame::{Frame, Sight};
use cloudwright_core::image::{Layer, LinearPicture, Picture};
use cloudwright_core::measure::Counts;
use cloudwright_core::method::{Drawn, Method, Renderer};
use cloudwright_core::raster::develop;
use cloudwright_core::scene::Camera;
use cloudwright_core::view_history::{STEP_S, ViewHistory};
use cloudwright_core::watch::Watch;
use cloudwright_render::{AdapterChoice, Gpu, PassClock};
use std::borrow::Cow;
use std::sync::Arc;
use std::time::Instant;

/// A method at its subject.
#[derive(Debug)]
pub struct Easel<'a> {
    /// By which it draws.
    pub method: &'static Method,
    subject: Subject<'a>,
    derived: Cow<'a, Derived>,
    way: Way,
    gpu: Option<Box<(Gpu, cloudwright_render::Renderer)>>,
    /// Cancelled: pictures need not be whole any more.
    stop: Arc<Watch>,
}

#[derive(Debug)]
enum Way {
    Still(Box<(Camera, ViewHistory)>),
    Flight(Box<Playback>),
}

/// A frame as figures need it.
#[derive(Debug, Clone)]
pub struct Shot {
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

impl<'a> Easel<'a> {
    /// Puts `method` before `subject`; `adapter` is for methods that need one.
    ///
    /// # Errors
    /// If there is no such adapter.
    pub fn new(subject: Subject<'a>, method: &'static Method, adapter: &AdapterChoice) -> Result<Self, RenderError> {
        let history = method.settings.history();
        let way = match subject.eye {
            Eye::Camera(camera) => Way::Still(Box::new((camera.clone(), history))),
            Eye::Path(path) => Way::Flight(Box::new(Playback::with_history(path, history))),
        };
        let gpu = if method.settings.renderer == Renderer::Gpu {
            let gpu = Gpu::headless(adapter)?;
            let renderer = cloudwright_render::Renderer::new(&gpu)?;
            Some(Box::new((gpu, renderer)))
        } else {
            None
        };
        let derived = method.settings.clouds(subject.derived, subject.atlas);
        Ok(Self { method, subject, derived, way, gpu, stop: Arc::default() })
    }

    /// What it draws need not be whole once `stop` is cancelled.
    #[must_use]
    pub fn until(self, stop: &Arc<Watch>) -> Self {
        Self { stop: Arc::clone(stop), ..self }
    }

    /// The adapter, if it needs one.
    pub fn adapter(&self) -> Option<String> {
        self.gpu.as_ref().map(|parts| gpu_name(&parts.0))
    }

    /// Draws the moment `at_s` for figures.
    ///
    /// # Errors
    /// If the adapter fails.
    pub fn draw(&mut self, at_s: f64) -> Result<Shot, RenderError> {
        let (start, stop) = (Instant::now(), Arc::clone(&self.stop));
        let settings = &self.method.settings;
        let (frame, gpu) = self.frame(at_s);
        let drawn = match (settings.draw(&frame, &stop), gpu) {
            (Some(drawn), _) => drawn,
            (None, Some((gpu, renderer))) => {
                let linear = renderer.linear_picture(gpu, &frame)?;
                Drawn { linear, clouds: Some(renderer.clouds(gpu, &frame)?) }.reduced(settings.pixels_a_pixel())
            }
            (None, None) => return Err(no_adapter()),
        };
        let picture = develop(&drawn.linear, frame.exposure);
        Ok(Shot { linear: drawn.linear, picture, clouds: drawn.clouds, drawn_ms: ms(start) })
    }

    /// Times the moment `at_s`, as it is drawn in a flight whose frame before it has just been shown.
    ///
    /// # Errors
    /// If the adapter fails.
    pub fn time(&mut self, at_s: f64) -> Result<Times, RenderError> {
        if let Way::Flight(playback) = &mut self.way {
            playback.seek(&self.derived, at_s - STEP_S);
        }
        let (start, stop) = (Instant::now(), Arc::clone(&self.stop));
        let settings = &self.method.settings;
        let (frame, gpu) = self.frame(at_s);
        if settings.picture(&frame, &stop).is_some() {
            let frame_ms = ms(start);
            return Ok(Times { frame_ms, cpu_ms: frame_ms, gpu_ms: None });
        }
        let (gpu, renderer) = gpu.ok_or_else(no_adapter)?;
        let cpu_ms = ms(start);
        renderer.picture(gpu, &frame)?;
        let frame_ms = ms(start);
        let pass = renderer.sprites_pass_time(gpu, &frame)?;
        let gpu_ms = (pass.clock == PassClock::Timestamps).then_some(pass.duration.as_secs_f64() * 1e3);
        Ok(Times { frame_ms, cpu_ms, gpu_ms })
    }

    /// Counts what the moment `at_s` takes.
    pub fn counts(&mut self, at_s: f64) -> Counts {
        let settings = &self.method.settings;
        settings.counts(&self.frame(at_s).0)
    }

    fn frame(&mut self, at_s: f64) -> (Frame<'_>, Option<&mut (Gpu, cloudwright_render::Renderer)>) {
        let Subject { scene, atlas, meshes, size, time_h, hidden, .. } = self.subject;
        let flown;
        let (camera, history) = match &mut self.way {
            Way::Still(parts) => (&parts.0, &parts.1),
            Way::Flight(playback) => {
                let (camera, history) = playback.seek(&self.derived, at_s);
                flown = camera;
                (&flown, history)
            }
        };
        let sight = Sight { camera, time_h, clock_s: at_s, size, hidden, meshes, history };
        // All methods draw clouds alone: the CPU has no aircraft.
        let frame = Frame { models: Vec::new(), ..self.method.settings.frame(scene, &self.derived, atlas, &sight) };
        (frame, self.gpu.as_deref_mut())
    }
}

fn ms(start: Instant) -> f64 {
    start.elapsed().as_secs_f64() * 1e3
}

fn no_adapter() -> RenderError {
    cloudwright_render::RenderError::Refused("this method draws on a graphics adapter, and has none".into()).into()
}
