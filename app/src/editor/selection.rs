//! What is selected: part of the view, never of the scene.

use cloudwright_core::scene::{BoxId, CameraId, CloudBox, CloudId, CloudModel, ModelId, Scene};

/// One thing of the scene, or nothing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Selection {
    /// Nothing.
    #[default]
    Nothing,
    /// A cloud model.
    Model(ModelId),
    /// A box of a model.
    Box(ModelId, BoxId),
    /// A placed cloud.
    Cloud(CloudId),
    /// A camera.
    Camera(CameraId),
}

impl Selection {
    /// Itself, or nothing if the scene has it no longer.
    pub(crate) fn still_in(self, scene: &Scene) -> Self {
        let there = match self {
            Self::Nothing => true,
            Self::Model(id) => scene.model(id).is_some(),
            Self::Box(model, id) => box_of(scene, model, id).is_some(),
            Self::Cloud(id) => scene.cloud(id).is_some(),
            Self::Camera(id) => scene.cameras.iter().any(|camera| camera.id == id),
        };
        if there { self } else { Self::Nothing }
    }

    /// The model that is selected itself, by one of its boxes or by one of its clouds.
    pub(crate) fn model(self, scene: &Scene) -> Option<&CloudModel> {
        match self {
            Self::Model(id) | Self::Box(id, _) => scene.model(id),
            Self::Cloud(id) => scene.model(scene.cloud(id)?.model),
            Self::Nothing | Self::Camera(_) => None,
        }
    }
}

/// A box by its ids.
pub(crate) fn box_of(scene: &Scene, model: ModelId, id: BoxId) -> Option<&CloudBox> {
    scene.model(model)?.boxes.iter().find(|b| b.id == id)
}
