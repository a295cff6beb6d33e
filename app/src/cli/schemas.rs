//! JSON Schemas of all that the command line writes as JSON, but for the scene, whose schema is core's.

use super::{check, exchange, formats, info, weather};
use crate::chart::report;
use cloudwright_core::formats::schema::text_of;
use cloudwright_core::formats::sprites_json;

/// Each by the name of its file in `assets/schemas/`: what of the program answers so, and the schema's text.
///
/// # Errors
/// None in practice: every schema can be said in JSON.
pub fn all() -> Result<Vec<(&'static str, String)>, serde_json::Error> {
    Ok(vec![
        // `export -o FILE.json`
        ("sprites", sprites_json::json_schema()?),
        // `chart`: chart.json, and with --json
        ("chart", report::json_schema()?),
        // `info --json`
        ("info", text_of::<info::SceneCounts>()?),
        // `check --json`
        ("check", text_of::<Vec<check::ProblemOut<'static>>>()?),
        // `export --json` and `import --json`
        ("exchange", text_of::<exchange::Answer<'static>>()?),
        // `formats --json`
        ("formats", text_of::<Vec<formats::Row>>()?),
        // `weather --json`
        ("weather", text_of::<weather::Answer<'static>>()?),
    ])
}
