// The aircraft: opaque triangles in the sun, under the sky, and behind haze. Textures and gloss there are none.

// What the ground gives back of the sky's light, from below.
const GROUND_SHARE: f32 = 0.45;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) from_eye: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec3f,
    // What the clouds' shadows leave of the directional light.
    @location(3) @interpolate(flat) sunlit: f32,
}

@vertex
fn place_vertex(
    @location(0) position: vec3f,
    @location(1) normal: vec3f,
    @location(2) color: vec3f,
    @location(3) origin_and_scale: vec4f,
    @location(4) turn: vec4f,
    @location(5) sunlit: f32,
) -> Corner {
    let from_eye = origin_and_scale.xyz + turned(position * origin_and_scale.w, turn);
    return Corner(project(from_eye), from_eye, turned(normal, turn), color, sunlit);
}

// Both sides of a triangle are lit: open shapes have an inside.
@fragment
fn draw_model(in: Corner, @builtin(front_facing) outside: bool) -> @location(0) vec4f {
    let normal = unit_or(select(-in.normal, in.normal, outside), vec3f(0.0, 1.0, 0.0));
    let sun = frame.directional_max * (in.sunlit * max(dot(normal, frame.light_direction), 0.0));
    let sky = frame.ambient_max.rgb * mix(GROUND_SHARE, 1.0, 0.5 + 0.5 * normal.y);
    let hazed = haze_share(length(in.from_eye));
    return vec4f(mix(in.color * (sun + sky), horizon_radiance(in.from_eye), hazed), 1.0);
}

// `v` turned by a unit quaternion.
fn turned(v: vec3f, turn: vec4f) -> vec3f {
    return v + 2.0 * cross(turn.xyz, cross(turn.xyz, v) + turn.w * v);
}
