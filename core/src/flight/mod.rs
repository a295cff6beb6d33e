//! Flights: what happens between the keys of a camera path, how an aircraft banks on it, and how a path is recorded
//! and timed anew.
//!
//! All is in closed form of the time since the path's first key: any instant can be asked for, in any order. Only what
//! a view remembers of its way is not, and is made in fixed steps ([`crate::view_history::Playback`]).

mod attitude;
mod curve;
mod record;
mod retime;
mod spline;

pub use attitude::{MAX_BANK_DEG, STANDSTILL_MPS};
pub use curve::{PathCurve, PathPoint, SHORTEST_LEG_S};
pub use record::keys_from_samples;
pub use retime::{leg_speed_mps, with_speed_from};
