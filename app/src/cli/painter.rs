//! What draws the pictures of one run: what may be asked for, and a renderer that tells what it is and gives way to the CPU
//! where the choice was left to us.

use super::failure::Failure;
use super::{arguments, say};
use crate::renderer::{RenderError, Renderer, RendererChoice};
use cloudwright_core::draw;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::{Layers, LinearPicture, Picture};
use cloudwright_core::method::{self, Method};
use cloudwright_core::raster::layers::Later;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::watch::Watch;

/// What may be asked for. A method says what draws and how; `--samples` goes before its own.
#[derive(Debug, Clone, clap::Args)]
pub(super) struct PainterArguments {
    /// What draws
    #[arg(long, value_enum, default_value_t)]
    renderer: RendererChoice,
    /// Draw by the method of this name; `cloudwright chart --help` lists them
    #[arg(long, value_name = "NAME", value_parser = arguments::method)]
    method: Option<&'static Method>,
    /// Short for --method truth: order the fragments of every ray by their own depth; slow, what errors are measured against
    #[arg(long, conflicts_with = "method")]
    truth: bool,
    /// Samples a pixel, a square number up to 64; the method's if not given, 1 without one
    #[arg(long = "samples", value_name = "N", value_parser = arguments::samples_side)]
    side: Option<u32>,
}

/// Draws the frames of one run.
pub(super) struct Painter {
    /// By which frames are to be made.
    pub(super) rules: Rules,
    renderer: Renderer,
    /// Whether the CPU may draw what the renderer can't.
    gives_way: bool,
    /// Whether it has been said that the CPU leaves models out.
    has_told: bool,
}

impl PainterArguments {
    fn method(&self) -> Option<&'static Method> {
        if self.truth { Some(method::truth()) } else { self.method }
    }

    /// The same, for what only the CPU does: `what` asks for it.
    ///
    /// # Errors
    /// If a GPU is asked for.
    pub(super) fn in_software(&self, what: &str) -> Result<Self, Failure> {
        if self.renderer == RendererChoice::Gpu || self.rules()?.rasterizer == Rasterizer::Gpu {
            let (asked, hint) = match self.method {
                Some(method) => (format!("--method {}", method.name), "leave the method out"),
                None => ("--renderer gpu".to_owned(), "use --renderer cpu, or auto"),
            };
            return Err(Failure::argument(format!("{what} with {asked}: only the CPU does that"), hint));
        }
        Ok(Self { renderer: RendererChoice::Cpu, ..self.clone() })
    }

    /// What is asked for, as the CPU would do it unless a method says otherwise.
    ///
    /// # Errors
    /// If a method and a renderer are asked for that don't go together.
    pub(super) fn rules(&self) -> Result<Rules, Failure> {
        let rules = self.method().map_or(Rules::SHIPPED, |method| method.rules);
        let rules = Rules { samples_side: self.side.unwrap_or(rules.samples_side), ..rules };
        let Some(method) = self.method() else { return Ok(rules) };
        let asked = if self.truth { "--truth".into() } else { format!("--method {}", method.name) };
        let (runs, other) = match (rules.rasterizer, self.renderer) {
            (Rasterizer::Gpu, RendererChoice::Cpu) => ("on a GPU", "cpu"),
            (Rasterizer::Gpu, _) | (_, RendererChoice::Auto | RendererChoice::Cpu) => return Ok(rules),
            (_, RendererChoice::Gpu) => ("on the CPU", "gpu"),
        };
        Err(Failure::argument(format!("{asked} runs {runs}"), format!("leave --renderer {other} or {asked} out")))
    }
}

impl Painter {
    /// The renderer that `arguments` ask for, by name on the terminal; it draws by `rules`, which come from them.
    pub(super) fn new(arguments: &PainterArguments, mut rules: Rules) -> Result<Self, RenderError> {
        let method = arguments.method();
        let renderer = match method {
            None => Renderer::new(arguments.renderer)?,
            Some(_) if rules.rasterizer == Rasterizer::Gpu => Renderer::new(RendererChoice::Gpu)?,
            Some(_) => Renderer::default(),
        };
        let name = renderer.name();
        match method {
            None => {
                rules.rasterizer = renderer.rules().rasterizer;
                say(&format!("renderer: {name}"));
            }
            Some(method) => {
                let samples = rules.samples_side * rules.samples_side;
                let unit = if samples == 1 { "sample" } else { "samples" };
                say(&format!("renderer: {name}, {} with {samples} {unit} a pixel", method.name));
            }
        }
        let gives_way = method.is_none() && arguments.renderer == RendererChoice::Auto;
        Ok(Self { rules, renderer, gives_way, has_told: false })
    }

    /// The picture of `frame`, which was made by the painter's rules. The truth tells `watch` how far it is.
    pub(super) fn picture(&mut self, frame: Frame<'_>, watch: &Watch) -> Result<Picture, RenderError> {
        self.draw(frame, |renderer, frame| renderer.picture(frame, watch))
    }

    /// As [`Painter::picture`], in linear light.
    pub(super) fn linear(&mut self, frame: Frame<'_>, watch: &Watch) -> Result<LinearPicture, RenderError> {
        self.draw(frame, |renderer, frame| renderer.linear(frame, watch))
    }

    /// As [`Painter::picture`], in layers; none by rules that keep none ([`PainterArguments::in_software`]).
    pub(super) fn layers(&mut self, frame: Frame<'_>, later: &Later<'_>) -> Result<Option<Layers>, RenderError> {
        self.draw(frame, |_, frame| Ok(draw::layers(frame, later)))
    }

    fn draw<T>(
        &mut self,
        mut frame: Frame<'_>,
        draw: impl Fn(&mut Renderer, &Frame<'_>) -> Result<T, RenderError>,
    ) -> Result<T, RenderError> {
        if frame.rules.rasterizer == Rasterizer::Gpu {
            match draw(&mut self.renderer, &frame) {
                Err(error) if self.gives_way => say(&format!("renderer: CPU, because {error}")),
                done => return done,
            }
            self.rules.rasterizer = Rules::SHIPPED.rasterizer;
            frame.rules = self.rules;
        }
        if !frame.models.is_empty() && !self.has_told {
            say("aircraft and props are left out: only a GPU draws them");
            self.has_told = true;
        }
        draw(&mut self.renderer, &frame)
    }
}
