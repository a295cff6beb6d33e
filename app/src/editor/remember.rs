//! What the editor remembers for the next start: look, units, window, last scenes. The next start reads it in `Editor::new`.

use super::Editor;
use super::done::Done;
use crate::storage;
use crate::widget::section;

impl Editor {
    /// As the user left it.
    pub(super) fn recall(&mut self, context: &egui::Context) {
        self.recall_layout();
        section::fold(context, self.disk.settings().folded.clone());
        self.put_on(context);
    }

    /// Whoever changed it, it is noticed here.
    pub(super) fn remember_look(&mut self, context: &egui::Context) {
        self.remember_scale(context);
        let folded = section::folded(context);
        if folded != self.disk.settings().folded {
            self.disk.remember(move |settings| settings.folded.clone_from(&folded));
        }
        let at_rest = !context.input(|input| input.pointer.any_down());
        if at_rest && self.layout.take_changed() {
            let layout = self.layout.to_saved();
            self.disk.remember(move |settings| settings.layout.clone_from(&layout));
        }
        let inner = context.input(|input| input.viewport().inner_rect);
        if let Some(size) = inner.map(|rect| rect.size()).filter(|size| size.is_finite() && size.min_elem() >= 1.0) {
            let size = Some([size.x, size.y]);
            if size != self.disk.window_size {
                // The frame in which a window grows may still be presented at its old size.
                context.request_repaint();
            }
            self.disk.window_size = size;
        }
    }

    /// Shows the last scenes, when it is known which are still there.
    pub(super) fn list_recent(&mut self, context: &egui::Context) {
        let paths = self.disk.settings().recent().to_vec();
        self.disk.file_jobs.ask(move || {
            let with_state = paths.into_iter().map(|path| {
                let there = storage::is_there(&path);
                (path, there)
            });
            Done::Recent(with_state.collect())
        });
        context.request_repaint();
    }
}
