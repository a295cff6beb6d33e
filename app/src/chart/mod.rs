//! Speed against accuracy, to look at: what was measured of every method becomes a file for programs and one for people.
//!
//! [`report`] is `chart.json`; [`front`] tells which methods no other one beats; [`svg`] draws cost against error;
//! [`heat`] colours a picture's errors; [`html`] puts it all on one page. Pure functions: figures and pictures in,
//! text out, and the same input gives the same bytes.

mod columns;
pub mod front;
pub mod heat;
pub mod html;
pub mod report;
pub mod svg;
mod text;

/// What a method is among the others: a mark of its own in charts.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Family {
    /// What errors are measured against.
    Truth,
    /// What Cloudwright draws with unless told otherwise.
    Shipped,
    /// A way of drawing worth a look.
    Other,
    /// A way that is known to go wrong, kept to show how.
    Failing,
}

impl Family {
    /// In the order of legends.
    pub const ALL: [Self; 4] = [Self::Truth, Self::Shipped, Self::Other, Self::Failing];

    /// For legends and badges.
    pub fn name(self) -> &'static str {
        match self {
            Self::Truth => "truth",
            Self::Shipped => "shipped",
            Self::Other => "others",
            Self::Failing => "known to fail",
        }
    }

    /// Its class in style sheets.
    fn class(self) -> &'static str {
        match self {
            Self::Truth => "truth",
            Self::Shipped => "shipped",
            Self::Other => "other",
            Self::Failing => "failing",
        }
    }
}
