//! Weather reports into a scene, for window and command line: [`reading`] makes reports of a text, [`making`] a sky of
//! reports, its clouds by the plugins that ship, [`words`] says both to people.

pub mod making;
pub mod reading;
pub mod words;

pub use making::{Cover, MOST_TIME, Made, MadeLayer, MakeError, Making, make, make_sky};
pub use reading::{Line, lines};
