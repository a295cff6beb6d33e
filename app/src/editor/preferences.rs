//! What a user prefers: each thing is set in one way, whether by a command or in *Preferences*.

use super::Editor;
use crate::command::{Keymap, keymap};
use crate::renderer::RendererChoice;
use crate::storage::{Settings, ThemeChoice};
use crate::units::Units;
use egui::{Context, ThemePreference};

/// One thing, as it is to be.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Preference {
    Theme(ThemeChoice),
    Units(Units),
    Keymap(Keymap),
    /// Times the interface's usual size.
    Scale(f32),
    /// Seconds between two keepings of unsaved work.
    KeepWork(u32),
    /// Megabytes for what can be undone; 0 for no bound.
    UndoMemory(u32),
    /// From the next start on.
    Renderer(RendererChoice),
    /// Whether it is shown at a start without a scene.
    StartPage(bool),
}

impl Preference {
    fn set(self, settings: &mut Settings) {
        match self {
            Self::Theme(theme) => settings.theme = theme,
            Self::Units(units) => settings.units = units,
            Self::Keymap(keymap) => settings.keymap = keymap,
            Self::Scale(scale) => settings.set_scale(scale),
            Self::KeepWork(seconds) => settings.set_keep_work_every_s(seconds),
            Self::UndoMemory(megabytes) => settings.undo_mb = megabytes,
            Self::Renderer(renderer) => settings.renderer = renderer,
            Self::StartPage(on) => settings.start_page = on,
        }
    }
}

impl Editor {
    /// Sets it, now and for the next start.
    pub(super) fn prefer(&mut self, preference: Preference, context: &Context) {
        self.disk.remember(move |settings| preference.set(settings));
        self.put_on(context);
    }

    /// Gives the window the look and the keys that are remembered.
    pub(super) fn put_on(&self, context: &Context) {
        let settings = self.disk.settings();
        context.set_theme(match settings.theme {
            ThemeChoice::System => ThemePreference::System,
            ThemeChoice::Dark => ThemePreference::Dark,
            ThemeChoice::Light => ThemePreference::Light,
        });
        keymap::choose(context, settings.keymap);
        if context.zoom_factor() != settings.scale() {
            context.set_zoom_factor(settings.scale());
        }
    }

    /// From the dark look to the light one and back.
    pub(super) fn switch_theme(&mut self, context: &Context) {
        let is_dark = context.theme() == egui::Theme::Dark;
        self.prefer(Preference::Theme(if is_dark { ThemeChoice::Light } else { ThemeChoice::Dark }), context);
    }

    /// From metric units to those of aviation and back.
    pub(super) fn switch_units(&mut self, context: &Context) {
        self.prefer(Preference::Units(self.disk.settings().units.other()), context);
    }

    /// From the editor's own keys to Blender's and back.
    pub(super) fn switch_keymap(&mut self, context: &Context) {
        self.prefer(Preference::Keymap(self.disk.settings().keymap.other()), context);
    }

    /// The interface may have been scaled by the keys that egui itself knows: Ctrl and plus, minus, 0.
    pub(super) fn remember_scale(&mut self, context: &Context) {
        let scale = context.zoom_factor();
        if self.disk.scale.replace(scale).is_some_and(|before| before != scale) {
            self.disk.remember(move |settings| settings.set_scale(scale));
        }
    }
}
