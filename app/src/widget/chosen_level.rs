//! The colour level that was touched last: chosen in the panel and on the cloud alike.

use egui::{Context, Id};

/// What an arrow key moves a level's height by.
pub(crate) const LEVEL_STEP: f64 = 0.01;

/// The level that was touched last, 0 the lowest.
pub(crate) fn chosen_level(context: &Context) -> usize {
    context.data(|data| data.get_temp(id())).unwrap_or(2)
}

/// Another one is touched.
pub(crate) fn choose_level(context: &Context, level: usize) {
    context.data_mut(|data| data.insert_temp(id(), level));
}

fn id() -> Id {
    Id::unique("chosen colour level")
}
