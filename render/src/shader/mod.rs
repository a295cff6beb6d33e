//! Shaders, joined from snippets: WGSL has no include, so each is the text of what it needs and then its pass's own.
//!
//! No two snippets of one shader define the same name. A new pass adds a function here and a row to [`all`].

const FRAME: &str = include_str!("frame.wgsl");
const MATH: &str = include_str!("math.wgsl");
const DOME: &str = include_str!("dome.wgsl");
const CLOUD_DATA: &str = include_str!("../pass/sprites/cloud_data.wgsl");
const SPRITE_NOW: &str = include_str!("../pass/sprites/sprite_now.wgsl");
const FULL_SCREEN: &str = include_str!("full_screen.wgsl");

/// Sky, sun, moon, stars, ground and haze.
pub fn sky() -> String {
    let night = include_str!("../pass/sky/night.wgsl");
    [FRAME, MATH, DOME, FULL_SCREEN, night, include_str!("../pass/sky/sky.wgsl")].join("\n")
}

/// The sprites.
pub fn sprites() -> String {
    [FRAME, MATH, DOME, CLOUD_DATA, SPRITE_NOW, include_str!("../pass/sprites/sprites.wgsl")].join("\n")
}

/// The clouds' shadows for the ground.
pub fn shadows() -> String {
    [FRAME, MATH, CLOUD_DATA, SPRITE_NOW, include_str!("../pass/shadows/shadows.wgsl")].join("\n")
}

/// The aircraft.
pub fn models() -> String {
    [FRAME, MATH, DOME, include_str!("../pass/models/models.wgsl")].join("\n")
}

/// The air inside a cloud.
pub fn veil() -> String {
    [FRAME, FULL_SCREEN, include_str!("../pass/veil/veil.wgsl")].join("\n")
}

/// The picture in the order that fades out.
pub fn crossfade() -> String {
    [FRAME, FULL_SCREEN, include_str!("../pass/crossfade/crossfade.wgsl")].join("\n")
}

/// Linear light to a display.
pub fn tone_map() -> String {
    [FRAME, FULL_SCREEN, include_str!("../pass/tone_map/tone_map.wgsl")].join("\n")
}

/// Every shader there is, by the name of its pass; for tests that need no GPU.
pub fn all() -> Vec<(&'static str, String)> {
    vec![
        ("sky", sky()),
        ("shadows", shadows()),
        ("models", models()),
        ("sprites", sprites()),
        ("crossfade", crossfade()),
        ("veil", veil()),
        ("tone_map", tone_map()),
    ]
}

pub(crate) fn module(device: &wgpu::Device, label: &str, source: String) -> wgpu::ShaderModule {
    device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some(label),
        source: wgpu::ShaderSource::Wgsl(source.into()),
    })
}
