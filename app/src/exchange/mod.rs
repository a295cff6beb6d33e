//! Scenes that leave as other programs' files, and what comes in from those, for window and command line. What files hold is
//! told in core's `exchange`; here are the disk, and the one undo point that what comes in becomes.

mod arriving;
mod leaving;

pub use arriving::{CameIn, ChooseError, ComeInError, Placing, ReadError, called, choose, come_in, read};
pub use leaving::{LeaveError, Left, Order, Subject, leave};
