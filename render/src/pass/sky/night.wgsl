// Moon and stars. The twin of core/src/sky/night.rs and stars.rs, which say what and why.

const STAR_CELLS: i32 = 64;
const STAR_CHANCE: f32 = 0.37;
const STAR_SPOT_PX: f32 = 2.08;
const STAR_WIDEST: f32 = 0.0072;
const MOON_DAY: vec3f = vec3f(1.35, 1.29, 1.16);
const MOON_NIGHT: vec3f = vec3f(0.010, 0.012, 0.016);
const AIR: vec3f = vec3f(0.10, 0.16, 0.27);

// Moon and stars in a unit direction.
fn night_lights(direction: vec3f) -> vec3f {
    if direction.y <= 0.0 {
        return vec3f(0.0);
    }
    let through_air = exp(-AIR / (direction.y + 0.02));
    let offset = direction - frame.moon_direction;
    let radius = max(frame.moon_radius, 0.75 * frame.pixel);
    let disc = clamp((radius - length(offset)) / frame.pixel + 0.5, 0.0, 1.0);
    var lights = vec3f(0.0);
    if frame.moon > 0.0 {
        let lit = 0.5 * (1.0 - dot(frame.moon_direction, frame.dome_sun_direction));
        let square = dot(offset, offset);
        let halo = 0.055 * 0.0005 / (0.0005 + square) + 0.012 * 0.03 / (0.03 + square);
        lights += vec3f(0.72, 0.88, 1.10) * (lit * halo * frame.moon);
        if disc > 0.0 {
            let share = frame.moon_radius / radius;
            lights += moon_face(offset / radius) * (disc * share * share * frame.moon);
        }
    }
    if frame.stars > 0.0 {
        lights += stars_radiance(from_world(direction)) * (frame.stars * (1.0 - disc));
    }
    return lights * through_air;
}

// A vector in the axes in which the stars stand still.
fn from_world(v: vec3f) -> vec3f {
    return frame.celestial_from_world[0].xyz * v.x
        + frame.celestial_from_world[1].xyz * v.y
        + frame.celestial_from_world[2].xyz * v.z;
}

// The moon's face at a place off its middle, in its radii.
fn moon_face(place: vec3f) -> vec3f {
    let normal = place - frame.moon_direction * sqrt(max(1.0 - dot(place, place), 0.0));
    let day = smoothstep(0.0, 0.35, dot(normal, frame.dome_sun_direction));
    let middle = from_world(frame.moon_direction);
    let east = unit_or(vec3f(-middle.y, middle.x, 0.0), vec3f(1.0, 0.0, 0.0));
    let on_sphere = from_world(place);
    let at = vec2f(dot(on_sphere, east), dot(on_sphere, cross(middle, east)));
    let dry = off_sea(at, 0.25, 0.50, 0.33) * off_sea(at, -0.27, 0.45, 0.22)
        * off_sea(at, -0.45, 0.13, 0.27) * off_sea(at, -0.79, 0.28, 0.14)
        * off_sea(at, -0.72, -0.10, 0.20) * off_sea(at, 0.62, 0.22, 0.40)
        * off_sea(at, 0.60, -0.40, 0.16) * off_sea(at, 0.22, -0.35, 0.26);
    return MOON_DAY * (max(dry, 0.5) * day) + MOON_NIGHT;
}

fn off_sea(at: vec2f, x: f32, y: f32, radius: f32) -> f32 {
    return 0.62 + 0.38 * smoothstep(0.55 * radius, 1.15 * radius, length(at - vec2f(x, y)));
}

// All stars in a unit direction of their own axes: those of the four cells next to it.
fn stars_radiance(direction: vec3f) -> vec3f {
    let size = abs(direction);
    var axis = 2;
    var major = direction.z;
    var across = direction.xy;
    if size.x >= size.y && size.x >= size.z {
        axis = 0;
        major = direction.x;
        across = direction.yz;
    } else if size.y >= size.z {
        axis = 1;
        major = direction.y;
        across = direction.zx;
    }
    let face = 2 * axis + select(0, 1, major < 0.0);
    let place = across / abs(major);
    let warped = sign(place) * (sqrt(1.0 + 3.0 * abs(place)) - 1.0);
    let first = vec2i(floor((warped + 1.0) * (0.5 * f32(STAR_CELLS)) - 0.5));
    let wanted = max(STAR_SPOT_PX * frame.pixel, 1e-7);
    let radius = min(wanted, STAR_WIDEST);
    let fade = (radius / wanted) * (radius / wanted);
    let sum = cell_radiance(face, first, direction, radius)
        + cell_radiance(face, first + vec2i(1, 0), direction, radius)
        + cell_radiance(face, first + vec2i(0, 1), direction, radius)
        + cell_radiance(face, first + vec2i(1, 1), direction, radius);
    return sum * (5.0 / (3.14159265 * radius * radius) * fade * fade);
}

// The star of one cell, of a spot of such a radius whose middle is 1.
fn cell_radiance(face: i32, cell: vec2i, direction: vec3f, radius: f32) -> vec3f {
    let inside = all(cell >= vec2i(0)) && all(cell < vec2i(STAR_CELLS));
    let row = u32(face * STAR_CELLS + cell.x);
    if !inside || hash(row, u32(cell.y), 16u) >= STAR_CHANCE {
        return vec3f(0.0);
    }
    let u = unwarped(cell.x, hash(row, u32(cell.y), 17u));
    let v = unwarped(cell.y, hash(row, u32(cell.y), 18u));
    let side = select(1.0, -1.0, (face & 1) == 1);
    var star = vec3f(u, v, side);
    if face < 2 {
        star = vec3f(side, u, v);
    } else if face < 4 {
        star = vec3f(v, side, u);
    }
    let apart = (direction - normalize(star)) / radius;
    let left = max(1.0 - dot(apart, apart), 0.0);
    if left <= 0.0 {
        return vec3f(0.0);
    }
    let rank = sqrt(max(hash(row, u32(cell.y), 19u), 1e-4));
    let tint = mix(vec3f(1.0, 0.80, 0.58), vec3f(0.78, 0.90, 1.15), hash(row, u32(cell.y), 20u));
    return tint * (1.0 / (rank * sqrt(rank))) * (left * left) * (left * left);
}

fn unwarped(cell: i32, random: f32) -> f32 {
    var within = random;
    if cell == 0 {
        within = 0.5 + 0.5 * random;
    } else if cell == STAR_CELLS - 1 {
        within = 0.5 * random;
    }
    let warped = (f32(cell) + within) / (0.5 * f32(STAR_CELLS)) - 1.0;
    return warped * (2.0 + abs(warped)) / 3.0;
}
