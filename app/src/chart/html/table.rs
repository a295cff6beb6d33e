//! Every figure of every method, to sort by any of them.

use super::Page;
use super::card::badge;
use crate::chart::columns::{Column, filled};
use crate::chart::{class, text};
use std::fmt::Write;

/// The table; a click on a column's name sorts by it (`page.js`).
pub(super) fn write(page: &Page<'_>, out: &mut String) {
    let methods = &page.report.methods;
    if methods.is_empty() {
        return;
    }
    let columns = filled(methods);
    out.push_str(
        "<section class=\"all\">\n<h2>All figures</h2>\n\
         <div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"All figures\">\n<table>\n<thead>\n<tr><td></td>",
    );
    for group in columns.chunk_by(|a, b| a.group == b.group) {
        let _ = write!(out, r#"<th scope="colgroup" colspan="{}">{}</th>"#, group.len(), group[0].group);
    }
    out.push_str("</tr>\n<tr><th scope=\"col\"><button type=\"button\">method</button></th>");
    for (column, class) in columns.iter().zip(group_starts(&columns)) {
        let unit = if column.unit.is_empty() { String::new() } else { format!(", {}", column.unit) };
        let _ = write!(out, r#"<th scope="col"{class}><button type="button">{}{unit}</button></th>"#, column.name);
    }
    out.push_str("</tr>\n</thead>\n<tbody>\n");
    for (index, method) in methods.iter().enumerate() {
        let front = if method.on_front { r#" <span class="badge front">front</span>"# } else { "" };
        let _ = write!(
            out,
            r##"<tr class="{}"><th scope="row"><a href="#{}">{}</a>{}{front}</th>"##,
            class(page.family(method)),
            Page::card_id(index),
            text::escape(&method.name),
            badge(page.family(method))
        );
        for (column, class) in columns.iter().zip(group_starts(&columns)) {
            let value = (column.of)(method).filter(|x| x.is_finite());
            // The exact number, to sort by.
            let exact = value.map_or_else(String::new, |x| x.to_string());
            let _ = write!(out, r#"<td{class} data-value="{exact}">{}</td>"#, text::figure(value));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</tbody>\n</table>\n</div>\n</section>\n");
}

/// An attribute for the first column of each group, which has a line before it.
fn group_starts(columns: &[&Column]) -> Vec<&'static str> {
    let starts = |i: usize| i == 0 || columns[i].group != columns[i - 1].group;
    (0..columns.len()).map(|i| if starts(i) { r#" class="starts""# } else { "" }).collect()
}
