//! What draws the pictures of one run: a renderer that tells what it is, and gives way to the CPU where the choice was
//! left to us.

use crate::renderer::{RenderError, Renderer, RendererChoice};
use cloudwright_core::detail::Detail;
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{Layers, LinearPicture, Picture};
use cloudwright_core::method::Method;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::watch::Watch;

/// What is asked for.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Painting {
    /// What draws.
    pub(crate) renderer: RendererChoice,
    /// What draws and how, if that is said.
    pub(crate) method: Option<&'static Method>,
    /// Samples a pixel, as the side of their square; the method's if that is not said.
    pub(crate) side: Option<u32>,
    /// How far from the picture of all sprites it may be, as mean FLIP; the method's if there is one.
    pub(crate) tolerance: f32,
}

impl Painting {
    /// As the CPU would do it unless a method says otherwise.
    pub(crate) fn rules(&self) -> Rules {
        let own = || Rules { detail: Detail::within(self.tolerance), ..Rules::SHIPPED };
        let rules = self.method.map_or_else(own, |method| method.rules);
        Rules { samples_side: self.side.unwrap_or(rules.samples_side), ..rules }
    }
}

/// Draws the frames of one run.
pub(crate) struct Painter<'a> {
    /// By which frames are to be made.
    pub(crate) rules: Rules,
    renderer: Renderer,
    /// Whether the CPU may draw what the renderer can't.
    gives_way: bool,
    tell: &'a dyn Fn(&str),
}

impl<'a> Painter<'a> {
    /// The renderer that `painting` asks for, which it tells by name; it draws by `rules`, which come from that. That
    /// it gives way it tells too.
    pub(crate) fn new(painting: &Painting, mut rules: Rules, tell: &'a dyn Fn(&str)) -> Result<Self, RenderError> {
        let method = painting.method;
        let renderer = match method {
            None => Renderer::new(painting.renderer)?,
            Some(_) if rules.rasterizer == Rasterizer::Gpu => Renderer::new(RendererChoice::Gpu)?,
            Some(_) => Renderer::default(),
        };
        let name = renderer.name();
        match method {
            None => {
                rules.rasterizer = renderer.rules().rasterizer;
                tell(&format!("renderer: {name}"));
            }
            Some(method) => {
                let samples = rules.samples_side * rules.samples_side;
                let unit = if samples == 1 { "sample" } else { "samples" };
                tell(&format!("renderer: {name}, {} with {samples} {unit} a pixel", method.name));
            }
        }
        let gives_way = method.is_none() && painting.renderer == RendererChoice::Auto;
        Ok(Self { rules, renderer, gives_way, tell })
    }

    /// The picture of `frame`, which was made by the painter's rules. The truth tells `watch` how far it is.
    pub(crate) fn picture(&mut self, frame: Frame<'_>, watch: &Watch) -> Result<Picture, RenderError> {
        self.draw(frame, |renderer, frame| renderer.picture(frame, watch))
    }

    /// As [`Painter::picture`], in linear light.
    pub(crate) fn linear(&mut self, frame: Frame<'_>, watch: &Watch) -> Result<LinearPicture, RenderError> {
        self.draw(frame, |renderer, frame| renderer.linear(frame, watch))
    }

    /// As [`Painter::picture`], in layers; none by rules that keep none.
    pub(crate) fn layers(&mut self, frame: Frame<'_>, later: &Later<'_>) -> Result<Option<Layers>, RenderError> {
        self.draw(frame, |_, frame| Ok(draw::layers(frame, later)))
    }

    fn draw<T>(
        &mut self,
        mut frame: Frame<'_>,
        draw: impl Fn(&mut Renderer, &Frame<'_>) -> Result<T, RenderError>,
    ) -> Result<T, RenderError> {
        if frame.rules.rasterizer == Rasterizer::Gpu {
            match draw(&mut self.renderer, &frame) {
                Err(error) if self.gives_way => (self.tell)(&format!("renderer: CPU, because {error}")),
                done => return done,
            }
            self.rules.rasterizer = Rules::SHIPPED.rasterizer;
            frame.rules = self.rules;
        }
        draw(&mut self.renderer, &frame)
    }
}
