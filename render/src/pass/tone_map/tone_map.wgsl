// From linear light to a display: exposure, the tone curve “shoulder”, sRGB, dither. The twin of core/src/tone.rs.

const SHOULDER = 0.7;

@group(1) @binding(0) var linear_picture: texture_2d<f32>;

@fragment
fn develop(@builtin(position) position: vec4f) -> @location(0) vec4f {
    let pixel = vec2u(position.xy);
    let exposed = textureLoad(linear_picture, pixel, 0).rgb * frame.exposure;
    let shown = srgb_from_linear(tone_curve(exposed)) * 255.0 + 0.5 + dither(pixel);
    // Whole steps of the 8-bit target, so that its own rounding changes nothing.
    return vec4f(floor(clamp(shown, vec3f(0.0), vec3f(255.0))) / 255.0, 1.0);
}

fn tone_curve(x: vec3f) -> vec3f {
    let room = 1.0 - SHOULDER;
    let pressed = SHOULDER + room * (1.0 - exp((SHOULDER - x) / room));
    return select(pressed, max(x, vec3f(0.0)), x <= vec3f(SHOULDER));
}

// sRGB's transfer function (IEC 61966-2-1).
fn srgb_from_linear(x: vec3f) -> vec3f {
    return select(1.055 * pow(x, vec3f(1.0 / 2.4)) - 0.055, 12.92 * x, x <= vec3f(0.0031308));
}

// Bayer's 8 × 8 matrix (1973), in (−½, ½).
fn dither(pixel: vec2u) -> f32 {
    let rank = (spread(pixel.x ^ pixel.y) << 1u) | spread(pixel.y);
    return (f32(rank) + 0.5) / 64.0 - 0.5;
}

fn spread(v: u32) -> u32 {
    return ((v & 1u) << 4u) | ((v & 2u) << 1u) | ((v & 4u) >> 2u);
}
