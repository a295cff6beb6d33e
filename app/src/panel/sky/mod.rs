//! Time of day, the light over the day, the sun, the air and exposure, wind and weather.

mod dome;
mod hour;
mod keys;
mod strip;
mod sun_path;

use crate::command::Command;
use crate::state::{Action, Reading, ViewChange};
use crate::theme::{self, icon};
use crate::units::typed_hour;
use crate::widget::{Fields, name_it, number_field, refusal, section};
use cloudwright_core::color::{Rgb, Rgba};
use cloudwright_core::document::Edit;
use cloudwright_core::math::clock;
use cloudwright_core::property::{Number, Owner, TIME_OF_DAY_H};
use cloudwright_core::scene::{DailyKey, DailyTable, Sky, Sun};
use cloudwright_core::weather::on_day;
use egui::{ScrollArea, Slider, SliderClamping, Ui};
use std::cell::Cell;
use strip::Strip;
use sun_path::SunPath;

/// Of the slider, hours: two minutes are as fine as a hand can be.
const TIME_STEP_H: f64 = 1.0 / 30.0;
/// Of the hour's diamond, points.
const KEY_WIDTH: f32 = 12.0;
const TIME_SPEED: Number = Number {
    label: "Speed of time",
    unit: "h/min",
    min: 0.1,
    max: 600.0,
    doc: "Hours of the scene in a minute of yours.",
};

/// The panel.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ScrollArea::vertical().auto_shrink(false).show(ui, |ui| {
        let scene = reading.session.scene();
        let path = SunPath::of(ui.ctx(), scene.sun, &scene.site);
        time(ui, reading, actions);
        section(ui, "Light over the day", |ui| light(ui, reading, &path, actions));
        section(ui, "Sun", |ui| {
            ui.horizontal_top(|ui| {
                if let Some(sun) = dome::show(ui, scene.sun, &scene.site, reading.time_h(), &path) {
                    actions.push(Action::change("Sun", Edit::Sun(sun), ui.input(|input| input.pointer.any_down())));
                }
                ui.vertical(|ui| sun(ui, reading, actions));
            });
        });
        section(ui, "Air and exposure", |ui| air(ui, reading, actions));
        section(ui, "Weather", |ui| weather(ui, reading, actions));
    });
}

/// The hour, and time that runs.
fn time(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    // By itself: a hand is the finer, the longer the slider is.
    ui.horizontal(|ui| {
        let mut hour = reading.time_h();
        let field = ui.spacing().interact_size.x + 2.0 * ui.spacing().button_padding.x + KEY_WIDTH;
        let room = ui.available_width() - field - 2.0 * ui.spacing().item_spacing.x;
        ui.spacing_mut().slider_width = room.max(60.0);
        actions.extend(hour::key(ui, hour, reading));
        if time_slider(ui, &mut hour) {
            let live = ui.input(|input| input.pointer.any_down());
            actions.extend(hour::set(hour, live, reading));
        }
    });
    ui.horizontal(|ui| {
        let (glyph, name) = if reading.time_play.runs() { (icon::PAUSE, "Stop") } else { (icon::PLAY, "Play") };
        let button = ui.button(glyph);
        name_it(ui, &button, name);
        if button.on_hover_text(Command::PlayTime.row().tooltip(ui.ctx())).clicked() {
            actions.push(Action::Command(Command::PlayTime));
        }
        let mut speed = reading.time_play.hours_a_minute();
        if number_field(ui, TIME_SPEED.label, &TIME_SPEED, &mut speed, false) {
            actions.push(Action::View(ViewChange::TimeSpeed(speed)));
        }
    });
    if reading.time_play.time_h().is_some() {
        tried_out(ui, reading, actions);
    }
}

/// That the hour is not the scene's, and the two ways on.
fn tried_out(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    ui.horizontal_wrapped(|ui| {
        let scene_hour = clock(reading.session.scene().time_of_day_h);
        ui.colored_label(theme::warning(ui), format!("Preview: the scene's hour is {scene_hour}"));
        for command in [Command::KeepHour, Command::SceneHour] {
            let button = ui.small_button(command.row().label());
            if button.on_hover_text(command.row().tooltip(ui.ctx())).clicked() {
                actions.push(Action::Command(command));
            }
        }
    });
}

/// A slider over the day.
fn time_slider(ui: &mut Ui, hour: &mut f64) -> bool {
    let number = &TIME_OF_DAY_H;
    let refused = Cell::new(None);
    let slider = Slider::new(hour, number.min..=number.max)
        .step_by(TIME_STEP_H)
        // Else it would round an hour that no hand has touched, and call that a change.
        .clamping(SliderClamping::Edits)
        .custom_formatter(|hour, _| clock(hour))
        .update_while_editing(false)
        .custom_parser(|text| typed_hour(text).map_err(|why| refused.set(Some(why))).ok());
    let response = ui.add(slider);
    name_it(ui, &response, number.label);
    let changed = response.changed();
    refusal::tell_and_show(ui, &response, refused.take(), changed);
    response.on_hover_text(number.doc);
    changed && number.allows(*hour)
}

/// The two tables over the day.
fn light(ui: &mut Ui, reading: &Reading<'_>, path: &SunPath, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    let (sky, hour) = (&scene.sky, reading.time_h());
    // Keys by the sun stand where they do on this day.
    let shown = |filed: &DailyTable<Rgba>| on_day(filed, scene.sun, &scene.site);
    let as_filed = |filed: &DailyTable<Rgba>, changed| keys::as_filed(filed, changed, shown);
    let filed = with_alpha(&sky.directional);
    let (ambient, directional) = (shown(&sky.ambient), shown(&filed));
    let ambient = Strip {
        name: "Ambient",
        doc: "The sky's light on the clouds; its opacity scales that of all sprites.",
        has_alpha: true,
        table: &ambient,
        hour,
        path,
    };
    if let Some((ambient, live)) = ambient.show(ui) {
        let sky = Sky { ambient: as_filed(&sky.ambient, ambient), ..sky.clone() };
        actions.push(Action::change("Ambient light", Edit::Sky(sky), live));
    }
    let directional = Strip {
        name: "Directional",
        doc: "The sun's light on the clouds, or the moon's.",
        has_alpha: false,
        table: &directional,
        hour,
        path,
    };
    if let Some((table, live)) = directional.show(ui) {
        let sky = Sky { directional: without_alpha(&as_filed(&filed, table)), ..sky.clone() };
        actions.push(Action::change("Directional light", Edit::Sky(sky), live));
    }
}

fn with_alpha(table: &DailyTable<Rgb>) -> DailyTable<Rgba> {
    let keys = table.keys.iter();
    DailyTable {
        keys: keys
            .map(|key| DailyKey { hour: key.hour, sun_deg: key.sun_deg, value: Rgba { rgb: key.value, a: 1.0 } })
            .collect(),
    }
}

fn without_alpha(table: &DailyTable<Rgba>) -> DailyTable<Rgb> {
    let keys = table.keys.iter();
    DailyTable {
        keys: keys.map(|key| DailyKey { hour: key.hour, sun_deg: key.sun_deg, value: key.value.rgb }).collect(),
    }
}

fn sun(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let scene = reading.session.scene();
    Fields::of(&[&scene.sun], reading)
        .owned([Owner::Sun])
        .show(ui, "Sun", actions, Fields::all, |_, sun| Edit::Sun(sun));
    if scene.sun == Sun::ByPlace {
        Fields::of(&[&scene.site], reading).show(ui, "Place", actions, Fields::all, |_, place| Edit::Site(place));
    }
}

fn air(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let sky = &reading.session.scene().sky;
    Fields::of(&[sky], reading).owned([Owner::Sky]).show(ui, "Sky", actions, Fields::all, |_, sky| Edit::Sky(sky));
}

fn weather(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let weather = &reading.session.scene().weather;
    let edit = |_, weather| Edit::Weather(weather);
    Fields::of(&[weather], reading).owned([Owner::Weather]).show(ui, "Weather", actions, Fields::all, edit);
}
