//! What tests, benches and asset makers share. Ships nothing.

pub mod atlas;
pub mod authoring;
pub mod boards;
pub mod flip_pairs;
pub mod gpu;
pub mod laid_out;
pub mod part_edits;
pub mod small_scenes;
pub mod suite;

use std::path::PathBuf;

/// The project's root.
pub fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// A shipped scene's file.
pub fn scene_path(name: &str) -> PathBuf {
    root().join("assets/scenes").join(name).with_extension("cloudscene")
}

/// README with the command table's shortcuts between its marks; none if it has no marks.
pub fn with_shortcuts(readme: &str) -> Result<String, String> {
    use cloudwright::command::manual::{MARKS, shortcuts};
    let [begin, end] = MARKS;
    let no_mark = || format!("README.md has no line {begin}, or none {end}");
    let (before, rest) = readme.split_once(begin).ok_or_else(no_mark)?;
    let (_, after) = rest.split_once(end).ok_or_else(no_mark)?;
    Ok(format!("{before}{begin}\n\n{}\n{end}{after}", shortcuts()))
}
