//! Noise built on an integer hash, so that the same bytes come out of every machine:
//! floats see only + - * / sqrt, and nothing depends on a platform's maths library.
//!
//! Sources: S. Worley, *A Cellular Texture Basis Function*, SIGGRAPH 1996;
//! K. Perlin, *Improving Noise*, SIGGRAPH 2002;
//! M. Jarzynski and M. Olano, *Hash Functions for GPU Rendering*, JCGT 9(3), 2020 (pcg3d).

/// A point or a direction: x to the right, y up, z towards the viewer.
pub type Vec3 = [f32; 3];

pub fn clamp(value: f32, low: f32, high: f32) -> f32 {
    if value < low {
        low
    } else if value > high {
        high
    } else {
        value
    }
}

pub fn saturate(value: f32) -> f32 {
    clamp(value, 0.0, 1.0)
}

pub fn mix(from: f32, to: f32, amount: f32) -> f32 {
    from + (to - from) * amount
}

pub fn smoothstep(low: f32, high: f32, value: f32) -> f32 {
    let t = saturate((value - low) / (high - low));
    t * t * (3.0 - 2.0 * t)
}

/// Three well-mixed words from three (pcg3d).
pub fn hash3(mut x: u32, mut y: u32, mut z: u32) -> [u32; 3] {
    const MULTIPLIER: u32 = 1_664_525;
    const INCREMENT: u32 = 1_013_904_223;
    x = x.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
    y = y.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
    z = z.wrapping_mul(MULTIPLIER).wrapping_add(INCREMENT);
    for _ in 0..2 {
        x = x.wrapping_add(y.wrapping_mul(z));
        y = y.wrapping_add(z.wrapping_mul(x));
        z = z.wrapping_add(x.wrapping_mul(y));
        x ^= x >> 16;
        y ^= y >> 16;
        z ^= z >> 16;
    }
    [x, y, z]
}

/// The top 24 bits as a float in [0, 1): exact, no rounding anywhere.
pub fn unit(word: u32) -> f32 {
    (word >> 8) as f32 * (1.0 / 16_777_216.0)
}

/// A lattice cell (as words, so that negative cells wrap) and the place within it.
fn split(coordinate: f32) -> (u32, f32) {
    let floor = libm::floorf(coordinate);
    (floor as i32 as u32, coordinate - floor)
}

/// Worley's F1: the distance to the nearest of one feature point per unit cell,
/// clamped to 1. The scan of 3x3x3 cells skips those that cannot hold a nearer point.
pub fn worley(p: Vec3, seed: u32) -> f32 {
    let (cx, fx) = split(p[0]);
    let (cy, fy) = split(p[1]);
    let (cz, fz) = split(p[2]);
    let mut nearest = 1.0_f32;
    // The middle cell comes first: its point is usually near, and then most
    // neighbours are skipped without hashing.
    for dz in [0_i32, -1, 1] {
        let gap_z = gap(fz, dz);
        for dy in [0_i32, -1, 1] {
            let gap_y = gap(fy, dy);
            for dx in [0_i32, -1, 1] {
                let gap_x = gap(fx, dx);
                if gap_x * gap_x + gap_y * gap_y + gap_z * gap_z >= nearest {
                    continue;
                }
                let h =
                    hash3(cx.wrapping_add_signed(dx) ^ seed, cy.wrapping_add_signed(dy), cz.wrapping_add_signed(dz));
                let x = dx as f32 + unit(h[0]) - fx;
                let y = dy as f32 + unit(h[1]) - fy;
                let z = dz as f32 + unit(h[2]) - fz;
                let squared = x * x + y * y + z * z;
                if squared < nearest {
                    nearest = squared;
                }
            }
        }
    }
    nearest.sqrt()
}

/// The least distance along one axis from a place within a cell to a neighbouring cell.
fn gap(place: f32, offset: i32) -> f32 {
    match offset {
        0 => 0.0,
        1 => 1.0 - place,
        _ => place,
    }
}

/// Perlin's gradient noise of 2002, about -1 to 1.
pub fn perlin(p: Vec3, seed: u32) -> f32 {
    let (cx, fx) = split(p[0]);
    let (cy, fy) = split(p[1]);
    let (cz, fz) = split(p[2]);
    let corner = |dx: u32, dy: u32, dz: u32| {
        let h = hash3(cx.wrapping_add(dx) ^ seed, cy.wrapping_add(dy), cz.wrapping_add(dz));
        slope(h[0] >> 28, fx - dx as f32, fy - dy as f32, fz - dz as f32)
    };
    let (u, v, w) = (fade(fx), fade(fy), fade(fz));
    let near = mix(mix(corner(0, 0, 0), corner(1, 0, 0), u), mix(corner(0, 1, 0), corner(1, 1, 0), u), v);
    let far = mix(mix(corner(0, 0, 1), corner(1, 0, 1), u), mix(corner(0, 1, 1), corner(1, 1, 1), u), v);
    mix(near, far, w)
}

fn fade(t: f32) -> f32 {
    t * t * t * (t * (t * 6.0 - 15.0) + 10.0)
}

/// Perlin's twelve edge gradients (four of them twice).
fn slope(index: u32, x: f32, y: f32, z: f32) -> f32 {
    let a = if index < 8 { x } else { y };
    let b = if index < 4 {
        y
    } else if index == 12 || index == 14 {
        x
    } else {
        z
    };
    let a = if index & 1 == 0 { a } else { -a };
    let b = if index & 2 == 0 { b } else { -b };
    a + b
}

/// Octaves summed with falling weights; the sum is divided by the weights.
fn fractal(p: Vec3, frequency: f32, octaves: u32, basis: impl Fn(Vec3, u32) -> f32) -> f32 {
    let (mut sum, mut weights, mut weight, mut scale) = (0.0, 0.0, 1.0_f32, frequency);
    for octave in 0..octaves {
        sum += weight * basis([p[0] * scale, p[1] * scale, p[2] * scale], octave);
        weights += weight;
        weight *= 0.55;
        // Not 2: the lattices of the octaves shall not line up.
        scale *= 2.13;
    }
    sum / weights
}

pub fn perlin_fractal(p: Vec3, frequency: f32, octaves: u32, seed: u32) -> f32 {
    fractal(p, frequency, octaves, |q, octave| perlin(q, seed.wrapping_add(octave.wrapping_mul(0x9E37_79B9))))
}

/// Round swellings with sharp creases between them: 1 - F1, summed (0 to 1, mean near 0.45).
pub fn billow(p: Vec3, frequency: f32, octaves: u32, seed: u32) -> f32 {
    fractal(p, frequency, octaves, |q, octave| 1.0 - worley(q, seed.wrapping_add(octave.wrapping_mul(0x9E37_79B9))))
}
