//! What stands still in a chart: grid, scales, rails, titles, legend, tolerance.

use super::shape::shape;
use super::{Sheet, text_width};
use crate::chart::labels::Rect;
use crate::chart::{Family, text};
use std::fmt::Write;

/// All but the marks.
pub(super) fn draw(sheet: &Sheet<'_>, out: &mut String) {
    grid(sheet, out);
    titles(sheet, out);
    legend(sheet, out);
    tolerance(sheet, out);
}

fn line(out: &mut String, class: &str, [x1, y1]: [f64; 2], [x2, y2]: [f64; 2]) {
    let _ = writeln!(out, r#"<line class="{class}" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#);
}

/// `anchor`: start, middle or end.
pub(super) fn words(out: &mut String, class: &str, [x, y]: [f64; 2], (size, anchor): (f64, &str), words: &str) {
    let words = text::escape(words);
    let _ = writeln!(
        out,
        r#"<text class="{class}" x="{x:.1}" y="{y:.1}" font-size="{size}" text-anchor="{anchor}">{words}</text>"#
    );
}

fn grid(sheet: &Sheet<'_>, out: &mut String) {
    let Sheet { text, field, cost, error, .. } = sheet;
    let (right, lower, small) = (field.x + field.width, field.y + field.height, text * 0.92);
    for tick in cost.ticks(text * 3.4) {
        line(out, "grid", [tick.at_px, field.y], [tick.at_px, lower]);
        words(out, "soft", [tick.at_px, lower + text * 1.4], (small, "middle"), &tick.label);
    }
    for tick in error.ticks(text * 1.6) {
        line(out, "grid", [field.x, tick.at_px], [right, tick.at_px]);
        words(out, "soft", [field.x - text * 0.5, tick.at_px + text * 0.32], (small, "end"), &tick.label);
    }
    // The scales themselves end where a rail begins.
    line(out, "axis", [cost.low_px(), lower], [right, lower]);
    line(out, "axis", [field.x, field.y], [field.x, error.low_px()]);
    if let Some(rail) = cost.rail() {
        cut(out, text * 0.35, [(rail.at_px + cost.low_px()) / 2.0, lower]);
        line(out, "rail", [rail.at_px, field.y], [rail.at_px, lower]);
        words(out, "soft", [rail.at_px, lower + text * 1.4], (small, "middle"), &rail.label);
    }
    if let Some(rail) = error.rail() {
        cut(out, text * 0.35, [field.x, (rail.at_px + error.low_px()) / 2.0]);
        line(out, "rail", [field.x, rail.at_px], [right, rail.at_px]);
        words(out, "soft", [field.x - text * 0.5, rail.at_px + text * 0.32], (small, "end"), &rail.label);
    }
}

/// Two strokes that say: the scale does not go on to here.
fn cut(out: &mut String, size: f64, [x, y]: [f64; 2]) {
    for aside in [-0.5, 0.5] {
        let (x, y) = (x + aside * size, y + aside * size);
        line(out, "axis", [x - size, y + size], [x + size, y - size]);
    }
}

fn titles(sheet: &Sheet<'_>, out: &mut String) {
    let Sheet { plot, text, field, size, .. } = sheet;
    let cost = format!("{} · ← quicker", plot.cost_title);
    words(out, "", [field.x + field.width, size[1] - text * 0.7], (*text, "end"), &cost);
    let error = format!("{} · ↓ {}", plot.error_title, plot.less_error);
    words(out, "", [text * 0.4, field.y - text], (*text, "start"), &error);
}

/// A row above the chart, of the families that are in it, and of the line.
fn legend(sheet: &Sheet<'_>, out: &mut String) {
    let Sheet { plot, text, .. } = sheet;
    let small = text * 0.92;
    let mut x = text * 0.4;
    let y = text * 1.5;
    for family in Family::ALL.into_iter().filter(|family| plot.marks.iter().any(|mark| mark.family == *family)) {
        let name = family.name();
        shape(out, family, [x + text * 0.5, y - text * 0.35], text * 0.4);
        words(out, "soft", [x + text * 1.6, y], (small, "start"), name);
        x += text * 2.6 + text_width(name, small);
    }
    // At the end of the next row, where it does not make this one longer than a telephone is wide.
    let (right, y) = (sheet.field.x + sheet.field.width, sheet.field.y - text);
    words(out, "soft", [right, y], (small, "end"), "front");
    let end = right - text_width("front", small) - text * 0.4;
    line(out, "front", [end - text * 1.6, y - text * 0.35], [end, y - text * 0.35]);
}

/// Where the tolerance's name stands, if the tolerance is drawn.
pub(super) fn tolerance_name(sheet: &Sheet<'_>) -> Option<(Rect, String)> {
    let Sheet { text, field, error, .. } = sheet;
    let tolerance = sheet.plot.tolerance.filter(|tolerance| error.shows(*tolerance))?;
    let name = format!("tolerance {}", text::round_number(tolerance));
    let width = text_width(&name, text * 0.92);
    let y = error.at(tolerance) - text * 1.4;
    Some((Rect { x: field.x + field.width - width - text * 0.4, y, width, height: text * 1.4 }, name))
}

fn tolerance(sheet: &Sheet<'_>, out: &mut String) {
    let Some((rect, name)) = tolerance_name(sheet) else { return };
    let Sheet { text, field, .. } = sheet;
    let y = rect.y + rect.height;
    line(out, "tolerance", [field.x, y], [field.x + field.width, y]);
    words(out, "soft halo", [rect.x + rect.width, y - text * 0.4], (text * 0.92, "end"), &name);
}
