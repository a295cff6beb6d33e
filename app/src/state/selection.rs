//! What is selected: part of the view, never of the scene.
//!
//! Any mix of things, in the order in which they were chosen; the last one is the primary, whose values the inspector
//! shows. Boxes and sprites belong to models, which may be placed often: `through` is the placement in which the artist
//! sees and moves them.

pub use cloudwright_core::arrange::Thing as Item;
use cloudwright_core::scene::{
    Aircraft, AircraftId, BoxId, Camera, CameraId, Cloud, CloudBox, CloudId, CloudModel, GroupId, ModelId, PathId,
    Scene, ShadingGroup,
};

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
        self.items.contains(&item)
    }

    /// Adds or takes out `items`, seen in the placement `through` if that matters.
    pub fn choose(&mut self, items: impl IntoIterator<Item = Item>, through: Option<CloudId>, how: Choose) {
        if how == Choose::Only {
            *self = Self::default();
        }
        for item in items {
            let there = self.items.iter().position(|each| *each == item);
            if let Some(at) = there {
                self.items.remove(at);
            }
            if there.is_none() || how != Choose::Toggle {
                self.items.push(item);
            }
        }
        self.through = through.or(self.through);
    }

    /// Leaves out what the scene has no longer. If all of it is gone, the cloud that it was seen in is left.
    pub(crate) fn keep_what_is_in(&mut self, scene: &Scene) {
        let was_empty = self.items.is_empty();
        self.items.retain(|item| is_in(*item, scene));
        self.through = self.through.filter(|id| scene.cloud(*id).is_some());
        if self.items.is_empty() && !was_empty {
            self.items.extend(self.through.map(Item::Cloud));
        }
    }

    /// The selected clouds.
    pub fn clouds(&self) -> impl Iterator<Item = CloudId> + '_ {
        self.items.iter().filter_map(|item| if let Item::Cloud(id) = item { Some(*id) } else { None })
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

    /// The selected cameras.
    pub(crate) fn cameras(&self) -> impl Iterator<Item = CameraId> + '_ {
        self.items.iter().filter_map(|item| if let Item::Camera(id) = item { Some(*id) } else { None })
    }

    /// The selected camera paths.
    pub(crate) fn paths(&self) -> impl Iterator<Item = PathId> + '_ {
        self.items.iter().filter_map(|item| if let Item::Path(id) = item { Some(*id) } else { None })
    }

    /// The selected aircraft.
    pub(crate) fn aircraft(&self) -> impl Iterator<Item = AircraftId> + '_ {
        self.items.iter().filter_map(|item| if let Item::Aircraft(id) = item { Some(*id) } else { None })
    }

    /// The selected shading groups with their models.
    pub(crate) fn groups(&self) -> impl Iterator<Item = (ModelId, GroupId)> + '_ {
        self.items.iter().filter_map(|item| if let Item::Group(model, id) = item { Some((*model, *id)) } else { None })
    }

    /// Whether the model itself or a group or sprite of it is selected.
    pub(crate) fn of_model(&self, model: ModelId) -> bool {
        let of =
            |item: &Item| matches!(item, Item::Model(id) | Item::Group(id, _) | Item::Sprite(id, ..) if *id == model);
        self.items.iter().any(of)
    }

    /// The model of the primary: itself, its box's, sprite's or group's, or its cloud's.
    pub(crate) fn model<'s>(&self, scene: &'s Scene) -> Option<&'s CloudModel> {
        scene.model(model_of(self.primary()?, scene)?)
    }

    /// The models of all that is selected, each once, the primary's first.
    pub(crate) fn models<'s>(&self, scene: &'s Scene) -> Vec<&'s CloudModel> {
        let mut models: Vec<&CloudModel> = Vec::new();
        for id in self.items.iter().rev().filter_map(|item| model_of(*item, scene)) {
            if !models.iter().any(|model| model.id == id) {
                models.extend(scene.model(id));
            }
        }
        models
    }

    /// The placement that the primary is seen in: the cloud itself, the one that it was picked in, or the first of its
    /// model.
    pub(crate) fn cloud<'s>(&self, scene: &'s Scene) -> Option<&'s Cloud> {
        let primary = self.primary()?;
        if let Item::Cloud(id) = primary {
            return scene.cloud(id);
        }
        let model = model_of(primary, scene)?;
        let picked = self.through.and_then(|id| scene.cloud(id)).filter(|cloud| cloud.model == model);
        picked.or_else(|| scene.clouds.iter().find(|cloud| cloud.model == model))
    }
}

/// The model that a thing belongs to or places; none for cameras, paths and aircraft.
pub(crate) fn model_of(item: Item, scene: &Scene) -> Option<ModelId> {
    match item {
        Item::Model(id) | Item::Box(id, _) | Item::Sprite(id, ..) | Item::Group(id, _) => Some(id),
        Item::Cloud(id) => Some(scene.cloud(id)?.model),
        Item::Camera(_) | Item::Path(_) | Item::Aircraft(_) => None,
    }
}

/// Whether the scene has it.
pub(super) fn is_in(item: Item, scene: &Scene) -> bool {
    match item {
        Item::Model(id) => scene.model(id).is_some(),
        Item::Box(model, id) => box_of(scene, model, id).is_some(),
        Item::Sprite(model, id, index) => box_of(scene, model, id).is_some_and(|each| index < each.sprite_count),
        Item::Group(model, id) => group_of(scene, model, id).is_some(),
        Item::Cloud(id) => scene.cloud(id).is_some(),
        Item::Camera(id) => camera_of(scene, id).is_some(),
        Item::Path(id) => scene.path(id).is_some(),
        Item::Aircraft(id) => aircraft_of(scene, id).is_some(),
    }
}

/// A box by its ids.
pub(crate) fn box_of(scene: &Scene, model: ModelId, id: BoxId) -> Option<&CloudBox> {
    scene.model(model)?.boxes.iter().find(|each| each.id == id)
}

/// A shading group by its ids.
pub(crate) fn group_of(scene: &Scene, model: ModelId, id: GroupId) -> Option<&ShadingGroup> {
    scene.model(model)?.groups.iter().find(|group| group.id == id)
}

/// A camera by its id.
pub(crate) fn camera_of(scene: &Scene, id: CameraId) -> Option<&Camera> {
    scene.cameras.iter().find(|camera| camera.id == id)
}

/// An aircraft by its id.
pub(crate) fn aircraft_of(scene: &Scene, id: AircraftId) -> Option<&Aircraft> {
    scene.aircraft.iter().find(|aircraft| aircraft.id == id)
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
