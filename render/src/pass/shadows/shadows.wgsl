// The clouds' shadows for the ground: a spot for each sprite, on the plane across the light. The twin of
// core/src/weather/shadows/ (plane.rs, map.rs). What is left of the light is multiplied, spot by spot.

const FALLOFF = 0.1;
const SUN_RADIUS = 0.00465;
const LEAST_SPOT = 0.75;
const MOST_TEXELS = 512.0;

struct Spot {
    @builtin(position) position: vec4f,
    // From the middle, in halves.
    @location(0) off: vec2f,
    @location(1) @interpolate(flat) depth: f32,
}

// An instance is the cloud, the sprite, and the bits of its optical depth.
@vertex
fn place_spot(@builtin(vertex_index) corner_index: u32, @location(0) instance: vec3u) -> Spot {
    let cloud = load_cloud(instance.x);
    let moment = load_moment(instance.x);
    let rest = load_sprite(instance.y);
    let shown = formed_at(rest.position, cloud, moment) * condensed(instance.y, moment) * frame.ambient_max.a;
    let depth = bitcast<f32>(instance.z) * shown;
    let now = sprite_now(rest, instance.y, cloud, moment);
    let point = moment.from_eye + now.position;

    let turn = now.rotation;
    let across = 0.5 * length(vec2f(now.width * turn.y, now.height * turn.x));
    let upwards = 0.5 * length(vec2f(now.width * turn.x, now.height * turn.y));
    let rise = frame.light_direction.y;
    let level = sqrt(max(1.0 - rise * rise, 0.0));
    let half = vec2f(across, length(vec2f(across * rise, upwards * level)));
    let soft = SUN_RADIUS * max(point.y + frame.ground_eye_height_m, 0.0) / rise;
    let least = LEAST_SPOT * frame.shadow_texel_m;
    let wider = sqrt(half * half + vec2f(soft * soft) + least * least);

    let at = vec2f(dot(point, frame.shadow_level), dot(point, frame.shadow_upwards));
    let place = vec2f(frame.shadow_eye_x, frame.shadow_eye_y) + at / frame.shadow_texel_m;
    let off = vec2f(f32(corner_index & 1u), f32(corner_index >> 1u)) * 2.0 - 1.0;
    let corner = (place + off * wider / frame.shadow_texel_m) * (2.0 / MOST_TEXELS);
    // One that takes no light away has no area.
    let shows = select(0.0, 1.0, depth > 0.0);
    var out: Spot;
    out.position = vec4f((corner.x - 1.0) * shows, (1.0 - corner.y) * shows, 0.0, 1.0);
    out.off = off;
    out.depth = depth * (half.x * half.y) / (wider.x * wider.y);
    return out;
}

@fragment
fn draw_spot(in: Spot) -> @location(0) vec4f {
    let inside = max(1.0 - dot(in.off, in.off), 0.0);
    return vec4f(exp(-FALLOFF * in.depth * inside * sqrt(inside)));
}
