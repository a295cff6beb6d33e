//! The sources' ways that fail, kept so that charts and tests can show how: seen nowhere else.
//!
//! Each stands where the shipped way stands ([`crate::facing::FacingRule`], [`crate::draw_list::Sorting`],
//! [`crate::shading::FormingRule`]) or beside it.

pub mod eight_bits;
mod facing;
mod sorting;
mod stepped_fade;

pub use facing::FacingVariant;
pub use sorting::LazySorting;
pub(crate) use sorting::LazyState;
pub use stepped_fade::{Listing, SteppedFade, SteppedForming};
