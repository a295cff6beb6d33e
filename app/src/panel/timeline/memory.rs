//! What the panel remembers from frame to frame: what is in sight, what is typed and folded, and a gesture in the making.

use super::lines::{Group, Lines};
use super::values::Values;
use crate::state::Reading;
use cloudwright_core::arrange::keys::KeyPlace;
use cloudwright_core::property::Target;
use cloudwright_core::scene::Track;
use cloudwright_core::version::Version;
use egui::mutex::Mutex;
use egui::{Context, Id, Pos2, Vec2};
use std::collections::{BTreeSet, HashMap};
use std::sync::Arc;

/// Of one window.
#[derive(Default)]
pub(super) struct Memory {
    /// What of the time is in sight, seconds; none: as much as the clock runs.
    pub(super) times_s: Option<[f64; 2]>,
    /// What tracks are found by.
    pub(super) typed: String,
    /// Groups whose tracks are folded away.
    pub(super) folded: BTreeSet<Group>,
    pub(super) gesture: Option<Gesture>,
    /// What of the curves' values is in sight.
    pub(super) values: Values,
    /// How often the view had been asked to fit and to reveal, when it was done last.
    pub(super) fitted: u64,
    pub(super) revealed: u64,
    /// How far the middle button has pulled the lines, points.
    pub(super) scrolled: f32,
    lines: Option<(Version, Arc<Lines>)>,
    /// What addresses are of: to read one takes a search.
    targets: HashMap<String, Option<Target>>,
}

/// What a hand does while a button is down.
#[derive(Clone)]
pub(super) enum Gesture {
    /// Keys are dragged, or are about to be.
    Keys(Held),
    /// A box is drawn around keys, from there on.
    Box(Pos2),
    /// The slope of a curve is pulled.
    Slope { held: Held, part: usize, leaves: bool },
    /// In and out mark are drawn, from that time on, seconds.
    Marks(f64),
}

/// Keys in hand.
#[derive(Clone)]
pub(super) struct Held {
    /// Where the pointer was last.
    pub(super) last: Pos2,
    /// How far the hand has come, points.
    pub(super) by: Vec2,
    /// The one under the pointer when it went down, and its time and value, the value's part too.
    pub(super) key: KeyPlace,
    pub(super) time_s: f64,
    pub(super) part: Option<usize>,
    /// What was chosen then, and those tracks.
    pub(super) chosen: BTreeSet<KeyPlace>,
    pub(super) tracks: Vec<Arc<Track>>,
    /// Alt: distances from the clock are scaled.
    pub(super) scales: bool,
    /// The hand has moved by more than a tremble.
    pub(super) moved: bool,
    /// A click, without a move, chooses this alone.
    pub(super) alone: bool,
    /// What was asked for last: the same again changes nothing.
    pub(super) asked: Option<[f64; 2]>,
}

impl Memory {
    /// The window's own.
    pub(super) fn of(context: &Context) -> Arc<Mutex<Self>> {
        let id = Id::unique("timeline");
        context.data_mut(|data| Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Self>>>(id)))
    }

    /// The lines to show, made anew only when something has changed.
    pub(super) fn lines(&mut self, reading: &Reading<'_>) -> Arc<Lines> {
        let version = reading.session.revision();
        if let Some((of, lines)) = &self.lines
            && *of == version
        {
            return Arc::clone(lines);
        }
        let targets = &mut self.targets;
        let mut target_of = |property: &str| match targets.get(property) {
            Some(target) => *target,
            None => {
                let target = property.parse().ok();
                targets.insert(property.to_owned(), target);
                target
            }
        };
        let lines = Arc::new(Lines::new(reading.session.scene(), &self.typed, &self.folded, &mut target_of));
        self.lines = Some((version, Arc::clone(&lines)));
        lines
    }

    /// Others are found, folded or unfolded.
    pub(super) fn forget_lines(&mut self) {
        self.lines = None;
    }
}
