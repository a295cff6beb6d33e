//! Speed against accuracy: methods are measured, and what was found becomes a file for programs and one for people.
//!
//! [`run`] measures: a [`subject`] is what all methods draw, an [`charted`] draws it by one of them, [`frame_figures`] are
//! what one frame tells, a [`pictures`] is what the page shows. [`report`] is `chart.json`; [`front`] tells which methods
//! no other one beats; [`svg`] draws cost against error; [`heat`] colours a picture's errors; [`html`] puts it all on one
//! page. But for `charted`, which reads the clock, these are pure functions: the same input gives the same bytes.

pub mod charted;
pub(crate) mod choice;
mod columns;
pub mod frame_figures;
pub mod front;
pub mod heat;
pub mod html;
pub(crate) mod labels;
pub(crate) mod log_axis;
pub mod pictures;
pub mod report;
pub mod run;
pub mod subject;
pub mod svg;
pub(crate) mod text;

pub use cloudwright_core::method::Family;

/// A family's class in style sheets.
fn class(family: Family) -> &'static str {
    match family {
        Family::Truth => "truth",
        Family::Shipped => "shipped",
        Family::Other => "other",
        Family::Failing => "failing",
    }
}
