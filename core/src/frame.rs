//! One picture's worth of input: what both renderers draw from.

use crate::camera::View;
use crate::color::Rgb;
use crate::derived::Derived;
use crate::detail::Kept;
use crate::draw_list::{Choice, DrawList};
use crate::facing::Poses;
use crate::model_in_view::{ModelInView, aircraft_in_view};
use crate::rules::Rules;
use crate::scene::Scene;
use crate::shading::{Veil, veil};
use crate::sight::Sight;
use crate::sky::{Background, Dome, GroundLook};
use crate::sprites::{Atlas, PlacedCloud};
use crate::version::Version;
use crate::weather::{Formed, Light};

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
    /// By which rules it is drawn.
    pub rules: Rules,
    /// The aircraft in view, in any order.
    pub models: Vec<ModelInView>,
}

impl<'a> Frame<'a> {
    /// What is seen of `scene`, whose `derived` is, with the tiles of `atlas`. It is of as many pixels as the sight's rules
    /// take samples.
    pub fn new(scene: &Scene, derived: &'a Derived, atlas: &'a Atlas, sight: &Sight) -> Self {
        let Sight { camera, moment, size, hidden, meshes, history, rules } = sight;
        let (clouds, clouds_version) = (derived.clouds(), derived.version());
        let [width, height] = size.map(|length| length * rules.pixels_a_pixel());
        let view = View::new(camera, width, height);
        let light = Light::at(scene, moment.time_h.unwrap_or(scene.time_of_day_h));
        let formed = clouds.iter().map(|cloud| rules.forming.formed(cloud.formation.as_ref(), moment.clock_s));
        let formed: Vec<Formed> = formed.collect();
        let kept = &Kept::new(rules.detail, clouds, atlas);
        let mut poses = Poses::new(&rules.facing, clouds, clouds_version, &view, &history.facing);
        if !kept.is_all() {
            poses.retain(|cloud, sprite| kept.has(cloud, &clouds[cloud].sprites[sprite as usize], sprite));
        }
        let choice = Choice { clouds, formed: &formed, poses: &poses, kept, hidden };
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
            rules: *rules,
            models: aircraft_in_view(scene, meshes, moment.clock_s, view.eye),
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
