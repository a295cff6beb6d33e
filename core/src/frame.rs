//! One picture's worth of input: what both renderers draw from.

use crate::camera::View;
use crate::color::Rgb;
use crate::derived::Derived;
use crate::draw_list::{DrawList, Hidden};
use crate::model_in_view::ModelInView;
use crate::scene::{Camera, Scene};
use crate::shading::Light;
use crate::sky::{Background, Dome, GroundLook};
use crate::sprites::{Atlas, PlacedCloud};
use crate::version::Version;

/// A scene's clouds, light and background as one eye sees them at one moment.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    /// The eye and the picture's size.
    pub view: View,
    /// The light on the clouds.
    pub light: Light,
    /// Sky, ground and haze.
    pub background: Background,
    /// What the light is multiplied with before the tone curve.
    pub exposure: f32,
    /// All clouds; the list counts into them.
    pub clouds: &'a [PlacedCloud],
    /// Tells this state of the clouds from every other.
    pub clouds_version: Version,
    /// The sprites in view, back to front.
    pub list: DrawList,
    /// Their tiles.
    pub atlas: &'a Atlas,
    /// The aircraft in view, in any order.
    pub models: Vec<ModelInView>,
}

impl<'a> Frame<'a> {
    /// The frame that `camera` sees of `scene` at `time_h` in `size` (width and height in pixels). `derived` is the
    /// scene's.
    pub fn new(
        scene: &Scene,
        derived: &'a Derived,
        atlas: &'a Atlas,
        camera: &Camera,
        time_h: f64,
        size: [u32; 2],
    ) -> Self {
        Self::hiding(scene, derived, atlas, camera, time_h, size, &Hidden::default())
    }

    /// As [`Frame::new`], without what is `hidden`.
    pub fn hiding(
        scene: &Scene,
        derived: &'a Derived,
        atlas: &'a Atlas,
        camera: &Camera,
        time_h: f64,
        size: [u32; 2],
        hidden: &Hidden,
    ) -> Self {
        let clouds = derived.clouds();
        let view = View::new(camera, size[0], size[1]);
        let light = Light::at(scene, time_h);
        Self {
            view,
            light,
            background: background(scene, &view, &light),
            exposure: libm::exp2(scene.sky.exposure_ev) as f32,
            list: DrawList::hiding(clouds, &view, hidden),
            clouds,
            clouds_version: derived.version(),
            atlas,
            models: Vec::new(),
        }
    }
}

fn background(scene: &Scene, view: &View, light: &Light) -> Background {
    let albedo = scene.ground.as_ref().map_or(Rgb::grey(0.1), |ground| ground.dark.mix(ground.bright, 0.5));
    Background {
        dome: Dome::new(
            light.sun_direction,
            scene.sky.turbidity as f32,
            albedo,
            scene.sky.gain as f32,
            light.directional_max,
        ),
        ground: scene.ground.as_ref().and_then(|ground| GroundLook::new(ground, view.eye, light)),
        haze_length_m: (scene.sky.haze_length_m as f32).max(1.0),
    }
}
