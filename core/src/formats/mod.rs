//! Bytes to values and back, one file a format. No files here: `app` reads and writes them.

pub mod base64;
pub mod cld;
pub mod cry_cloud;
pub mod flightgear;
pub mod flightgear_voxels;
pub mod metar;
mod misread;
pub mod mitsuba_vol;
pub mod model_glb;
pub mod picture_exr;
pub mod pretty_json;
pub mod scene_clip;
pub mod scene_file;
pub mod schema;
pub mod sprites_csv;
pub mod sprites_json;
pub mod stored_zip;
pub mod usda;
pub mod vdb;
pub mod wpr;
pub mod xml;

pub use misread::Misread;
