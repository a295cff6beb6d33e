//! What the panel remembers from frame to frame: what is searched for, folded, in sight and in hand.

use crate::state::{Item, Selection};
use cloudwright_core::scene::{FolderId, ModelId, Scene};
use egui::mutex::Mutex;
use egui::{Context, Id};
use std::collections::BTreeSet;
use std::sync::Arc;

/// Of one window.
#[derive(Default)]
pub(super) struct Memory {
    /// What rows are found by.
    pub(super) typed: String,
    /// The list that is shown alone, by its name in files.
    pub(super) only: Option<&'static str>,
    pub(super) folded: BTreeSet<Fold>,
    /// The primary of the selection when it was brought into sight last.
    seen: Option<Item>,
    /// What is to be brought into sight.
    pub(super) reveal: Option<Item>,
    /// What is to have the keyboard's focus once it is laid out.
    pub(super) focus: Option<Item>,
    /// Whether a row has it.
    pub(super) has_keys: bool,
    /// How far the rows are scrolled, and how many points of them are in sight.
    pub(super) scrolled: [f32; 2],
    /// What is dragged to another place of its list.
    pub(super) dragged: Vec<Item>,
    /// The name that is typed, and whose it is.
    pub(super) renamed: Option<(Item, String)>,
}

/// What can be folded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Fold {
    /// A list, by its name in files.
    List(&'static str),
    /// The boxes of a model.
    Model(ModelId),
    /// The clouds of a folder.
    Folder(FolderId),
}

impl Memory {
    pub(super) fn of(context: &Context) -> Arc<Mutex<Self>> {
        let id = Id::unique("outline");
        context.data_mut(|data| Arc::clone(data.get_temp_mut_or_default::<Arc<Mutex<Self>>>(id)))
    }

    /// What was chosen last is brought into sight, wherever it was chosen.
    pub(super) fn follow(&mut self, selection: &Selection, scene: &Scene) {
        let primary = selection.primary();
        if primary != self.seen {
            self.seen = primary;
            self.reveal = primary.map(row_of);
            let fold = match self.reveal {
                Some(Item::Box(model, _)) => Some(Fold::Model(model)),
                Some(Item::Cloud(id)) => scene.cloud(id).and_then(|cloud| cloud.folder).map(Fold::Folder),
                _ => None,
            };
            if let Some(fold) = fold {
                self.folded.remove(&fold);
            }
        }
    }

    pub(super) fn toggle(&mut self, fold: Fold) {
        if !self.folded.remove(&fold) {
            self.folded.insert(fold);
        }
    }
}

/// What stands for `item` in the outline: for a sprite its box, for a shading group its model.
pub(super) fn row_of(item: Item) -> Item {
    match item {
        Item::Sprite(model, id, _) => Item::Box(model, id),
        Item::Group(model, _) => Item::Model(model),
        listed => listed,
    }
}
