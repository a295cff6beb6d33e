//! How the Rust side lays out what shaders read, for the test that holds it against the shaders themselves.

use crate::{frame_uniform, texels};

/// Each member of the frame's uniform with its offset, bytes, in order.
pub fn frame_uniform() -> Vec<(&'static str, usize)> {
    frame_uniform::FrameUniform::MEMBERS.to_vec()
}

/// Size of the frame's uniform, bytes.
pub fn frame_uniform_size() -> usize {
    size_of::<frame_uniform::FrameUniform>()
}

/// Constants of the sprites' shader with the values that the Rust side computes by.
pub fn sprite_constants() -> Vec<(&'static str, f64)> {
    let count = |size: usize| (size / size_of::<[u32; 4]>()) as f64;
    vec![
        ("DATA_ROW_BITS", f64::from(crate::texture::DATA_ROW_BITS)),
        ("SPRITE_TEXELS", count(size_of::<texels::SpriteTexels>())),
        ("GROUP_TEXELS", count(size_of::<texels::GroupTexels>())),
        ("CLOUD_TEXELS", count(size_of::<texels::CloudTexels>())),
        ("MOMENT_TEXELS", count(size_of::<texels::MomentTexels>())),
        ("BAKED_TEXELS", count(size_of::<texels::BakedTexels>())),
        ("STIR_TEXELS", count(size_of::<texels::StirTexel>())),
        ("POSE_TEXELS", count(size_of::<texels::PoseTexels>())),
        ("FACES_EYE", f64::from(cloudwright_core::draw_list::FACES_EYE)),
        ("TILE_SIZE", cloudwright_core::sprites::TILE_SIZE as f64),
        ("GLOW_KEPT", f64::from(cloudwright_core::sky::GLOW_KEPT)),
        ("GLOW_FROM_COSINE", f64::from(cloudwright_core::sky::GLOW_FROM_COSINE)),
        ("CONDENSING", f64::from(cloudwright_core::weather::CONDENSING)),
        ("SWAY", f64::from(cloudwright_core::weather::SWAY)),
        ("LAST_MIP", (cloudwright_core::sprites::MIP_LEVELS - 1) as f64),
    ]
}
