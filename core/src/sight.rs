//! How a scene is looked at, for one frame.

use crate::camera::View;
use crate::draw_list::Hidden;
use crate::model_in_view::Meshes;
use crate::panorama::Facet;
use crate::rules::Rules;
use crate::scene::Camera;
use crate::view_history::ViewHistory;
use crate::weather::Moment;
use std::sync::Arc;

/// Everything that a picture depends on beside the scene and its atlas: another sight, another picture.
#[derive(Debug, Clone, PartialEq)]
pub struct Sight {
    /// From where.
    pub camera: Camera,
    /// When.
    pub moment: Moment,
    /// Width and height of the picture, pixels.
    pub size: [u32; 2],
    /// What is left out.
    pub hidden: Hidden,
    /// The shapes of aircraft that have a file of their own.
    pub meshes: Meshes,
    /// Where the eye has been, by the same rules; nowhere, for a still.
    pub history: Arc<ViewHistory>,
    /// By which rules it is drawn.
    pub rules: Rules,
    /// Of a panorama, which side is looked at from where the camera is; none for what the camera sees.
    pub facet: Option<Facet>,
}

impl Sight {
    /// The still that `camera` sees in `size` at the beginning of the scene's clock, by the rules that ship.
    pub fn still(camera: &Camera, size: [u32; 2]) -> Self {
        Self {
            camera: camera.clone(),
            moment: Moment::default(),
            size,
            hidden: Hidden::default(),
            meshes: Meshes::default(),
            history: Arc::default(),
            rules: Rules::SHIPPED,
            facet: None,
        }
    }

    /// The eye, with as many pixels as the rules take samples.
    pub fn view(&self) -> View {
        let scale = self.rules.pixels_a_pixel();
        let [width, height] = self.size.map(|length| length * scale);
        match self.facet {
            Some(facet) => facet.view(&self.camera, self.size[0], scale),
            None => View::new(&self.camera, width, height),
        }
    }
}
