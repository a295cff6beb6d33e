//! Asks what of which models' light is to be fitted, and shows how near that has come.

use super::exchange::{ExchangeAnswer, Stage, ask};
use crate::theme;
use cloudwright_core::fit_light::Free;
use egui::Context;

/// What is chosen, until the window is closed.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FitLightChosen {
    pub(crate) free: Free,
    pub(crate) only_selected: bool,
    /// Only the sun of the scene's hour counts.
    pub(crate) only_hour: bool,
}

impl Default for FitLightChosen {
    fn default() -> Self {
        Self { free: Free::ALL, only_selected: true, only_hour: false }
    }
}

/// Asks. `selected` is how many models are.
pub(crate) fn ask_fit_light(
    context: &Context,
    stage: Stage<'_>,
    selected: usize,
    chosen: &mut FitLightChosen,
) -> Option<ExchangeAnswer> {
    let can_go = !chosen.free.is_none();
    ask(context, ("Fit light", "Fit"), stage, can_go, |ui| {
        ui.label(
            "Brings the light on the clouds as near as it gets to a path tracer's, which looks at one cloud of each model \
             from all around. Hues, heights and opacities of the colour levels stay, and so does the halo.",
        );
        ui.add_space(theme::GAP);
        let Free { levels, shares, self_shadow } = &mut chosen.free;
        ui.checkbox(levels, "Brightness of the colour levels");
        ui.checkbox(shares, "Shares of the directional light")
            .on_hover_text("Towards the sun, across and away from it, of each box and shading group.");
        ui.checkbox(self_shadow, "Self-shadow");
        ui.add_space(theme::GAP);
        ui.horizontal(|ui| {
            ui.radio_value(&mut chosen.only_hour, false, "By the day's suns")
                .on_hover_text("Of the scene's hour, and of 8, 12, 16 and 20 o'clock, as far as the sun is up.");
            ui.radio_value(&mut chosen.only_hour, true, "By the sun of the scene's hour");
        });
        if selected > 0 {
            ui.checkbox(&mut chosen.only_selected, "Only the selected models");
        }
    })
}
