//! The hour, keyed: its diamond, and what becomes of a change.

use crate::state::{Action, Reading, TimelineChange};
use crate::widget::key_button;
use cloudwright_core::arrange::keys;
use cloudwright_core::document::Edit;
use cloudwright_core::property::{TIME_OF_DAY_H, Target};
use cloudwright_core::scene::KeyValue;
use egui::Ui;

/// The hour's diamond.
pub(super) fn key(ui: &mut Ui, hour: f64, reading: &Reading<'_>) -> Option<Action> {
    let target: Target = "time_of_day_h".parse().ok()?;
    key_button(ui, TIME_OF_DAY_H.label, &vec![(target, KeyValue::One(hour))], reading)
}

/// Another hour for the scene; where it is keyed and *Auto-key* is on, a key of it.
pub(super) fn set(hour: f64, live: bool, reading: &Reading<'_>) -> Vec<Action> {
    let change = Action::change("Time of day", Edit::TimeOfDay(hour), live);
    let target = "time_of_day_h".parse::<Target>().ok().filter(|target| reading.has_track(target));
    match target {
        Some(target) if reading.view.timeline.auto_key => {
            let values = [(target, KeyValue::One(hour))];
            let rekeyed = keys::keyed(reading.session.scene(), &values, reading.clock.time_s());
            vec![Action::Keys { name: "Key time of day".into(), rekeyed, live, choose: false }]
        }
        Some(target) => vec![Action::Timeline(TimelineChange::Unkeyed(vec![target])), change],
        None => vec![change],
    }
}
