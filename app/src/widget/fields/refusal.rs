//! What a field says when it does not take a value: beneath it, for a few seconds, also to screen readers.

use crate::theme;
use egui::accesskit::{Live, Role};
use egui::{Id, Response, RichText, Tooltip, Ui};
use std::time::Duration;

/// How long it is shown, seconds.
const SHOWN_S: f64 = 5.0;

#[derive(Clone)]
struct Refusal {
    text: String,
    until_s: f64,
}

fn key(field: &Response) -> Id {
    field.id.with("refusal")
}

/// From now on `field` says `text`.
pub(super) fn tell(ui: &Ui, field: &Response, text: String) {
    let until_s = ui.input(|input| input.time) + SHOWN_S;
    ui.data_mut(|data| data.insert_temp(key(field), Refusal { text, until_s }));
}

/// Both: says why `refused`, if that is so, and shows it until the field `took_another` value.
pub(crate) fn tell_and_show(ui: &Ui, field: &Response, refused: Option<String>, took_another: bool) {
    if let Some(why) = refused {
        tell(ui, field, why);
    }
    show(ui, field, took_another);
}

/// Shows what the field says, until it takes another value; whether there is something.
pub(super) fn show(ui: &Ui, field: &Response, took_another: bool) -> bool {
    let Some(refusal) = ui.data(|data| data.get_temp::<Refusal>(key(field))) else { return false };
    let left_s = refusal.until_s - ui.input(|input| input.time);
    if left_s <= 0.0 || took_another {
        ui.data_mut(|data| data.remove::<Refusal>(key(field)));
        return false;
    }
    ui.ctx().request_repaint_after(Duration::from_secs_f64(left_s));
    Tooltip::always_open(ui.ctx().clone(), field.layer_id, field.id, field).show(|ui| {
        let label = ui.label(RichText::new(&refusal.text).color(theme::error(ui)));
        ui.ctx().accesskit_node_builder(label.id, |node| {
            node.set_role(Role::Alert);
            node.set_live(Live::Assertive);
            node.set_label(refusal.text.as_str());
        });
    });
    true
}
