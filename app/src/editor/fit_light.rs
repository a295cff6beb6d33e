//! Light fitted to a path tracer's: asked for, worked out off the frame, and one undo point.

use super::Editor;
use super::progress::Progress;
use crate::command::Command;
use crate::opening::Beside;
use crate::panel::{self, ExchangeAnswer, FitLightChosen};
use cloudwright_core::fit_light::{Choice, FitError, FittedLight, FittedModel, fit_light};
use cloudwright_core::scene::Scene;
use cloudwright_core::version::Version;
use cloudwright_core::watch::Watch;
use std::sync::Arc;

/// What is being asked, and what was chosen last.
#[derive(Default)]
pub(super) struct FittingLight {
    asked: Option<Progress<Request, Answer>>,
    /// Until the window is closed.
    chosen: FitLightChosen,
}

type Answer = (Version, Result<FittedLight, FitError>);

struct Request {
    scene: Arc<Scene>,
    /// The scene's.
    revision: Version,
    beside: Beside,
    choice: Choice,
}

fn carry_out(Request { scene, revision, beside, choice }: Request, watch: &Watch) -> Answer {
    (revision, fit_light(&scene, beside.sheet(), &choice, watch))
}

impl FittingLight {
    pub(super) fn is_asking(&self) -> bool {
        self.asked.is_some()
    }
}

impl Editor {
    pub(super) fn ask_fit_light(&mut self) {
        match self.session.commit() {
            Ok(()) => self.fitting_light.asked = Some(Progress::Choosing(None)),
            Err(error) => self.tell_error(error.to_string()),
        }
    }

    pub(super) fn show_fit_light(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.fitting_light.asked.take() else { return };
        if let Some((revision, answer)) = asked.answer() {
            asked = match answer {
                Ok(fitted) if revision == self.session.revision() => self.fit_light(fitted),
                Ok(_) => Progress::Choosing(Some("Nothing was changed: the scene has changed meanwhile.".into())),
                Err(FitError::Cancelled) => Progress::Choosing(None),
                Err(error) => Progress::Choosing(Some(format!("Nothing was changed: {error}."))),
            };
        }
        let selected = self.view.selection.models(self.session.scene()).len();
        let chosen = &mut self.fitting_light.chosen;
        match panel::ask_fit_light(context, asked.stage(context), selected, chosen) {
            Some(ExchangeAnswer::Begin) => asked = Progress::begin(self.fit_light_request(), carry_out, context),
            Some(ExchangeAnswer::Stop) => asked = Progress::Choosing(None),
            Some(ExchangeAnswer::Close) => return,
            None => {}
        }
        self.fitting_light.asked = Some(asked);
    }

    fn fit_light_request(&self) -> Request {
        let FitLightChosen { free, only_selected, only_hour } = self.fitting_light.chosen;
        let scene = self.session.scene();
        let selected = self.view.selection.models(scene).into_iter().map(|model| model.id);
        let choice = Choice {
            models: if only_selected { selected.collect() } else { Vec::new() },
            free,
            hours: if only_hour { vec![scene.time_of_day_h] } else { Vec::new() },
            ..Choice::default()
        };
        let (_, _, beside) = self.session.to_draw();
        Request { scene: Arc::new(scene.clone()), revision: self.session.revision(), beside, choice }
    }

    /// One undo point, and what came of it.
    fn fit_light(&mut self, FittedLight { edits, models, .. }: FittedLight) -> Progress<Request, Answer> {
        match self.session.edit(Command::FitLight.row().label(), edits) {
            Ok(()) => Progress::Done(models.iter().flat_map(FittedModel::in_words).collect(), Vec::new()),
            Err(error) => Progress::Choosing(Some(format!("Nothing was changed: {error}."))),
        }
    }
}
