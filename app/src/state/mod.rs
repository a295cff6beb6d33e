//! What panels, viewport and editor share: the open document, how it is looked at, and what may be asked of the editor.
//!
//! Everything here is a value with its rules; none of it knows a panel, the viewport or the editor. Panels and viewport
//! read it as a `Reading` and return `Action`s, which the editor carries out.

mod action;
mod baking;
mod charting;
mod clock;
pub(crate) mod color_levels;
mod keying;
mod offered;
mod reading;
mod regeneration;
mod script;
mod selection;
mod session;
mod time_play;
mod timeline;
mod view;

pub(crate) use action::{Action, ViewChange};
pub(crate) use charting::{ChartChange, ChartSubject, Charting, WIDTHS_PX};
pub(crate) use clock::{CLOCK_SPEED, Clock, ClockChange};
pub(crate) use keying::{Keyed, Values, place_value, take_place};
pub(crate) use offered::{CommandState, Offered};
pub(crate) use reading::Reading;
pub(crate) use script::{Script, ScriptChange};
pub use selection::{Choose, Item, Selection};
pub(crate) use selection::{box_of, group_of};
pub use session::{Pending, Session};
pub(crate) use time_play::{MAX_STEP_S, TimePlay};
pub(crate) use timeline::TimelineChange;
pub use timeline::{TimeSnap, TimelineView};
pub use view::{Lens, Snap, SpriteMarks, Tool, ViewState};
