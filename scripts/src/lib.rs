//! Rhai scripts: plugins that place boxes and timelines that move the weather. To come.
//!
//! A script will run once and record edits; sprites and pixels are never computed in it. It knows the core and nothing
//! of the renderers.
