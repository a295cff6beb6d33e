//! *Import…*: what another program made, into the scene; a whole scene in its place.

use crate::editor::Editor;
use crate::editor::intent::Intent;
use crate::editor::progress::Progress;
use crate::exchange::{CameIn, ComeInError, Placing, ReadError, called, choose, come_in, read};
use crate::panel::{self, ArrivingForm, ExchangeAnswer};
use crate::reports::{MOST_TIME, MakeError, words};
use crate::state::{Item, Selection};
use crate::units::{Units, counted};
use cloudwright_core::document::{Document, Edit, SavedMark};
use cloudwright_core::exchange::{Arrived, Content, Format, Note, Options};
use cloudwright_core::scene::Scene;
use cloudwright_core::watch::Watch;
use cloudwright_scripts::{Fault, Patience};
use glam::DVec3;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::Instant;

/// What is being asked, and what was chosen last.
#[derive(Default)]
pub(in crate::editor) struct Arriving {
    asked: Option<Asked>,
    seed: u64,
    keeps_clouds: bool,
}

struct Asked {
    path: PathBuf,
    name: String,
    format: &'static Format,
    options: Options,
    /// The state that it comes into.
    before: SavedMark,
    progress: Progress<Request, Outcome>,
}

struct Request {
    path: PathBuf,
    format: &'static Format,
    options: Options,
    scene: Arc<Scene>,
    at: DVec3,
    model_at: DVec3,
    seed: u64,
    keeps_clouds: bool,
    /// Whether it lies where a scene can name it.
    is_beside: bool,
}

/// What came, with what could not; none if it was stopped.
type Outcome = Result<Option<(Came, Vec<Note>)>, String>;

enum Came {
    Whole(Box<Scene>),
    /// An undo point of that name, and what it is made of.
    Edits(String, Vec<Edit>, CameIn),
}

impl Arriving {
    pub(in crate::editor) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }
}

fn carry_out(request: Request, watch: &Watch) -> Outcome {
    let Request { path, format, options, scene, at, model_at, seed, keeps_clouds, is_beside } = request;
    let arrived = read(&path, format, &options).map_err(|error| match error {
        ReadError::Misread { misread, .. } => format!("{misread}, read as {}", format.title),
        ReadError::Storage(error) => error.to_string(),
    })?;
    let Arrived { content, notes } = arrived;
    if let Content::Scene(scene) = content {
        return Ok(Some((Came::Whole(scene), notes)));
    }
    if matches!(content, Content::Model(_)) && !is_beside {
        return Err("it is a model, which has to lie beside the scene's file; copy it there first".into());
    }
    let file_name = path.file_name().and_then(|name| name.to_str()).ok_or("its name is no text")?;
    let placing = Placing { file_name, at, model_at, seed, keeps_clouds };
    let mut document = Document::new(Scene::clone(&scene));
    let patience = Patience { cancelled: watch.cancelled(), until: Some(Instant::now() + MOST_TIME) };
    match come_in(&mut document, &content, &placing, &patience) {
        Ok(mut came) => {
            let mut notes = notes;
            notes.append(&mut came.notes);
            let name = document.undo_name().unwrap_or_default().to_owned();
            Ok(Some((Came::Edits(name, document.last_edits(), came), notes)))
        }
        Err(ComeInError::Make(MakeError::Plugin { error, .. })) if error.fault == Fault::Cancelled => Ok(None),
        Err(error) => Err(error.to_string()),
    }
}

impl Editor {
    /// Asks how the file at `path` is to come in, if any format fits it.
    pub(in crate::editor) fn ask_arriving(&mut self, path: &Path) {
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        match choose(path, None) {
            Ok(format) => {
                self.arriving.seed = self.arriving.seed.max(1);
                self.arriving.asked = Some(Asked {
                    path: path.into(),
                    name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
                    format,
                    options: format.usual_for_reading(),
                    before: self.session.document().mark(),
                    progress: Progress::Choosing(None),
                });
            }
            Err(error) => self.dialogs.fail("Nothing was imported", &error),
        }
    }

    pub(in crate::editor) fn show_arriving(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.arriving.asked.take() else { return };
        if let Some(outcome) = asked.progress.answer() {
            let is_of_this = asked.before == self.session.document().mark();
            asked.progress = match outcome {
                Err(error) => Progress::Choosing(Some(format!("Nothing came in: {error}."))),
                Ok(None) => Progress::Choosing(None),
                Ok(Some(_)) if !is_of_this => {
                    Progress::Choosing(Some("Nothing came in: the scene has changed meanwhile.".into()))
                }
                Ok(Some((Came::Whole(scene), notes))) => {
                    let line = format!("{} in a scene of its own", counted(scene.clouds.len(), "cloud", "clouds"));
                    self.want(Intent::Take(Arc::new(*scene)), context);
                    Progress::Done(vec![line], notes)
                }
                Ok(Some((Came::Edits(name, edits, came), notes))) => match self.session.edit(&name, edits) {
                    Ok(()) => {
                        let clouds = came.clouds.iter().map(|id| Item::Cloud(*id));
                        self.select(Selection::of(clouds.chain(came.model.iter().map(|(thing, _)| *thing))));
                        Progress::Done(told(&came), notes)
                    }
                    Err(error) => Progress::Choosing(Some(format!("Nothing came in: {error}."))),
                },
            };
            if let Progress::Done(lines, notes) = &asked.progress
                && notes.is_empty()
            {
                self.tell(format!("Imported {}: {}", asked.name, lines.join("; ")));
                return;
            }
        }
        let form = ArrivingForm { name: &asked.name, format: asked.format, stage: asked.progress.stage(context) };
        let Arriving { seed, keeps_clouds, .. } = &mut self.arriving;
        match panel::ask_arriving(context, &form, &mut asked.options, (seed, keeps_clouds)) {
            Some(ExchangeAnswer::Begin) => self.begin_arriving(&mut asked, context),
            Some(ExchangeAnswer::Stop) => asked.progress = Progress::Choosing(None),
            Some(ExchangeAnswer::Close) => return,
            None => {}
        }
        self.arriving.asked = Some(asked);
    }

    fn begin_arriving(&mut self, asked: &mut Asked, context: &egui::Context) {
        asked.before = self.session.document().mark();
        let at = self.viewport.looked_at();
        let request = Request {
            path: asked.path.clone(),
            format: asked.format,
            options: asked.options.clone(),
            scene: Arc::new(self.session.scene().clone()),
            at,
            // On the ground below it.
            model_at: at.with_y(0.0),
            seed: self.arriving.seed,
            keeps_clouds: self.arriving.keeps_clouds,
            is_beside: self.lies_beside(&asked.path),
        };
        asked.progress = Progress::begin(request, carry_out, context);
    }
}

/// What came in, a line each.
fn told(came: &CameIn) -> Vec<String> {
    let layer = |made: &crate::reports::MadeLayer| {
        let what = words::layer(&made.layer, Units::Metric);
        match made.fullest() {
            Some(cover) => format!("{what}: {:.1} of {:.1} oktas", cover.measured_oktas, cover.asked_oktas),
            None => what,
        }
    };
    if !came.layers.is_empty() {
        return came.layers.iter().map(layer).collect();
    }
    if let Some((thing, model)) = &came.model {
        return vec![format!("{} of {}", called(*thing), counted(model.triangles, "triangle", "triangles"))];
    }
    match (came.models, came.clouds.len()) {
        (0, 0) => vec!["no clouds".into()],
        (models, clouds) => {
            vec![format!("{}, {}", counted(models, "model", "models"), counted(clouds, "cloud", "clouds"))]
        }
    }
}
