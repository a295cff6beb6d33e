// Clouds and sprites as the clock has them, for the shaders that draw sprites: the twin of
// render/src/pass/sprites/{cloud_data,sprite_now}.wgsl. What they are stands in textures of four words a texel, in rows of
// DATA_ROW texels.

uniform usampler2D sprite_data;
uniform usampler2D group_data;
uniform usampler2D cloud_data;
uniform usampler2D moment_data;
uniform usampler2D pose_data;
uniform usampler2D stir_data;
uniform usampler2D baked_data;
uniform sampler2D shade_data;
uniform vec3 shadow_axes[2];
uniform float shadow_share;
// The air that moves sprites one by one.
uniform vec3 air_lean;
uniform vec3 air_lean_shear;
uniform float air_turned;
uniform float air_turbulence;
uniform vec3 air_swings;
uniform float air_humidity;


uvec4 words(usampler2D data, uint at) {
    return texelFetch(data, ivec2(at % DATA_ROW, at / DATA_ROW), 0);
}

vec4 floats(usampler2D data, uint at) {
    return uintBitsToFloat(words(data, at));
}

struct Cloud {
    vec3 center;
    float inverse_radius;
    float bottom;
    float top;
    // Heights of the colour levels, and their colours.
    float heights[5];
    vec4 colors[5];
    // Where what is baked begins, from the sprites; self-shadow and halo.
    int baked_from_sprites;
    float self_shadow;
    float halo;
    // Sine and cosine of the turn from the model's space.
    vec2 heading;
};

Cloud load_cloud(uint index) {
    uint at = index * 10u;
    vec4 sphere = floats(cloud_data, at);
    vec4 extent = floats(cloud_data, at + 1u);
    vec4 heights = floats(cloud_data, at + 2u);
    Cloud cloud;
    cloud.center = sphere.xyz;
    cloud.inverse_radius = sphere.w;
    cloud.bottom = extent.x;
    cloud.top = extent.y;
    cloud.heights = float[5](heights.x, heights.y, heights.z, heights.w, extent.z);
    for (int i = 0; i < 5; i++) {
        cloud.colors[i] = floats(cloud_data, at + 3u + uint(i));
    }
    vec4 soft = floats(cloud_data, at + 8u);
    cloud.baked_from_sprites = int(soft.x);
    cloud.self_shadow = soft.y;
    cloud.halo = soft.z;
    cloud.heading = floats(cloud_data, at + 9u).xy;
    return cloud;
}

struct Moment {
    vec3 from_eye;
    float formed_core;
    float formed_falloff;
    float growth;
    float opacity;
    float scale;
    // Sine and cosine, counter-clockwise from above.
    vec2 turn;
    // How far edges can be carried, metres; negative in air that carries nothing.
    float reach_m;
    // The directions around the sun's, and their shares.
    uvec3 around;
    vec3 shares;
    // The grid of what other clouds take of the light: its first node, nodes a metre, which that is of all, and nodes along
    // each side; none in the light.
    vec2 shade_low;
    float shade_nodes_a_metre;
    uint shade_first;
    uint shade_side;
};

Moment load_moment(uint cloud) {
    vec4 first = floats(moment_data, cloud * 6u);
    vec4 second = floats(moment_data, cloud * 6u + 1u);
    vec4 third = floats(moment_data, cloud * 6u + 2u);
    uint places = uint(third.w);
    uvec3 around = uvec3(places, places >> 4u, places >> 8u) & uvec3(15u);
    vec3 shares = floats(moment_data, cloud * 6u + 3u).xyz;
    vec4 fifth = floats(moment_data, cloud * 6u + 4u);
    vec4 sixth = floats(moment_data, cloud * 6u + 5u);
    return Moment(
        first.xyz, first.w, second.x, second.y, second.z, second.w, third.xy, third.z, around, shares,
        fifth.xy, fifth.z, uint(fifth.w), uint(sixth.x)
    );
}

// The sine of so many whole turns.
float sine(float turns) {
    return sin(6.2831855 * (turns - floor(turns + 0.5)));
}

vec3 turned_by(vec2 turn, vec3 v) {
    return vec3(turn.y * v.x + turn.x * v.z, v.y, turn.y * v.z - turn.x * v.x);
}

// A direction as it lies to the cloud at rest, where light is taken.
vec3 at_rest(vec3 direction, Moment moment) {
    return turned_by(vec2(-moment.turn.x, moment.turn.y), direction);
}

float height_within(Cloud cloud, float y) {
    float extent = cloud.top - cloud.bottom;
    return extent > 0.0 ? clamp((y - cloud.bottom) / extent, 0.0, 1.0) : 0.0;
}

Cloud cloud;
Moment moment;
// The sprite at rest, and as it is now, from the cloud's origin; sine and cosine of its rotation; how much of it has condensed.
vec3 now_rest;
vec3 now_position;
float now_width;
float now_height;
vec2 now_rotation;
float now_condensed;

// Where growth, turn and scale put it, and what the air adds.
void place_sprite(uint of_cloud, uint sprite) {
    cloud = load_cloud(of_cloud);
    moment = load_moment(of_cloud);
    vec4 first = floats(sprite_data, sprite * 2u);
    uvec4 second = words(sprite_data, sprite * 2u + 1u);
    now_rest = first.xyz;
    vec3 rest = now_rest;
    vec3 grown = vec3(rest.x, rest.y + (rest.y - cloud.bottom) * (moment.growth - 1.0), rest.z);
    now_position = moment.scale * turned_by(moment.turn, grown);
    now_width = first.w * moment.scale;
    now_height = uintBitsToFloat(second.x) * moment.scale;
    now_rotation = uintBitsToFloat(second.yz);
    now_condensed = 1.0;
    if (moment.reach_m >= 0.0) {
        uvec4 stir = words(stir_data, sprite);
        float looseness = uintBitsToFloat(stir.x);
        float threshold = uintBitsToFloat(stir.y);
        vec2 turn_and_sway = unpackSnorm2x16(stir.z);
        vec3 phases = vec3(uvec3(stir.w, stir.w >> 10u, stir.w >> 20u) & uvec3(1023u)) / 1024.0;
        vec3 lean = air_lean + air_lean_shear * (height_within(cloud, rest.y) - 0.5);
        vec3 swings = air_swings + phases;
        float sway = air_turbulence * turn_and_sway.y * SWAY * min(now_width, now_height);
        now_position += lean * (looseness * moment.reach_m) + vec3(sine(swings.x), sine(swings.y), sine(swings.z)) * sway;
        float turns = turn_and_sway.x * air_turned;
        vec2 more = vec2(sine(turns), sine(turns + 0.25));
        now_rotation = vec2(
            now_rotation.x * more.y + now_rotation.y * more.x, now_rotation.y * more.y - now_rotation.x * more.x
        );
        now_condensed = smoothstep(threshold - CONDENSING, threshold + CONDENSING, air_humidity);
    }
}

// How much of the cloud's opacity there is at a point of it at rest.
float formed_at(vec3 point) {
    float radii = distance(point, cloud.center) * cloud.inverse_radius;
    return clamp(moment.formed_core - moment.formed_falloff * radii, 0.0, 1.0) * moment.opacity;
}

vec3 shade_node(uint node) {
    return texelFetch(shade_data, ivec2(node % DATA_ROW, node / DATA_ROW), 0).xyz;
}

// What other clouds leave of the light at a point that counts from the cloud's origin (core/src/weather/shade.rs).
float shade_at(vec3 point) {
    if (moment.shade_side == 0u) {
        return 1.0;
    }
    float last = float(moment.shade_side - 1u);
    vec2 along = vec2(dot(point, shadow_axes[0]), dot(point, shadow_axes[1]));
    vec2 place = clamp((along - moment.shade_low) * moment.shade_nodes_a_metre, vec2(0.0), vec2(last));
    vec2 first = min(floor(place), vec2(last - 1.0));
    vec2 share = place - first;
    uint at = moment.shade_first + uint(first.y) * moment.shade_side + uint(first.x);
    vec3 above = mix(shade_node(at), shade_node(at + 1u), share.x);
    vec3 below = mix(shade_node(at + moment.shade_side), shade_node(at + moment.shade_side + 1u), share.x);
    vec3 met = mix(above, below, share.y);
    if (met.x <= 0.0) {
        return 1.0;
    }
    float before = clamp(0.5 + 0.5 * (met.y - dot(point, sun_direction) * met.x) / max(met.z, 1e-6), 0.0, 1.0);
    return 1.0 - shadow_share * (1.0 - exp(-0.1 * met.x * before));
}
