//! What may be asked of what draws pictures, on the command line.

use super::failure::Failure;
use super::{arguments, say};
use crate::picture_kind::PictureKind;
use crate::renderer::{RenderError, RendererChoice};
use crate::rendering::{self, Painter, Painting};
use cloudwright_core::method::{self, Method};
use cloudwright_core::rules::{Rasterizer, Rules};
use std::path::Path;

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
    /// How far the picture may be from that of all sprites, as mean FLIP, 0 to 1: far sprites are merged as that allows, which
    /// is faster where there are many; 0.01 is hardly seen, 0 draws all
    #[arg(long, value_name = "FLIP", default_value_t = 0.0, value_parser = arguments::tolerance, allow_negative_numbers = true)]
    #[arg(conflicts_with_all = ["method", "truth"])]
    tolerance: f32,
}

impl PainterArguments {
    fn painting(&self) -> Painting {
        let method = if self.truth { Some(method::truth()) } else { self.method };
        Painting { renderer: self.renderer, method, side: self.side, tolerance: self.tolerance }
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

    /// The same, for a file of that kind with layers.
    ///
    /// # Errors
    /// If the kind holds none, or what is asked for draws none.
    pub(super) fn in_layers(&self, kind: PictureKind) -> Result<Self, Failure> {
        if kind != PictureKind::Exr {
            let what = format!("--layers: a .{} file has none", kind.ending());
            return Err(Failure::argument(what, "write OpenEXR: a name in .exr, or fly --format exr"));
        }
        let painter = self.in_software("--layers")?;
        if matches!(painter.rules()?.rasterizer, Rasterizer::Fast(_)) {
            return Ok(painter);
        }
        Err(Failure::argument("--layers: this method keeps none", "leave --truth or --method out"))
    }

    /// What is asked for, as the CPU would do it unless a method says otherwise.
    ///
    /// # Errors
    /// If a method and a renderer are asked for that don't go together.
    pub(super) fn rules(&self) -> Result<Rules, Failure> {
        let painting = self.painting();
        let rules = painting.rules();
        let Some(method) = painting.method else { return Ok(rules) };
        let asked = if self.truth { "--truth".into() } else { format!("--method {}", method.name) };
        let (runs, other) = match (rules.rasterizer, self.renderer) {
            (Rasterizer::Gpu, RendererChoice::Cpu) => ("on a GPU", "cpu"),
            (Rasterizer::Gpu, _) | (_, RendererChoice::Auto | RendererChoice::Cpu) => return Ok(rules),
            (_, RendererChoice::Gpu) => ("on the CPU", "gpu"),
        };
        Err(Failure::argument(format!("{asked} runs {runs}"), format!("leave --renderer {other} or {asked} out")))
    }

    /// The renderer that is asked for, by name on the terminal; it draws by `rules`, which come from [`Self::rules`].
    pub(super) fn painter(&self, rules: Rules) -> Result<Painter<'static>, RenderError> {
        Painter::new(&self.painting(), rules, &say)
    }
}

/// The kind of file that the ending of `output` says.
pub(super) fn kind_of(output: &Path) -> Result<PictureKind, Failure> {
    rendering::kind_of(output).ok_or_else(|| {
        let what = format!("--output {}: a picture is written as PNG, OpenEXR or Radiance HDR", output.display());
        Failure::argument(what, "end its name in .png, .exr or .hdr")
    })
}
