//! *Render flight…*: the frames and the video that `cloudwright fly` writes, from the window.

use super::Told;
use crate::editor::progress::Progress;
use crate::editor::{Ask, Editor};
use crate::opening::Beside;
use crate::panel::{self, ExchangeAnswer, FilmChosen, FilmForm, film_eyes};
use crate::picture_kind::PictureKind;
use crate::renderer::RendererChoice;
use crate::rendering::{
    Eye, Film, Filmed, Flight, IN_LAYERS, NoFlight, NoPicture, Painter, Painting, check_memory, check_size, is_video,
    last_key_s,
};
use crate::state::Item;
use crate::storage::{StorageError, There};
use crate::units::counted;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::method;
use cloudwright_core::rules::{Rasterizer, Rules};
use cloudwright_core::scene::{Scene, Thing};
use cloudwright_core::watch::Watch;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A film from a camera lasts so long where no track says how long, seconds.
const DURATION_S: f64 = 10.0;

/// What is being asked.
#[derive(Default)]
pub(in crate::editor) struct Filming {
    asked: Option<Asked>,
}

struct Asked {
    chosen: FilmChosen,
    progress: Progress<Request, Result<Made, NoFlight>>,
}

impl Filming {
    pub(in crate::editor) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }
}

struct Request {
    scene: Arc<Scene>,
    beside: Beside,
    file: Option<PathBuf>,
    eye: Thing,
    seconds: f64,
    painting: Painting,
    crossfade: bool,
    film: Film,
    /// Whether a video that is there may be lost.
    may_replace: bool,
}

struct Made {
    filmed: Filmed,
    /// What the pictures lack.
    news: Vec<String>,
    to: PathBuf,
}

/// By which rules the films of that painting are drawn.
fn rules(painting: &Painting, crossfade: bool) -> Rules {
    let rules = painting.rules();
    if crossfade && painting.method.is_none() { rules.sorted(Sorting::Crossfade) } else { rules }
}

fn eye<'a>(scene: &'a Scene, eye: Thing, seconds: f64, rules: Rules) -> Option<Eye<'a>> {
    match eye {
        Thing::Path(id) => scene.paths.with_id(id).map(|path| Eye::along(path, rules)),
        Thing::Camera(id) => scene.cameras.with_id(id).map(|camera| Eye::Still(camera, seconds)),
        _ => None,
    }
}

fn carry_out(request: Request, watch: &Watch) -> Result<Made, NoFlight> {
    let Request { scene, beside, file, eye: thing, seconds, painting, crossfade, film, may_replace } = request;
    let rules = rules(&painting, crossfade);
    check_memory(film.size, rules.pixels_a_pixel(), if film.in_layers { IN_LAYERS } else { 1 })
        .map_err(NoPicture::from)?;
    if film.in_layers && !matches!(rules.rasterizer, Rasterizer::Fast(_)) {
        return Err(NoPicture::NoLayers.into());
    }
    if is_video(&film.output) {
        check_size(film.size)?;
        if film.output.exists() && !may_replace {
            let reason = "there is a file of that name already".into();
            return Err(StorageError::InTheWay { path: film.output, reason }.into());
        }
    }
    let told = Told::default();
    let tell = |line: &str| told.tell(line);
    let eye = eye(&scene, thing, seconds, rules).ok_or(NoFlight::NoEye)?;
    let flight = Flight { scene: &scene, beside: &beside, file: file.as_deref(), eye };
    let painter = || Ok(Painter::new(&painting, rules, &tell)?);
    let filmed = flight.film(&film, painter, watch)?;
    Ok(Made { filmed, news: told.news(), to: film.output })
}

impl Editor {
    /// Whether anything can film.
    pub(in crate::editor) fn can_film(&self) -> bool {
        let scene = self.session.scene();
        !scene.cameras.is_empty() || scene.paths.iter().any(|path| path.keys.len() > 1)
    }

    pub(in crate::editor) fn ask_filming(&mut self) {
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        let scene = self.session.scene();
        let eyes = film_eyes(scene);
        let is_there = |thing: &Thing| eyes.iter().any(|(each, _)| each == thing);
        let selected = match self.view.selection.primary() {
            Some(Item::Camera(id)) => Some(Thing::Camera(id)),
            _ => self.clock.path(scene).map(|path| Thing::Path(path.id)),
        };
        let Some(eye) = selected.filter(is_there).or_else(|| Some(eyes.first()?.0)) else { return };
        let chosen = FilmChosen {
            settings: self.disk.settings().film.clone(),
            eye,
            seconds: last_key_s(scene).unwrap_or(DURATION_S),
            part: None,
        };
        self.filming.asked = Some(Asked { chosen, progress: Progress::Choosing(None) });
    }

    pub(in crate::editor) fn show_filming(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.filming.asked.take() else { return };
        match asked.progress.answer() {
            Some(Ok(Made { filmed: Filmed { drawn, kept, folder }, news, to })) => {
                let drawn = counted(drawn, "frame", "frames");
                self.tell(match is_video(&to) {
                    true => format!("Written: {}; {drawn} drawn, {kept} kept, in {}", to.display(), folder.display()),
                    false => format!("Written: {drawn}, {kept} kept, in {}", folder.display()),
                });
                news.iter().for_each(|line| self.tell(line));
                return;
            }
            Some(Err(NoFlight::Picture(NoPicture::Stopped))) => {
                let word = "Stopped: the frames drawn so far are there, and kept if you choose so.";
                asked.progress = Progress::Choosing(Some(word.into()));
            }
            Some(Err(error @ NoFlight::NoVideo { .. })) => asked.progress = Progress::Choosing(Some(error.to_string())),
            Some(Err(error)) => {
                asked.progress = Progress::Choosing(Some(format!("Nothing more was written: {error}.")));
            }
            None => {}
        }
        let scene = self.session.scene();
        let FilmChosen { eye: thing, seconds, .. } = asked.chosen;
        let duration_s = eye(scene, thing, seconds, Rules::SHIPPED).map_or(0.0, |eye| eye.duration_s());
        let hour_h = self.time_play.time_h();
        let stage = asked.progress.stage(context);
        let form = FilmForm { scene, duration_s, hour_h, stage, can_go: self.waiting.is_none() };
        match panel::ask_film(context, &form, &mut asked.chosen) {
            Some(ExchangeAnswer::Begin) => {
                let settings = asked.chosen.settings.clone();
                let name = || PathBuf::from(&self.session.scene().name);
                let start = self.session.path().map_or_else(name, PathBuf::from);
                let is_video = settings.video;
                self.disk.remember(move |all| all.film = settings.clone());
                self.ask(if is_video { Ask::Video(start.with_extension("mp4")) } else { Ask::Frames(start) }, context);
            }
            Some(ExchangeAnswer::Stop) => asked.progress.stop(),
            Some(ExchangeAnswer::Close) => return,
            None => {}
        }
        self.filming.asked = Some(asked);
    }

    /// Has the film drawn into the video or folder whose name was given.
    pub(in crate::editor) fn film_to(&mut self, given: &Path, asked_already: bool, context: &egui::Context) {
        let Some(mut asked) = self.filming.asked.take() else { return };
        let FilmChosen { settings, eye, seconds, part } = &asked.chosen;
        let output = match given.extension() {
            None if settings.video => given.with_extension("mp4"),
            _ => given.to_path_buf(),
        };
        if is_video(&output) != settings.video {
            let word = if settings.video { "a video's name ends in .mp4" } else { "frames go into a folder" };
            asked.progress = Progress::Choosing(Some(format!("Nothing was written: {word}.")));
            self.filming.asked = Some(asked);
            return;
        }
        let kind = if settings.video { PictureKind::Png } else { settings.frame.kind };
        let in_layers = kind == PictureKind::Exr && settings.frame.layers;
        let painting = Painting {
            // Layers are drawn on the CPU.
            renderer: if in_layers { RendererChoice::Cpu } else { self.renderer },
            method: settings.frame.method.as_deref().and_then(method::named),
            side: settings.frame.samples_side(),
            tolerance: 0.0,
        };
        let (_, _, beside) = self.session.to_draw();
        let request = Request {
            scene: Arc::new(self.session.scene().clone()),
            beside,
            file: self.session.path().map(PathBuf::from),
            eye: *eye,
            seconds: *seconds,
            painting,
            crossfade: settings.crossfade && matches!(eye, Thing::Path(_)),
            may_replace: asked_already && output == given || settings.there == There::Replace,
            film: Film {
                output,
                kind,
                in_layers,
                size: settings.frame.size(),
                fps: settings.frames_a_second(),
                asked: part.clone(),
                time_h: self.time_play.time_h(),
                there: settings.there,
            },
        };
        asked.progress = Progress::begin(request, carry_out, context);
        self.filming.asked = Some(asked);
    }
}
