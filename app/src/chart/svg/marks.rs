//! The front, the marks and their names.

use super::frame;
use super::shape::shape;
use super::{Mark, Sheet, text_width};
use crate::chart::labels::{self, PlacedLabel, Rect, Wanted};
use crate::chart::{Family, class, text};
use std::fmt::Write;

/// Of a mark, in units of the text's size.
const RADIUS: f64 = 0.42;

/// Draws them, the names over all else.
pub(super) fn draw(sheet: &Sheet<'_>, out: &mut String) {
    let front = sheet.front();
    draw_front(sheet, &front, out);
    // Names find their places in the order of importance; what is drawn last lies on top.
    let mut marks: Vec<&Mark<'_>> = sheet.plot.marks.iter().collect();
    marks.sort_by_key(|mark| match mark.family {
        Family::Shipped => 0,
        Family::Truth => 1,
        Family::Failing => 2,
        Family::Other => 3,
    });
    let placed = place_names(sheet, &marks, &front);
    for (mark, PlacedLabel { leader, .. }) in marks.iter().zip(&placed) {
        let ([x1, y1], Some([x2, y2])) = (sheet.at(mark.at), *leader) else { continue };
        let _ = writeln!(out, r#"<line class="leader" x1="{x1:.1}" y1="{y1:.1}" x2="{x2:.1}" y2="{y2:.1}"/>"#);
    }
    for (mark, placed) in marks.iter().zip(&placed).rev() {
        draw_mark(sheet, mark, placed, out);
    }
}

fn draw_front(sheet: &Sheet<'_>, corners: &[[f64; 2]], out: &mut String) {
    let Rect { x, y, width, .. } = sheet.field;
    let path = corners.iter().map(|[x, y]| format!("{x:.1} {y:.1}")).collect::<Vec<_>>().join(" L ");
    if path.is_empty() {
        return;
    }
    let _ = writeln!(out, r#"<path class="fill" d="M {path} L {:.1} {y:.1} Z"/>"#, x + width);
    let _ = writeln!(out, r#"<path class="front" d="M {path}"/>"#);
}

fn place_names(sheet: &Sheet<'_>, marks: &[&Mark<'_>], front: &[[f64; 2]]) -> Vec<PlacedLabel> {
    let size = sheet.text;
    let wanted: Vec<Wanted> = marks
        .iter()
        .map(|mark| {
            let radius = size * if mark.family == Family::Shipped { 0.75 } else { RADIUS };
            Wanted { at: sheet.at(mark.at), radius, size: [text_width(mark.name, size), size * 1.25] }
        })
        .collect();
    let mut lines: Vec<_> = front.windows(2).map(|pair| [pair[0], pair[1]]).collect();
    let mut taken = Vec::new();
    if let Some((name, _)) = frame::tolerance_name(sheet) {
        let (Rect { x, width, .. }, y) = (sheet.field, name.y + name.height);
        lines.push([[x, y], [x + width, y]]);
        taken.push(name);
    }
    labels::place(&wanted, sheet.field, &taken, &lines)
}

fn draw_mark(sheet: &Sheet<'_>, mark: &Mark<'_>, placed: &PlacedLabel, out: &mut String) {
    let linked = !mark.link.is_empty();
    if linked {
        let _ = writeln!(out, r#"<a href="{}">"#, text::escape(&mark.link));
    }
    let [cost, error] = mark.at.map(|x| text::figure(Some(x)));
    let _ = writeln!(
        out,
        "<g><title>{}: {}, {cost}; {}, {error}</title>",
        text::escape(mark.name),
        text::escape(sheet.plot.cost_title),
        text::escape(sheet.plot.error_title)
    );
    shape(out, mark.family, sheet.at(mark.at), sheet.text * RADIUS);
    let class = format!("halo {}", class(mark.family));
    // The estimated width is the widest; text grows away from its mark, so that the gap is kept.
    let (rect, x) = (placed.rect, sheet.at(mark.at)[0]);
    let (at, anchor) = if rect.x > x {
        (rect.x, "start")
    } else if rect.x + rect.width < x {
        (rect.x + rect.width, "end")
    } else {
        (rect.x + rect.width / 2.0, "middle")
    };
    frame::words(out, &class, [at, rect.y + sheet.text * 0.97], (sheet.text, anchor), mark.name);
    out.push_str("</g>\n");
    if linked {
        out.push_str("</a>\n");
    }
}
