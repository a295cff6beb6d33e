// The clouds' shadows for the ground: a spot for each sprite, on the plane across the light. The twin of
// render/src/pass/shadows/shadows.wgsl.

// Cloud, sprite, and the bits of its optical depth.
layout(location = 0) in uvec3 instance;
uniform float ground_eye_height_m;
uniform vec2 shadow_eye;
uniform vec2 shadow_texel_m;

out vec2 off;
flat out float depth;

void main() {
    place_sprite(instance.x, instance.y);
    depth = uintBitsToFloat(instance.z) * formed_at(now_rest) * now_condensed * ambient.a;
    vec3 point = moment.from_eye + now_position;
    float wide = 0.5 * length(vec2(now_width * now_rotation.y, now_height * now_rotation.x));
    float high = 0.5 * length(vec2(now_width * now_rotation.x, now_height * now_rotation.y));
    float rise = sun_direction.y;
    float level = sqrt(max(1.0 - rise * rise, 0.0));
    vec2 halves = vec2(wide, length(vec2(wide * rise, high * level)));
    float soft = SUN_RADIUS * max(point.y + ground_eye_height_m, 0.0) / rise;
    vec2 least = 0.75 * shadow_texel_m;
    vec2 wider = sqrt(halves * halves + vec2(soft * soft) + least * least);
    off = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    vec2 place = shadow_eye + vec2(dot(point, shadow_axes[0]), dot(point, shadow_axes[1])) / shadow_texel_m;
    vec2 corner = (place + off * wider / shadow_texel_m) * (2.0 / SHADOW_TEXELS) - 1.0;
    // One that takes no light away has no area.
    gl_Position = vec4(depth > 0.0 ? corner : vec2(0.0), 0.0, 1.0);
    depth *= (halves.x * halves.y) / (wider.x * wider.y);
}
