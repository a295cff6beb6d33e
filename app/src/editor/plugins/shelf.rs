//! The plugins that there are, read off the frame and kept up with the user's folder while the window has the focus.

use crate::plugins::{self, Library};
use crate::storage::{Listing, Watcher};
use crate::worker::Latest;
use std::path::{Path, PathBuf};

/// The library as it was last read.
pub(super) struct Shelf {
    folder: Option<PathBuf>,
    library: Library,
    /// None where the system gives no thread.
    reader: Option<Latest<(), Library>>,
    watcher: Option<Watcher<Listing>>,
    is_begun: bool,
}

impl Shelf {
    /// Nothing is read until the first frame is made.
    pub(super) fn new(context: &egui::Context, folder: Option<PathBuf>) -> Self {
        let [for_reader, for_watcher] = [context.clone(), context.clone()];
        let of = folder.clone();
        let read = move |()| Library::read(of.as_deref());
        let reader = Latest::start("plugins", read, move || for_reader.request_repaint()).ok();
        let watch =
            |_: &Path| Watcher::start(|path| Some(plugins::listing(path)), move || for_watcher.request_repaint());
        let watcher = folder.as_deref().and_then(|folder| watch(folder).ok());
        Self { folder, library: Library::default(), reader, watcher, is_begun: false }
    }

    /// At the end of each frame: takes up what was read, and sees that what has changed is read.
    pub(super) fn keep_up(&mut self, focused: bool) {
        let Some(reader) = &self.reader else { return };
        if !std::mem::replace(&mut self.is_begun, true) {
            reader.ask(());
        }
        if let Some(library) = reader.newest() {
            self.library = library;
        }
        let (Some(watcher), Some(folder)) = (&self.watcher, &self.folder) else { return };
        let is_read = !self.library.entries().is_empty();
        watcher.watch((focused && is_read).then_some((folder, Some(self.library.seen()))));
        if watcher.news().is_some() {
            reader.ask(());
        }
    }

    /// As it was last read; empty until then.
    pub(super) fn library(&self) -> &Library {
        &self.library
    }
}
