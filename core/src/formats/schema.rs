//! JSON Schemas of what is written as JSON: made of the very types that are written.

use super::pretty_json;
use schemars::JsonSchema;
use schemars::generate::SchemaSettings;

/// The schema of a type as it is written, as text.
///
/// # Errors
/// None in practice: every schema can be said in JSON.
pub fn text_of<T: JsonSchema>() -> Result<String, serde_json::Error> {
    let schema = SchemaSettings::draft2020_12().for_serialize().into_generator().into_root_schema_for::<T>();
    Ok(pretty_json::write(&serde_json::to_value(schema)?))
}
