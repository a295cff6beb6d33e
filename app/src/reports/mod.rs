//! Weather reports into a scene, for window and command line: [`reading`] makes reports of a text, [`making`] a sky of
//! reports, its clouds by the plugins that ship.

pub mod making;
pub mod reading;

pub use making::{Made, MadeLayer, MakeError, Making, make, make_sky};
pub use reading::{Line, lines};
