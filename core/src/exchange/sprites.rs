//! All sprites as JSON or as a table.

use super::{ExportError, Files, Leaving, Note};
use crate::formats::{sprites_csv, sprites_json};

pub(super) fn write_json(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let Leaving { now, watch, name, .. } = leaving;
    files.add(name, &mut |mut out| sprites_json::write(&mut out, &now.clouds, leaving.still(), watch))?;
    Ok(Vec::new())
}

pub(super) fn write_csv(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let Leaving { now, watch, name, .. } = leaving;
    files.add(name, &mut |mut out| sprites_csv::write(&mut out, &now.clouds, leaving.still(), watch))?;
    Ok(Vec::new())
}
