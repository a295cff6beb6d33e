//! How a file comes in.

use super::{ExchangeAnswer, Stage, ask, grid, option_rows};
use crate::theme;
use crate::widget::seed_field;
use cloudwright_core::exchange::{Format, Options, Part};
use egui::Context;

/// What is shown of a file.
#[derive(Clone, Copy)]
pub(crate) struct ArrivingForm<'a> {
    /// Its name.
    pub(crate) name: &'a str,
    pub(crate) format: &'static Format,
    pub(crate) stage: Stage<'a>,
}

/// Asks.
pub(crate) fn ask_arriving(
    context: &Context,
    form: &ArrivingForm<'_>,
    options: &mut Options,
    (seed, keeps_clouds): (&mut u64, &mut bool),
) -> Option<ExchangeAnswer> {
    ask(context, ("Import", "Import"), form.stage, true, |ui| {
        ui.label(form.name);
        ui.weak(format!("{}: {}.", form.format.title, form.format.about));
        ui.add_space(theme::GAP);
        grid(ui, "import", |ui| {
            option_rows(ui, form.format.read_options, options);
            // Layers and air become a sky of plugins' clouds.
            if form.format.carries.contains(&Part::Weather) {
                ui.label("");
                ui.checkbox(keeps_clouds, "Keep the clouds that stand")
                    .on_hover_text("Else the weather's clouds take their place.");
                ui.end_row();
                let doc = "Another one is another sky of the same weather.";
                ui.label("Seed").on_hover_text(doc);
                ui.horizontal(|ui| seed_field(ui, "Seed", "Re-roll Seed", doc, seed));
                ui.end_row();
            }
        });
    })
}
