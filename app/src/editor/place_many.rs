//! Many placements at once: what is chosen is shown as an open gesture, which becomes one undo point or nothing.

use super::Editor;
use crate::command::Command;
use crate::panel::{self, Answer};
use crate::state::{Item, Selection};
use cloudwright_core::arrange::place_many::{self, Places};
use cloudwright_core::scene::ModelId;

/// What is being chosen.
#[derive(Debug)]
pub(super) struct PlaceMany {
    model: ModelId,
    places: Places,
    /// What the scene shows, and the clouds that it shows it by.
    shown: Option<Places>,
    made: Vec<Item>,
}

impl Editor {
    pub(super) fn ask_place_many(&mut self) {
        let Some(model) = self.view.selection.model(self.session.scene()) else { return };
        let mut center = self.viewport.looked_at();
        if let Some(cloud) = self.view.selection.cloud(self.session.scene()) {
            center.y = cloud.position.y;
        }
        self.place_many =
            Some(PlaceMany { model: model.id, places: panel::default_places(center), shown: None, made: Vec::new() });
    }

    pub(super) fn show_place_many(&mut self, context: &egui::Context) {
        let Some(mut asked) = self.place_many.take() else { return };
        // Whatever ended the gesture meanwhile (a save, an undo) has answered.
        if asked.shown.is_some() && !self.session.document().is_open() {
            return;
        }
        let Some(model) = self.session.scene().model(asked.model) else { return };
        let answer = panel::ask_place_many(context, &model.name, &mut asked.places);
        match answer {
            Some(Answer::Do) => {
                self.show_places(&mut asked);
                let done = self.session.commit();
                if done.is_ok() {
                    self.select(Selection::of(asked.made));
                }
                self.report(done);
            }
            Some(Answer::Cancel) => self.session.cancel(),
            None => {
                self.show_places(&mut asked);
                self.place_many = Some(asked);
            }
        }
    }

    /// Brings the scene to what is chosen.
    fn show_places(&mut self, asked: &mut PlaceMany) {
        if asked.shown == Some(asked.places) {
            return;
        }
        self.session.cancel();
        let arrangement = place_many::model(self.session.scene(), asked.model, &asked.places);
        asked.made = arrangement.made;
        let done = self.session.drag(Command::PlaceMany.row().label(), arrangement.edits);
        self.report(done);
        asked.shown = Some(asked.places);
    }
}
