// What stands behind the clouds: sky, sun, moon and stars, ground and the haze between. The twin of core/src/sky/.

@group(1) @binding(0) var shadow_map: texture_2d<f32>;
@group(1) @binding(1) var shadow_sampler: sampler;

// core/src/weather/shadows/mod.rs.
const UNDER_A_CLOUD = vec2f(0.45, 0.55);
const MOST_TEXELS = 512.0;

@fragment
fn draw_background(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let direction = normalize(ray_through(position.xy));
    if !(frame.ground_eye_height_m > 0.0 && direction.y < -1e-5) {
        if frame.moon + frame.stars <= 0.0 {
            return vec4f(dome_radiance(direction), 1.0);
        }
        return vec4f(dome_radiance(direction) + night_lights(direction), 1.0);
    }
    let distance_m = -frame.ground_eye_height_m / direction.y;
    let pixel_m = distance_m * frame.pixel / max(abs(direction.y), 1e-6);
    let ground = ground_radiance(direction * distance_m, pixel_m);
    return vec4f(mix(ground, horizon_radiance(direction), haze_share(distance_m)), 1.0);
}

// Radiance of the ground at an eye-relative point, where a pixel covers `pixel_m` metres.
fn ground_radiance(point: vec3f, pixel_m: f32) -> vec3f {
    let place = frame.ground_eye_in_pattern_m + point.xz;
    let cells_m = frame.ground_cells_m;
    let sum = octave_noise(place, 0u, cells_m.x, pixel_m, 0.5)
        + octave_noise(place, 1u, cells_m.y, pixel_m, 0.35)
        + octave_noise(place, 2u, cells_m.z, pixel_m, 0.245)
        + octave_noise(place, 3u, cells_m.w, pixel_m, 0.1715);
    let lit = mix(frame.ground_dark, frame.ground_bright, smoothstep(-0.22, 0.22, sum));
    if frame.shadow_share <= 0.0 {
        return lit;
    }
    return lit * mix(frame.ground_without_sun, vec3f(1.0), reaches_ground(point));
}

// Of the directional light, what the clouds' shadows leave at an eye-relative point of the ground.
fn reaches_ground(point: vec3f) -> f32 {
    let at = vec2f(dot(point, frame.shadow_level), dot(point, frame.shadow_upwards));
    let place = vec2f(frame.shadow_eye_x, frame.shadow_eye_y) + at / frame.shadow_texel_m;
    let left = textureSampleLevel(shadow_map, shadow_sampler, place / MOST_TEXELS, 0.0).r;
    let left_4 = (left * left) * (left * left);
    return 1.0 - frame.shadow_share * (1.0 - (UNDER_A_CLOUD.x * left + UNDER_A_CLOUD.y * left_4 * left_4));
}

// One lattice's share, around 0. Where its cells are smaller than a pixel there is nothing to hash.
fn octave_noise(place: vec2f, octave: u32, cell_m: f32, pixel_m: f32, weight: f32) -> f32 {
    let shown = 1.0 - smoothstep(0.25, 0.75, pixel_m / cell_m);
    if shown <= 0.0 {
        return 0.0;
    }
    return weight * shown * (lattice_noise(place / cell_m, octave, cell_m) - 0.5);
}

// Value noise in 0 to 1: smooth between random values at whole numbers.
fn lattice_noise(place: vec2f, octave: u32, cell_m: f32) -> f32 {
    let cell = floor(place);
    let t = place - cell;
    let fade = t * t * (3.0 - 2.0 * t);
    let period = i32(frame.ground_period_m / cell_m);
    let low = wrap(vec2i(cell), period);
    let high = wrap(vec2i(cell) + 1, period);
    let near_row = plain_mix(hash(low.x, low.y, octave), hash(high.x, low.y, octave), fade.x);
    let far_row = plain_mix(hash(low.x, high.y, octave), hash(high.x, high.y, octave), fade.x);
    return plain_mix(near_row, far_row, fade.y);
}

fn plain_mix(a: f32, b: f32, t: f32) -> f32 {
    return a + (b - a) * t;
}

// The remainder that is never negative. GLSL leaves that of negative numbers undefined, so as many whole periods are
// added first as no ground lies far away.
fn wrap(cell: vec2i, period: i32) -> vec2u {
    return (bitcast<vec2u>(cell) + u32(period) * 1048576u) % u32(period);
}

// 0 to 1 from three numbers, bit for bit as in core/src/sky/ground.rs (O'Neill's PCG-RXS-M-XS, 2014).
fn hash(x: u32, z: u32, octave: u32) -> f32 {
    let state = ((x * 73856093u) ^ (z * 19349663u) ^ (octave * 83492791u)) * 747796405u + 2891336453u;
    let word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return f32(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}
