// The air inside a cloud, before everything; then from linear light to the display: exposure, the tone curve “shoulder”,
// sRGB, dither. The twin of render/src/pass/tone_map/tone_map.wgsl.

uniform sampler2D linear_picture;
// Premultiplied.
uniform vec4 veil;
out vec4 shown;

vec3 tone_curve(vec3 x) {
    float room = 1.0 - SHOULDER;
    vec3 pressed = SHOULDER + room * (1.0 - exp((SHOULDER - x) / room));
    return mix(pressed, max(x, 0.0), vec3(lessThanEqual(x, vec3(SHOULDER))));
}

// IEC 61966-2-1.
vec3 srgb_from_linear(vec3 x) {
    return mix(1.055 * pow(x, vec3(1.0 / 2.4)) - 0.055, 12.92 * x, vec3(lessThanEqual(x, vec3(0.0031308))));
}

uint spread(uint v) {
    return ((v & 1u) << 4u) | ((v & 2u) << 1u) | ((v & 4u) >> 2u);
}

// Bayer's 8 × 8 matrix (1973), in (−½, ½); rows count from the top.
float dither(uvec2 at) {
    uint rank = (spread(at.x ^ at.y) << 1u) | spread(at.y);
    return (float(rank) + 0.5) / 64.0 - 0.5;
}

void main() {
    vec3 linear = texelFetch(linear_picture, ivec2(gl_FragCoord.xy), 0).rgb;
    vec3 exposed = (veil.rgb + (1.0 - veil.a) * linear) * exposure;
    uvec2 at = uvec2(gl_FragCoord.x, size_px.y - gl_FragCoord.y);
    vec3 steps = srgb_from_linear(tone_curve(exposed)) * 255.0 + 0.5 + dither(at);
    shown = vec4(floor(clamp(steps, 0.0, 255.0)) / 255.0, 1.0);
}
