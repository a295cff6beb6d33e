//! Play, pause, and the clock's slider.

use super::button;
use crate::command::Command;
use crate::state::{Action, CLOCK_SPEED, ClockChange, Reading, ViewChange};
use crate::theme::{self, icon};
use crate::widget::{name_it, number_field};
use egui::{Slider, SliderClamping, Ui};

const DOC: &str = "Seconds since play began: by this clock clouds form, and the path is flown.";

pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let clock = reading.clock;
    let length_s = clock.length_s(reading.session.scene());
    ui.horizontal(|ui| {
        button(ui, Command::FlightStart, icon::SKIP_BACK, "To the start", false, actions);
        let (glyph, name) = if clock.plays() { (icon::PAUSE, "Pause flight") } else { (icon::PLAY, "Play flight") };
        button(ui, Command::PlayFlight, glyph, name, false, actions);
        button(ui, Command::FlightEnd, icon::SKIP_FORWARD, "To the end", false, actions);
        button(ui, Command::LoopFlight, icon::REPEAT, "Loop flight", clock.loops(), actions);
        ui.add_space(theme::GAP * 0.5);
        button(ui, Command::BoardFlight, icon::STEERING_WHEEL, "On board", clock.boards(), actions);
        let mut speed = clock.speed();
        if number_field(ui, CLOCK_SPEED.label, &CLOCK_SPEED, &mut speed, false) {
            actions.push(Action::View(ViewChange::Clock(ClockChange::Speed(speed))));
        }
    });
    ui.horizontal(|ui| {
        let mut time_s = clock.time_s();
        let value = ui.spacing().interact_size.x + 2.0 * ui.spacing().button_padding.x;
        ui.spacing_mut().slider_width = (ui.available_width() - value - 3.0 * ui.spacing().item_spacing.x).max(60.0);
        let slider = Slider::new(&mut time_s, 0.0..=length_s)
            // Else it would round a time that no hand has touched, and call that a change.
            .clamping(SliderClamping::Edits)
            .custom_formatter(|time_s, _| format!("{time_s:.1}"))
            .suffix(" s");
        let response = ui.add(slider);
        name_it(ui, &response, "Clock");
        let changed = response.changed();
        response.on_hover_text(DOC);
        if changed {
            actions.push(Action::View(ViewChange::Clock(ClockChange::Seek(time_s))));
        }
    });
}
