//! What is selected: part of the view, never of the scene.
//!
//! Any mix of things, in the order in which they were chosen; the last one is the primary, whose values the inspector
//! shows. Boxes and sprites belong to models, which may be placed often: `through` is the placement in which the artist
//! sees and moves them.

pub use cloudwright_core::scene::Thing as Item;
use cloudwright_core::scene::{
    BoxId, Cloud, CloudBox, CloudId, CloudModel, GroupId, Listed, ModelId, Scene, ShadingGroup,
};
use std::collections::BTreeSet;
use std::ops::RangeInclusive;

/// How a choice joins what is selected already.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Choose {
    /// Only this.
    Only,
    /// This too.
    Too,
    /// This too, or this no longer.
    Toggle,
}

/// Any number of things of the scene.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Selection {
    items: Vec<Item>,
    /// The same, to be asked for each thing of a large scene.
    sorted: BTreeSet<Item>,
    through: Option<CloudId>,
}

impl Selection {
    /// Of several things, the last one primary.
    pub fn of(items: impl IntoIterator<Item = Item>) -> Self {
        let mut selection = Self::default();
        selection.choose(items, None, Choose::Too);
        selection
    }

    /// As seen in the placement `cloud`.
    #[must_use]
    pub fn through(mut self, cloud: CloudId) -> Self {
        self.through = Some(cloud);
        self
    }

    /// In the order of choice.
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// The one chosen last.
    pub fn primary(&self) -> Option<Item> {
        self.items.last().copied()
    }

    /// Whether nothing is selected.
    pub fn is_empty(&self) -> bool {
        self.items.is_empty()
    }

    /// Whether `item` is selected.
    pub fn contains(&self, item: Item) -> bool {
        self.sorted.contains(&item)
    }

    /// Adds or takes out `items`, seen in the placement `through` if that matters.
    pub fn choose(&mut self, items: impl IntoIterator<Item = Item>, through: Option<CloudId>, how: Choose) {
        if how == Choose::Only {
            *self = Self::default();
        }
        for item in items {
            let was_there = !self.sorted.insert(item);
            if was_there {
                self.items.retain(|each| *each != item);
            }
            if was_there && how == Choose::Toggle {
                self.sorted.remove(&item);
            } else {
                self.items.push(item);
            }
        }
        self.through = through.or(self.through);
    }

    /// Leaves out what the scene has no longer. If all of it is gone, the cloud that it was seen in is left.
    pub(crate) fn keep_what_is_in(&mut self, scene: &Scene) {
        let was_empty = self.items.is_empty();
        self.items.retain(|item| item.is_in(scene));
        self.through = self.through.filter(|id| scene.cloud(*id).is_some());
        if self.items.is_empty() && !was_empty {
            self.items.extend(self.through.map(Item::Cloud));
        }
        self.sorted = self.items.iter().copied().collect();
    }

    /// The selected clouds.
    pub fn clouds(&self) -> impl Iterator<Item = CloudId> + '_ {
        self.all::<Cloud>()
    }

    /// The selected boxes with their models.
    pub fn boxes(&self) -> impl Iterator<Item = (ModelId, BoxId)> + '_ {
        self.items.iter().filter_map(|item| if let Item::Box(model, id) = item { Some((*model, *id)) } else { None })
    }

    /// The selected sprites: model, box and index.
    pub fn sprites(&self) -> impl Iterator<Item = (ModelId, BoxId, u32)> + '_ {
        self.items.iter().filter_map(|item| match item {
            Item::Sprite(model, id, index) => Some((*model, *id, *index)),
            _ => None,
        })
    }

    /// The selected things of a kind.
    pub(crate) fn all<T: Listed>(&self) -> impl Iterator<Item = T::Id> + '_ {
        self.items.iter().filter_map(|item| T::id_of(*item))
    }

    /// The selected shading groups with their models.
    pub(crate) fn groups(&self) -> impl Iterator<Item = (ModelId, GroupId)> + '_ {
        self.items.iter().filter_map(|item| if let Item::Group(model, id) = item { Some((*model, *id)) } else { None })
    }

    /// Whether the model itself or a group or sprite of it is selected.
    pub(crate) fn of_model(&self, model: ModelId) -> bool {
        self.contains(Item::Model(model))
            || self.has_any(Item::Group(model, GroupId(0))..=Item::Group(model, GroupId(u64::MAX)))
            || self.has_sprite_of(model)
    }

    /// Whether a box of the model is selected.
    pub(crate) fn has_box_of(&self, model: ModelId) -> bool {
        self.has_any(Item::Box(model, BoxId(0))..=Item::Box(model, BoxId(u64::MAX)))
    }

    /// Whether a sprite of the model is selected.
    pub(crate) fn has_sprite_of(&self, model: ModelId) -> bool {
        self.has_any(Item::Sprite(model, BoxId(0), 0)..=Item::Sprite(model, BoxId(u64::MAX), u32::MAX))
    }

    fn has_any(&self, range: RangeInclusive<Item>) -> bool {
        self.sorted.range(range).next().is_some()
    }

    /// The model of the primary: itself, its box's, sprite's or group's, or its cloud's.
    pub(crate) fn model<'s>(&self, scene: &'s Scene) -> Option<&'s CloudModel> {
        scene.model(self.primary()?.model(scene)?)
    }

    /// The models of all that is selected, each once, the primary's first.
    pub(crate) fn models<'s>(&self, scene: &'s Scene) -> Vec<&'s CloudModel> {
        let ids = self.items.iter().rev().filter_map(|item| item.model(scene));
        let mut seen = BTreeSet::new();
        ids.filter(|id| seen.insert(*id)).filter_map(|id| scene.model(id)).collect()
    }

    /// The placement that the primary is seen in: the cloud itself, the one that it was picked in, or the first of its
    /// model.
    pub(crate) fn cloud<'s>(&self, scene: &'s Scene) -> Option<&'s Cloud> {
        let primary = self.primary()?;
        if let Item::Cloud(id) = primary {
            return scene.cloud(id);
        }
        let model = primary.model(scene)?;
        let picked = self.through.and_then(|id| scene.cloud(id)).filter(|cloud| cloud.model == model);
        picked.or_else(|| scene.clouds.iter().find(|cloud| cloud.model == model))
    }
}

/// A box by its ids.
pub(crate) fn box_of(scene: &Scene, model: ModelId, id: BoxId) -> Option<&CloudBox> {
    scene.model(model)?.boxes.with_id(id)
}

/// A shading group by its ids.
pub(crate) fn group_of(scene: &Scene, model: ModelId, id: GroupId) -> Option<&ShadingGroup> {
    scene.model(model)?.groups.with_id(id)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn choosing_keeps_the_order_and_the_last_one_is_primary() {
        let [a, b, c] = [1, 2, 3].map(|id| Item::Cloud(CloudId(id)));
        let mut selection = Selection::of([a, b]);
        assert_eq!(selection.primary(), Some(b));
        selection.choose([c], None, Choose::Toggle);
        selection.choose([a], None, Choose::Too);
        assert_eq!(selection.items(), [b, c, a], "chosen again, it is primary");
        selection.choose([c], None, Choose::Toggle);
        assert_eq!(selection.items(), [b, a]);
        selection.choose([c], None, Choose::Only);
        assert_eq!(selection.items(), [c]);
    }
}
