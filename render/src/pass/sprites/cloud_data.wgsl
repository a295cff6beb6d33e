// The scene's sprites, groups and clouds in data textures: texel after texel of four words, in rows of
// 2^DATA_ROW_BITS. The Rust side is texels.rs; a test compares the sizes. OpenGL ES 3.0 has no storage buffers.

const DATA_ROW_BITS = 11u;
const SPRITE_TEXELS = 2u;
const GROUP_TEXELS = 2u;
const CLOUD_TEXELS = 8u;
const MOMENT_TEXELS = 6u;
const BAKED_TEXELS = 4u;
const STIR_TEXELS = 1u;
const POSE_TEXELS = 2u;
// In place of a pose: the sprite simply faces the eye.
const FACES_EYE = 0xffffffffu;

@group(1) @binding(0) var sprite_data: texture_2d<u32>;
@group(1) @binding(1) var group_data: texture_2d<u32>;
@group(1) @binding(2) var cloud_data: texture_2d<u32>;
// Written every frame: of each cloud where it lies from the eye, how far it has formed, how it has grown and turned; the
// sprites near the eye.
@group(1) @binding(3) var moment_data: texture_2d<u32>;
@group(1) @binding(4) var pose_data: texture_2d<u32>;
// What the air makes of each sprite; of a scene without weather there is none.
@group(1) @binding(7) var stir_data: texture_2d<u32>;
// The light that is left at each sprite from each of a set of directions; of a scene that is lit by groups alone there is none.
@group(1) @binding(8) var baked_data: texture_2d<u32>;
// What other clouds take of the light, on each cloud's grid.
@group(1) @binding(9) var shade_data: texture_2d<u32>;

struct Sprite {
    position: vec3f,
    width: f32,
    height: f32,
    // Sine and cosine: a shader's own may be off by 2⁻¹¹.
    rotation: vec2f,
    group: u32,
    tile: u32,
}

struct Group {
    center: vec3f,
    c: vec3f,
}

struct Cloud {
    center: vec3f,
    inverse_radius: f32,
    bottom: f32,
    top: f32,
    heights: vec4f,
    height_4: f32,
    color_0: vec4f,
    color_1: vec4f,
    color_2: vec4f,
    color_3: vec4f,
    color_4: vec4f,
    baked_from_sprites: u32,
}

struct Moment {
    from_eye: vec3f,
    formed_core: f32,
    formed_falloff: f32,
    growth: f32,
    opacity: f32,
    scale: f32,
    // Sine and cosine, counter-clockwise from above.
    turn: vec2f,
    // How far edges can be carried, metres; negative in air that carries nothing.
    reach_m: f32,
    // Of the sun's light; the directions around it, a byte each, and their shares.
    self_shadow: f32,
    around: vec3u,
    shares: vec3f,
    // Sine and cosine of the turn from the model's space.
    heading: vec2f,
    halo: f32,
    // The grid of what other clouds take of the light: its first node, which that is of all, nodes a metre, and nodes along
    // each axis; none in the light.
    shade_low: vec2f,
    shade_nodes_a_metre: vec2f,
    shade_first: u32,
    shade_size: vec2u,
}

// core/src/sprites/stir.rs.
struct Stir {
    looseness: f32,
    threshold: f32,
    turn: f32,
    sway: f32,
    phases: vec3f,
}

struct Pose {
    towards: vec3f,
    up: vec3f,
    fade: f32,
}

fn load_bits(data: texture_2d<u32>, address: u32) -> vec4u {
    return textureLoad(data, vec2u(address & ((1u << DATA_ROW_BITS) - 1u), address >> DATA_ROW_BITS), 0);
}

fn load(data: texture_2d<u32>, address: u32) -> vec4f {
    return bitcast<vec4f>(load_bits(data, address));
}

fn load_sprite(index: u32) -> Sprite {
    let first = load(sprite_data, index * SPRITE_TEXELS);
    let second = load_bits(sprite_data, index * SPRITE_TEXELS + 1u);
    let floats = bitcast<vec4f>(second);
    return Sprite(first.xyz, first.w, floats.x, floats.yz, second.w >> 4u, second.w & 15u);
}

fn load_group(index: u32) -> Group {
    let first = load(group_data, index * GROUP_TEXELS);
    let second = load(group_data, index * GROUP_TEXELS + 1u);
    return Group(first.xyz, vec3f(first.w, second.xy));
}

fn load_cloud(index: u32) -> Cloud {
    let at = index * CLOUD_TEXELS;
    let sphere = load(cloud_data, at);
    let extent = load(cloud_data, at + 1u);
    return Cloud(
        sphere.xyz,
        sphere.w,
        extent.x,
        extent.y,
        load(cloud_data, at + 2u),
        extent.z,
        load(cloud_data, at + 3u),
        load(cloud_data, at + 4u),
        load(cloud_data, at + 5u),
        load(cloud_data, at + 6u),
        load(cloud_data, at + 7u),
        load_bits(cloud_data, at + 1u).w,
    );
}

fn load_moment(cloud: u32) -> Moment {
    let first = load(moment_data, cloud * MOMENT_TEXELS);
    let second = load(moment_data, cloud * MOMENT_TEXELS + 1u);
    let third = load(moment_data, cloud * MOMENT_TEXELS + 2u);
    let around = load_bits(moment_data, cloud * MOMENT_TEXELS + 3u);
    let fifth = load(moment_data, cloud * MOMENT_TEXELS + 4u);
    let sixth = load(moment_data, cloud * MOMENT_TEXELS + 5u);
    let shade = bitcast<u32>(fifth.w);
    return Moment(
        first.xyz,
        first.w,
        second.x,
        second.y,
        second.z,
        second.w,
        third.xy,
        third.z,
        third.w,
        vec3u(around.x, around.x >> 8u, around.x >> 16u) & vec3u(255u),
        bitcast<vec3f>(around.yzw),
        fifth.xy,
        fifth.z,
        sixth.xy,
        sixth.zw,
        shade >> 10u,
        vec2u(shade, shade >> 5u) & vec2u(31u),
    );
}

fn load_stir(sprite: u32) -> Stir {
    let bits = load_bits(stir_data, sprite * STIR_TEXELS);
    let shares = unpack2x16snorm(bits.z);
    let phases = vec3u(bits.w, bits.w >> 10u, bits.w >> 20u) & vec3u(1023u);
    return Stir(bitcast<f32>(bits.x), bitcast<f32>(bits.y), shares.x, shares.y, vec3f(phases) / 1024.0);
}

// The light that is left at a sprite from the direction of that number, e^(−τ/10): at its middle, and how it changes along the
// model's axes (core/src/baked/mod.rs).
fn load_left(sprite: u32, direction: u32) -> vec4f {
    let words = load_bits(baked_data, sprite * BAKED_TEXELS + (direction >> 2u));
    let word = words[direction & 3u];
    return vec4f(f32(word & 255u) / 255.0, unpack4x8snorm(word).yzw);
}

// What other clouds leave of the light at a point that counts from the cloud's origin (core/src/weather/shade.rs).
fn shade_at(moment: Moment, point: vec3f) -> f32 {
    let size = moment.shade_size;
    if size.x == 0u {
        return 1.0;
    }
    let last = vec2f(size - 1u);
    let along = vec2f(dot(point, frame.shadow_level), dot(point, frame.shadow_upwards));
    let place = clamp((along - moment.shade_low) * moment.shade_nodes_a_metre, vec2f(0.0), last);
    let first = min(floor(place), last - 1.0);
    let share = place - first;
    let at = moment.shade_first + u32(first.y) * size.x + u32(first.x);
    let above = mix(load(shade_data, at).xyz, load(shade_data, at + 1u).xyz, share.x);
    let below = mix(load(shade_data, at + size.x).xyz, load(shade_data, at + size.x + 1u).xyz, share.x);
    let met = mix(above, below, share.y);
    if met.x <= 0.0 {
        return 1.0;
    }
    // As much of it as lies from the point towards the light.
    let before = clamp(0.5 + 0.5 * (met.y - dot(point, frame.light_direction) * met.x) / max(met.z, 1e-6), 0.0, 1.0);
    return 1.0 - frame.shadow_share * (1.0 - exp(-0.1 * met.x * before));
}

fn load_pose(index: u32) -> Pose {
    let first = load(pose_data, index * POSE_TEXELS);
    return Pose(first.xyz, load(pose_data, index * POSE_TEXELS + 1u).xyz, first.w);
}
