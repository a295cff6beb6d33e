//! What the targets of a frame hold for each pixel.

/// The target that sprites are blended in: linear, premultiplied.
pub(crate) const LINEAR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;
/// How near the models are: 1 at the near plane, 0 at infinity.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;
/// What is left of the light on the plane across it.
pub(crate) const SHADOW_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R16Float;
/// The finished picture; its values are sRGB-encoded already.
pub(crate) const DISPLAY_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;
