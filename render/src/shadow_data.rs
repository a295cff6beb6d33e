//! What the shadows pass draws: on the edit clock which sprites cast, on the camera clock whether anything has moved.

use crate::buffer::VertexBuffer;
use crate::cloud_data::{CloudData, Instance};
use crate::{Gpu, RenderError};
use cloudwright_core::frame::Frame;
use cloudwright_core::version::Version;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};
use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};

/// The sprites that cast a shadow, and which state of them is drawn.
#[derive(Debug)]
pub(crate) struct ShadowData {
    /// Cloud index, sprite address, and the bits of its optical depth.
    pub(crate) casters: VertexBuffer,
    held: Vec<Instance>,
    /// How often they were others.
    held_at: u64,
    /// Of which clouds they are; nothing after an error.
    version: Option<Version>,
    /// Those of clouds that cast, in this frame.
    pub(crate) runs: Vec<Range<u32>>,
    /// What is to be drawn; none in a frame without shadows.
    wanted: Option<u64>,
    /// What the map shows; 0 for nothing yet.
    drawn: AtomicU64,
    /// By the last update.
    pub(crate) bytes_uploaded: u64,
}

impl ShadowData {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        let casters = VertexBuffer::new(gpu, "the sprites that cast shadows");
        Self {
            casters,
            held: Vec::new(),
            held_at: 0,
            version: None,
            runs: Vec::new(),
            wanted: None,
            drawn: AtomicU64::new(0),
            bytes_uploaded: 0,
        }
    }

    /// Brings everything up to date with `frame`, whose clouds `clouds` holds.
    ///
    /// # Errors
    /// If the device can't hold so many sprites.
    pub(crate) fn update(&mut self, gpu: &Gpu, frame: &Frame<'_>, clouds: &CloudData) -> Result<(), RenderError> {
        (self.wanted, self.bytes_uploaded) = (None, 0);
        let is_cast = frame.now.shadows.is_some_and(|shadows| shadows.plane.is_some());
        if !is_cast || frame.background.ground.is_none() {
            return Ok(());
        }
        let now = &frame.now.clouds;
        if self.version != Some(frame.clouds_version) {
            self.version = None;
            let of = |(index, cloud): (usize, &_)| clouds.casters_of(index, cloud);
            let all: Vec<Instance> = now.iter().enumerate().flat_map(of).collect();
            // A cloud that has another name casts no other shadow.
            if all != self.held {
                self.held.clear();
                self.casters.write(gpu, &all)?;
                self.bytes_uploaded = self.casters.bytes();
                (self.held, self.held_at) = (all, self.held_at + 1);
            }
            self.version = Some(frame.clouds_version);
        }
        self.runs.clear();
        let mut first = 0;
        for cloud in now {
            let end = first + cloud.placed.sprites.len() as u32;
            match self.runs.last_mut() {
                _ if !cloud.casts() => {}
                Some(run) if run.end == first => run.end = end,
                _ => self.runs.push(first..end),
            }
            first = end;
        }
        let mut hasher = FxHasher::default();
        self.held_at.hash(&mut hasher);
        self.runs.hash(&mut hasher);
        frame.now.shadows_state().hash(&mut hasher);
        self.wanted = Some(hasher.finish() | 1);
        Ok(())
    }

    pub(crate) fn is_to_draw(&self) -> bool {
        self.wanted.is_some_and(|wanted| wanted != self.drawn.load(Ordering::Relaxed))
    }

    /// Says that the map shows what was wanted.
    pub(crate) fn is_drawn(&self) {
        self.drawn.store(self.wanted.unwrap_or(0), Ordering::Relaxed);
    }
}
