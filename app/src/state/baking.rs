//! Light that is baked beside the window: clouds are shown before it is there, and again when it is.
//!
//! What is baked is kept where the clouds are, so of clouds that were overtaken meanwhile, all that is still theirs stays.

use crate::worker::Latest;
use cloudwright_core::derived::Derived;
use cloudwright_core::watch::Watch;
use std::sync::Arc;
use std::time::{Duration, Instant};

/// After so long, work on clouds that are no longer shown is given up.
const PATIENCE: Duration = Duration::from_millis(500);

#[derive(Debug, Default)]
pub(super) struct Baking {
    worker: Option<Latest<(Arc<Derived>, Arc<Watch>), bool>>,
    in_hand: Option<InHand>,
}

#[derive(Debug)]
struct InHand {
    clouds: Arc<Derived>,
    watch: Arc<Watch>,
    begun: Instant,
}

impl Baking {
    /// Once a frame: sees that the light of `clouds` gets baked. Whether some has been meanwhile.
    pub(super) fn keep_up(&mut self, clouds: &Arc<Derived>, context: &egui::Context) -> bool {
        let has_more = self.worker.as_ref().and_then(Latest::newest).is_some();
        if has_more {
            self.in_hand = None;
        }
        match &self.in_hand {
            Some(work) if !Arc::ptr_eq(&work.clouds, clouds) && work.begun.elapsed() > PATIENCE => work.watch.cancel(),
            None if clouds.is_unbaked() => self.begin(Arc::clone(clouds), context),
            _ => {}
        }
        has_more
    }

    fn begin(&mut self, clouds: Arc<Derived>, context: &egui::Context) {
        if self.worker.is_none() {
            let wake = context.clone();
            let work = |(clouds, watch): (Arc<Derived>, Arc<Watch>)| clouds.bake(&watch);
            // Without a thread clouds stay as their groups light them.
            self.worker = Latest::start_beside_the_window("light", work, move || wake.request_repaint()).ok();
        }
        if let Some(worker) = &self.worker {
            let watch = Arc::new(Watch::default());
            worker.ask((Arc::clone(&clouds), Arc::clone(&watch)));
            self.in_hand = Some(InHand { clouds, watch, begun: Instant::now() });
        }
    }
}

impl Drop for Baking {
    fn drop(&mut self) {
        if let Some(work) = &self.in_hand {
            work.watch.cancel();
        }
    }
}
