//! What the editor remembers for the next start: look, units, window, last scenes. The next start reads it in `Editor::new`.

use super::Editor;
use super::done::Done;
use super::layout::Layout;
use crate::command::keymap;
use crate::storage::{self, ThemeChoice};
use egui::ThemePreference;

impl Editor {
    /// As the user left it.
    pub(super) fn recall(&mut self, context: &egui::Context) {
        if let Some(layout) = self.disk.settings().layout.as_ref().and_then(Layout::from_saved) {
            self.layout = layout;
        }
        context.set_theme(match self.disk.settings().theme {
            ThemeChoice::System => ThemePreference::System,
            ThemeChoice::Dark => ThemePreference::Dark,
            ThemeChoice::Light => ThemePreference::Light,
        });
        keymap::choose(context, self.disk.settings().keymap);
    }

    /// Whoever changed it, it is noticed here.
    pub(super) fn remember_look(&mut self, context: &egui::Context) {
        let theme = match context.options(|options| options.theme_preference) {
            ThemePreference::System => ThemeChoice::System,
            ThemePreference::Dark => ThemeChoice::Dark,
            ThemePreference::Light => ThemeChoice::Light,
        };
        if theme != self.disk.settings().theme {
            self.disk.remember(move |settings| settings.theme = theme);
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

    /// From metric units to those of aviation and back.
    pub(super) fn switch_units(&mut self) {
        let units = self.disk.settings().units.other();
        self.disk.remember(move |settings| settings.units = units);
    }

    /// From the editor's own keys to Blender's and back.
    pub(super) fn switch_keymap(&mut self, context: &egui::Context) {
        let keymap = self.disk.settings().keymap.other();
        self.disk.remember(move |settings| settings.keymap = keymap);
        keymap::choose(context, keymap);
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
