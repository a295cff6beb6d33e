// The twin of core/src/math.rs.

// `v` scaled to length 1, or `fallback` where it is too short (or too long, or no number) to have a direction.
fn unit_or(v: vec3f, fallback: vec3f) -> vec3f {
    let largest = max(max(abs(v.x), abs(v.y)), abs(v.z));
    if !(largest > 1.1754944e-38 && largest <= 3.4028234e38) {
        return fallback;
    }
    let scaled = v / largest;
    return scaled / length(scaled);
}

// The part of `v` across the unit vector `axis`.
fn across(v: vec3f, axis: vec3f) -> vec3f {
    return v - axis * dot(v, axis);
}

// Arc cosine within 2e-8 rad (Abramowitz and Stegun, 4.4.46). The built-in may be a thousand times coarser, which
// shows in the glow around the sun.
fn arc_cosine(x: f32) -> f32 {
    let a = min(abs(x), 1.0);
    var p = -0.0012624911;
    p = p * a + 0.0066700901;
    p = p * a - 0.0170881256;
    p = p * a + 0.0308918810;
    p = p * a - 0.0501743046;
    p = p * a + 0.0889789874;
    p = p * a - 0.2145988016;
    p = p * a + 1.5707963050;
    let near = sqrt(1.0 - a) * p;
    return select(near, 3.14159265 - near, x < 0.0);
}
