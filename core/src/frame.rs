//! One picture's worth of input: what both renderers draw from.

use crate::camera::View;
use crate::color::Rgb;
use crate::derived::Derived;
use crate::detail::Subset;
use crate::draw_list::{Choice, DrawList, DrawSprite};
use crate::facing::Poses;
use crate::model_in_view::{ModelInView, models_in_view};
use crate::posed_sprite::PosedSprite;
use crate::rules::Rules;
use crate::scene::Scene;
use crate::shading::{Veil, veil};
use crate::sight::Sight;
use crate::sky::{Background, Dome, GroundLook, GroundShadow, NightSky};
use crate::sprites::{Atlas, PlacedCloud};
use crate::version::Version;
use crate::weather::{KeptShadows, SceneNow};
use glam::DVec3;
use std::sync::Arc;

/// A scene's clouds, light and background as one eye sees them at one moment.
#[derive(Debug, Clone)]
pub struct Frame<'a> {
    /// The eye and the picture's size.
    pub view: View,
    /// The moment: light, exposure, and the clouds as they are now; the list counts into these.
    pub now: SceneNow<'a>,
    /// Sky, ground and haze; [`Frame::behind`] has the shadows on it.
    pub background: Background,
    /// The same clouds at rest.
    pub clouds: &'a [PlacedCloud],
    /// Tells this state of the clouds from every other.
    pub clouds_version: Version,
    /// The sprites in view, back to front.
    pub list: DrawList,
    /// The same in the order that fades out, with its share of the picture.
    pub fading: Option<(DrawList, f32)>,
    /// Before everything: the air inside a cloud.
    pub veil: Veil,
    /// What the sun adds to the veil's colour; the rest is the sky's.
    pub veil_directional: Rgb,
    /// Their tiles.
    pub atlas: &'a Atlas,
    /// By which rules it is drawn.
    pub rules: Rules,
    /// The aircraft and props in view, in any order.
    pub models: Vec<ModelInView>,
    /// The clouds' shadows, kept for the next frame; those on the ground are drawn when asked for.
    pub shadows: KeptShadows,
}

impl<'a> Frame<'a> {
    /// What is seen of `scene`, whose `derived` is, with the tiles of `atlas`. It is of as many pixels as the sight's rules
    /// take samples.
    pub fn new(scene: &Scene, derived: &'a Derived, atlas: &'a Atlas, sight: &Sight) -> Self {
        derived.bake_on_demand();
        let of = (derived.clouds(), &**derived.timeline());
        let hidden = &sight.hidden.clouds;
        let now = SceneNow::unshaded(scene, of, sight.moment, sight.rules.of_weather())
            .hiding(|cloud| hidden.contains(&cloud.placed.id))
            .shaded_as_kept(derived.shadows(), derived.version());
        let frame = Self::of(now, derived, atlas, sight);
        let models = models_in_view(&scene.paths, &frame.now, &sight.meshes, sight.moment.clock_s, frame.view.eye);
        Self { models, ..frame }
    }

    /// As [`Frame::new`], but without models, of a scene `now`, whatever the sight's moment is.
    pub fn of(now: SceneNow<'a>, derived: &'a Derived, atlas: &'a Atlas, sight: &Sight) -> Self {
        let Sight { hidden, history, rules, .. } = sight;
        let (clouds, clouds_version) = (&now.clouds, derived.version());
        let view = sight.view();
        let subset = &Subset::new(rules.detail, clouds, atlas);
        let mut poses = Poses::new(&rules.facing, clouds, derived.shapes(), &view, &history.facing);
        if !subset.is_all() {
            poses.retain(|cloud, at| subset.has(cloud, &clouds[cloud].placed.sprites[at as usize], at));
        }
        let haze_length_m = if hidden.haze { f32::INFINITY } else { now.haze_length_m };
        let choice = Choice { clouds, poses: &poses, subset, hidden, haze_length_m };
        let (order, fading) = history.order.orders();
        let (veil, veil_directional) = veil((clouds, &poses), (&view, &now.light, atlas, hidden), now.inside_density);
        Self {
            background: background(&now, view.eye).without(hidden),
            list: DrawList::new(&choice, &view, order),
            fading: fading.map(|(order, share)| (DrawList::new(&choice, &view, Some(order)), share)),
            veil,
            veil_directional,
            clouds: derived.clouds(),
            clouds_version,
            atlas,
            rules: *rules,
            models: Vec::new(),
            shadows: derived.shadows().clone(),
            view,
            now,
        }
    }

    /// What stands behind the clouds, with their shadows on it, for who draws on the CPU.
    pub fn behind(&self) -> Background {
        let mut behind = self.background.clone();
        if let (Some(ground), Some(shadows)) = (&mut behind.ground, self.now.shadows) {
            let of = (self.clouds_version, self.now.shadows_state());
            let map = self.shadows.map.of(of, || self.now.shadow_map().map(Arc::new));
            ground.shadow = map.map(|map| GroundShadow::new(map, shadows, self.view.eye));
        }
        behind
    }

    /// A sprite of the list, as this eye sees it.
    pub fn posed(&self, drawn: &DrawSprite) -> PosedSprite<'_> {
        let cloud = &self.now.clouds[drawn.cloud as usize];
        PosedSprite::new(cloud, drawn.sprite as usize, self.list.pose(drawn, &self.view), &self.now.light)
    }

    /// The same frame in the order that fades out, alone, with its share of the picture.
    pub fn older(&self) -> Option<(Self, f32)> {
        let (list, share) = self.fading.clone()?;
        Some((Self { list, fading: None, ..self.clone() }, share))
    }
}

/// What stands behind the clouds of a scene `now`, as it is from an `eye`.
pub(crate) fn background(now: &SceneNow<'_>, eye: DVec3) -> Background {
    let SceneNow { light, ground, .. } = now;
    let night = light.night.as_ref().map(|night| NightSky::new(night, light.sun_direction, now.sky_gain));
    let albedo = ground.as_ref().map_or(Rgb::grey(0.1), |ground| ground.dark.mix(ground.bright, 0.5));
    Background {
        dome: Dome {
            night,
            ..Dome::new(light.sun_direction, now.turbidity, albedo, now.sky_gain, light.directional_max)
        },
        ground: ground.as_ref().and_then(|ground| GroundLook::new(ground, eye, light)),
        haze_length_m: now.haze_length_m,
    }
}
