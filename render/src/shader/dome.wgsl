// The sky of Hosek and Wilkie (2012), the sun's disc, and the haze that takes the horizon's colour.
// The twin of core/src/sky/dome.rs, by its formulas and not its tables.

// How much of the model is kept around the sun.
const GLOW_KEPT: f32 = 0.6;
const GLOW_FROM_COSINE: f32 = 0.573576;

fn glow_kept(cos_gamma: f32) -> f32 {
    let near = max((cos_gamma - GLOW_FROM_COSINE) / (1.0 - GLOW_FROM_COSINE), 0.0);
    let rest = 1.0 - near * near;
    return 1.0 - (1.0 - GLOW_KEPT) * (1.0 - rest * rest);
}

// 1 + A exp(B / (cos theta + 0.01)).
fn around_zenith(cos_theta: f32) -> vec3f {
    return 1.0 + frame.dome_parameters[0].rgb * exp(frame.dome_parameters[1].rgb / (cos_theta + 0.01));
}

// C + D exp(E gamma) + F cos² gamma + G chi(gamma).
fn around_sun(cos_gamma: f32) -> vec3f {
    let gamma = arc_cosine(cos_gamma);
    let cos2 = cos_gamma * cos_gamma;
    let i = frame.dome_parameters[8].rgb;
    let base = 1.0 + i * i - 2.0 * i * cos_gamma;
    return frame.dome_parameters[2].rgb
        + frame.dome_parameters[3].rgb * exp(frame.dome_parameters[4].rgb * gamma)
        + frame.dome_parameters[5].rgb * cos2
        + frame.dome_parameters[6].rgb * (1.0 + cos2) / (base * sqrt(base));
}

// The sine of an elevation, kept from the edge of the formulas at the horizon by a soft maximum.
fn lifted_sine(sine: f32) -> f32 {
    let up = max(sine, 0.0);
    return min(0.5 * (up + sqrt(up * up + 4.0 * frame.horizon_sine * frame.horizon_sine)), 1.0);
}

// Radiance of the sky alone in a unit direction; below the horizon as at the horizon.
fn sky_radiance(direction: vec3f) -> vec3f {
    return distribution(lifted_sine(direction.y), cosine_to_glow(direction));
}

// Cosine of the angle to the sky's brightest point, for a unit direction lifted from the horizon.
fn cosine_to_glow(direction: vec3f) -> f32 {
    let up = lifted_sine(direction.y);
    let level = unit_or(vec3f(direction.x, 0.0, direction.z), vec3f(1.0, 0.0, 0.0));
    let lifted = level * sqrt(max(1.0 - up * up, 0.0)) + vec3f(0.0, up, 0.0);
    return clamp(dot(lifted, frame.glow_direction), -1.0, 1.0);
}

fn distribution(cos_theta: f32, cos_gamma: f32) -> vec3f {
    let i_term = frame.dome_parameters[7].rgb * sqrt(cos_theta);
    let day = frame.dome_scale * glow_kept(cos_gamma) * (around_zenith(cos_theta) * (around_sun(cos_gamma) + i_term));
    return day + night_glow(cos_theta);
}

// The air's own glow at the sine of an elevation.
fn night_glow(up: f32) -> vec3f {
    let low = (1.0 - up) * (1.0 - up);
    return mix(frame.glow_overhead, frame.glow_at_horizon, low * low);
}

// Radiance of sky and sun in a unit direction. The cosine to the sun is 1 − |d − s|²/2: the plain dot product of
// nearly equal vectors has no bits left for a disc half a degree wide.
fn dome_radiance(direction: vec3f) -> vec3f {
    let apart = direction - frame.dome_sun_direction;
    let cos_sun = 1.0 - 0.5 * dot(apart, apart);
    let disc = smoothstep(frame.sun_disc_cosine_from, frame.sun_disc_cosine_to, cos_sun);
    return sky_radiance(direction) + frame.sun_disc * disc;
}

// Radiance of the sky at the horizon below or above `direction` (any length): what haze turns things to.
fn horizon_radiance(direction: vec3f) -> vec3f {
    let level = vec3f(direction.x, 0.0, direction.z);
    return distribution(frame.horizon_sine, cosine_to_glow(level));
}

// 1 − e^(−distance / length).
fn haze_share(distance_m: f32) -> f32 {
    return 1.0 - exp(-distance_m / frame.haze_length_m);
}
