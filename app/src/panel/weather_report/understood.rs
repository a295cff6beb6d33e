//! What was understood of reports: each one's groups; and first the group of each that could not be read.

use crate::reports::{Line, words};
use crate::theme::{self, icon};
use crate::units::Units;
use crate::visible;
use egui::{Label, RichText, ScrollArea, Ui};

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

/// The group of each report that can't be read.
pub(in crate::panel) fn refusals(ui: &mut Ui, lines: Result<&[Line], &str>) {
    let lines = match lines {
        Ok(lines) => lines,
        Err(why) => return refusal(ui, why),
    };
    let refused = lines.iter().filter_map(|line| Some((line.number, line.read.as_ref().err()?)));
    let count = refused.clone().count();
    for (number, refused) in refused.take(FEW) {
        let place = if lines.len() > 1 { format!("report in line {number}, ") } else { String::new() };
        refusal(ui, &format!("{place}{refused}"));
    }
    if count > FEW {
        refusal(ui, &format!("and {} more that can't be read", count - FEW));
    }
}

/// So many faults are told at once.
const FEW: usize = 4;

fn refusal(ui: &mut Ui, why: &str) {
    ui.horizontal_top(|ui| {
        ui.colored_label(theme::error(ui), icon::WARNING_CIRCLE);
        ui.add(Label::new(RichText::new(visible::one_line(why)).color(theme::error(ui))).wrap());
    });
}
