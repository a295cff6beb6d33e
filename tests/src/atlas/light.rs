//! How open to the light each part of a puff is.

use super::density::{OPAQUE, Puff, cell_place, place};
use super::noise::{Vec3, mix};

/// Cells a side of the coarse field that the light is reckoned in: it is coarse on purpose,
/// since fine detail in luminance becomes speckle where many sprites overlap.
const COARSE: usize = 48;
/// The rays that feel for open sky, and how far each goes.
const RAYS: usize = 9;
const RAY_STEPS: u32 = 8;
const RAY_STRIDE: f32 = 0.07;

impl Puff {
    /// How open each coarse cell is to the hemisphere before it (0 to 1). Only the viewer's
    /// hemisphere and the same all round it: a tile may be turned by any angle, so no sun is baked.
    pub fn openness(&self) -> Vec<f32> {
        let mut field = vec![0.0_f32; COARSE * COARSE * COARSE];
        for (layer, cells) in field.chunks_exact_mut(COARSE * COARSE).enumerate() {
            let z = place(layer, COARSE);
            let Some(body) = self.body(COARSE, z, 1) else {
                continue;
            };
            for (index, (cell, &depth)) in cells.iter_mut().zip(&body).enumerate() {
                // No billows: only the greater lobes shall show in the light.
                *cell = self.density(cell_place(index, COARSE, z), depth, 0);
            }
        }
        let rays: [Vec3; RAYS] = core::array::from_fn(|ray| {
            // One ray towards the viewer, the others in a cone about it.
            if ray == 0 {
                return [0.0, 0.0, 1.0];
            }
            let turn = ray as f32 * (2.0 * core::f32::consts::PI / (RAYS - 1) as f32);
            [0.86 * libm::cosf(turn), 0.86 * libm::sinf(turn), 0.51]
        });
        let layer = COARSE * COARSE;
        let mut open = vec![1.0_f32; field.len()];
        // How thick the cloud before each column is: what lies deep is never seen.
        let mut before = vec![0.0_f32; layer];
        let step = self.substance.extinction * 2.0 / COARSE as f32;
        for cell in (0..open.len()).rev() {
            let column = cell % layer;
            if before[column] > OPAQUE {
                continue;
            }
            before[column] += step * field[cell];
            let p = cell_place(column, COARSE, place(cell / layer, COARSE));
            open[cell] = self.open_at(p, &field, &rays);
        }
        open
    }

    fn open_at(&self, p: Vec3, field: &[f32], rays: &[Vec3]) -> f32 {
        let extinction = 1.1 * self.substance.extinction * RAY_STRIDE;
        let mut sum = 0.0;
        for ray in rays {
            let mut thickness = 0.0;
            for step in 1..=RAY_STEPS {
                let far = RAY_STRIDE * step as f32;
                thickness += sample(field, [p[0] + ray[0] * far, p[1] + ray[1] * far, p[2] + ray[2] * far]);
                if thickness * extinction > OPAQUE {
                    break;
                }
            }
            sum += libm::expf(-extinction * thickness);
        }
        sum / rays.len() as f32
    }
}

/// The coarse field between its cells, and nothing outside it.
pub fn sample(field: &[f32], p: Vec3) -> f32 {
    let half = 0.5 * COARSE as f32;
    let axis = |coordinate: f32| {
        let cell = (coordinate + 1.0) * half - 0.5;
        let floor = libm::floorf(cell);
        (floor as i32, cell - floor)
    };
    let (x, fx) = axis(p[0]);
    let (y, fy) = axis(-p[1]);
    let (z, fz) = axis(p[2]);
    let last = COARSE as i32 - 2;
    if x < 0 || y < 0 || z < 0 || x > last || y > last || z > last {
        return 0.0;
    }
    let origin = (z as usize * COARSE + y as usize) * COARSE + x as usize;
    let row = |start: usize| mix(field[start], field[start + 1], fx);
    let plane = |start: usize| mix(row(start), row(start + COARSE), fy);
    mix(plane(origin), plane(origin + COARSE * COARSE), fz)
}
