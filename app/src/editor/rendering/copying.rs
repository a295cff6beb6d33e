//! *Copy picture*: what the view shows, without marks and handles, as an image on the clipboard.

use super::Told;
use crate::editor::Editor;
use crate::editor::progress::Progress;
use crate::opening::Beside;
use crate::renderer::RendererChoice;
use crate::rendering::{NoPicture, Painter, Painting};
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::method::Method;
use cloudwright_core::rules::Rules;
use cloudwright_core::scene::Scene;
use cloudwright_core::sight::Sight;
use cloudwright_core::watch::Watch;
use std::sync::Arc;

/// What is being drawn for the clipboard.
#[derive(Default)]
pub(in crate::editor) struct Copying(Option<Progress<Request, Result<(Picture, Vec<String>), NoPicture>>>);

struct Request {
    scene: Arc<Scene>,
    derived: Arc<Derived>,
    beside: Beside,
    sight: Sight,
    renderer: RendererChoice,
    method: Option<&'static Method>,
}

fn carry_out(request: Request, watch: &Watch) -> Result<(Picture, Vec<String>), NoPicture> {
    let Request { scene, derived, beside, mut sight, renderer, method } = request;
    let told = Told::default();
    let tell = |line: &str| told.tell(line);
    let mut painter = Painter::new(&Painting { renderer, method, side: None, tolerance: 0.0 }, sight.rules, &tell)?;
    sight.rules = Rules { rasterizer: painter.rules.rasterizer, ..sight.rules };
    let picture = painter.picture(Frame::new(&scene, &derived, beside.sheet(), &sight), watch)?;
    drop(painter);
    Ok((picture, told.news()))
}

impl Editor {
    pub(in crate::editor) fn copy_picture(&mut self, context: &egui::Context) {
        let Some(sight) = self.viewport.sight().cloned() else { return };
        let (scene, derived, beside) = self.session.to_draw();
        let (renderer, method) = (self.renderer, self.view.method);
        let request = Request { scene, derived, beside, sight, renderer, method };
        self.copying.0 = Some(Progress::begin(request, carry_out, context));
    }

    /// Puts the picture onto the clipboard when it is there.
    pub(in crate::editor) fn keep_copying(&mut self, context: &egui::Context) {
        let Some(progress) = &self.copying.0 else { return };
        let done = match progress {
            Progress::Choosing(refusal) => Err(refusal.clone().unwrap_or_default()),
            _ => match progress.answer() {
                Some(answer) => answer.map_err(|error| format!("Nothing was copied: {error}.")),
                None => return,
            },
        };
        self.copying.0 = None;
        match done {
            Ok((picture, news)) => {
                self.tell(format!("Copied the picture, {} × {} pixels", picture.width, picture.height));
                news.iter().for_each(|line| self.tell(line));
                context.copy_image(crate::viewport::image(&picture));
            }
            Err(why) => self.tell_error(why),
        }
    }
}
