//! Shading groups and colour levels.

use crate::command::Command;
use crate::editor::Editor;
use crate::state::color_levels::with_levels;
use cloudwright_core::arrange::group::{self, Destination};
use cloudwright_core::arrange::{Arrangement, Names, auto_group};

impl Editor {
    pub(super) fn new_group(&mut self) {
        let Some(model) = self.view.selection.model(self.session.scene()) else { return };
        let name = Names::new(model.groups.iter().map(|group| group.name.as_str())).free("group");
        self.put_into(Command::NewGroup, &Destination::New(name));
    }

    pub(super) fn ungroup(&mut self) {
        self.put_into(Command::Ungroup, &Destination::Own);
    }

    fn put_into(&mut self, command: Command, destination: &Destination) {
        let scene = self.session.scene();
        let Some(model) = self.view.selection.model(scene) else { return };
        let things = self.view.selection.items();
        let arrangement = group::put(scene, model.id, things, destination);
        self.arrange(command, arrangement);
    }

    /// By the sprites of the cloud that the artist looks at, which stays selected.
    pub(super) fn auto_group(&mut self) {
        let scene = self.session.scene();
        let Some(model) = self.view.selection.model(scene) else { return };
        if self.session.pending().is_some() {
            return self.tell_error("The sprites are still being strewn: group them when they are there");
        }
        let own_seed = self.view.selection.cloud(scene).and_then(|cloud| cloud.seed);
        let Some(populated) = self.session.derived().populated(model.id, own_seed.unwrap_or(model.seed)) else {
            return self.tell_error("A model that is placed nowhere has no sprites to group: place it first");
        };
        let edits = auto_group::model(scene, model.id, populated).edits;
        self.arrange(Command::AutoGroup, Arrangement { edits, made: Vec::new() });
    }

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
