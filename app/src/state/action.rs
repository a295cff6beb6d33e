//! What panels and viewport ask for: they read the scene and return these; the editor alone carries them out.

use super::charting::ChartChange;
use super::clock::ClockChange;
use super::script::ScriptChange;
use super::selection::{Choose, Item};
use super::timeline::TimelineChange;
use super::view::Lens;
use crate::command::{Command, Pasted};
use crate::plugins::Origin;
use cloudwright_core::arrange::keys::Rekeyed;
use cloudwright_core::document::Edit;
use cloudwright_core::draw_list::Sorting;
use cloudwright_core::method::Method;
use cloudwright_core::scene::{CameraId, CloudId, PathId};

/// Something to be done after the panels are drawn.
#[derive(Debug)]
pub(crate) enum Action {
    /// A command of the table.
    Command(Command),
    /// Add what came from the clipboard.
    Paste(Pasted),
    /// Ask what is to be chosen of the plugin from there, and run it.
    Plugin(Origin),
    /// Something about the script that is being written.
    Script(ScriptChange),
    /// Values were changed: part of a gesture if `live`, which one undo point holds as a whole.
    Change {
        /// What the history calls it.
        name: &'static str,
        /// The new values.
        edits: Vec<Edit>,
        /// Whether the button is still down.
        live: bool,
    },
    /// Something was put elsewhere: one undo point under a name of its own.
    Put {
        /// What the history calls it.
        name: String,
        /// What is done.
        edits: Vec<Edit>,
        /// What is to be selected then, if anything.
        made: Vec<Item>,
    },
    /// Values are shown as they would be, as long as each frame asks for it; then it is taken back.
    Preview {
        /// What the history calls it once it is done.
        name: &'static str,
        /// What shows it; empty while it is shown.
        edits: Vec<Edit>,
    },
    /// Tracks were changed: part of a gesture if `live`.
    Keys {
        /// What the history calls it.
        name: String,
        /// The tracks, and what else goes with them.
        rekeyed: Rekeyed,
        /// Whether the button is still down.
        live: bool,
        /// Whether the keys that were changed are to be the chosen ones.
        choose: bool,
    },
    /// Something about what of the timeline is worked on.
    Timeline(TimelineChange),
    /// Stop the work that is pending, and take back what asked for it.
    CancelPending,
    /// Take the open gesture back.
    DropGesture,
    /// Choose something.
    Select {
        /// What.
        items: Vec<Item>,
        /// The placement in which boxes and sprites were picked.
        through: Option<CloudId>,
        /// Instead of what is selected, or with it.
        how: Choose,
    },
    /// Something about how the scene is shown.
    View(ViewChange),
    /// Something about what each method costs.
    Chart(ChartChange),
    /// See what that camera sees.
    LookThrough(CameraId),
    /// Put that camera where the view is.
    SetFromView(CameraId),
    /// See what a path's key sees, at its time.
    GoToKey(PathId, usize),
    /// Ask for the file of the model of that aircraft or prop.
    ChooseModel(Item),
    /// Undo or redo until so many points are done.
    JumpTo(usize),
}

/// A change to the view, which no undo takes back.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum ViewChange {
    /// Hide it, or show it again.
    Hidden(Item, bool),
    /// Keep the pointer from picking it, or let it again.
    Locked(Item, bool),
    /// That thing's name is typed in the outline, or none is.
    Renaming(Option<Item>),
    /// Another base altitude for the box tool, metres.
    BaseAltitude(f64),
    /// Steps that gestures snap to.
    Snap(super::view::Snap),
    /// How fast the time of day runs, hours a minute.
    TimeSpeed(f64),
    /// The scene's clock.
    Clock(ClockChange),
    /// Work on that key of a path, or on the whole path.
    PathKey(Option<(PathId, usize)>),
    /// When sprites are sorted again.
    Sorting(Sorting),
    /// Draw by that method, or by the window's own way.
    Method(Option<&'static Method>),
    /// Show the picture in another way.
    Lens(Lens),
}

impl Action {
    /// Selects one thing and nothing else.
    pub(crate) fn select(item: Item) -> Self {
        Self::Select { items: vec![item], through: None, how: Choose::Only }
    }

    /// A change that is shown only; all else as it is.
    pub(crate) fn previewed(self) -> Self {
        match self {
            Self::Change { name, edits, .. } => Self::Preview { name, edits },
            other => other,
        }
    }

    /// One edit of a field.
    pub(crate) fn change(name: &'static str, edit: Edit, live: bool) -> Self {
        Self::Change { name, edits: vec![edit], live }
    }
}
