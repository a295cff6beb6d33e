// A sprite as the clock has it, for the passes that draw sprites: the twin of core/src/weather/cloud_now.rs and air.rs.

const CONDENSING: f32 = 0.08;
const SWAY: f32 = 0.1;

// A sprite as it is now (core/src/weather/cloud_now.rs, air.rs): at rest what is added is zero.
fn sprite_now(rest: Sprite, index: u32, cloud: Cloud, moment: Moment) -> Sprite {
    var now = rest;
    let grown = rest.position + vec3f(0.0, (rest.position.y - cloud.bottom) * (moment.growth - 1.0), 0.0);
    let turn = moment.turn;
    now.position =
        moment.scale * vec3f(turn.y * grown.x + turn.x * grown.z, grown.y, turn.y * grown.z - turn.x * grown.x);
    now.width = rest.width * moment.scale;
    now.height = rest.height * moment.scale;
    if moment.reach_m >= 0.0 {
        let stir = load_stir(index);
        let height = height_within(cloud, rest.position.y);
        let lean = (frame.air_lean + frame.air_lean_shear * (height - 0.5)) * (stir.looseness * moment.reach_m);
        let swings = frame.air_swings + stir.phases;
        let sway = frame.air_turbulence * stir.sway * SWAY * min(now.width, now.height);
        now.position += lean + vec3f(sine(swings.x), sine(swings.y), sine(swings.z)) * sway;
        let turns = stir.turn * frame.air_turned;
        let more = vec2f(sine(turns), sine(turns + 0.25));
        now.rotation = vec2f(
            rest.rotation.x * more.y + rest.rotation.y * more.x,
            rest.rotation.y * more.y - rest.rotation.x * more.x,
        );
    }
    return now;
}

// How much of a sprite has condensed.
fn condensed(index: u32, moment: Moment) -> f32 {
    if moment.reach_m < 0.0 {
        return 1.0;
    }
    let threshold = load_stir(index).threshold;
    return smoothstep(threshold - CONDENSING, threshold + CONDENSING, frame.air_humidity);
}

// A direction, as it lies to the cloud at rest.
fn at_rest(direction: vec3f, moment: Moment) -> vec3f {
    let turn = moment.turn;
    return vec3f(
        turn.y * direction.x - turn.x * direction.z,
        direction.y,
        turn.x * direction.x + turn.y * direction.z,
    );
}

// The sine of so many whole turns (core/src/weather/air.rs).
fn sine(turns: f32) -> f32 {
    let within = turns - floor(turns + 0.5);
    let folded = select(within, select(-0.5, 0.5, within > 0.0) - within, abs(within) > 0.25);
    let squared = folded * folded;
    let high = squared * (-76.70586 + squared * (42.05869 - squared * 15.094643));
    return folded * (6.2831855 + squared * (-41.3417 + squared * (81.60525 + high)));
}

// How much of the cloud's opacity there is at a point of it at rest.
fn formed_at(point: vec3f, cloud: Cloud, moment: Moment) -> f32 {
    let radii = distance(point, cloud.center) * cloud.inverse_radius;
    return clamp(moment.formed_core - moment.formed_falloff * radii, 0.0, 1.0) * moment.opacity;
}

fn height_within(cloud: Cloud, y: f32) -> f32 {
    let extent = cloud.top - cloud.bottom;
    if extent > 0.0 {
        return clamp((y - cloud.bottom) / extent, 0.0, 1.0);
    }
    return 0.0;
}
