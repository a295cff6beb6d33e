//! A scene at a moment: all that the clock, or a look at another hour, can change, as plain numbers.

use super::shadows::{KeptShadows, ShadowMap, ShadowPlane, between};
use super::{AirNow, CloudNow, Light, Moment, Shade, Shadows, Timeline, WeatherRules, clouds_now};
use crate::scene::{Aircraft, Ground, List, Prop, Scene};
use crate::sprites::PlacedCloud;
use crate::version::Version;
use glam::DVec3;
use rustc_hash::FxHasher;
use std::hash::{Hash, Hasher};

/// A scene at one moment.
#[derive(Debug, Clone)]
pub struct SceneNow<'a> {
    /// Sun, sky's light and time of day.
    pub light: Light,
    /// What light is multiplied with before the tone curve.
    pub exposure: f32,
    /// How hazy the sky's own light is, 1 to 10.
    pub turbidity: f32,
    /// What scales it.
    pub sky_gain: f32,
    /// Metres over which 1 − 1/e of a colour turns to the horizon's.
    pub haze_length_m: f32,
    /// How dense the air inside a cloud looks, 1 as its sprites.
    pub inside_density: f32,
    /// What lies below, if anything.
    pub ground: Option<Ground>,
    /// The aircraft; where they are follows from their paths, when a frame asks for them.
    pub aircraft: List<Aircraft>,
    /// What stands.
    pub props: List<Prop>,
    /// The clouds, in their order.
    pub clouds: Vec<CloudNow<'a>>,
    /// What the clouds cast; none if nothing is to be seen of it.
    pub shadows: Option<Shadows>,
}

impl<'a> SceneNow<'a> {
    /// The air that moves sprites one by one, if any does: the same for all clouds.
    pub fn air(&self) -> Option<&AirNow> {
        self.clouds.iter().find_map(|cloud| Some(&cloud.air.as_ref()?.air))
    }

    /// `scene`, whose placed `clouds` and `timeline` are, at `moment`, where clouds form and stream by those rules. It
    /// follows from these alone.
    pub fn new(
        scene: &Scene,
        (clouds, timeline): (&'a [PlacedCloud], &Timeline),
        moment: Moment,
        rules: WeatherRules,
    ) -> Self {
        Self::unshaded(scene, (clouds, timeline), moment, rules).shaded()
    }

    /// The same before the clouds' shadows are known.
    pub(crate) fn unshaded(
        scene: &Scene,
        (clouds, timeline): (&'a [PlacedCloud], &Timeline),
        moment: Moment,
        rules: WeatherRules,
    ) -> Self {
        let time_h = moment.time_h.unwrap_or_else(|| timeline.time_of_day_h(scene, moment.clock_s));
        let scene = timeline.surroundings_at(scene, moment.clock_s);
        let sky = &scene.sky;
        let light = Light::at(&scene, time_h);
        Self {
            shadows: Shadows::new(light.direction, sky.cloud_shadows as f32, light.ambient_max.a),
            light,
            exposure: libm::exp2(sky.exposure_ev) as f32 * light.brightened(sky.adaptation as f32),
            turbidity: sky.turbidity as f32,
            sky_gain: sky.gain as f32,
            haze_length_m: (sky.haze_length_m as f32).max(1.0),
            inside_density: sky.inside_density as f32,
            ground: scene.ground.clone(),
            aircraft: scene.aircraft.clone(),
            props: scene.props.clone(),
            clouds: clouds_now(clouds, timeline, moment.clock_s, rules),
        }
    }

    /// The same for someone who has hidden some of its clouds, which then cast no shadow.
    #[must_use]
    pub(crate) fn hiding(mut self, is_hidden: impl Fn(&CloudNow<'_>) -> bool) -> Self {
        self.clouds.iter_mut().for_each(|cloud| cloud.is_hidden = is_hidden(cloud));
        self
    }

    /// With the clouds' shadows.
    fn shaded(self) -> Self {
        let now = self.over_ground();
        let shades = now.shades();
        now.with_shades(&shades)
    }

    /// The same with what is kept of the last frame, if that was of the same clouds, which have that `version`.
    pub(crate) fn shaded_as_kept(self, kept: &KeptShadows, version: Version) -> Self {
        let now = self.over_ground();
        let shades = kept.between.of((version, now.shadows_state()), || now.shades().into());
        now.with_shades(&shades)
    }

    /// With what the ground's shadows are drawn on.
    fn over_ground(mut self) -> Self {
        let ground_m = self.ground.as_ref().map(|ground| ground.altitude_m);
        if let Some(shadows) = &mut self.shadows {
            shadows.plane = ground_m.and_then(|ground_m| ShadowPlane::new(&self.clouds, shadows.direction, ground_m));
        }
        self
    }

    fn shades(&self) -> Vec<Option<Shade>> {
        self.shadows.as_ref().map_or_else(Vec::new, |shadows| between::shades(&self.clouds, shadows))
    }

    fn with_shades(mut self, shades: &[Option<Shade>]) -> Self {
        for (cloud, shade) in self.clouds.iter_mut().zip(shades) {
            cloud.shade.clone_from(shade);
        }
        self
    }

    /// What the clouds' shadows leave of the light over the ground; none if there are none.
    pub fn shadow_map(&self) -> Option<ShadowMap> {
        ShadowMap::new(&self.clouds, self.shadows.as_ref()?)
    }

    /// Another for each shadow that the same clouds cast.
    pub fn shadows_state(&self) -> u64 {
        let mut hasher = FxHasher::default();
        let mut number = |number: f64| number.to_bits().hash(&mut hasher);
        if let Some(Shadows { direction, share, opacity, plane }) = self.shadows {
            direction.to_array().into_iter().chain([share, opacity]).for_each(|share| number(share.into()));
            let of_plane = |plane: ShadowPlane| {
                plane.texel_m.into_iter().for_each(|metres| number(metres.into()));
                plane.from_m.into_iter().chain([plane.ground_m]).for_each(&mut number);
            };
            plane.map(of_plane);
        }
        for cloud in &self.clouds {
            cloud.origin().to_array().into_iter().for_each(&mut number);
            let [sin, cos] = cloud.turn.sin_cos();
            let formed = [cloud.formed.core, cloud.formed.falloff, cloud.opacity, f32::from(u8::from(cloud.casts()))];
            formed.into_iter().chain([sin, cos, cloud.scale, cloud.growth]).for_each(|share| number(share.into()));
        }
        if let Some(air) = self.air() {
            let of = air.lean.to_array().into_iter().chain(air.lean_shear.to_array()).chain(air.swings);
            of.chain([air.turned, air.turbulence, air.humidity]).for_each(|share| number(share.into()));
        }
        hasher.finish()
    }

    /// What they leave of it at a point of the world, 0 to 1.
    pub fn sunlit(&self, point: DVec3) -> f32 {
        self.shadows.as_ref().map_or(1.0, |shadows| shadows.reaches(&self.clouds, point))
    }
}
