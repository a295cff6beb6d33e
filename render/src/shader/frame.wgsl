// What every pass knows of the frame. The twin of FrameUniform in frame_uniform.rs: same names, same order; a test
// compares the two.
struct Frame {
    right_in_world: vec3f,
    // Length of a pixel's side on a plane at distance 1.
    pixel: f32,
    up_in_world: vec3f,
    width_px: f32,
    forward_in_world: vec3f,
    height_px: f32,
    // To what the directional light comes from: the sun, or at night the moon.
    light_direction: vec3f,
    haze_length_m: f32,
    ambient_max: vec4f,
    directional_max: vec3f,
    exposure: f32,
    // A to I of Hosek and Wilkie's model, each for red, green and blue.
    dome_parameters: array<vec4f, 9>,
    dome_scale: vec3f,
    near_m: f32,
    sun_disc: vec3f,
    // 0 where there is no ground below the eye.
    ground_eye_height_m: f32,
    dome_sun_direction: vec3f,
    ground_period_m: f32,
    glow_direction: vec3f,
    horizon_sine: f32,
    ground_dark: vec3f,
    sun_disc_cosine_from: f32,
    ground_bright: vec3f,
    sun_disc_cosine_to: f32,
    ground_eye_in_pattern_m: vec2f,
    // Sines of the elevation between which a sprite's upright turns from the world's up to the camera's.
    pole_sines: vec2f,
    ground_cells_m: vec4f,
    // Premultiplied, before everything.
    veil: vec4f,
    // The air that moves sprites one by one (core/src/weather/air.rs).
    air_lean: vec3f,
    air_turned: f32,
    air_lean_shear: vec3f,
    air_turbulence: f32,
    air_swings: vec3f,
    air_humidity: f32,
    // The night's (core/src/sky/night.rs); all 0 by day.
    glow_overhead: vec3f,
    stars: f32,
    glow_at_horizon: vec3f,
    moon: f32,
    moon_direction: vec3f,
    moon_radius: f32,
    celestial_from_world: array<vec4f, 3>,
    // The plane of the clouds' shadows (core/src/weather/shadows/plane.rs): its axes, where on it the eye is, texels, how much
    // of them is seen, and what is left of the ground's light in the deepest.
    shadow_level: vec3f,
    shadow_eye_x: f32,
    shadow_upwards: vec3f,
    shadow_eye_y: f32,
    ground_without_sun: vec3f,
    shadow_share: f32,
    shadow_texel_m: vec2f,
    unused: vec2f,
}

@group(0) @binding(0) var<uniform> frame: Frame;

// The ray through a pixel coordinate, of length 1 along the view direction.
fn ray_through(position_px: vec2f) -> vec3f {
    return frame.forward_in_world
        + frame.right_in_world * ((position_px.x - 0.5 * frame.width_px) * frame.pixel)
        + frame.up_in_world * ((0.5 * frame.height_px - position_px.y) * frame.pixel);
}

// An eye-relative point in clip space. Depth is reversed: 1 at the near plane, 0 at infinity.
fn project(point: vec3f) -> vec4f {
    let depth = dot(point, frame.forward_in_world);
    let to_clip = 2.0 / (frame.pixel * vec2f(frame.width_px, frame.height_px));
    let on_plane = vec2f(dot(point, frame.right_in_world), dot(point, frame.up_in_world));
    return vec4f(on_plane * to_clip, frame.near_m, depth);
}
