//! Why bytes are no file of a format, and where.

/// What is wrong with a file, and where in it.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{place}: {message}")]
pub struct Misread {
    /// "byte 132", "line 7".
    pub place: String,
    /// What is wrong there.
    pub message: String,
}

impl Misread {
    /// Something wrong there.
    pub fn new(place: impl Into<String>, message: impl Into<String>) -> Self {
        Self { place: place.into(), message: message.into() }
    }
}
