//! Files of other programs, out and in: asked for, worked off the frame, and one undo point or nothing.

mod arriving;
mod leaving;

pub(super) use arriving::Arriving;
pub(super) use leaving::Leaving;
