//! The scene as lines: a heading for each list, its things, and what is in them below: boxes of models, clouds of folders.
//!
//! The lines are words of the scene and no more, so that thousands are made anew in each frame; only those in sight are
//! laid out.

use super::memory::{Fold, Memory};
use crate::state::Item;
use cloudwright_core::scene::{
    Cloud, CloudModel, Folder, FolderId, ForKind, InScene, Listed, Scene, Track, for_each_kind,
};
use std::collections::HashMap;

/// A line of the outline.
#[derive(Debug, Clone, Copy)]
pub(super) enum Line<'s> {
    /// Above a list: its name in files, how many are shown, and of how many.
    Heading { list: &'static str, shown: usize, of: usize },
    /// A thing with its name, which may be empty; of a cloud, the folder that it is in.
    Thing { item: Item, name: &'s str, within: Option<&'s Folder> },
    /// A folder, and how many clouds are in it.
    Folder { folder: &'s Folder, holds: usize },
}

impl<'s> Line<'s> {
    pub(super) fn item(&self) -> Option<Item> {
        match self {
            Self::Heading { .. } => None,
            Self::Thing { item, .. } => Some(*item),
            Self::Folder { folder, .. } => Some(Item::Folder(folder.id)),
        }
    }

    /// What a thing is called; may be empty.
    pub(super) fn name(&self) -> Option<&'s str> {
        match self {
            Self::Heading { .. } => None,
            Self::Thing { name, .. } => Some(name),
            Self::Folder { folder, .. } => Some(&folder.name),
        }
    }

    /// The folder that it is, or is in.
    pub(super) fn folder(&self) -> Option<&'s Folder> {
        match self {
            Self::Heading { .. } => None,
            Self::Thing { within, .. } => *within,
            Self::Folder { folder, .. } => Some(folder),
        }
    }

    /// How deep it stands in the tree.
    pub(super) fn depth(&self) -> usize {
        match self {
            Self::Heading { .. } => 0,
            Self::Thing { item: Item::Box(..), .. } | Self::Thing { within: Some(_), .. } => 2,
            Self::Thing { .. } | Self::Folder { .. } => 1,
        }
    }

    /// What is folded by it.
    pub(super) fn fold(&self) -> Option<Fold> {
        match self {
            Self::Heading { list, .. } => Some(Fold::List(list)),
            Self::Thing { item: Item::Model(id), .. } => Some(Fold::Model(*id)),
            Self::Folder { folder, .. } => Some(Fold::Folder(folder.id)),
            Self::Thing { .. } => None,
        }
    }
}

/// All lines that are to be shown.
pub(super) fn lines<'s>(scene: &'s Scene, memory: &Memory) -> Vec<Line<'s>> {
    let sought = memory.typed.trim().to_lowercase();
    let mut lines = Lines { scene, memory, sought, lines: Vec::with_capacity(scene.clouds.len() + 64) };
    lines.clouds();
    lines.models();
    for_each_kind(&mut Others(&mut lines));
    lines.lines
}

/// Every kind that is in the outline, by its list's name in files.
pub(super) fn kinds() -> Vec<&'static str> {
    struct All(Vec<&'static str>);
    impl ForKind for All {
        fn kind<T: Listed>(&mut self) {
            // Tracks are in the timeline: there may be hundreds. Folders are among their clouds.
            if ![Track::LIST, Folder::LIST].contains(&T::LIST) {
                self.0.push(T::LIST);
            }
        }
    }
    let mut all = All(Vec::new());
    for_each_kind(&mut all);
    all.0
}

struct Lines<'s, 'm> {
    scene: &'s Scene,
    memory: &'m Memory,
    /// In small letters.
    sought: String,
    lines: Vec<Line<'s>>,
}

/// All but clouds and their models, which come first.
struct Others<'l, 's, 'm>(&'l mut Lines<'s, 'm>);

impl ForKind for Others<'_, '_, '_> {
    fn kind<T: Listed>(&mut self) {
        if ![Cloud::LIST, Folder::LIST, CloudModel::LIST, Track::LIST].contains(&T::LIST) {
            self.0.list::<T>();
        }
    }
}

impl<'s> Lines<'s, '_> {
    fn list<T: Listed>(&mut self) {
        let list = T::list(self.scene);
        self.section(T::LIST, list.len(), |lines| list.iter().filter(|value| lines.add(*value, None)).count());
    }

    /// A line for it, if it is found.
    fn add<T: Listed>(&mut self, value: &'s T, within: Option<&'s Folder>) -> bool {
        let finds = self.finds(value.name());
        if finds {
            self.lines.push(Line::Thing { item: T::thing(value.id()), name: value.name(), within });
        }
        finds
    }

    /// Each folder with its clouds, where those are unfolded or sought; then those in none.
    fn clouds(&mut self) {
        let scene = self.scene;
        self.section(Cloud::LIST, scene.clouds.len(), |lines| {
            let mut held: HashMap<FolderId, Vec<&Cloud>> = HashMap::new();
            let is_in_folder = |cloud: &&Cloud| scene.folder_of(cloud).is_some();
            let (within, others): (Vec<&Cloud>, Vec<&Cloud>) = scene.clouds.iter().partition(is_in_folder);
            for cloud in within {
                held.entry(cloud.folder.unwrap_or(FolderId(0))).or_default().push(cloud);
            }
            let mut shown = 0;
            for folder in &scene.folders {
                let clouds = held.remove(&folder.id).unwrap_or_default();
                shown += lines.folder(folder, &clouds);
            }
            shown + others.into_iter().filter(|cloud| lines.add(*cloud, None)).count()
        });
    }

    /// How many of its clouds are found.
    fn folder(&mut self, folder: &'s Folder, clouds: &[&'s Cloud]) -> usize {
        let (at, is_sought) = (self.lines.len(), !self.sought.is_empty());
        self.lines.push(Line::Folder { folder, holds: clouds.len() });
        if !is_sought && self.memory.folded.contains(&Fold::Folder(folder.id)) {
            return clouds.len();
        }
        let found = clouds.iter().filter(|cloud| self.add(**cloud, Some(folder))).count();
        if found == 0 && !self.finds(folder.name()) {
            self.lines.truncate(at);
        }
        found
    }

    /// Each with its boxes, where those are unfolded or sought.
    fn models(&mut self) {
        let models = &self.scene.models;
        self.section(CloudModel::LIST, models.len(), |lines| models.iter().filter(|model| lines.model(model)).count());
    }

    /// Whether it is found, or one of its boxes.
    fn model(&mut self, model: &'s CloudModel) -> bool {
        let (at, finds) = (self.lines.len(), self.finds(&model.name));
        self.lines.push(Line::Thing { item: Item::Model(model.id), name: &model.name, within: None });
        let is_sought = !self.sought.is_empty();
        if is_sought || !self.memory.folded.contains(&Fold::Model(model.id)) {
            for each in &model.boxes {
                if !is_sought || self.finds(&each.name) {
                    let item = Item::Box(model.id, each.id);
                    self.lines.push(Line::Thing { item, name: &each.name, within: None });
                }
            }
        }
        let shown = finds || self.lines.len() > at + 1;
        if !shown {
            self.lines.truncate(at);
        }
        shown
    }

    /// A heading, and what `add` adds below it: how many of the list.
    fn section(&mut self, list: &'static str, of: usize, add: impl FnOnce(&mut Self) -> usize) {
        if self.memory.only.is_some_and(|only| only != list) {
            return;
        }
        let at = self.lines.len();
        self.lines.push(Line::Heading { list, shown: of, of });
        if self.sought.is_empty() && self.memory.folded.contains(&Fold::List(list)) {
            return;
        }
        let shown = add(self);
        self.lines[at] = Line::Heading { list, shown, of };
    }

    fn finds(&self, name: &str) -> bool {
        self.sought.is_empty() || name.to_lowercase().contains(&self.sought)
    }
}
