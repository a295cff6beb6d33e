//! Methods as values: every way to draw, said as plain data, so that charts, tests and tools choose one by its name.
//!
//! A [`Method`] is a name, a sentence, a [`Family`] and its [`Rules`]: what draws, in which order, by which rule sprites
//! face the eye and clouds form, how many sprites are kept, how texels are filtered, how many samples a pixel has.
//! [`METHODS`] is the table; a new method is a row there.

mod table;

pub use table::METHODS;

use crate::rules::Rules;

/// A way to draw, with its name.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Method {
    /// Lower case, words joined by hyphens: what command lines, files and charts say.
    pub name: &'static str,
    /// What it does, or what is wrong with it, in a sentence or two.
    pub about: &'static str,
    /// What it is among the others.
    pub family: Family,
    /// All that makes it.
    pub rules: Rules,
}

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
}

/// The method of that name.
pub fn named(name: &str) -> Option<&'static Method> {
    METHODS.iter().find(|method| method.name == name)
}

/// What errors are measured against.
pub fn truth() -> &'static Method {
    &table::TRUTH
}

/// What is drawn with unless something else is asked for, on the CPU.
pub fn shipped() -> &'static Method {
    &table::SHIPPED
}
