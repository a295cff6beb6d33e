//! How scenes leave for other tools, and what comes in from them.
//!
//! A row of [`FORMATS`] is one kind of file: its name, the endings by which it is chosen, what of a scene it carries, what
//! can be set, and the functions that write and read it. Bytes to values and back are [`crate::formats`]' business; what
//! those values mean for a scene is said here. What a scene has and a format does not carry follows from the table
//! ([`Format::left_out`]); what else was lost on the way, a writer or reader tells as [`Note`]s.

mod arrived_model;
mod arriving;
mod cld;
mod cry_cloud;
mod flightgear;
mod flightgear_voxels;
mod format;
pub mod glb;
mod leaving;
mod left_sprites;
pub mod motion;
mod options;
mod part;
mod placed_by_hand;
mod quads;
mod sampled;
mod sheet;
mod shorts;
mod sprites;
mod sun;
mod table;
mod tiles;
mod usd;
mod volume;
mod web;
mod wpr;

pub use arrived_model::ArrivedModel;
pub use arriving::{Arrived, ArrivedCloud, Arriving, Content};
pub use format::{ChoiceError, Corners, Format, HEAD_BYTES};
pub use leaving::{ExportError, Files, Leaving, Note, NoteKind, numbered};
pub use options::{OptionError, OptionKind, OptionRow, Options};
pub use part::Part;
pub use table::FORMATS;
