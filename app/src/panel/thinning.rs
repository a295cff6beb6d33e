//! Asks how much a scene may change when sprites are dropped, and shows how far that has come.

use crate::theme;
use crate::widget::{fitted, number_field, work_bar};
use cloudwright_core::property::Number;
use egui::{Context, Grid, Id, Modal, Ui};

/// The largest mean FLIP of any view.
/// Before another one is chosen: hard to see.
pub(crate) const USUAL_TOLERANCE: f64 = 0.01;
const TOLERANCE: Number = Number {
    label: "Tolerance",
    unit: "",
    min: 0.0005,
    max: 0.2,
    doc: "By how much a view may differ from what it is now: the mean FLIP, of which 0.01 is hard to see and 0.05 plain.",
};

/// What is answered.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum ThinAnswer {
    Begin,
    /// The work; it may be asked again.
    Stop,
    Close,
}

/// Asks. `done` is how far the work has come, 0 to 1, if it goes on; `refusal` why it came to nothing.
pub(crate) fn ask_thinning(
    context: &Context,
    tolerance: &mut f64,
    done: Option<f32>,
    refusal: Option<&str>,
) -> Option<ThinAnswer> {
    let modal = Modal::new(Id::unique("thin out")).frame(theme::dialog(context));
    let modal = modal.show(context, |ui| {
        fitted(ui, theme::DIALOG_WIDTH, |ui| {
        ui.heading("Thin out");
        ui.label(
            "Drops the sprites that show least, as long as no view differs by more than the tolerance: neither from the \
             cameras, nor along the paths, nor in eight views around each cloud (around 150 of them, if there are more), by the light of this hour.",
        );
        ui.add_space(theme::GAP);
        ui.add_enabled_ui(done.is_none(), |ui| {
            Grid::new("thin out").num_columns(2).min_col_width(theme::NAME_WIDTH).show(ui, |ui| {
                ui.label(TOLERANCE.label);
                number_field(ui, TOLERANCE.label, &TOLERANCE, tolerance, false);
                ui.end_row();
            });
        });
        if let Some(refusal) = refusal {
            ui.colored_label(ui.visuals().warn_fg_color, format!("Nothing was dropped: {refusal}."));
        }
        ui.add_space(theme::GAP);
        buttons(ui, done)
        })
    });
    let escaped = context.input(|input| input.key_pressed(egui::Key::Escape));
    modal.inner.or(escaped.then_some(if done.is_some() { ThinAnswer::Stop } else { ThinAnswer::Close }))
}

fn buttons(ui: &mut Ui, done: Option<f32>) -> Option<ThinAnswer> {
    ui.horizontal(|ui| match done {
        Some(share) => {
            let stop = ui.button("Stop").clicked().then_some(ThinAnswer::Stop);
            work_bar(ui, "Progress of thinning", share);
            stop
        }
        None => {
            let begin = ui.button("Thin out").clicked().then_some(ThinAnswer::Begin);
            begin.or(ui.button("Cancel").clicked().then_some(ThinAnswer::Close))
        }
    })
    .inner
}
