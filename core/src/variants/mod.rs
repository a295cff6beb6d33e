//! The sources' ways that fail, kept so that charts and tests can show how: seen nowhere else.
//!
//! Each is a value of the type that the shipped way is one of ([`crate::facing::FacingRule`],
//! [`crate::draw_list::LazySorting`], [`crate::weather::Stepped`]), or stands beside it. Only the table of methods and the
//! one place that decides what draws know them.

pub mod eight_bits;
mod facing;
mod sorting;
mod stepped_fade;
mod stepped_streaming;

pub use facing::{LOCK_WITHOUT_FADE, NO_LOCK, VIEW_PLANE, WANGS_DOT_PRODUCT};
pub use sorting::{SIMGEAR, SKYWORKS};
pub use stepped_fade::{Listing, STEPPED_AS_PRINTED, STEPPED_MENDED, SteppedFade};
pub use stepped_streaming::{STEPPED_10, STEPPED_24};
