// What stands behind the clouds: sky, sun, ground and the haze between. The twin of render/src/pass/sky/sky.wgsl.

// 0 where there is no ground below the eye.
uniform float ground_eye_height_m;
uniform vec2 ground_eye_in_pattern_m;
uniform vec3 ground_dark;
uniform vec3 ground_bright;
// The clouds' shadows: what is left of the light on the plane across it, its axes, where on it the eye is, texels, how much of
// them is seen, and what is left of the ground's light in the deepest.
uniform sampler2D shadow_map;
uniform vec3 shadow_axes[2];
uniform vec2 shadow_eye;
uniform vec2 shadow_texel_m;
uniform float shadow_share;
uniform vec3 ground_without_sun;
out vec4 light;

// O'Neill's PCG-RXS-M-XS (2014): 0 to 1 from three numbers, bit for bit as in core/src/sky/ground.rs.
float hash(uint x, uint z, uint octave) {
    uint state = ((x * 73856093u) ^ (z * 19349663u) ^ (octave * 83492791u)) * 747796405u + 2891336453u;
    uint word = ((state >> ((state >> 28u) + 4u)) ^ state) * 277803737u;
    return float(((word >> 22u) ^ word) >> 8u) / 16777216.0;
}

// The remainder that is never negative: whole periods are added first.
uvec2 wrap(ivec2 cell, uint period) {
    return (uvec2(cell) + period * 1048576u) % period;
}

float lattice_noise(vec2 place, uint octave, float cell_m) {
    vec2 cell = floor(place);
    vec2 t = place - cell;
    vec2 fade = t * t * (3.0 - 2.0 * t);
    uint period = uint(GROUND_PERIOD_M / cell_m);
    uvec2 low = wrap(ivec2(cell), period);
    uvec2 high = wrap(ivec2(cell) + 1, period);
    float near_row = mix(hash(low.x, low.y, octave), hash(high.x, low.y, octave), fade.x);
    float far_row = mix(hash(low.x, high.y, octave), hash(high.x, high.y, octave), fade.x);
    return mix(near_row, far_row, fade.y);
}

// One lattice's share, around 0; none where its cells are smaller than a pixel.
float octave_noise(vec2 place, uint octave, float cell_m, float pixel_m, float weight) {
    float shown = 1.0 - smoothstep(0.25, 0.75, pixel_m / cell_m);
    if (shown <= 0.0) {
        return 0.0;
    }
    return weight * shown * (lattice_noise(place / cell_m, octave, cell_m) - 0.5);
}

// Of the directional light, what the clouds' shadows leave at an eye-relative point of the ground.
float reaches_ground(vec3 point) {
    vec2 place = shadow_eye + vec2(dot(point, shadow_axes[0]), dot(point, shadow_axes[1])) / shadow_texel_m;
    float left = texture(shadow_map, place / SHADOW_TEXELS).r;
    float left_4 = (left * left) * (left * left);
    return 1.0 - shadow_share * (1.0 - (UNDER_A_CLOUD_SCATTERED * left + UNDER_A_CLOUD_STRAIGHT * left_4 * left_4));
}

vec3 ground_radiance(vec3 point, float pixel_m) {
    vec2 place = ground_eye_in_pattern_m + point.xz;
    float sum = octave_noise(place, 0u, GROUND_CELL_0_M, pixel_m, 0.5)
        + octave_noise(place, 1u, GROUND_CELL_1_M, pixel_m, 0.35)
        + octave_noise(place, 2u, GROUND_CELL_2_M, pixel_m, 0.245)
        + octave_noise(place, 3u, GROUND_CELL_3_M, pixel_m, 0.1715);
    vec3 lit = mix(ground_dark, ground_bright, smoothstep(-0.22, 0.22, sum));
    return shadow_share > 0.0 ? lit * mix(ground_without_sun, vec3(1.0), reaches_ground(point)) : lit;
}

// The plain cosine of nearly equal vectors has no bits left for a disc half a degree wide.
vec3 dome_radiance(vec3 direction) {
    vec3 apart = direction - sun_direction;
    float cos_sun = 1.0 - 0.5 * dot(apart, apart);
    vec3 sky = distribution(lifted_sine(direction.y), cosine_to_glow(direction));
    return sky + sun_disc * smoothstep(SUN_DISC_COSINE_FROM, SUN_DISC_COSINE_TO, cos_sun);
}

void main() {
    vec2 from_middle = (gl_FragCoord.xy - 0.5 * size_px) * pixel;
    vec3 direction =
        normalize(forward_in_world + right_in_world * from_middle.x + up_in_world * from_middle.y);
    light.a = 1.0;
    if (!(ground_eye_height_m > 0.0 && direction.y < -1e-5)) {
        light.rgb = dome_radiance(direction);
        return;
    }
    float distance_m = -ground_eye_height_m / direction.y;
    float pixel_m = distance_m * pixel / max(abs(direction.y), 1e-6);
    vec3 ground = ground_radiance(direction * distance_m, pixel_m);
    light.rgb = mix(ground, horizon_radiance(direction), haze_share(distance_m));
}
