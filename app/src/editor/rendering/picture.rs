//! *Render picture…*: the file that `cloudwright render` writes, from the window.

use super::Told;
use crate::editor::files::over;
use crate::editor::progress::Progress;
use crate::editor::{Ask, Editor};
use crate::opening::Beside;
use crate::panel::{self, ExchangeAnswer, PictureForm};
use crate::picture_kind::PictureKind;
use crate::renderer::RendererChoice;
use crate::rendering::{
    IN_LAYERS, NoPicture, Painter, Painting, Still, StillEye, TooManySamples, check_memory, kind_of,
};
use crate::saving::{SaveError, check_unused};
use crate::storage::{Over, PictureSettings, StorageError, Together};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::draw_list::Hidden;
use cloudwright_core::method;
use cloudwright_core::rules::Rasterizer;
use cloudwright_core::scene::{Camera, CameraId, Scene};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is being asked.
#[derive(Default)]
pub(in crate::editor) struct Rendering {
    asked: Option<Asked>,
}

struct Asked {
    chosen: PictureSettings,
    /// Of the scene; the view if it is none.
    camera: Option<CameraId>,
    progress: Progress<Request, Result<Rendered, Failed>>,
}

impl Rendering {
    pub(in crate::editor) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }
}

struct Request {
    scene: Arc<Scene>,
    beside: Beside,
    file: Option<PathBuf>,
    /// By its id; or where the view is, with what can't be seen from there.
    eye: Result<CameraId, (Camera, Hidden)>,
    moment: Moment,
    painting: Painting,
    kind: PictureKind,
    size: [u32; 2],
    in_layers: bool,
    over: Over,
    to: PathBuf,
}

struct Rendered {
    to: PathBuf,
    /// What the picture lacks.
    news: Vec<String>,
}

/// Why no file was written.
#[derive(Debug, thiserror::Error)]
enum Failed {
    #[error(transparent)]
    Picture(#[from] NoPicture),
    #[error(transparent)]
    Save(#[from] SaveError),
    #[error(transparent)]
    Storage(#[from] StorageError),
    #[error("the camera is no longer there")]
    NoCamera,
    #[error("a picture is written as PNG, OpenEXR or Radiance HDR: end its name in .png, .exr or .hdr")]
    NoKind,
    #[error("only OpenEXR holds layers")]
    NoLayers,
}

impl From<TooManySamples> for Failed {
    fn from(error: TooManySamples) -> Self {
        Self::Picture(error.into())
    }
}

fn carry_out(request: Request, watch: &Watch) -> Result<Rendered, Failed> {
    let Request { scene, beside, file, eye, moment, painting, kind, size, in_layers, over, to } = request;
    check_unused(&scene, file.as_deref(), &to)?;
    let rules = painting.rules();
    check_memory(size, rules.pixels_a_pixel(), if in_layers { IN_LAYERS } else { 1 })?;
    if in_layers && !matches!(rules.rasterizer, Rasterizer::Fast(_)) {
        return Err(NoPicture::NoLayers.into());
    }
    // What the window shows may still be on the way to this scene.
    let nothing = Derived::default();
    // Progress is the picture's.
    let of_clouds = Watch::cancelled_by(watch.cancelled());
    let derived = nothing.plan(&scene, &Change::everything()).carry_out(&of_clouds).ok_or(NoPicture::Stopped)?;
    let all = Hidden::default();
    let (eye, hidden) = match &eye {
        Ok(id) => (StillEye::Saved(scene.cameras.with_id(*id).ok_or(Failed::NoCamera)?), &all),
        Err((camera, hidden)) => (StillEye::Free(camera), hidden),
    };
    let told = Told::default();
    let tell = |line: &str| told.tell(line);
    let mut painter = Painter::new(&painting, rules, &tell).map_err(NoPicture::from)?;
    let still = Still { scene: &scene, derived: &derived, beside: &beside, eye, moment, size, hidden };
    let bytes = still.file(&mut painter, kind, in_layers, watch)?;
    drop(painter);
    let mut files = Together::default();
    files.add(&to, over, |sink| sink.write_all(&bytes))?;
    if watch.is_cancelled() {
        return Err(NoPicture::Stopped.into());
    }
    files.take_names()?;
    Ok(Rendered { to, news: told.news() })
}

impl Editor {
    pub(in crate::editor) fn ask_rendering(&mut self) {
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        let chosen = self.disk.settings().picture.clone();
        self.rendering.asked = Some(Asked { chosen, camera: None, progress: Progress::Choosing(None) });
    }

    pub(in crate::editor) fn show_rendering(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.rendering.asked.take() else { return };
        match asked.progress.answer() {
            Some(Ok(Rendered { to, news })) => {
                self.tell(format!("Written: {}", to.display()));
                news.iter().for_each(|line| self.tell(line));
                return;
            }
            Some(Err(Failed::Picture(NoPicture::Stopped))) => asked.progress = Progress::Choosing(None),
            Some(Err(error)) => asked.progress = Progress::Choosing(Some(format!("Nothing was written: {error}."))),
            None => {}
        }
        let stage = asked.progress.stage(context);
        let form = PictureForm {
            scene: self.session.scene(),
            clock_s: self.clock.time_s(),
            hour_h: self.time_play.time_h(),
            stage,
            can_go: self.waiting.is_none(),
        };
        match panel::ask_picture(context, &form, &mut asked.chosen, &mut asked.camera) {
            Some(ExchangeAnswer::Begin) => {
                let chosen = asked.chosen.clone();
                self.disk.remember(move |settings| settings.picture = chosen.clone());
                let name = || PathBuf::from(&self.session.scene().name);
                let start = self.session.path().map_or_else(name, PathBuf::from);
                self.ask(Ask::Picture(start.with_extension(asked.chosen.kind.ending())), context);
            }
            Some(ExchangeAnswer::Stop) => asked.progress = Progress::Choosing(None),
            Some(ExchangeAnswer::Close) => return,
            None => {}
        }
        self.rendering.asked = Some(asked);
    }

    /// Has the picture drawn into the file whose name was given.
    pub(in crate::editor) fn render_to(&mut self, given: &Path, asked_already: bool, context: &egui::Context) {
        let Some(mut asked) = self.rendering.asked.take() else { return };
        asked.progress = match self.to_render(&asked, given, asked_already) {
            Ok(request) => Progress::begin(request, carry_out, context),
            Err(error) => Progress::Choosing(Some(format!("Nothing was written: {error}."))),
        };
        self.rendering.asked = Some(asked);
    }

    fn to_render(&self, asked: &Asked, given: &Path, asked_already: bool) -> Result<Request, Failed> {
        let chosen = &asked.chosen;
        let to = match given.extension() {
            Some(_) => given.to_path_buf(),
            None => given.with_extension(chosen.kind.ending()),
        };
        let kind = kind_of(&to).ok_or(Failed::NoKind)?;
        let in_layers = chosen.kind == PictureKind::Exr && chosen.layers;
        if in_layers && kind != PictureKind::Exr {
            return Err(Failed::NoLayers);
        }
        let (_, _, beside) = self.session.to_draw();
        Ok(Request {
            scene: Arc::new(self.session.scene().clone()),
            beside,
            file: self.session.path().map(PathBuf::from),
            eye: asked.camera.ok_or_else(|| self.viewport.picture_eye()),
            moment: Moment { clock_s: self.clock.time_s(), time_h: self.time_play.time_h() },
            painting: Painting {
                // Layers are drawn on the CPU.
                renderer: if in_layers { RendererChoice::Cpu } else { self.renderer },
                method: chosen.method.as_deref().and_then(method::named),
                side: chosen.samples_side(),
                tolerance: 0.0,
            },
            kind,
            size: chosen.size(),
            in_layers,
            over: over(given, &to, asked_already),
            to,
        })
    }
}
