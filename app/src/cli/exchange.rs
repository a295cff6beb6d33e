//! What `export`, `import` and `formats` say alike: how a format is chosen and set, and what was lost.

use super::arguments::did_you_mean;
use super::failure::Failure;
use super::say;
use cloudwright_core::exchange::{ChoiceError, FORMATS, Format, Note, OptionError, OptionRow, Options};
use schemars::JsonSchema;
use serde::Serialize;

/// What was written, as JSON.
#[derive(Serialize, JsonSchema)]
pub(super) struct Answer<'a> {
    pub(super) format: &'static str,
    pub(super) files: Vec<String>,
    pub(super) notes: &'a [Note],
}

/// Each note as a line on stderr.
pub(super) fn tell_notes(notes: &[Note]) {
    notes.iter().for_each(|note| say(&note.to_string()));
}

/// The formats that are written, or those that are read.
fn formats(written: bool) -> impl Iterator<Item = &'static Format> {
    FORMATS.iter().filter(move |format| if written { format.is_written() } else { format.is_read() })
}

/// Why there is no format for `file`, which is to be written or read.
pub(super) fn choice_failure(error: &ChoiceError, file: &str, written: bool) -> Failure {
    let names: Vec<&str> = formats(written).map(|format| format.name).collect();
    match error {
        ChoiceError::NoEnding => {
            // Several formats may have one.
            let mut endings: Vec<String> = Vec::new();
            for ending in formats(written).flat_map(|format| format.endings).map(|ending| format!(".{ending}")) {
                if !endings.contains(&ending) {
                    endings.push(ending);
                }
            }
            let hint = match endings.split_last() {
                Some((last, [])) => format!("end its name in {last}"),
                Some((last, others)) => format!("end its name in {} or {last}, or say --format", others.join(", ")),
                None => "there is no format".into(),
            };
            Failure::argument(format!("{file}: {error}"), hint)
        }
        ChoiceError::Unknown { name, .. } => {
            let hint = format!("{}the formats are {}", did_you_mean(name, &names), names.join(", "));
            Failure::argument(format!("--format: {error}"), hint)
        }
        ChoiceError::OneWay { .. } => {
            Failure::argument(format!("--format: {error}"), format!("the formats are {}", names.join(", ")))
        }
    }
}

/// Sets what `--set NAME=VALUE` says.
pub(super) fn set_options(options: &mut Options, set: &[String], rows: &[OptionRow]) -> Result<(), Failure> {
    let names: Vec<&str> = rows.iter().map(|row| row.name).collect();
    for set in set {
        let Some((name, value)) = set.split_once('=') else {
            return Err(Failure::argument(format!("--set {set}: there is no ="), "write it as NAME=VALUE"));
        };
        options.set(name.trim(), value).map_err(|error| {
            let hint = match &error {
                OptionError::Value { .. } => "nothing is written".into(),
                OptionError::Unknown { .. } if names.is_empty() => "this format has no options".into(),
                OptionError::Unknown { name, .. } => {
                    format!("{}the options are {}", did_you_mean(name, &names), names.join(", "))
                }
            };
            Failure::argument(format!("--set: {error}"), hint)
        })?;
    }
    Ok(())
}
