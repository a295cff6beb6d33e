//! How the Rust side lays out what shaders read, for the test that holds it against the shaders themselves.

use crate::{cloud_data, frame_uniform};

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
    let texels = |size: usize| (size / size_of::<[u32; 4]>()) as f64;
    vec![
        ("DATA_ROW_BITS", f64::from(crate::texture::DATA_ROW_BITS)),
        ("SPRITE_TEXELS", texels(size_of::<cloud_data::SpriteTexels>())),
        ("GROUP_TEXELS", texels(size_of::<cloud_data::GroupTexels>())),
        ("CLOUD_TEXELS", texels(size_of::<cloud_data::CloudTexels>())),
        ("MOMENT_TEXELS", texels(size_of::<cloud_data::MomentTexels>())),
        ("BAKED_TEXELS", texels(size_of::<cloud_data::BakedTexels>())),
        ("STIR_TEXELS", texels(size_of::<cloud_data::StirTexel>())),
        ("POSE_TEXELS", texels(size_of::<cloud_data::PoseTexels>())),
        ("FACES_EYE", f64::from(cloudwright_core::draw_list::FACES_EYE)),
        ("TILE_SIZE", cloudwright_core::sprites::TILE_SIZE as f64),
        ("GLOW_KEPT", f64::from(cloudwright_core::sky::GLOW_KEPT)),
        ("GLOW_FROM_COSINE", f64::from(cloudwright_core::sky::GLOW_FROM_COSINE)),
        ("CONDENSING", f64::from(cloudwright_core::weather::CONDENSING)),
        ("SWAY", f64::from(cloudwright_core::weather::SWAY)),
        ("LAST_MIP", (cloudwright_core::sprites::MIP_LEVELS - 1) as f64),
    ]
}
