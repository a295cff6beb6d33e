// What every shader knows of the frame, and the formulas that several share: the twins of render/src/shader/. Numbers in
// capitals are #defined before this, from the program's own constants.
precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;
precision highp sampler2DArray;

uniform vec3 right_in_world;
uniform vec3 up_in_world;
uniform vec3 forward_in_world;
// Width and height.
uniform vec2 size_px;
// Length of a pixel's side on a plane at distance 1.
uniform float pixel;
uniform vec3 sun_direction;
uniform vec4 ambient;
uniform vec3 directional;
uniform float haze_length_m;
uniform float exposure;
// A to I of Hosek and Wilkie's model, each for red, green and blue.
uniform vec3 dome_parameters[9];
uniform vec3 dome_scale;
uniform vec3 sun_disc;
uniform vec3 glow_direction;

vec3 unit_or(vec3 v, vec3 fallback) {
    float largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if (!(largest > 1e-30)) {
        return fallback;
    }
    return normalize(v / largest);
}

vec3 across(vec3 v, vec3 axis) {
    return v - axis * dot(v, axis);
}

// Within 2e-8 rad (Abramowitz and Stegun, 4.4.46); the built-in one shows in the glow around the sun.
float arc_cosine(float x) {
    float a = min(abs(x), 1.0);
    float p = -0.0012624911;
    p = p * a + 0.0066700901;
    p = p * a - 0.0170881256;
    p = p * a + 0.0308918810;
    p = p * a - 0.0501743046;
    p = p * a + 0.0889789874;
    p = p * a - 0.2145988016;
    p = p * a + 1.5707963050;
    float near = sqrt(1.0 - a) * p;
    return x < 0.0 ? 3.14159265 - near : near;
}

// The sky, where the angle to the zenith and that to its brightest point have these cosines.
vec3 distribution(float cos_theta, float cos_gamma) {
    float near = max((cos_gamma - GLOW_FROM_COSINE) / (1.0 - GLOW_FROM_COSINE), 0.0);
    float rest = 1.0 - near * near;
    float glow_kept = 1.0 - (1.0 - GLOW_KEPT) * (1.0 - rest * rest);
    vec3 around_zenith = 1.0 + dome_parameters[0] * exp(dome_parameters[1] / (cos_theta + 0.01));
    float cos2 = cos_gamma * cos_gamma;
    vec3 i = dome_parameters[8];
    vec3 base = 1.0 + i * i - 2.0 * i * cos_gamma;
    vec3 around_sun = dome_parameters[2]
        + dome_parameters[3] * exp(dome_parameters[4] * arc_cosine(cos_gamma))
        + dome_parameters[5] * cos2
        + dome_parameters[6] * (1.0 + cos2) / (base * sqrt(base));
    return dome_scale * glow_kept * (around_zenith * (around_sun + dome_parameters[7] * sqrt(cos_theta)));
}

// The sine of an elevation, kept from the edge of the formulas at the horizon.
float lifted_sine(float sine) {
    float up = max(sine, 0.0);
    return min(0.5 * (up + sqrt(up * up + 4.0 * HORIZON_SINE * HORIZON_SINE)), 1.0);
}

// For a unit direction, lifted from the horizon.
float cosine_to_glow(vec3 direction) {
    float up = lifted_sine(direction.y);
    vec3 level = unit_or(vec3(direction.x, 0.0, direction.z), vec3(1.0, 0.0, 0.0));
    vec3 lifted = level * sqrt(max(1.0 - up * up, 0.0)) + vec3(0.0, up, 0.0);
    return clamp(dot(lifted, glow_direction), -1.0, 1.0);
}

// What haze turns things to: the horizon's light.
vec3 horizon_radiance(vec3 direction) {
    vec3 level = vec3(direction.x, 0.0, direction.z);
    return distribution(HORIZON_SINE, cosine_to_glow(level));
}

float haze_share(float distance_m) {
    return 1.0 - exp(-distance_m / haze_length_m);
}
