//! The menu of the right button in the picture.

use super::Viewport;
use super::pick::{self, Picked};
use super::screen::Screen;
use crate::command::context;
use crate::state::{Action, Choose, Item, Reading};
use crate::widget::context_menu;
use egui::Response;

impl Viewport {
    /// A click of the right button offers what can be done with what lies there, which is chosen unless it is already; not
    /// where a click ends something else, and so `may_ask` for nothing.
    pub(super) fn menu(
        &self,
        may_ask: bool,
        response: &Response,
        screen: &Screen,
        reading: &Reading<'_>,
        actions: &mut Vec<Action>,
    ) {
        if !may_ask && response.secondary_clicked() {
            return;
        }
        if response.secondary_clicked()
            && let Some(at) = response.interact_pointer_pos()
        {
            let picked = match self.paths.under(at, screen) {
                Some((path, _)) => Some(Picked { item: Item::Path(path), through: None }),
                None => {
                    let under = pick::under(at, screen, reading);
                    under.get(pick::first(&under, reading)).copied()
                }
            };
            if let Some(Picked { item, through }) = picked.filter(|found| !reading.view.selection.contains(found.item))
            {
                actions.push(Action::Select { items: vec![item], through, how: Choose::Only });
            }
        }
        actions.extend(context_menu(response, context::VIEWPORT, reading.offered).map(Action::Command));
    }
}
