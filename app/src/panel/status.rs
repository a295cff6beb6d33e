//! The line at the bottom: which renderer draws what, and what it costs.

use super::progress::progress;
use crate::command::Command;
use crate::state::{Action, Reading};
use crate::theme;
use cloudwright_core::math::clock;
use egui::{Align, Layout, Ui};
use std::time::Duration;

/// The viewport's last picture.
pub(crate) struct Drawn {
    /// What drew it, for people.
    pub(crate) renderer: String,
    /// How long it took; none until the first is there.
    pub(crate) time: Option<Duration>,
    /// Sprites blended on a pixel, in the mean, if that is known.
    pub(crate) overdraw: Option<f32>,
}

/// The status bar.
pub(crate) fn status(ui: &mut Ui, reading: &Reading<'_>, drawn: &Drawn, is_saving: bool, actions: &mut Vec<Action>) {
    let clouds = reading.session.derived().clouds();
    let kept: usize = clouds.iter().map(|cloud| cloud.sprites.len()).sum();
    let tried: usize = clouds.iter().map(|cloud| cloud.candidate_count).sum();
    ui.horizontal(|ui| {
        ui.label(&drawn.renderer);
        ui.label(drawn.time.map_or_else(|| "…".into(), |time| format!("{:.0} ms", time.as_secs_f64() * 1e3)))
            .on_hover_text("What the last picture took.");
        ui.separator();
        ui.label(format!("{} cloud{}", clouds.len(), if clouds.len() == 1 { "" } else { "s" }));
        ui.label(format!("{kept} / {tried} sprites")).on_hover_text("Kept, and tried before culling.");
        ui.separator();
        hour(ui, reading);
        if let Some(overdraw) = drawn.overdraw {
            ui.separator();
            ui.label(format!("overdraw {overdraw:.1}")).on_hover_text("Sprites blended on a pixel, in the mean.");
        }
        ui.with_layout(Layout::right_to_left(Align::Center), |ui| {
            progress(ui, reading.session, actions);
            if is_saving {
                ui.label("Saving…");
            }
        });
    });
}

/// The hour that is shown, marked if it is not the scene's.
fn hour(ui: &mut Ui, reading: &Reading<'_>) {
    let shown = clock(reading.time_h());
    if reading.time_play.time_h().is_none() {
        ui.label(shown);
        return;
    }
    let scene_hour = clock(reading.session.scene().time_of_day_h);
    let hint =
        format!("The scene's hour is {scene_hour}. “{}” makes this one the scene's.", Command::KeepHour.row().label());
    ui.colored_label(theme::warning(ui), format!("{shown} preview")).on_hover_text(hint);
}
