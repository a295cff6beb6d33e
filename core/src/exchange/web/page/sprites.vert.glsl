// The sprites: each turned to the eye, its corners lit and hazed. The twin of render/src/pass/sprites/sprites.wgsl, which
// says why it is so; what the sprites are is loaded as clouds.glsl has it.
//
// A vertex is a corner; each of the four computes all four corners' light, because light runs bilinearly over the quad and
// not linearly over its two triangles.

const uint FACES_EYE = 0xffffffffu;

// Cloud, sprite and pose.
layout(location = 0) in uvec3 instance;
out vec2 uv;
// Light at (u, v): base + u·right + v·down + u·v·both; straight linear rgb after haze, and alpha.
flat out vec4 light_base;
flat out vec4 light_right;
flat out vec4 light_down;
flat out vec4 light_both;
// What haze adds for a fragment of alpha 1, and the mip level.
flat out vec4 haze_and_mip;
flat out uint tile;

// The first level above `height` and the one below it.
vec4 level_color(Cloud cloud, float height) {
    vec4 color = cloud.colors[4];
    for (int i = 4; i > 0; i--) {
        if (cloud.heights[i] > height) {
            float share = (height - cloud.heights[i - 1]) / (cloud.heights[i] - cloud.heights[i - 1]);
            color = mix(cloud.colors[i - 1], cloud.colors[i], share);
        }
    }
    return cloud.heights[0] > height ? cloud.colors[0] : color;
}

// Cmin where the cosine between `outward` and the sun is −1, Cmed at 0, Cmax at 1.
float directional_share(vec3 outward, vec3 c, vec3 sun) {
    float d = clamp(dot(unit_or(outward, vec3(0.0)), sun), -1.0, 1.0);
    return c.y + d * (d < 0.0 ? c.y - c.x : c.z - c.y);
}

// The upright of a sprite that faces a far eye: the world's up, and towards the poles the camera's.
vec3 upright_across(vec3 to_eye) {
    vec3 any_axis = abs(to_eye.x) < 0.8 ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 0.0, 1.0);
    vec3 fallback = normalize(across(any_axis, to_eye));
    float pole = smoothstep(POLE_FROM, POLE_TO, abs(to_eye.y));
    vec3 world = unit_or(across(vec3(0.0, 1.0, 0.0), to_eye), vec3(0.0));
    vec3 camera = unit_or(across(up_in_world, to_eye), world);
    return unit_or(world * (1.0 - pole) + camera * pole, fallback);
}

// The level whose texels, twice filtered, blur as much as a pixel does, sharpened, within the levels there are.
float mip_level(vec3 center, float width, float height) {
    float depth = max(dot(center, forward_in_world), NEAR_M);
    float mip = log2(TILE_SIZE * depth * pixel / sqrt(width * height)) + FINER;
    float level = floor(mip);
    return clamp(level + clamp(2.0 * (mip - level) - 0.5, 0.0, 1.0), 0.0, LAST_MIP);
}

vec3 group_center;
vec3 group_c;
vec3 sun_at_rest;
// What light is left at the sprite from the sun, from straight up and from straight down: at its middle, and how it changes.
vec4 from_sun;
vec4 from_above;
vec4 from_below;
float halo;
// What other clouds leave of the light.
float shade;

vec4 load_left(uint direction) {
    uint sprite = uint(int(instance.y) + cloud.baked_from_sprites);
    uint word = words(baked_data, sprite * 4u + (direction >> 2u))[direction & 3u];
    return vec4(float(word & 255u) / 255.0, (ivec3(int(word) << 16, int(word) << 8, int(word)) >> 24)) / vec4(1.0, vec3(127.0));
}

void load_through(vec3 towards_eye) {
    if (cloud.self_shadow <= 0.0 && cloud.halo <= 0.0) {
        return;
    }
    from_sun = moment.shares.x * load_left(moment.around.x)
        + moment.shares.y * load_left(moment.around.y)
        + moment.shares.z * load_left(moment.around.z);
    from_above = load_left(6u);
    from_below = load_left(13u);
    float spread = 1.0 + FORWARD * FORWARD + 2.0 * FORWARD * dot(towards_eye, sun_direction);
    halo = cloud.halo * HALO * (1.0 - FORWARD * FORWARD) * 0.07957747 / (spread * sqrt(spread));
}

float left_at(vec4 left, vec3 offset) {
    return clamp(left.x + dot(left.yzw, offset), 0.0, 1.0);
}

// At `offset` from the sprite's middle at rest: linear rgb, straight; alpha as far as the cloud has formed.
vec4 corner_light(vec3 rest, vec3 offset, float reach) {
    vec3 point = rest + offset;
    vec4 level = level_color(cloud, height_within(cloud, point.y));
    float sky_share = 1.0;
    float shade_4 = (shade * shade) * (shade * shade);
    float in_shade = (SCATTERED * shade + STRAIGHT * shade_4 * shade_4) / (SCATTERED + STRAIGHT);
    float sun_share = directional_share(point - group_center, group_c, sun_at_rest) * in_shade;
    if (cloud.self_shadow > 0.0 || cloud.halo > 0.0) {
        vec3 in_model = turned_by(vec2(-cloud.heading.x, cloud.heading.y), offset) / reach;
        float sun = left_at(from_sun, in_model) * shade;
        float sun_4 = (sun * sun) * (sun * sun);
        float let_through = group_c.z * (SCATTERED * sun + STRAIGHT * sun_4 * sun_4);
        float open = (1.0 - FROM_BELOW) * sqrt(left_at(from_above, in_model))
            + FROM_BELOW * sqrt(left_at(from_below, in_model));
        sun_share = sun_share * (1.0 - cloud.self_shadow) + cloud.self_shadow * let_through + halo * sun_4;
        sky_share = 1.0 - cloud.self_shadow * SKY_KEPT_OUT * (1.0 - open);
    }
    vec3 rgb = level.rgb * ambient.rgb * sky_share + directional * sun_share;
    return vec4(rgb, clamp(level.a * ambient.a, 0.0, 1.0) * formed_at(point));
}

void main() {
    place_sprite(instance.x, instance.y);
    vec4 first = floats(sprite_data, instance.y * 2u);
    uvec4 second = words(sprite_data, instance.y * 2u + 1u);
    uint group = second.w >> 4u;
    vec4 group_first = floats(group_data, group * 2u);
    vec4 group_second = floats(group_data, group * 2u + 1u);
    group_center = group_first.xyz;
    group_c = vec3(group_first.w, group_second.xy);
    sun_at_rest = at_rest(sun_direction, moment);

    vec3 rest = now_rest;
    float width = now_width;
    float height = now_height;
    vec2 rotation = now_rotation;
    float condensed = now_condensed;
    vec3 center = moment.from_eye + now_position;

    // It faces the eye, unless it is near and has a pose of its own.
    vec3 towards = unit_or(-center, vec3(0.0, 0.0, 1.0));
    vec3 upright;
    float fade = 1.0;
    if (instance.z == FACES_EYE) {
        upright = upright_across(towards);
    } else {
        vec4 pose = floats(pose_data, instance.z * 2u);
        towards = pose.xyz;
        fade = pose.w;
        upright = floats(pose_data, instance.z * 2u + 1u).xyz;
    }
    vec3 level_right = cross(upright, towards);
    vec3 to_right = (level_right * rotation.y + upright * rotation.x) * (0.5 * width);
    vec3 to_top = (upright * rotation.y - level_right * rotation.x) * (0.5 * height);

    float hazed = haze_share(length(center));
    vec4 shows = vec4(vec3(1.0 - hazed), fade * condensed);
    vec3 right_at_rest = at_rest(to_right, moment) / moment.scale;
    vec3 top_at_rest = at_rest(to_top, moment) / moment.scale;
    shade = shade_at(now_position);
    load_through(towards);
    float reach = 0.5 * length(vec2(first.w, uintBitsToFloat(second.x)));
    vec4 top_left = shows * corner_light(rest, top_at_rest - right_at_rest, reach);
    vec4 top_right = shows * corner_light(rest, right_at_rest + top_at_rest, reach);
    vec4 bottom_left = shows * corner_light(rest, -right_at_rest - top_at_rest, reach);
    vec4 bottom_right = shows * corner_light(rest, right_at_rest - top_at_rest, reach);

    uv = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec3 corner = center + to_right * (2.0 * uv.x - 1.0) + to_top * (1.0 - 2.0 * uv.y);
    vec2 on_plane = vec2(dot(corner, right_in_world), dot(corner, up_in_world)) * 2.0 / (pixel * size_px);
    // Depth is reversed: 1 at the near plane, 0 at infinity.
    gl_Position = vec4(on_plane, NEAR_M, dot(corner, forward_in_world));
    light_base = top_left;
    light_right = top_right - top_left;
    light_down = bottom_left - top_left;
    light_both = (bottom_right - bottom_left) - (top_right - top_left);
    haze_and_mip = vec4(horizon_radiance(center) * hazed, mip_level(center, width, height));
    tile = second.w & 15u;
}
