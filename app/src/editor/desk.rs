//! What lies around the document: the clerk who writes files, what is remembered for the user, the recovery slot, and
//! the file as it was last known. Everything slow goes to the clerk; answers are taken up at the beginning of a frame.

use super::Editor;
use super::autosave::AutosaveClock;
use super::dialogs::Dialog;
use super::done::Done;
use crate::storage::{Folders, RecoverySlot, Settings, Stamp, StorageError, Watcher};
use crate::worker::InOrder;

/// Files and memory of one editor.
pub(super) struct Desk {
    /// None: nothing is remembered and nothing rescued.
    folders: Option<Folders>,
    settings: Settings,
    pub(super) clerk: InOrder<Done>,
    pub(super) saving: bool,
    pub(super) slot: Option<RecoverySlot>,
    pub(super) autosave_clock: AutosaveClock,
    pub(super) watcher: Option<Watcher>,
    /// The document's file as it was last read or written here; none if there is none.
    pub(super) known: Option<Stamp>,
    /// Of the window, points.
    pub(super) window_size: Option<[f32; 2]>,
}

impl Desk {
    /// With what is remembered in `folders`; and a notice if that can't be understood.
    pub(super) fn new(context: &egui::Context, folders: Option<Folders>) -> (Self, Option<String>) {
        let (settings, notice) = folders.as_ref().map(Settings::load).unwrap_or_default();
        let (for_clerk, for_watcher) = (context.clone(), context.clone());
        let desk = Self {
            folders,
            settings,
            clerk: InOrder::start("files", move || for_clerk.request_repaint()),
            saving: false,
            slot: None,
            autosave_clock: AutosaveClock::default(),
            watcher: Watcher::start(move || for_watcher.request_repaint()).ok(),
            known: None,
            window_size: None,
        };
        (desk, notice)
    }

    pub(super) fn folders(&self) -> Option<&Folders> {
        self.folders.as_ref()
    }

    /// What is remembered.
    pub(super) fn settings(&self) -> &Settings {
        &self.settings
    }

    /// This editor's recovery slot, claimed when it is first needed.
    pub(super) fn slot(&mut self, folders: &Folders) -> Result<&RecoverySlot, StorageError> {
        let slot = match self.slot.take() {
            Some(slot) => slot,
            None => RecoverySlot::claim(folders)?,
        };
        Ok(self.slot.insert(slot))
    }

    /// Changes what is remembered, here at once and on disk soon.
    pub(super) fn remember(&mut self, change: impl Fn(&mut Settings) + Send + 'static) {
        let mut settings = self.settings.clone();
        change(&mut settings);
        if settings == self.settings {
            return;
        }
        self.settings = settings;
        if let Some(folders) = self.folders.clone() {
            self.clerk.ask(move || Done::Remembered(Settings::change(&folders, change)));
        }
    }
}

impl Editor {
    /// Whether files are being written.
    pub fn is_busy(&self) -> bool {
        self.desk.clerk.is_busy()
    }

    pub(super) fn take_up_what_is_done(&mut self, context: &egui::Context) {
        while let Some(done) = self.desk.clerk.next_answer() {
            match done {
                Done::Saved { path, mark, outcome } => self.saved(path, mark, outcome, context),
                Done::Rescued(Err(error)) => self.tell_error(format!("The work can't be kept for a crash: {error}")),
                Done::Remembered(Err(error)) => self.tell_error(format!("The settings can't be kept: {error}")),
                Done::Rescued(Ok(())) | Done::Remembered(Ok(())) => {}
                Done::Recent(scenes) => self.dialogs.open(Dialog::Recent(scenes)),
            }
        }
    }

    /// What a clean exit leaves behind: nothing but settings.
    pub fn leave(&mut self) {
        if let Some(size) = self.desk.window_size {
            self.desk.remember(move |settings| settings.window_size = Some(size));
        }
        self.drop_rescue();
        self.desk.clerk.finish();
    }
}
