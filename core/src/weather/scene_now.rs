//! A scene at a moment: all that the clock, or a look at another hour, can change, as plain numbers.

use super::{AirNow, CloudNow, Light, Moment, Timeline, WeatherRules, clouds_now};
use crate::scene::{Aircraft, Ground, List, Prop, Scene};
use crate::sprites::PlacedCloud;

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
        let time_h = moment.time_h.unwrap_or_else(|| timeline.time_of_day_h(scene, moment.clock_s));
        let scene = timeline.surroundings_at(scene, moment.clock_s);
        let sky = &scene.sky;
        Self {
            light: Light::at(&scene, time_h),
            exposure: libm::exp2(sky.exposure_ev) as f32,
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
}
