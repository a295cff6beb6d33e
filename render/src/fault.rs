//! What a device reports outside any call: its loss, and errors that no one waited for. wgpu's own answer is a panic;
//! here they are noted down, and the next step of a frame returns them.

use crate::RenderError;
use std::sync::{Arc, Mutex, PoisonError};

/// The first fault since the last look, and the loss, which stays.
#[derive(Debug, Default)]
pub(crate) struct Faults {
    noted: Mutex<Noted>,
}

#[derive(Debug, Default)]
struct Noted {
    lost: Option<String>,
    refused: Option<String>,
}

impl Faults {
    /// From now on, `device` notes its faults here, in place of any handlers it had.
    pub(crate) fn of(device: &wgpu::Device) -> Arc<Self> {
        let faults = Arc::new(Self::default());
        let noted = Arc::clone(&faults);
        device.set_device_lost_callback(move |_, message| noted.note(|n| n.lost.get_or_insert(message.clone()).len()));
        let noted = Arc::clone(&faults);
        device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
            noted.note(|n| n.refused.get_or_insert_with(|| error.to_string()).len());
        }));
        faults
    }

    /// A loss found by other means.
    pub(crate) fn note_loss(&self, message: &str) {
        self.note(|n| n.lost.get_or_insert(message.to_owned()).len());
    }

    fn note(&self, write: impl FnOnce(&mut Noted) -> usize) {
        // A poisoned lock holds whole strings all the same.
        write(&mut self.noted.lock().unwrap_or_else(PoisonError::into_inner));
    }

    /// The fault noted since the last look, if any.
    pub(crate) fn check(&self) -> Result<(), RenderError> {
        let mut noted = self.noted.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(message) = &noted.lost {
            return Err(RenderError::DeviceLost(message.clone()));
        }
        noted.refused.take().map_or(Ok(()), |message| Err(RenderError::Refused(message)))
    }
}
