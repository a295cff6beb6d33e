//! Other names: of one thing in its row of the outline, of many by a pattern.

use crate::command::Command;
use crate::editor::Editor;
use crate::editor::dialogs::{Dialog, Rename};
use crate::panel::Panel;
use crate::state::Item;
use cloudwright_core::arrange::{Arrangement, rename};

impl Editor {
    /// What of the selection has a name to change, in the order of choice.
    pub(super) fn renamable(&self) -> impl Iterator<Item = Item> {
        let scene = self.session.scene();
        self.view.selection.items().iter().copied().filter(|item| rename::name_of(scene, *item).is_some())
    }

    pub(super) fn rename(&mut self) {
        let things: Vec<Item> = self.renamable().collect();
        match things.as_slice() {
            // Groups have no row in the outline.
            [item] if !matches!(item, Item::Group(..)) => {
                self.layout.bring_up(Panel::Outline);
                self.view.renaming = Some(*item);
            }
            _ => self.dialogs.open(Dialog::Rename(Rename::new(self.session.scene(), things))),
        }
    }

    pub(in crate::editor) fn rename_many(&mut self, asked: &Rename) {
        let Arrangement { edits, .. } =
            rename::many(self.session.scene(), &asked.things, &asked.pattern, asked.first());
        self.arrange(Command::Rename, Arrangement { edits, made: Vec::new() });
    }
}
