//! The window's panels, one file each. They read the scene and return actions; none changes anything itself.

mod bars;
mod camera;
mod cloud;
mod cloud_box;
mod fields;
mod inspector;
mod model;
mod outline;
mod preset_gallery;
mod sky;
mod status;

pub(crate) use bars::{CommandState, menu_bar, toolbar};
pub(crate) use inspector::inspector;
pub(crate) use outline::outline;
pub use preset_gallery::{category_gallery, preset_gallery};
pub(crate) use status::status;
