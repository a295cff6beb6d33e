//! What of weather reports can't be read, for fields that reports are put into.

use crate::reports::Line;
use crate::theme::{self, icon};
use crate::visible;
use egui::{Label, RichText, Ui};

/// The group of each report that can't be read.
pub(super) fn refusals(ui: &mut Ui, lines: Result<&[Line], &str>) {
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
