//! The scene's sprites as they lie, for functions that measure or list them: placed when first asked for, and again
//! where the script has changed something since.

use crate::error::Said;
use crate::limits::{Ended, Hears, Patience, TimeOf};
use crate::recorder::Recorder;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::Change;
use cloudwright_core::watch::Watch;
use std::cell::{Cell, RefCell};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// The sprites of a run's scene.
pub(crate) struct Placed {
    patience: Patience,
    /// Hears, once, that placing begins and ends, if that is not the script's own time.
    hears: Cell<Option<Hears>>,
    derived: RefCell<Derived>,
    /// The recorder's, of when they were placed.
    revision: Cell<Option<usize>>,
    took: Cell<Duration>,
}

impl Placed {
    pub(crate) fn new(patience: &Patience, hears: Option<Hears>) -> Self {
        Self {
            patience: patience.clone(),
            hears: Cell::new(hears),
            derived: RefCell::default(),
            revision: Cell::default(),
            took: Cell::default(),
        }
    }

    /// How long placing has taken so far.
    pub(super) fn took(&self) -> Duration {
        self.took.get()
    }

    /// That the run is still wanted and in time, if `unasked` was not the script's own.
    pub(super) fn look(&self, unasked: Duration) -> Result<(), Said> {
        self.patience.ended_now(unasked).map_or(Ok(()), |ended| Err(ended.into()))
    }

    /// What the sprites of the recorder's scene tell.
    pub(super) fn tell<T>(
        &self,
        recorder: &Recorder,
        tell: impl FnOnce(&Derived) -> Result<T, Said>,
    ) -> Result<T, Said> {
        if self.revision.get() != Some(recorder.revision()) {
            let hears = self.hears.take();
            let hear = |whose| hears.iter().for_each(|hears| hears(whose));
            hear(TimeOf::Scene);
            let start = Instant::now();
            let watch = Watch::cancelled_by(Arc::clone(&self.patience.cancelled));
            // What is as it was is found to be so, and kept.
            let plan = |derived: &Derived| derived.plan(recorder.scene(), &Change::everything()).place(&watch);
            let placed = plan(&self.derived.borrow());
            self.took.set(self.took.get() + start.elapsed());
            hear(TimeOf::Script);
            let Some(placed) = placed else { return Err(Ended::Cancelled.into()) };
            self.derived.replace(placed);
            self.revision.set(Some(recorder.revision()));
        }
        tell(&self.derived.borrow())
    }
}
