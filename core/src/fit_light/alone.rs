//! One cloud alone, whole and at rest, before black: what its sprites show in a light, and what their vapour would.

use super::values::Heights;
use crate::color::{Rgb, Rgba};
use crate::density::{Fineness, Vapour};
use crate::derived::Derived;
use crate::frame::Frame;
use crate::image::Layer;
use crate::raster::fast;
use crate::rules::Blending;
use crate::scene::{Camera, Cloud, CloudModel, ColorLevels, List, Scene};
use crate::sight::Sight;
use crate::sprites::{Atlas, Group, GroupKey, PlacedCloud, SoftLight};
use crate::traced::{Medium, Surroundings, Traced, trace};
use crate::watch::Watch;
use crate::weather::{CloudNow, Light, SceneNow};
use glam::{DVec3, Vec3};
use std::sync::Arc;

/// From where it is looked at: headings and how far the eye looks up, degrees. Twice each from below, from its side and from
/// above, all around.
const LOOKS: [[f64; 2]; 6] = [[20.0, 20.0], [80.0, 0.0], [140.0, -25.0], [200.0, 20.0], [260.0, 0.0], [320.0, -25.0]];
/// Width and height of a picture, pixels.
const SIDE: u32 = 24;
/// Sprites are drawn with so many pixels on a side of each, as their tiles have texture.
const FINE: u32 = 4;
/// Voxels along the longest side of the vapour.
const VOXELS: u32 = 64;

/// How sprites are lit.
#[derive(Debug, Clone)]
pub(super) struct Look {
    pub(super) levels: ColorLevels,
    pub(super) groups: Arc<[Group]>,
    pub(super) soft_light: SoftLight,
}

impl Look {
    /// As `model` has it, which that cloud is of, but for the self-shadow.
    pub(super) fn of(model: &CloudModel, alone: &Alone<'_>, self_shadow: f32) -> Self {
        let shares = |group: &Group| Group { c: shares_of(model, group.key).unwrap_or(group.c), ..*group };
        Self {
            levels: model.color_levels,
            groups: alone.placed().groups.iter().map(shares).collect(),
            soft_light: SoftLight { self_shadow, ..SoftLight::of(model) },
        }
    }
}

/// Of the group of that key, as its box or the model's list has them.
fn shares_of(model: &CloudModel, key: GroupKey) -> Option<[f32; 3]> {
    let light = match key {
        GroupKey::Named(id) => model.groups.with_id(id)?.light,
        GroupKey::Lump(id, _) => model.boxes.with_id(id)?.light,
    };
    Some([light.c_min, light.c_med, light.c_max].map(|share| share as f32))
}

/// By which light alone; either is white.
#[derive(Debug, Clone, Copy)]
pub(super) enum By {
    Sky,
    /// From the cloud to the sun, unit.
    Sun(Vec3),
}

/// One cloud, with the places that it is looked at from.
pub(super) struct Alone<'a> {
    derived: Derived,
    atlas: &'a Atlas,
    scene: Scene,
    sights: Vec<Sight>,
    /// The scene's light, whose opacity is the sprites'.
    light: Light,
    pub(super) heights: Heights,
}

impl<'a> Alone<'a> {
    /// Of `scene`, a cloud of that model. None if `watch` is cancelled, or the cloud has no sprites.
    pub(super) fn new(
        scene: &Scene,
        (cloud, model): (&Cloud, &CloudModel),
        atlas: &'a Atlas,
        watch: &Watch,
    ) -> Option<Self> {
        let light = Light::at(scene, scene.time_of_day_h);
        let mut scene = scene.clone();
        scene.tracks.clear();
        let cloud = Cloud { formation: None, formed: None, opacity: 1.0, growth: 1.0, folder: None, ..cloud.clone() };
        // A model that has none of it would not be baked.
        let model = CloudModel { self_shadow: 1.0, ..model.clone() };
        (scene.clouds, scene.models) = ([cloud].into_iter().collect(), [model].into_iter().collect());
        let derived = Derived::new(&scene);
        derived.bake(&watch.part()).then_some(())?;
        let placed = derived.clouds().first().filter(|placed| !placed.sprites.is_empty())?;
        let heights = Heights::of(placed);
        let sights = LOOKS.map(|look| Sight::still(&camera(placed, look), [SIDE * FINE; 2])).into();
        Some(Self { derived, atlas, scene, sights, light, heights })
    }

    pub(super) fn placed(&self) -> &PlacedCloud {
        &self.derived.clouds()[0]
    }

    /// How many pictures there are.
    pub(super) fn views(&self) -> usize {
        self.sights.len()
    }

    /// The sprites in that look and light from the place of that number; without haze.
    pub(super) fn drawn(&self, look: &Look, by: By, view: usize) -> Layer {
        let placed = PlacedCloud {
            color_levels: look.levels,
            groups: Arc::clone(&look.groups),
            soft_light: look.soft_light,
            ..self.placed().clone()
        };
        let frame = Frame::of(self.now(&placed, by), &self.derived, self.atlas, &self.sights[view]);
        fast::clouds(&frame, Blending::AS_PLAIN).reduced(FINE)
    }

    fn now<'b>(&self, placed: &'b PlacedCloud, by: By) -> SceneNow<'b> {
        let (sky, sun, direction) = match by {
            By::Sky => (Rgb::grey(1.0), Rgb::BLACK, Vec3::Y),
            By::Sun(direction) => (Rgb::BLACK, Rgb::grey(1.0), direction),
        };
        let light = Light {
            sun_direction: direction,
            direction,
            ambient_max: Rgba { rgb: sky, a: self.light.ambient_max.a },
            directional_max: sun,
            night: None,
            ..self.light
        };
        SceneNow {
            light,
            exposure: 1.0,
            turbidity: self.scene.sky.turbidity as f32,
            sky_gain: 1.0,
            haze_length_m: f32::MAX,
            inside_density: 0.0,
            ground: None,
            shadows: None,
            aircraft: List::new(),
            props: List::new(),
            clouds: vec![CloudNow::at_rest(placed)],
        }
    }

    /// What a path tracer makes of it from each place; none if `watch` is cancelled or nothing of the cloud shows. `reach` is
    /// told how far it is.
    pub(super) fn traced(
        &self,
        around: &Surroundings,
        samples: u32,
        reach: &dyn Fn(f32),
        watch: &Watch,
    ) -> Option<Vec<Traced>> {
        let cloud = CloudNow::at_rest(self.placed());
        let vapour = Vapour { clouds: &[&cloud], atlas: self.atlas, light: &self.light };
        let density = vapour.density(Fineness::Longest(VOXELS), &watch.part()).ok()?;
        let medium = Medium::new(&density.grid);
        let count = self.sights.len() as f32;
        let trace = |(done, sight): (usize, &Sight)| {
            reach(done as f32 / count);
            let sight = Sight { size: [SIDE; 2], ..sight.clone() };
            trace(&medium, &sight.view(), around, samples, &watch.part())
        };
        let all = self.sights.iter().enumerate().map(trace).collect();
        (!watch.is_cancelled()).then_some(all)
    }
}

/// Looks at the middle of `cloud` from where all of it fits.
fn camera(cloud: &PlacedCloud, [heading_deg, pitch_deg]: [f64; 2]) -> Camera {
    let mut camera = Camera { heading_deg, pitch_deg, ..Camera::free(cloud.origin + cloud.center.as_dvec3()) };
    let half_height = libm::sin((camera.field_of_view_deg * 0.5).to_radians());
    let away_m = f64::from(cloud.reach) / half_height;
    let (heading, pitch) = (heading_deg.to_radians(), pitch_deg.to_radians());
    let level = libm::cos(pitch);
    let forward = DVec3::new(libm::sin(heading) * level, libm::sin(pitch), -libm::cos(heading) * level);
    camera.position -= forward * away_m;
    camera
}
