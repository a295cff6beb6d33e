//! The tour: the panel that a step is about comes up with it.

use super::Editor;
use crate::panel::{STEPS, TourAnswer, tour};
use egui::Context;

impl Editor {
    pub(super) fn begin_tour(&mut self) {
        self.go_on_tour(0);
    }

    fn go_on_tour(&mut self, at: usize) {
        self.tour = STEPS.get(at).map(|step| {
            if !self.layout.shows(step.panel) {
                self.layout.bring_up(step.panel);
            }
            at
        });
    }

    pub(super) fn show_tour(&mut self, context: &Context) {
        let Some(at) = self.tour else { return };
        let about = STEPS.get(at).and_then(|step| self.layout.place_of(step.panel));
        // Questions, gestures and flights end by Esc first.
        let takes_esc = !self.is_asking()
            && !self.session.document().is_open()
            && !self.viewport.has_keys()
            && !self.viewport.is_on_board()
            && !context.text_edit_focused();
        match tour(context, at, self.layout.picture_place(context), about, takes_esc) {
            Some(TourAnswer::Go(to)) => self.go_on_tour(to),
            Some(TourAnswer::Leave) => self.tour = None,
            None => {}
        }
    }
}
