//! What was understood of reports: each one's groups; and first the group of each that could not be read.

use crate::panel::refusals::refusals;
use crate::reports::{Line, words};
use crate::units::Units;
use egui::{Label, ScrollArea, Ui};

/// So many are listed: of more, nobody reads each.
const MOST: usize = 60;
/// Points.
const HEIGHT: f32 = 150.0;

/// Lists them; or tells why there are none.
pub(super) fn show(ui: &mut Ui, lines: Result<&[Line], &str>, units: Units) {
    refusals(ui, lines);
    let reports = lines.unwrap_or_default().iter().filter_map(|line| line.read.as_ref().ok()).flatten();
    let count = reports.clone().count();
    ScrollArea::vertical().id_salt("understood").max_height(HEIGHT).show(ui, |ui| {
        ui.set_width(ui.available_width());
        for report in reports.take(MOST) {
            ui.strong(words::head(report));
            ui.add(Label::new(words::groups(report, units).join(" · ")).wrap());
        }
        if count > MOST {
            ui.weak(format!("and {} more", count - MOST));
        }
    });
}
