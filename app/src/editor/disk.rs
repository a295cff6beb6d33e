//! What of an editor lies on a disk: the document's file as it was last known, settings, unsaved work, and the thread that
//! reads and writes them. Everything slow goes to it; answers are taken up at the beginning of a frame.

use super::Editor;
use super::dialogs::Dialog;
use super::done::{Done, unkept};
use crate::storage::{Folders, RescueWriter, Settings, Stamp, Unsaved, Watcher};
use crate::worker::InOrder;
use std::time::Instant;

/// Files and memory of one editor.
pub(super) struct Disk {
    /// None: nothing is remembered and nothing rescued.
    folders: Option<Folders>,
    settings: Settings,
    pub(super) file_jobs: InOrder<Done>,
    pub(super) saving: bool,
    /// None where there is nothing to rescue to.
    pub(super) rescue_writer: Option<RescueWriter>,
    /// What it was given last, as long as the document is modified.
    pub(super) kept: Option<Unsaved>,
    pub(super) watcher: Option<Watcher<Stamp>>,
    /// The document's file as it was last read or written here; none if there is none.
    pub(super) known: Option<Stamp>,
    /// How large the interface was in the last frame.
    pub(super) scale: Option<f32>,
    /// When unsaved work was last given to be kept.
    pub(super) kept_at: Option<Instant>,
    /// Of the window, points.
    pub(super) window_size: Option<[f32; 2]>,
}

impl Disk {
    /// With what is remembered in `folders`; and notices of what can't be understood or done.
    pub(super) fn new(context: &egui::Context, folders: Option<Folders>) -> (Self, Vec<String>) {
        let (settings, notice) = folders.as_ref().map(Settings::load).unwrap_or_default();
        let mut notices = Vec::from_iter(notice);
        let (for_clerk, for_watcher, for_writer) = (context.clone(), context.clone(), context.clone());
        let start = |folders| RescueWriter::start(folders, move || for_writer.request_repaint());
        let rescue_writer = folders
            .clone()
            .and_then(|folders| start(folders).map_err(|error| notices.push(unkept(&error.to_string()))).ok());
        let disk = Self {
            folders,
            settings,
            file_jobs: InOrder::start("files", move || for_clerk.request_repaint()),
            saving: false,
            rescue_writer,
            kept: None,
            watcher: Watcher::start(Stamp::of, move || for_watcher.request_repaint()).ok(),
            known: None,
            scale: None,
            kept_at: None,
            window_size: None,
        };
        (disk, notices)
    }

    pub(super) fn folders(&self) -> Option<&Folders> {
        self.folders.as_ref()
    }

    /// What is remembered.
    pub(super) fn settings(&self) -> &Settings {
        &self.settings
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
            self.file_jobs.ask(move || Done::Remembered(Settings::change(&folders, change)));
        }
    }
}

impl Editor {
    /// Whether files are being written.
    pub fn is_busy(&self) -> bool {
        self.disk.file_jobs.is_busy() || self.disk.rescue_writer.as_ref().is_some_and(RescueWriter::is_busy)
    }

    pub(super) fn take_up_what_is_done(&mut self, context: &egui::Context) {
        while let Some(done) = self.disk.file_jobs.next_answer() {
            match done {
                Done::Saved { path, mark, outcome } => self.saved(path, mark, outcome, context),
                Done::Remembered(Err(error)) => self.tell_error(format!("The settings can't be kept: {error}")),
                Done::Remembered(Ok(())) => {}
                Done::Exported { path, lines, outcome } => self.exported(&path, lines, outcome),
                Done::ScriptRead { path, stamp, outcome } => self.script_read(&path, stamp, outcome),
                Done::ScriptSaved { path, text, outcome } => self.script_saved(path, text, outcome, context),
                Done::Reported { path, outcome } => self.reported(&path, outcome),
                Done::FolderShown(Err(error)) => self.tell_error(error.to_string()),
                Done::FolderShown(Ok(())) => {}
                Done::StillThere(scenes) => self.dialogs.tell_recent(scenes),
                Done::Recent(scenes) => self.dialogs.open(Dialog::Recent(scenes)),
            }
        }
    }

    /// What a clean exit leaves behind: nothing but settings.
    pub fn leave(&mut self) {
        if let Some(size) = self.disk.window_size {
            self.disk.remember(move |settings| settings.window_size = Some(size));
        }
        self.drop_rescue();
        self.disk.rescue_writer = None;
        self.disk.file_jobs.finish();
    }
}
