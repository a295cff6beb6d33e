//! Shading groups and colour levels.

use crate::editor::Editor;

impl Editor {
    pub(super) fn new_group(&mut self) {}

    pub(super) fn ungroup(&mut self) {}

    pub(super) fn auto_group(&mut self) {}

    pub(super) fn copy_levels(&mut self) {
        self.copied_levels = self.view.selection.model(self.session.scene()).map(|model| model.color_levels);
    }

    pub(super) fn paste_levels(&mut self) {}
}
