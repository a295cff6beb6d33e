//! What panels and viewport ask for: they read the scene and return these; the editor alone carries them out.

use super::selection::Selection;
use crate::command::Command;
use cloudwright_core::document::Edit;
use cloudwright_core::scene::CameraId;

/// Something to be done after the panels are drawn.
#[derive(Debug)]
pub(crate) enum Action {
    /// A command of the table.
    Command(Command),
    /// A value was changed: part of a gesture if `live`, which one undo point holds as a whole.
    Change {
        /// What the history calls it.
        name: &'static str,
        /// The new value.
        edit: Box<Edit>,
        /// Whether the button is still down.
        live: bool,
    },
    /// Stop the work that is pending, and take back what asked for it.
    CancelPending,
    /// Choose something.
    Select(Selection),
    /// See what that camera sees.
    LookThrough(CameraId),
    /// Put that camera where the view is.
    SetFromView(CameraId),
}
