//! The fast renderer's picture in layers.
//!
//! Clouds are drawn once, in four lights side by side: the sky's and the sun's on each sprite, what haze adds, and, as a
//! light of their own, how far away each sprite is and how it moves. So every layer has been through the same blending,
//! and their sum is the picture. The sprites' order, the early stop and the veil are the picture's.

use super::bins::TileRect;
use super::fast::{Lit, TileRow, draw_lights};
use super::{Glow, ScreenSprite, faded, prepare};
use crate::camera::View;
use crate::color::Rgb;
use crate::derived::Derived;
use crate::draw_list::DrawSprite;
use crate::frame::Frame;
use crate::image::{LayeredPixel, Layers};
use crate::rules::Blending;
use crate::scene::Scene;
use crate::sight::Sight;
use crate::sky::{BackgroundRows, haze_share};
use crate::tone::Planes;
use crate::weather::SceneNow;
use rayon::prelude::*;

/// Ambient, directional, haze, and distance with motion.
const LIGHTS: usize = 4;

/// Where eye and clouds are a frame later: what motion leads to.
#[derive(Debug, Clone)]
pub struct Later<'a> {
    view: View,
    now: SceneNow<'a>,
}

impl<'a> Later<'a> {
    /// What `sight`, that of the next frame, sees of a scene whose `derived` is.
    pub fn new(scene: &Scene, derived: &'a Derived, sight: &Sight) -> Self {
        let (clouds, timeline, rules) = (derived.clouds(), derived.timeline(), sight.rules.of_weather());
        Self { view: sight.view(), now: SceneNow::new(scene, (clouds, timeline), sight.moment, rules) }
    }
}

/// The frame in layers, with pixels done when less than `blending` gets through. Motion is that until `later`, of
/// the same scene.
pub fn layers(frame: &Frame<'_>, later: &Later<'_>, blending: Blending) -> Layers {
    faded(frame, |frame| in_order(frame, later, blending), Layers::mix)
}

fn in_order(frame: &Frame<'_>, later: &Later<'_>, blending: Blending) -> Layers {
    let sprites = &prepare(frame);
    let drawn = frame.list.sprites.par_iter().zip(sprites).with_min_len(256);
    let lights: Vec<[Glow; LIGHTS]> = drawn.map(|(drawn, sprite)| lights(frame, later, drawn, sprite)).collect();
    let veil = frame.veil;
    let ambient = Rgb::new(veil.r, veil.g, veil.b) + frame.veil_directional * -1.0;
    let lit = Lit {
        sprites,
        lights: |index: usize| lights[index],
        // The air around the eye is no distance away, and goes with it.
        veil: ([ambient, frame.veil_directional, Rgb::BLACK, Rgb::BLACK], veil.a),
    };
    let behind_all = frame.behind();
    let background = BackgroundRows::new(&behind_all, &frame.view);
    let finish = |rect: TileRect, row: u32, clouds: &TileRow<'_, LIGHTS>, out: &mut [LayeredPixel]| {
        let (left, y) = (rect.left, rect.top + row);
        let mut behind: Planes<32> = [[0.0; 32]; 3];
        background.row(left, y, out.len(), &mut behind);
        for (x, pixel) in out.iter_mut().enumerate() {
            let [ambient, directional, haze, [depth_sum, across, up]] =
                clouds.lights.each_ref().map(|light| light.each_ref().map(|plane| plane[x]));
            let [r, g, b] = behind.each_ref().map(|plane| plane[x]);
            let (behind, is_ground) = (Rgb::new(r, g, b), background.is_ground(left + x as u32, y));
            let model = clouds.model(x);
            let is_ground = is_ground && model.is_none();
            let (sky, ground) = match (&model, is_ground) {
                (Some(_), _) => (Rgb::BLACK, Rgb::BLACK),
                (None, true) => (Rgb::BLACK, behind),
                (None, false) => (behind, Rgb::BLACK),
            };
            let [ambient, directional, haze] = [ambient, directional, haze].map(|[r, g, b]| Rgb::new(r, g, b));
            *pixel = LayeredPixel {
                ambient,
                directional,
                haze,
                alpha: 1.0 - clouds.through[x],
                depth_sum,
                motion_sum: [across, up],
                sky,
                ground,
                ground_share: if is_ground { 1.0 } else { 0.0 },
                models: model.unwrap_or(Rgb::BLACK),
                models_share: if model.is_some() { 1.0 } else { 0.0 },
            };
        }
    };
    let pixels = draw_lights(frame, &lit, blending, LayeredPixel::default(), finish);
    Layers { width: frame.view.width, height: frame.view.height, pixels }
}

fn lights(frame: &Frame<'_>, later: &Later<'_>, drawn: &DrawSprite, sprite: &ScreenSprite) -> [Glow; LIGHTS] {
    let posed = frame.posed(drawn);
    let clear = 1.0 - haze_share(drawn.center.length(), frame.background.haze_length_m);
    let lit = posed.corners(drawn.center).map(|corner| posed.light_at(corner - drawn.center));
    let glow = |corners| Glow { corners, added: [0.0; 3] };
    let added = |added| Glow { corners: [[0.0; 3]; 4], added };
    let [across, up] = motion(frame, later, drawn, sprite).unwrap_or_default();
    [
        glow(lit.map(|light| (light.ambient.rgb * clear).to_array())),
        glow(lit.map(|light| (light.directional * clear).to_array())),
        added(sprite.haze),
        added([drawn.center.length(), across, up]),
    ]
}

/// How far the sprite moves until `later`, pixels to the right and up, where it is nearest to its centre within the
/// picture; unknown of one that is not before the eye at both times.
fn motion(frame: &Frame<'_>, later: &Later<'_>, drawn: &DrawSprite, sprite: &ScreenSprite) -> Option<[f32; 2]> {
    let cloud = later.now.clouds.get(drawn.cloud as usize)?;
    if sprite.denominator.at_anchor <= 0.0 {
        return None;
    }
    let depth = sprite.depth / sprite.denominator.at_anchor;
    let center = cloud.from_eye(later.view.eye) + cloud.sprite_now(drawn.sprite as usize).position;
    let point = frame.view.ray(sprite.anchor.x, sprite.anchor.y) * depth;
    let moved = later.view.project(point + (center - drawn.center))? - sprite.anchor;
    moved.is_finite().then_some([moved.x, -moved.y])
}
