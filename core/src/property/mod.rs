//! What can be set in a scene: one table, a row for each value.
//!
//! A row says what a value is called in the file and on the screen, what kind it is, what it may be and what it means,
//! and reads and sets it. The checks of ranges walk the rows, the inspector shows them, and whatever changes values by
//! name finds them by [`Address`]: `cloud/7/heading_deg`. The rows of each kind of thing are a file here. Things
//! themselves are no properties: to add or remove one is an edit of a list.

mod address;
mod aircraft;
mod camera;
mod cloud;
mod cloud_box;
mod described;
mod folder;
mod light;
mod model;
mod number;
mod owner;
mod path;
mod prop;
mod reach;
mod row;
mod scene;
mod setting;
mod sky;
mod target;
mod track;
mod walk;
mod weather;

pub use address::{Address, NoSuchProperty, Table, tables};
pub use cloud::{FORMATION as CLOUD_FORMING, LOOK as CLOUD_LOOK, PLACE as CLOUD_PLACE};
pub use cloud_box::{PLACE as BOX_PLACE, SHADING as BOX_SHADING, SPRITES as BOX_SPRITES};
pub(crate) use described::enter;
pub use described::{Described, Visitor};
pub use light::HasLight;
pub use model::NAME as GROUP_NAME;
pub use number::*;
pub use owner::Owner;
pub use reach::{Change, change};
pub use row::{Property, Refusal, Row};
pub use setting::{Choice, Kind, Parts, Value};
pub use target::Target;
pub use walk::{addresses, place, value, walk};
