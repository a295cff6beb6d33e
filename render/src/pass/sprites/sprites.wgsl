// The sprites: each turned to the eye (the twin of core/src/facing/), its corners lit (core/src/shading/), hazed, and
// drawn as ScreenSprite::fragment does (core/src/raster/prepare.rs).
//
// What the sprites are is loaded from data textures (cloud_data.wgsl, sprite_now.wgsl). A vertex is a corner; each of the four computes
// all four corners' light, because light runs bilinearly over the quad and not linearly over its two triangles.

const TILE_SIZE: f32 = 128.0;
const LAST_MIP: f32 = 4.0;
const BRIGHTEST: f32 = 60000.0;
@group(1) @binding(5) var atlas: texture_2d_array<f32>;
@group(1) @binding(6) var atlas_sampler: sampler;
// How near the models are, as `project` has it; 0 where there is none.
@group(2) @binding(0) var nearness_of_models: texture_2d<f32>;

struct Corner {
    @builtin(position) position: vec4f,
    @location(0) uv: vec2f,
    // Light at (u, v): base + u·right + v·down + u·v·both; straight linear rgb after haze, and alpha.
    @location(1) @interpolate(flat) light_base: vec4f,
    @location(2) @interpolate(flat) light_right: vec4f,
    @location(3) @interpolate(flat) light_down: vec4f,
    @location(4) @interpolate(flat) light_both: vec4f,
    // What haze adds for a fragment of alpha 1, and the mip level.
    @location(5) @interpolate(flat) haze_and_mip: vec4f,
    @location(6) @interpolate(flat) tile: u32,
    @location(7) @interpolate(flat) half_depth_m: f32,
}

@vertex
fn place_corner(
    @builtin(vertex_index) corner_index: u32,
    @location(0) instance: vec3u,
) -> Corner {
    let cloud = load_cloud(instance.x);
    let moment = load_moment(instance.x);
    let rest = load_sprite(instance.y);
    let group = load_group(rest.group);
    let sprite = sprite_now(rest, instance.y, cloud, moment);
    let center = moment.from_eye + sprite.position;

    let pose = pose_of(instance.z, center);
    let facing = turned(pose, sprite.rotation);
    let to_right = facing.right * (0.5 * sprite.width);
    let to_top = facing.up * (0.5 * sprite.height);

    let distance_m = length(center);
    let hazed = haze_share(distance_m);
    let shown = vec4f(vec3f(1.0 - hazed), pose.fade * condensed(instance.y, moment));
    let right_at_rest = at_rest(to_right, moment) / moment.scale;
    let top_at_rest = at_rest(to_top, moment) / moment.scale;
    let through = through_cloud(instance.y, sprite.position, cloud, moment, pose.towards);
    let reach = 0.5 * length(vec2f(rest.width, rest.height));
    let top_left = shown * lit(rest, top_at_rest - right_at_rest, reach, cloud, moment, group, through);
    let top_right = shown * lit(rest, right_at_rest + top_at_rest, reach, cloud, moment, group, through);
    let bottom_left = shown * lit(rest, -right_at_rest - top_at_rest, reach, cloud, moment, group, through);
    let bottom_right = shown * lit(rest, right_at_rest - top_at_rest, reach, cloud, moment, group, through);

    let uv = vec2f(f32(corner_index & 1u), f32(corner_index >> 1u));
    var out: Corner;
    out.position = project(center + to_right * (2.0 * uv.x - 1.0) + to_top * (1.0 - 2.0 * uv.y));
    out.uv = uv;
    out.light_base = top_left;
    out.light_right = top_right - top_left;
    out.light_down = bottom_left - top_left;
    out.light_both = (bottom_right - bottom_left) - (top_right - top_left);
    out.haze_and_mip = vec4f(horizon_radiance(center) * hazed, mip_level(center, sprite));
    out.tile = sprite.tile;
    out.half_depth_m = 0.5 * min(sprite.width, sprite.height);
    return out;
}

@fragment
fn draw_sprite(in: Corner) -> @location(0) vec4f {
    return lit_texel(in);
}

@fragment
fn draw_sprite_among_models(in: Corner) -> @location(0) vec4f {
    return lit_texel(in) * share_before_models(in);
}

// A sprite stands for something as deep as it is wide: where a model is within that depth, so much of it shows as lies
// before the model, and no edge is seen where the quad cuts it.
fn share_before_models(in: Corner) -> f32 {
    let model_depth_m = frame.near_m / max(textureLoad(nearness_of_models, vec2u(in.position.xy), 0).r, 1e-30);
    let sprite_depth_m = 1.0 / in.position.w;
    return clamp(0.5 + 0.5 * (model_depth_m - sprite_depth_m) / in.half_depth_m, 0.0, 1.0);
}

fn lit_texel(in: Corner) -> vec4f {
    let light = in.light_base + in.uv.x * in.light_right + in.uv.y * (in.light_down + in.uv.x * in.light_both);
    let texel = textureSampleLevel(atlas, atlas_sampler, in.uv, in.tile, in.haze_and_mip.w);
    let rgb = texel.rgb * light.rgb + texel.a * in.haze_and_mip.rgb;
    // Brighter light would be infinite in the target's 16-bit floats.
    return light.a * vec4f(min(rgb, vec3f(BRIGHTEST * texel.a)), texel.a);
}

// The CPU's (core/src/raster/prepare.rs): −½·log₂ 3.
const FINER: f32 = -0.79248125;

// The level whose texels, twice filtered, blur as much as a pixel does, sharpened, within the levels there are.
fn mip_level(center: vec3f, sprite: Sprite) -> f32 {
    let depth = max(dot(center, frame.forward_in_world), frame.near_m);
    let texels = TILE_SIZE * depth * frame.pixel / sqrt(sprite.width * sprite.height);
    let mip = log2(texels) + FINER;
    let level = floor(mip);
    let sharpened = level + clamp(2.0 * (mip - level) - 0.5, 0.0, 1.0);
    return clamp(sharpened, 0.0, LAST_MIP);
}

struct Facing {
    right: vec3f,
    up: vec3f,
}

// A sprite near the eye has a pose of its own; any other, at `center` (eye-relative), faces the eye.
fn pose_of(index: u32, center: vec3f) -> Pose {
    if index != FACES_EYE {
        return load_pose(index);
    }
    let to_eye = unit_or(-center, vec3f(0.0, 0.0, 1.0));
    return Pose(to_eye, upright_across(to_eye), 1.0);
}

// `rotation` is sine and cosine, counter-clockwise as seen.
fn turned(pose: Pose, rotation: vec2f) -> Facing {
    let level_right = cross(pose.up, pose.towards);
    return Facing(
        level_right * rotation.y + pose.up * rotation.x,
        pose.up * rotation.y - level_right * rotation.x,
    );
}

// The unturned sprite's up: the world's, and towards the poles the camera's.
fn upright_across(to_eye: vec3f) -> vec3f {
    let any_axis = select(vec3f(0.0, 0.0, 1.0), vec3f(1.0, 0.0, 0.0), abs(to_eye.x) < 0.8);
    let fallback = normalize(across(any_axis, to_eye));
    let pole = smoothstep(frame.pole_sines.x, frame.pole_sines.y, abs(to_eye.y));
    let world = unit_or(across(vec3f(0.0, 1.0, 0.0), to_eye), vec3f(0.0));
    let camera = unit_or(across(frame.up_in_world, to_eye), world);
    return unit_or(world * (1.0 - pole) + camera * pole, fallback);
}

// The sun's light that comes through the cloud to a sprite (core/src/shading/through.rs).
struct Through {
    sun: vec4f,
    up: vec4f,
    down: vec4f,
    halo: f32,
    // What other clouds leave of the light, e^(−τ/10).
    shade: f32,
}

const UP = 6u;
const DOWN = 13u;
const SCATTERED = 0.85;
const STRAIGHT = 0.25;
const SKY_KEPT_OUT = 0.28;
const FROM_BELOW = 0.2;
const FORWARD = 0.75;
const HALO = 0.35;

fn through_cloud(sprite: u32, place: vec3f, cloud: Cloud, moment: Moment, towards_eye: vec3f) -> Through {
    let shade = shade_at(moment, place);
    if moment.self_shadow <= 0.0 && moment.halo <= 0.0 {
        return Through(vec4f(0.0), vec4f(0.0), vec4f(0.0), 0.0, shade);
    }
    let at = cloud.baked_from_sprites + sprite;
    let sun = moment.shares.x * load_left(at, moment.around.x)
        + moment.shares.y * load_left(at, moment.around.y)
        + moment.shares.z * load_left(at, moment.around.z);
    let cosine = -dot(towards_eye, frame.light_direction);
    return Through(sun, load_left(at, UP), load_left(at, DOWN), moment.halo * HALO * thrown(cosine), shade);
}

// How much of the light is thrown on so that it turns by an angle of that cosine.
fn thrown(cosine: f32) -> f32 {
    let spread = max(1.0 + FORWARD * FORWARD - 2.0 * FORWARD * clamp(cosine, -1.0, 1.0), 1e-6);
    return (1.0 - FORWARD * FORWARD) * 0.07957747 / (spread * sqrt(spread));
}

fn left_at(left: vec4f, offset: vec3f) -> f32 {
    return clamp(left.x + dot(left.yzw, offset), 0.0, 1.0);
}

// The light at `offset` from a sprite's middle at rest: linear rgb, straight; alpha, as far as the cloud has formed.
fn lit(
    rest: Sprite,
    offset: vec3f,
    reach: f32,
    cloud: Cloud,
    moment: Moment,
    group: Group,
    through: Through,
) -> vec4f {
    let point = rest.position + offset;
    let level = level_color(cloud, height_within(cloud, point.y));
    let sun_direction = at_rest(frame.light_direction, moment);
    var ambient = level.rgb * frame.ambient_max.rgb;
    let shade_4 = (through.shade * through.shade) * (through.shade * through.shade);
    let in_shade = (SCATTERED * through.shade + STRAIGHT * shade_4 * shade_4) / (SCATTERED + STRAIGHT);
    var share = directional_share(point - group.center, group.c, sun_direction) * in_shade;
    if moment.self_shadow > 0.0 || moment.halo > 0.0 {
        let heading = moment.heading;
        let in_model = vec3f(
            heading.y * offset.x - heading.x * offset.z,
            offset.y,
            heading.x * offset.x + heading.y * offset.z,
        ) / reach;
        let sun = left_at(through.sun, in_model) * through.shade;
        let sun_4 = (sun * sun) * (sun * sun);
        let let_through = group.c.z * (SCATTERED * sun + STRAIGHT * sun_4 * sun_4);
        let up = sqrt(left_at(through.up, in_model));
        let down = sqrt(left_at(through.down, in_model));
        let open = (1.0 - FROM_BELOW) * up + FROM_BELOW * down;
        share = share * (1.0 - moment.self_shadow) + moment.self_shadow * let_through + through.halo * sun_4;
        ambient *= 1.0 - moment.self_shadow * SKY_KEPT_OUT * (1.0 - open);
    }
    let alpha = clamp(level.a * frame.ambient_max.a, 0.0, 1.0) * formed_at(point, cloud, moment);
    return vec4f(ambient + frame.directional_max * share, alpha);
}

// g(d), d the cosine between `outward` and the sun: Cmin at −1, Cmed at 0, Cmax at 1.
fn directional_share(outward: vec3f, c: vec3f, sun_direction: vec3f) -> f32 {
    let d = clamp(dot(unit_or(outward, vec3f(0.0)), sun_direction), -1.0, 1.0);
    return c.y + d * select(c.z - c.y, c.y - c.x, d < 0.0);
}

// The first level above `height` and the one below it; written out so that no array is indexed at run time.
fn level_color(cloud: Cloud, height: f32) -> vec4f {
    var color = cloud.color_4;
    color = between(color, cloud.heights.w, cloud.color_3, cloud.height_4, cloud.color_4, height);
    color = between(color, cloud.heights.z, cloud.color_2, cloud.heights.w, cloud.color_3, height);
    color = between(color, cloud.heights.y, cloud.color_1, cloud.heights.z, cloud.color_2, height);
    color = between(color, cloud.heights.x, cloud.color_0, cloud.heights.y, cloud.color_1, height);
    return select(color, cloud.color_0, cloud.heights.x > height);
}

fn between(otherwise: vec4f, from_height: f32, from_color: vec4f, to_height: f32, to_color: vec4f, height: f32) -> vec4f {
    if to_height > height {
        return mix(from_color, to_color, (height - from_height) / (to_height - from_height));
    }
    return otherwise;
}
