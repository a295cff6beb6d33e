//! For tests of the GPU renderer: adapters that may be missing, scenes to draw, and how far a picture may be off.

mod backend;
mod cases;
mod tolerance;

pub use backend::{Backend, required};
pub use cases::{Case, cases, field, moved};
pub use tolerance::{Allowance, Worst};
