//! One picture's worth of input: what both renderers draw from.

use crate::camera::View;
use crate::color::Rgb;
use crate::derived::Derived;
use crate::draw_list::{Choice, DrawList, Hidden};
use crate::facing::Poses;
use crate::model_in_view::{Meshes, ModelInView, aircraft_in_view};
use crate::raster::Filter;
use crate::scene::{Camera, Scene};
use crate::shading::{Formed, Light, Veil, veil};
use crate::sky::{Background, Dome, GroundLook};
use crate::sprites::{Atlas, PlacedCloud};
use crate::version::Version;
use crate::view_history::ViewHistory;

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
    /// How far each has formed.
    pub formed: Vec<Formed>,
    /// Tells this state of the clouds from every other.
    pub clouds_version: Version,
    /// The sprites in view, back to front.
    pub list: DrawList,
    /// The same in the order that fades out, with its share of the picture.
    pub fading: Option<(DrawList, f32)>,
    /// Before everything: the air inside a cloud.
    pub veil: Veil,
    /// Their tiles.
    pub atlas: &'a Atlas,
    /// How renderers on the CPU take texels from them.
    pub filter: Filter,
    /// The aircraft in view, in any order.
    pub models: Vec<ModelInView>,
}

/// How a scene is looked at, for one frame.
#[derive(Debug, Clone, Copy)]
pub struct Sight<'a> {
    /// From where.
    pub camera: &'a Camera,
    /// Local civil hours: the light.
    pub time_h: f64,
    /// Seconds of the scene's clock: how far clouds have formed.
    pub clock_s: f64,
    /// Width and height, pixels.
    pub size: [u32; 2],
    /// What is left out.
    pub hidden: &'a Hidden,
    /// The shapes of aircraft that have a file of their own.
    pub meshes: &'a Meshes,
    /// Where the eye has been; nowhere, for a still.
    pub history: &'a ViewHistory,
}

impl<'a> Frame<'a> {
    /// The still that `camera` sees of `scene` at `time_h`, at the beginning of the scene's clock, in `size` (width and
    /// height in pixels). `derived` is the scene's.
    pub fn new(
        scene: &Scene,
        derived: &'a Derived,
        atlas: &'a Atlas,
        camera: &Camera,
        time_h: f64,
        size: [u32; 2],
    ) -> Self {
        let (hidden, meshes, history) = (&Hidden::default(), &Meshes::default(), &ViewHistory::default());
        Self::of(scene, derived, atlas, &Sight { camera, time_h, clock_s: 0.0, size, hidden, meshes, history })
    }

    /// What is seen of `scene`, whose `derived` is.
    pub fn of(scene: &Scene, derived: &'a Derived, atlas: &'a Atlas, sight: &Sight<'_>) -> Self {
        let Sight { camera, time_h, clock_s, size, hidden, meshes, history } = *sight;
        let (clouds, clouds_version) = (derived.clouds(), derived.version());
        let view = View::new(camera, size[0], size[1]);
        let light = Light::at(scene, time_h);
        let formed = clouds.iter().map(|cloud| history.forming.formed(cloud.formation.as_ref(), clock_s));
        let formed: Vec<Formed> = formed.collect();
        let poses = Poses::new(clouds, clouds_version, &view, &history.facing);
        let choice = Choice { clouds, formed: &formed, poses: &poses, hidden };
        let (order, fading) = history.order.orders();
        Self {
            view,
            light,
            background: background(scene, &view, &light),
            exposure: libm::exp2(scene.sky.exposure_ev) as f32,
            list: DrawList::new(&choice, &view, order),
            fading: fading.map(|(order, share)| (DrawList::new(&choice, &view, Some(order)), share)),
            veil: veil((clouds, &formed, &poses), (&view, &light, atlas, hidden), scene.sky.inside_density as f32),
            clouds,
            formed,
            clouds_version,
            atlas,
            filter: Filter::default(),
            models: aircraft_in_view(scene, meshes, clock_s, view.eye),
        }
    }

    /// How far the cloud of that index has formed.
    pub fn formed(&self, cloud: u32) -> &Formed {
        self.formed.get(cloud as usize).unwrap_or(&Formed::WHOLE)
    }

    /// The same frame in the order that fades out, alone, with its share of the picture.
    pub fn older(&self) -> Option<(Self, f32)> {
        let (list, share) = self.fading.clone()?;
        Some((Self { list, fading: None, ..self.clone() }, share))
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
