//! The scene as lines: a heading for each list, its things, and the boxes of models below them.
//!
//! The lines are words of the scene and no more, so that thousands are made anew in each frame; only those in sight are
//! laid out.

use super::memory::{Fold, Memory};
use crate::state::Item;
use cloudwright_core::scene::{Cloud, CloudModel, ForKind, List, Listed, Scene, Track, for_each_kind};

/// A line of the outline.
#[derive(Debug, Clone, Copy)]
pub(super) enum Line<'s> {
    /// Above a list: its name in files, how many are shown, and of how many.
    Heading { list: &'static str, shown: usize, of: usize },
    /// A thing with its name, which may be empty.
    Thing { item: Item, name: &'s str },
}

impl Line<'_> {
    pub(super) fn item(&self) -> Option<Item> {
        if let Self::Thing { item, .. } = self { Some(*item) } else { None }
    }

    /// How deep it stands in the tree.
    pub(super) fn depth(&self) -> usize {
        match self {
            Self::Heading { .. } => 0,
            Self::Thing { item: Item::Box(..), .. } => 2,
            Self::Thing { .. } => 1,
        }
    }

    /// What is folded by it.
    pub(super) fn fold(&self) -> Option<Fold> {
        match self {
            Self::Heading { list, .. } => Some(Fold::List(list)),
            Self::Thing { item: Item::Model(id), .. } => Some(Fold::Model(*id)),
            Self::Thing { .. } => None,
        }
    }
}

/// All lines that are to be shown.
pub(super) fn lines<'s>(scene: &'s Scene, memory: &Memory) -> Vec<Line<'s>> {
    let sought = memory.typed.trim().to_lowercase();
    let mut lines = Lines { scene, memory, sought, lines: Vec::with_capacity(scene.clouds.len() + 64) };
    lines.list::<Cloud>();
    lines.models();
    for_each_kind(&mut Others(&mut lines));
    lines.lines
}

/// Every kind that is in the outline, by its list's name in files.
pub(super) fn kinds() -> Vec<&'static str> {
    struct All(Vec<&'static str>);
    impl ForKind for All {
        fn kind<T: Listed>(&mut self) {
            // Tracks are in the timeline: there may be hundreds.
            if T::LIST != Track::LIST {
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
        if ![Cloud::LIST, CloudModel::LIST, Track::LIST].contains(&T::LIST) {
            self.0.list::<T>();
        }
    }
}

impl<'s> Lines<'s, '_> {
    fn list<T: Listed>(&mut self) {
        self.section(T::LIST, T::list(self.scene), |lines, value| {
            if lines.finds(value.name()) {
                lines.lines.push(Line::Thing { item: T::thing(value.id()), name: value.name() });
                return true;
            }
            false
        });
    }

    /// Each with its boxes, where those are unfolded or sought.
    fn models(&mut self) {
        self.section(CloudModel::LIST, &self.scene.models, |lines, model| {
            let (at, finds) = (lines.lines.len(), lines.finds(&model.name));
            lines.lines.push(Line::Thing { item: Item::Model(model.id), name: &model.name });
            let is_sought = !lines.sought.is_empty();
            if is_sought || !lines.memory.folded.contains(&Fold::Model(model.id)) {
                for each in &model.boxes {
                    if !is_sought || lines.finds(&each.name) {
                        lines.lines.push(Line::Thing { item: Item::Box(model.id, each.id), name: &each.name });
                    }
                }
            }
            let shown = finds || lines.lines.len() > at + 1;
            if !shown {
                lines.lines.truncate(at);
            }
            shown
        });
    }

    /// A heading, and what `add` adds for each of the list: whether it did.
    fn section<T>(&mut self, list: &'static str, all: &'s List<T>, add: impl Fn(&mut Self, &'s T) -> bool) {
        if self.memory.only.is_some_and(|only| only != list) {
            return;
        }
        let at = self.lines.len();
        self.lines.push(Line::Heading { list, shown: all.len(), of: all.len() });
        if self.sought.is_empty() && self.memory.folded.contains(&Fold::List(list)) {
            return;
        }
        let mut shown = 0;
        for value in all {
            shown += usize::from(add(self, value));
        }
        self.lines[at] = Line::Heading { list, shown, of: all.len() };
    }

    fn finds(&self, name: &str) -> bool {
        self.sought.is_empty() || name.to_lowercase().contains(&self.sought)
    }
}
