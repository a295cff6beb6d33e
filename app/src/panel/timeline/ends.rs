//! What the chosen tracks do before their first key and after their last, from the table of properties.

use crate::state::{Action, Reading};
use crate::theme;
use crate::widget::name_it;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::property::{Choice, Described, Kind, Row, Value};
use cloudwright_core::scene::Track;
use egui::{Button, Ui};

/// A menu, where a track is chosen.
pub(super) fn show(ui: &mut Ui, reading: &Reading<'_>, actions: &mut Vec<Action>) {
    let chosen = &reading.view.timeline.tracks;
    let tracks: Vec<&Track> =
        reading.session.scene().tracks.iter().filter(|track| chosen.contains(&track.id)).collect();
    let Some(first) = tracks.first() else { return };
    let after = Track::rows().filter_map(|row| Some((row, choices(row)?))).last();
    let text = after.and_then(|(row, choices)| chosen_of(row, choices, first)).map_or("ends", |choice| choice.label);
    let menu = ui.menu_button(text, |ui| {
        for (row, choices) in Track::rows().filter_map(|row| Some((row, choices(row)?))) {
            let label = row.property.label;
            ui.weak(format!("{label} the keys it")).on_hover_text(row.property.doc);
            for choice in choices {
                let is_it = chosen_of(row, choices, first) == Some(choice);
                let button = ui.add(Button::selectable(is_it, choice.label));
                name_it(ui, &button, &format!("{label}: {}", choice.label));
                if button.clicked() {
                    let value = Value::Text(choice.name.into());
                    let edits = tracks.iter().filter_map(|track| with(track, row, &value)).collect();
                    actions.push(Action::Change { name: "Ends of track", edits, live: false });
                }
            }
            ui.add_space(theme::GAP * 0.5);
        }
    });
    name_it(ui, &menu.response, "Before and after the keys");
    menu.response
        .on_hover_text("Whether the chosen tracks hold, repeat or swing before their first key and after their last.");
}

fn choices(row: &'static Row<Track>) -> Option<&'static [Choice]> {
    if let Kind::Choice(choices) = row.property.kind { Some(choices) } else { None }
}

fn chosen_of(row: &Row<Track>, choices: &'static [Choice], track: &Track) -> Option<&'static Choice> {
    let value = row.value(track, 0)?;
    choices.iter().find(|choice| value == Value::Text(choice.name.into()))
}

fn with(track: &Track, row: &Row<Track>, value: &Value) -> Option<Edit> {
    let mut track = track.clone();
    row.set(&mut track, 0, value).ok()?;
    Some(Edit::Track(ListEdit::Replace(track)))
}
