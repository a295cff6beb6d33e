// The picture in the order that fades out; how much of it is taken, the blending says.

@group(1) @binding(0) var older_picture: texture_2d<f32>;

@fragment
fn fade(@builtin(position) position: vec4f) -> @location(0) vec4f {
    return textureLoad(older_picture, vec2u(position.xy), 0);
}
