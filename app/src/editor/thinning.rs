//! Dropping the sprites that a scene can do without: asked for, worked out off the frame, and one undo point.

use super::Editor;
use crate::command::Command;
use crate::opening::Beside;
use crate::panel::{self, ThinAnswer};
use crate::worker::Latest;
use cloudwright_core::scene::Scene;
use cloudwright_core::thin::{ThinError, Thinned, thin};
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use std::sync::Arc;
use std::time::Duration;

/// Between two looks at how far it has come.
const LOOK: Duration = Duration::from_millis(100);

/// What is asked, and what is being worked out.
#[derive(Debug)]
pub(super) struct Thinning {
    tolerance: f64,
    work: Option<Work>,
    /// Why the last try came to nothing.
    refusal: Option<String>,
}

#[derive(Debug)]
struct Work {
    worker: Latest<Request, Result<Thinned, ThinError>>,
    watch: Arc<Watch>,
    /// The scene that it is of.
    revision: Version,
}

#[derive(Debug)]
struct Request {
    scene: Arc<Scene>,
    beside: Beside,
    tolerance: f64,
    watch: Arc<Watch>,
}

impl Drop for Work {
    fn drop(&mut self) {
        self.watch.cancel();
    }
}

impl Editor {
    pub(super) fn ask_thinning(&mut self) {
        self.thinning = Some(Thinning { tolerance: panel::USUAL_TOLERANCE, work: None, refusal: None });
    }

    pub(super) fn show_thinning(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.thinning.take() else { return };
        if let Some(answer) = asked.work.as_ref().and_then(|work| work.worker.newest()) {
            let is_of_this = asked.work.take().is_some_and(|work| work.revision == self.session.revision());
            match answer {
                Ok(thinned) if is_of_this => return self.thin_out(thinned),
                Ok(_) => asked.refusal = Some("the scene has changed meanwhile".into()),
                Err(error) => asked.refusal = Some(error.to_string()),
            }
        }
        let done = asked.work.as_ref().map(|work| work.watch.share());
        match panel::ask_thinning(context, &mut asked.tolerance, done, asked.refusal.as_deref()) {
            Some(ThinAnswer::Begin) => self.begin_thinning(&mut asked, context),
            Some(ThinAnswer::Stop) => asked.work = None,
            Some(ThinAnswer::Close) => return,
            None => {}
        }
        if asked.work.is_some() {
            context.request_repaint_after(LOOK);
        }
        self.thinning = Some(asked);
    }

    fn begin_thinning(&mut self, asked: &mut Thinning, context: &egui::Context) {
        let wake = context.clone();
        let work =
            |Request { scene, beside, tolerance, watch }: Request| thin(&scene, beside.sheet(), tolerance, &watch);
        match Latest::start_beside_the_window("thinning", work, move || wake.request_repaint()) {
            Ok(worker) => {
                let (scene, _, beside) = self.session.to_draw();
                let watch = Arc::new(Watch::default());
                worker.ask(Request { scene, beside, tolerance: asked.tolerance, watch: Arc::clone(&watch) });
                asked.refusal = None;
                asked.work = Some(Work { worker, watch, revision: self.session.revision() });
            }
            Err(error) => asked.refusal = Some(format!("the system gives no thread: {error}")),
        }
    }

    fn thin_out(&mut self, thinned: Thinned) {
        let Thinned { edits, before, after, error, worst_view, models_left, .. } = thinned;
        let done = self.session.edit(Command::ThinOut.row().label(), edits);
        if done.is_ok() {
            self.tell(format!(
                "{after} of {before} sprites are left; {worst_view} differs most, by a mean FLIP of {error:.4}"
            ));
            if models_left > 0 {
                self.tell(format!("Models with the fewest sprites were left as they were: {models_left} of them"));
            }
        }
        self.report(done);
    }
}
