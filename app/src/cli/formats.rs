//! `cloudwright formats`: as what a scene leaves, from what it comes, and what each carries.

use super::failure::Failure;
use super::{answer, info};
use cloudwright_core::exchange::{FORMATS, Format, OptionRow, Part};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright formats
  cloudwright formats --json

A file's ending chooses its format, or else --format NAME does, for `export` and `import` alike. Options are set by
--set NAME=VALUE.")]
pub(super) struct Arguments {
    /// Answer as JSON
    #[arg(long)]
    json: bool,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct Row {
    name: &'static str,
    title: &'static str,
    endings: &'static [&'static str],
    about: &'static str,
    written: bool,
    read: bool,
    carries: &'static [Part],
    #[serde(skip_serializing_if = "Vec::is_empty")]
    write_options: Vec<RowOption>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    read_options: Vec<RowOption>,
}

#[derive(Serialize, JsonSchema)]
struct RowOption {
    name: &'static str,
    about: &'static str,
    wanted: String,
    usual: String,
}

impl Row {
    fn of(format: &'static Format) -> Self {
        Self {
            name: format.name,
            title: format.title,
            endings: format.endings,
            about: format.about,
            written: format.is_written(),
            read: format.is_read(),
            carries: format.carries,
            write_options: options(format.write_options),
            read_options: options(format.read_options),
        }
    }
}

fn options(rows: &[OptionRow]) -> Vec<RowOption> {
    let option = |row: &OptionRow| RowOption {
        name: row.name,
        about: row.doc,
        wanted: row.kind.wanted(),
        usual: row.kind.usual(),
    };
    rows.iter().map(option).collect()
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let rows: Vec<Row> = FORMATS.iter().map(Row::of).collect();
    answer(&if arguments.json { info::json_text(&rows)? } else { as_text(&rows) })
}

fn as_text(rows: &[Row]) -> String {
    let mut text = String::new();
    for row in rows {
        let endings: Vec<String> = row.endings.iter().map(|ending| format!(".{ending}")).collect();
        let ways = match (row.written, row.read) {
            (true, true) => "out and in",
            (true, false) => "out",
            _ => "in",
        };
        let carries: Vec<&str> = row.carries.iter().map(|part| part.name()).collect();
        let _ = writeln!(text, "{:<18}{:<11}{} ({})", row.name, ways, row.title, endings.join(", "));
        let _ = writeln!(text, "{:<18}{}\n{:<18}carries {}", "", row.about, "", carries.join(", "));
        for (way, options) in [("out", &row.write_options), ("in", &row.read_options)] {
            for RowOption { name, about, wanted, usual } in options {
                let _ = writeln!(text, "{:<18}{way}, --set {name}: {about} {wanted}; {usual} if not given", "");
            }
        }
    }
    text
}
