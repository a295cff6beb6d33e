//! Time of day, sun, air and exposure.

use super::Reading;
use super::fields::{Fields, fields};
use crate::editor::Action;
use cloudwright_core::document::Edit;
use cloudwright_core::math::clock;
use cloudwright_core::parameter as p;
use cloudwright_core::scene::Sun;
use egui::{ScrollArea, Slider, Ui};
use std::slice::from_ref;

/// Of the slider, hours: two minutes are as fine as a hand can be.
const TIME_STEP_H: f64 = 1.0 / 30.0;

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| rows(ui, reading, actions));
}

fn rows(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    let time = |rows: &mut Fields<'_>, hour: &mut f64| {
        let name = p::TIME_OF_DAY_H.label;
        rows.row(name, p::TIME_OF_DAY_H.doc, |values| values.value(name, hour, time_slider));
    };
    fields(ui, "Time of day", actions, from_ref(&scene.time_of_day_h), time, Edit::TimeOfDay);
    fields(ui, "Sun", actions, from_ref(&scene.sun), sun, Edit::Sun);
    if scene.sun == Sun::ByPlace {
        fields(
            ui,
            "Place",
            actions,
            from_ref(&scene.place),
            |rows, place| {
                rows.number(&p::LATITUDE_DEG, &mut place.latitude_deg);
                rows.number(&p::LONGITUDE_DEG, &mut place.longitude_deg);
                rows.number(&p::UTC_OFFSET_H, &mut place.utc_offset_h);
                let mut date = place.date.to_string();
                rows.text("Date", &mut date);
                // What is no day is not taken over; the field shows the old one again.
                place.date = date.parse().unwrap_or(place.date);
            },
            Edit::Place,
        );
    }
    fields(
        ui,
        "Sky",
        actions,
        from_ref(&scene.sky),
        |rows, sky| {
            rows.number(&p::EXPOSURE_EV, &mut sky.exposure_ev);
            rows.number(&p::TURBIDITY, &mut sky.turbidity);
            rows.number(&p::SKY_GAIN, &mut sky.gain);
            rows.number(&p::HAZE_LENGTH_M, &mut sky.haze_length_m);
        },
        Edit::Sky,
    );
}

/// A slider over the day.
fn time_slider(ui: &mut Ui, hour: &mut f64) -> bool {
    let parameter = &p::TIME_OF_DAY_H;
    let slider = Slider::new(hour, parameter.min..=parameter.max)
        .step_by(TIME_STEP_H)
        .custom_formatter(|hour, _| clock(hour))
        .custom_parser(|text| crate::cli::time_of_day(text).ok());
    let response = ui.add(slider);
    ui.ctx().accesskit_node_builder(response.id, |node| node.set_label(parameter.label));
    let changed = response.changed();
    response.on_hover_text(parameter.doc);
    changed && parameter.allows(*hour)
}

fn sun(rows: &mut Fields<'_>, sun: &mut Sun) {
    let mut by_hand = *sun != Sun::ByPlace;
    rows.check("Sun by hand", "Where the sun stands, whatever place and time say.", &mut by_hand);
    *sun = match (by_hand, *sun) {
        (false, _) => Sun::ByPlace,
        (true, Sun::ByPlace) => Sun::ByHand { heading_deg: 180.0, elevation_deg: p::ELEVATION_DEG.default },
        (true, by_hand) => by_hand,
    };
    if let Sun::ByHand { heading_deg, elevation_deg } = sun {
        rows.labelled("Sun heading", &p::HEADING_DEG, heading_deg);
        rows.labelled("Sun elevation", &p::ELEVATION_DEG, elevation_deg);
    }
}
