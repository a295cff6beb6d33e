// A sprite's texel with its light, premultiplied. The twin of render/src/pass/sprites/sprites.wgsl.

uniform sampler2DArray atlas;
in vec2 uv;
flat in vec4 light_base;
flat in vec4 light_right;
flat in vec4 light_down;
flat in vec4 light_both;
flat in vec4 haze_and_mip;
flat in uint tile;
out vec4 shown;

void main() {
    vec4 light = light_base + uv.x * light_right + uv.y * (light_down + uv.x * light_both);
    vec4 texel = textureLod(atlas, vec3(uv, float(tile)), haze_and_mip.w);
    vec3 rgb = texel.rgb * light.rgb + texel.a * haze_and_mip.rgb;
    // Brighter light would be infinite in the target's 16-bit floats.
    shown = light.a * vec4(min(rgb, vec3(60000.0 * texel.a)), texel.a);
}
