//! The scene's clouds as texels of four words, which render/src/pass/sprites/cloud_data.wgsl reads; a test compares the sizes.

use cloudwright_core::baked::{Around, DIRECTIONS};
use cloudwright_core::camera::View;
use cloudwright_core::facing::Pose;
use cloudwright_core::sprites::{Group, Sprite};
use cloudwright_core::weather::{CloudNow, Light};

#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct SpriteTexels {
    position: [f32; 3],
    width: f32,
    height: f32,
    sin_rotation: f32,
    cos_rotation: f32,
    /// Address of its group, times 16, plus its tile.
    group_and_tile: u32,
}

#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct GroupTexels {
    center: [f32; 3],
    c: [f32; 3],
    unused: [f32; 2],
}

#[derive(Debug, Clone, Copy, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct CloudTexels {
    center: [f32; 3],
    /// 0 for a cloud without extent.
    inverse_radius: f32,
    bottom: f32,
    top: f32,
    level_height_4: f32,
    /// Where what is baked of its sprites begins, counted from where its sprites do; wraps.
    baked_from_sprites: u32,
    level_heights_0_to_3: [f32; 4],
    level_colors: [[f32; 4]; 5],
}

/// A cloud in one frame.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct MomentTexels {
    from_eye: [f32; 3],
    formed_core: f32,
    formed_falloff: f32,
    growth: f32,
    opacity: f32,
    scale: f32,
    /// Sine and cosine.
    turn: [f32; 2],
    /// Negative in air that carries nothing.
    reach_m: f32,
    /// Of the sun's light.
    self_shadow: f32,
    /// The directions around the light's, a byte each, and their shares.
    around: u32,
    shares: [f32; 3],
    /// Sine and cosine of the turn from the model's space.
    heading: [f32; 2],
    halo: f32,
    /// Which of all nodes is the first of its shade's grid, times 2¹⁰; nodes along each axis, five bits each, 0 in the light.
    pub(crate) shade_first_and_size: u32,
    pub(crate) shade_low: [f32; 2],
    pub(crate) shade_nodes_a_metre: [f32; 2],
}

/// What the air makes of a sprite, as [`Stir::packed`].
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub(crate) struct StirTexel(pub(crate) [u32; 4]);

/// The light that is baked of a sprite: its words, and two that are not used.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub(crate) struct BakedTexels([u32; 16]);

/// A sprite near the eye, in one frame.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(C)]
pub(crate) struct PoseTexels {
    towards: [f32; 3],
    fade: f32,
    up: [f32; 3],
    unused: f32,
}

pub(crate) fn sprite_texels(sprite: &Sprite, first_group: u32) -> SpriteTexels {
    let (sin_rotation, cos_rotation) = libm::sincosf(sprite.rotation);
    SpriteTexels {
        position: sprite.position.to_array(),
        width: sprite.width,
        height: sprite.height,
        sin_rotation,
        cos_rotation,
        group_and_tile: ((first_group + sprite.group) << 4) | u32::from(sprite.tile & 15),
    }
}

pub(crate) fn group_texels(group: &Group) -> GroupTexels {
    GroupTexels { center: group.center.to_array(), c: group.c, unused: [0.0; 2] }
}

pub(crate) fn baked_texels(words: &[u32]) -> BakedTexels {
    BakedTexels(std::array::from_fn(|word| words.get(word).copied().unwrap_or_default()))
}

pub(crate) fn cloud_texels(cloud: &CloudNow<'_>, baked_from_sprites: u32) -> CloudTexels {
    let (levels, cloud) = (cloud.color_levels(), cloud.placed);
    let heights = levels.map(|level| level.height as f32);
    let [h0, h1, h2, h3, level_height_4] = heights;
    CloudTexels {
        center: cloud.center.to_array(),
        inverse_radius: if cloud.radius > 0.0 { 1.0 / cloud.radius } else { 0.0 },
        bottom: cloud.bottom,
        top: cloud.top,
        level_height_4,
        baked_from_sprites,
        level_heights_0_to_3: [h0, h1, h2, h3],
        level_colors: levels.map(|level| level.color.to_array()),
    }
}

pub(crate) fn moment_texels(cloud: &CloudNow<'_>, view: &View, light: &Light) -> MomentTexels {
    let Around { at: [a, b, c], share } = DIRECTIONS.around(cloud.in_model(cloud.direction_at_rest(light.direction)));
    let soft_light = cloud.placed.soft_light;
    let as_baked = |share: f32| if cloud.baked.is_some() { share } else { 0.0 };
    MomentTexels {
        from_eye: cloud.from_eye(view.eye).to_array(),
        formed_core: cloud.formed.core,
        formed_falloff: cloud.formed.falloff,
        growth: cloud.growth,
        opacity: cloud.opacity,
        scale: cloud.scale,
        turn: cloud.turn.sin_cos(),
        reach_m: cloud.air.as_ref().map_or(-1.0, |air| air.reach_m),
        self_shadow: as_baked(soft_light.self_shadow),
        around: a | (b << 8) | (c << 16),
        shares: share,
        heading: cloud.placed.heading,
        halo: as_baked(soft_light.halo),
        shade_first_and_size: 0,
        shade_low: [0.0; 2],
        shade_nodes_a_metre: [0.0; 2],
    }
}

pub(crate) fn pose_texels(pose: &Pose) -> PoseTexels {
    PoseTexels { towards: pose.towards.to_array(), fade: pose.fade, up: pose.up.to_array(), unused: 0.0 }
}
