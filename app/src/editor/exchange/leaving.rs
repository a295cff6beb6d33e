//! *Export…*: a scene for other programs.

use crate::editor::files::over;
use crate::editor::progress::Progress;
use crate::editor::{Ask, Editor};
use crate::exchange::{LeaveError, Left, Order, Subject, leave};
use crate::opening::Beside;
use crate::panel::{self, ExchangeAnswer, LeavingChosen, LeavingForm};
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::exchange::ExportError;
use cloudwright_core::scene::Scene;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;
use cloudwright_scripts::PluginKind;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// What is being asked, and what was chosen last.
#[derive(Default)]
pub(in crate::editor) struct Leaving {
    asked: Option<Progress<Request, Result<Left, LeaveError>>>,
    /// Until the window is closed.
    chosen: LeavingChosen,
}

impl Leaving {
    pub(in crate::editor) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }
}

struct Request {
    scene: Arc<Scene>,
    beside: Beside,
    file: Option<PathBuf>,
    order: Order,
    to: PathBuf,
}

fn carry_out(request: Request, watch: &Watch) -> Result<Left, LeaveError> {
    let Request { scene, beside, file, order, to } = request;
    // What the window shows may still be on the way to this scene.
    let nothing = Derived::default();
    let plan = nothing.plan(&scene, &Change::everything());
    let derived = plan.carry_out(watch).ok_or(LeaveError::Export(ExportError::Cancelled))?;
    let subject = Subject { scene: &scene, derived: &derived, atlas: beside.sheet(), file: file.as_deref() };
    leave(subject, &order, &to, watch)
}

impl Editor {
    pub(in crate::editor) fn ask_leaving(&mut self) {
        if let Err(error) = self.session.commit() {
            return self.tell_error(error.to_string());
        }
        let chosen = &mut self.leaving.chosen;
        let cameras = &self.session.scene().cameras;
        if chosen.camera.is_none_or(|camera| cameras.with_id(camera).is_none()) {
            chosen.camera = cameras.first().map(|camera| camera.id);
        }
        self.leaving.asked = Some(Progress::Choosing(None));
    }

    pub(in crate::editor) fn show_leaving(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.leaving.asked.take() else { return };
        if let Some(answer) = asked.answer() {
            asked = match answer {
                Ok(Left { files, notes }) => {
                    let line = |path: &PathBuf| format!("Written: {}", path.display());
                    Progress::Done(files.iter().map(line).collect(), notes)
                }
                Err(LeaveError::Export(ExportError::Cancelled)) => Progress::Choosing(None),
                Err(error) => Progress::Choosing(Some(format!("Nothing was written: {error}."))),
            };
        }
        let library = self.plugins.library();
        let exporters = library.of_kind(PluginKind::Exporter).into_iter();
        let exporters: Vec<_> =
            exporters.map(|(entry, plugin)| (entry.origin.clone(), library.label(&entry.origin, plugin))).collect();
        let form = LeavingForm {
            scene: self.session.scene(),
            exporters: &exporters,
            clock_s: self.clock.time_s(),
            selected: self.view.selection.clouds().count(),
            stage: asked.stage(context),
            can_go: self.waiting.is_none(),
        };
        match panel::ask_leaving(context, &form, &mut self.leaving.chosen) {
            Some(ExchangeAnswer::Begin) => {
                let name = || PathBuf::from(&self.session.scene().name);
                let start = self.session.path().map_or_else(name, PathBuf::from);
                let start = start.with_extension(self.leaving.chosen.format.endings[0]);
                self.ask(Ask::Leave(start), context);
            }
            Some(ExchangeAnswer::Stop) => asked = Progress::Choosing(None),
            Some(ExchangeAnswer::Close) => return,
            None => {}
        }
        if let Some(exporter) = self.leaving.chosen.exporter.take() {
            return self.ask_plugin(&exporter, context);
        }
        self.leaving.asked = Some(asked);
    }

    /// Has the scene written under the name that was given.
    pub(in crate::editor) fn leave_to(&mut self, given: &Path, asked_already: bool, context: &egui::Context) {
        if !self.leaving.is_asking() {
            return;
        }
        let chosen = &self.leaving.chosen;
        let ending = chosen.format.endings[0];
        let to = if given.extension().is_some() { given.to_path_buf() } else { given.with_extension(ending) };
        let over = over(given, &to, asked_already);
        let scene = self.session.scene();
        let clock_s = self.clock.time_s();
        let camera = chosen.has_corners().then(|| match chosen.camera.and_then(|id| scene.cameras.with_id(id)) {
            Some(camera) => self.session.derived().timeline().camera_at(camera, clock_s),
            None => self.viewport.camera().clone(),
        });
        let selected = self.view.selection.clouds().collect::<Vec<_>>();
        let order = Order {
            format: chosen.format,
            options: chosen.options(),
            clouds: (chosen.only_selected && !selected.is_empty()).then_some(selected),
            camera,
            moment: Moment::at(clock_s),
            over,
        };
        let (_, _, beside) = self.session.to_draw();
        let file = self.session.path().map(PathBuf::from);
        let request = Request { scene: Arc::new(scene.clone()), beside, file, order, to };
        self.leaving.asked = Some(Progress::begin(request, carry_out, context));
    }
}
