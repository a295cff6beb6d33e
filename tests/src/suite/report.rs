//! The table as Markdown: a row for each situation, a column for each method.

use super::table::{Must, Row};
use super::{Bound, Figure};
use cloudwright_core::method::Method;

/// The table, what its marks and figures mean, how each situation is made, and why its bound holds.
pub fn report(rows: &[Row]) -> String {
    let methods: Vec<&Method> =
        rows.first().map_or(Vec::new(), |row| row.cells.iter().map(|cell| cell.method).collect());
    let names: Vec<&str> = methods.iter().map(|method| method.name).collect();
    let mut out =
        "# Where methods fail\n\nMethods in situations that are hard for one of them, each by the figure that shows \
                   it.\n\n"
            .to_owned();
    out += &format!("| situation | figure | at most | {} |\n", names.join(" | "));
    out += &format!("|{}\n", "---|".repeat(3 + methods.len()));
    for row in rows {
        let Bound { figure, at_most, .. } = row.situation.bound;
        let cells: Vec<String> = methods.iter().map(|method| cell(row, method)).collect();
        out +=
            &format!("| {} | {} | {} | {} |\n", row.situation.name, figure.name(), number(at_most), cells.join(" | "));
    }
    out += "\n✓ keeps the bound, as the shipped method must; ✗ breaks it, as it must; ‼ is not as it must be. Without a \
            mark: reported, not judged. – has no such figure.\n\n";
    for figure in Figure::ALL {
        out += &format!("- **{}**: {}\n", figure.name(), figure.about());
    }
    out.push('\n');
    for row in rows {
        let situation = row.situation;
        out += &format!(
            "- **{}**: {} At most {}: {}\n",
            situation.name,
            situation.about,
            number(situation.bound.at_most),
            situation.bound.because
        );
    }
    out
}

fn cell(row: &Row, method: &Method) -> String {
    let Some(cell) = row.cells.iter().find(|cell| cell.method.name == method.name) else { return "–".into() };
    let mark = match (cell.must, cell.keeps) {
        (Some(Must::Keep), true) => " ✓",
        (Some(Must::Break), false) => " ✗",
        (Some(_), _) => " ‼",
        (None, _) => "",
    };
    format!("{}{mark}", cell.figure.map_or_else(|| "–".into(), number))
}

/// To two digits.
fn number(x: f64) -> String {
    match x.abs() {
        0.0 => "0".into(),
        1000.0.. => format!("{x:.0}"),
        10.0.. => format!("{x:.1}"),
        0.095.. => format!("{x:.2}"),
        0.000_95.. => format!("{x:.4}"),
        _ => format!("{x:.1e}"),
    }
}
