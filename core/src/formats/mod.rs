//! Bytes to values and back, one file a format. No files here: `app` reads and writes them.

pub mod metar;
pub mod model_glb;
pub mod pretty_json;
pub mod scene_file;
pub mod scene_glb;
pub mod sprites_csv;
pub mod sprites_json;
