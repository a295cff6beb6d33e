//! Fits a model's light to a path tracer's: the brightness of its colour levels, Cmin, Cmed and Cmax, and its self-shadow.
//!
//! One cloud of each model is looked at alone, whole and at rest, from six places around it, by the suns of some hours. A slow
//! path tracer ([`crate::traced`]) says what its vapour would show by the sky's light and by each sun's, each alone and
//! white. A card that faces the sun has the radiance of the scene's greatest directional light; the sky has the mean of the one
//! that is drawn, and what is below the horizon a fifth of it. All of it is then scaled by one factor, so that
//! the cloud stays as bright on the whole as it was: exposure is the artist's.
//!
//! The sprites' picture is linear in the levels' brightness and in the shares, and, for given ones, in the self-shadow. So it
//! is drawn once for a unit of each, by the renderer that ships (`alone.rs`); the rest is least squares in closed form for
//! each of 101 self-shadows (`squares.rs`). Shares are fitted at the cloud's bottom and top (`values.rs`) as Cmin ≥ 0,
//! Cmed − Cmin ≥ 0 and Cmax − Cmed ≥ 0. Hues, heights and opacities stay the artist's, and so does the halo. Light is compared
//! where both the sprites and the vapour show, as radiance by opacity, so that outlines don't matter.

mod alone;
mod likeness;
mod one;
mod squares;
mod values;

pub use likeness::Likeness;
pub use values::{Free, Values};

use crate::color::Rgb;
use crate::document::{Edit, ListEdit};
use crate::scene::{Cloud, HasId, ModelId, Scene};
use crate::sky::Dome;
use crate::sprites::Atlas;
use crate::watch::Watch;
use crate::weather::Light;
use glam::Vec3;

/// Samples a pixel of the path tracer's that are usual.
pub const USUAL_SAMPLES: u32 = 256;
/// And the most.
pub const MOST_SAMPLES: u32 = 65_536;
/// Radiance of what is below the horizon, by the sky's: what a ground sends back of all light (MODEL §10).
const BELOW: f32 = 0.2;
/// Hours that are looked at besides the scene's.
const USUAL_HOURS: [f64; 4] = [8.0, 12.0, 16.0, 20.0];
/// Sine of the sun's least elevation, 2°: lower, the air before it takes its light.
const LOWEST_SUN: f32 = 0.034_899;
/// Cosine of the angle, 3°, within which two suns are one.
const SAME_SUN: f32 = 0.998_630;

/// What is to be fitted.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// These models; empty for all that clouds show.
    pub models: Vec<ModelId>,
    /// Which of their values.
    pub free: Free,
    /// Local civil hours whose suns count; empty for the scene's own hour and those of [`usual_hours`].
    pub hours: Vec<f64>,
    /// Samples a pixel of the path tracer's: twice as many, half the noise's square.
    pub samples: u32,
}

impl Default for Choice {
    fn default() -> Self {
        Self { models: Vec::new(), free: Free::ALL, hours: Vec::new(), samples: USUAL_SAMPLES }
    }
}

/// What came of it.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedLight {
    /// Set the values; one transaction. None for a model that can't be brought nearer.
    pub edits: Vec<Edit>,
    /// Of each model, in the scene's order.
    pub models: Vec<FittedModel>,
    /// The hours whose suns counted.
    pub hours: Vec<f64>,
}

/// What came of one model.
#[derive(Debug, Clone, PartialEq)]
pub struct FittedModel {
    /// Which.
    pub id: ModelId,
    /// For people.
    pub name: String,
    /// How near it was.
    pub before: Likeness,
    /// How near it is.
    pub after: Likeness,
    /// What its light is now; shares as the straight line that is nearest to them.
    pub values: Values,
}

impl FittedModel {
    /// How near its light was and is, and what it is now.
    pub fn in_words(&self) -> [String; 2] {
        let Self { name, before, after, values: Values { levels, shares, self_shadow }, .. } = self;
        let percent = |share: f64| format!("{:.1} %", 100.0 * share);
        let listed =
            |numbers: &[f32]| numbers.iter().map(|number| format!("{number:.2}")).collect::<Vec<_>>().join(" ");
        let [bottom, top] = shares.map(|end| listed(&end));
        let [error, now_error] = [before, after].map(|likeness| percent(likeness.error));
        let [correlation, now_correlation] = [before, after].map(|likeness| likeness.correlation);
        [
            format!(
                "“{name}”: error {error} before, {now_error} after; correlation {correlation:.2} before, \
                 {now_correlation:.2} after"
            ),
            format!(
                "  levels {}; Cmin, Cmed, Cmax {bottom} at the bottom, {top} at the top; self-shadow {self_shadow:.2}",
                listed(levels)
            ),
        ]
    }
}

/// Why nothing is fitted.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum FitError {
    /// All is to stay.
    #[error("nothing is to be fitted")]
    NothingFree,
    /// None of the models has a cloud that shows sprites.
    #[error("no cloud shows any of it")]
    NoClouds,
    /// An hour that was asked for.
    #[error("at {0} h the sun is not above the horizon")]
    SunIsDown(f64),
    /// At none of the usual hours.
    #[error("the sun is not above the horizon at the scene's hour, nor at 8, 12, 16 or 20 h")]
    NeverUp,
    /// The watch was cancelled.
    #[error("cancelled")]
    Cancelled,
}

/// The sun of an hour.
#[derive(Debug, Clone, Copy)]
struct Hour {
    time_h: f64,
    /// To the sun, unit.
    sun: Vec3,
    /// Luminance of the greatest ambient light, which the levels' brightness scales.
    ambient: f64,
    /// Mean luminance of the sky.
    sky_light: f64,
    /// Luminance of the greatest directional light.
    sun_light: f64,
}

/// Fits the light of models of `scene`, whose tiles are those of `atlas`.
///
/// # Errors
/// If there is nothing to fit or nothing to fit it to, or `watch` was cancelled.
pub fn fit_light(scene: &Scene, atlas: &Atlas, choice: &Choice, watch: &Watch) -> Result<FittedLight, FitError> {
    if choice.free.is_none() {
        return Err(FitError::NothingFree);
    }
    let hours = hours(scene, &choice.hours)?;
    let is_meant = |id: ModelId| choice.models.is_empty() || choice.models.contains(&id);
    let meant: Vec<_> = scene.models.iter().filter(|model| is_meant(model.id())).collect();
    let (mut edits, mut models) = (Vec::new(), Vec::new());
    for (done, model) in meant.iter().enumerate() {
        let of_all = |share: f32| watch.reach((done as f32 + share) / meant.len() as f32);
        let shows = |cloud: &&Cloud| cloud.model == model.id && scene.is_seen(cloud);
        if let Some(cloud) = scene.clouds.iter().find(shows) {
            let fitted = one::fit(scene, (cloud, model), atlas, (choice, &hours), &of_all, watch);
            if let Some((fitted, new)) = fitted {
                models.push(fitted);
                edits.extend(new.map(|model| Edit::Model(ListEdit::Replace(model))));
            }
        }
        if watch.is_cancelled() {
            return Err(FitError::Cancelled);
        }
    }
    if models.is_empty() {
        return Err(FitError::NoClouds);
    }
    Ok(FittedLight { edits, models, hours: hours.iter().map(|hour| hour.time_h).collect() })
}

fn sky_light(scene: &Scene, light: &Light) -> f32 {
    let sky = &scene.sky;
    let ground = Rgb::grey(BELOW);
    let dome = Dome::new(light.sun_direction, sky.turbidity as f32, ground, sky.gain as f32, light.directional_max);
    dome.mean_above_horizon().luminance().max(0.0)
}

/// The hours that count if none is chosen: the scene's own, and 8, 12, 16 and 20 o'clock, as far as the sun is up then and
/// stands elsewhere than at the others.
pub fn usual_hours(scene: &Scene) -> Vec<f64> {
    hours(scene, &[]).map(|hours| hours.iter().map(|hour| hour.time_h).collect()).unwrap_or_default()
}

fn hours(scene: &Scene, asked: &[f64]) -> Result<Vec<Hour>, FitError> {
    let hour = |time_h: f64| {
        let light = Light::at(scene, time_h);
        let hour = Hour {
            time_h,
            sun: light.sun_direction,
            ambient: light.ambient_max.rgb.luminance().max(0.0).into(),
            sky_light: sky_light(scene, &light).into(),
            sun_light: light.directional_max.luminance().max(0.0).into(),
        };
        (light.sun_direction.y >= LOWEST_SUN).then_some(hour)
    };
    if !asked.is_empty() {
        return asked.iter().map(|&time_h| hour(time_h).ok_or(FitError::SunIsDown(time_h))).collect();
    }
    let mut hours: Vec<Hour> = Vec::new();
    for hour in [scene.time_of_day_h].into_iter().chain(USUAL_HOURS).filter_map(hour) {
        if hours.iter().all(|other| other.sun.dot(hour.sun) < SAME_SUN) {
            hours.push(hour);
        }
    }
    if hours.is_empty() { Err(FitError::NeverUp) } else { Ok(hours) }
}
