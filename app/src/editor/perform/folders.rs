//! Folders of clouds: made, filled, emptied, hidden and locked.

use crate::command::Command;
use crate::editor::Editor;
use crate::editor::dialogs::Dialog;
use crate::panel::Panel;
use crate::state::{Choose, Item};
use cloudwright_core::arrange::folders;
use cloudwright_core::document::{Edit, ListEdit};
use cloudwright_core::scene::{CloudId, Folder, FolderId, Listed};
use std::collections::BTreeSet;

impl Editor {
    /// Of the selected clouds; its name can be typed at once.
    pub(in crate::editor) fn new_folder(&mut self) {
        let clouds: Vec<CloudId> = self.view.selection.clouds().collect();
        self.arrange(Command::NewFolder, folders::made(self.session.scene(), &clouds));
        self.layout.bring_up(Panel::Outline);
        self.view.renaming = self.view.selection.primary().filter(|item| matches!(item, Item::Folder(_)));
    }

    pub(super) fn ask_folder(&mut self) {
        self.dialogs.open(Dialog::IntoFolder);
    }

    /// The selected clouds go into `folder`, or out of theirs.
    pub(in crate::editor) fn put_into_folder(&mut self, folder: Option<FolderId>) {
        let scene = self.session.scene();
        let clouds: Vec<CloudId> = self.view.selection.clouds().collect();
        let put = folders::put(scene, &clouds, folder);
        if !put.edits.is_empty() {
            let name = folders::told(scene, put.made.len(), folder);
            let done = self.session.edit(&name, put.edits);
            self.report(done);
        }
    }

    /// The selected folders, and those of selected clouds.
    pub(super) fn folders_at_work(&self) -> BTreeSet<FolderId> {
        let (scene, selection) = (self.session.scene(), &self.view.selection);
        let of_clouds = selection.clouds().filter_map(|id| scene.cloud(id)?.folder);
        selection.all::<Folder>().chain(of_clouds).collect()
    }

    pub(super) fn select_folder(&mut self) {
        let scene = self.session.scene();
        let clouds = self.folders_at_work().into_iter().flat_map(|id| scene.clouds_in(id));
        let items: Vec<Item> = clouds.map(|cloud| Item::Cloud(cloud.id)).collect();
        if items.is_empty() {
            return self.tell("The folder is empty");
        }
        self.view.selection.choose(items, None, Choose::Only);
    }

    /// Sets the flag of those selected folders that don't have it; if all have, takes it from them.
    pub(super) fn toggle_folders(&mut self, flag: impl Fn(&mut Folder) -> &mut bool) {
        let scene = self.session.scene();
        let mut chosen: Vec<Folder> =
            self.view.selection.all::<Folder>().filter_map(|id| scene.folders.with_id(id).cloned()).collect();
        let on = !chosen.iter_mut().all(|folder| *flag(folder));
        let edits = chosen.into_iter().map(|mut folder| {
            *flag(&mut folder) = on;
            Edit::Folder(ListEdit::Replace(folder))
        });
        let edits: Vec<Edit> = edits.collect();
        if !edits.is_empty() {
            self.change(Folder::CHANGE, edits, false);
        }
    }
}
