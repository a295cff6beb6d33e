//! Layouts of the panels that are kept by name.

use super::Editor;
use super::dialogs::{Dialog, LONGEST_NAME};
use super::layout::Layout;

const NOT_UNDERSTOOD: &str =
    "is not understood here (a later version's, or damaged); the panels are in their usual places";

impl Editor {
    /// As the user left it; the usual one, and a word, if that can't be understood.
    pub(super) fn recall_layout(&mut self) {
        if let Some(saved) = &self.disk.settings().layout {
            match Layout::from_saved(saved) {
                Some(layout) => self.layout = layout,
                None => self.tell_error(format!("The layout of the last time {NOT_UNDERSTOOD}")),
            }
        }
    }

    pub(super) fn ask_layout_name(&mut self) {
        self.dialogs.open(Dialog::LayoutName(String::new()));
    }

    pub(super) fn list_layouts(&mut self) {
        self.dialogs.open(Dialog::Layouts);
    }

    /// Keeps the present layout under that name, in place of one that has it.
    pub(super) fn save_layout(&mut self, name: &str) {
        let name: String = name.trim().chars().take(LONGEST_NAME).collect();
        let Some(layout) = self.layout.to_saved() else { return };
        self.tell(format!("The layout is kept as “{name}”"));
        self.disk.remember(move |settings| drop(settings.layouts.insert(name.clone(), layout.clone())));
    }

    pub(super) fn use_layout(&mut self, name: &str) {
        match self.disk.settings().layouts.get(name).map(Layout::from_saved) {
            Some(Some(layout)) => self.layout.replace(layout),
            Some(None) => {
                self.layout.reset();
                self.tell_error(format!("The layout “{name}” {NOT_UNDERSTOOD}"));
            }
            None => {}
        }
    }

    pub(super) fn delete_layout(&mut self, name: &str) {
        let name = name.to_owned();
        self.disk.remember(move |settings| drop(settings.layouts.remove(&name)));
    }
}
