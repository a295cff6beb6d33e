//! Shading groups and colour levels.

use crate::command::Command;
use crate::editor::Editor;
use crate::panel::color_levels::with_levels;

impl Editor {
    pub(super) fn new_group(&mut self) {}

    pub(super) fn ungroup(&mut self) {}

    pub(super) fn auto_group(&mut self) {}

    pub(super) fn copy_levels(&mut self) {
        self.copied_levels = self.view.selection.model(self.session.scene()).map(|model| model.color_levels);
    }

    pub(super) fn paste_levels(&mut self) {
        let Some(levels) = self.copied_levels else { return };
        let models = self.view.selection.models(self.session.scene());
        let edits = models.into_iter().map(|model| with_levels(model, levels)).collect();
        let done = self.session.edit(Command::PasteLevels.row().label(), edits);
        self.report(done);
    }
}
