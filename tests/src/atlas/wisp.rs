//! The foggy tiles: thin cloud drawn out along a flow.
//!
//! A wisp has no surface to march to, so its optical depth is made in the plane: a few soft
//! patches bent by noise, torn, and combed into filaments by line integral convolution
//! (B. Cabral and L. Leedom, *Imaging Vector Fields Using Line Integral Convolution*, SIGGRAPH 1993).

use super::density::{margin, place};
use super::noise::{perlin, perlin_fractal, saturate, smoothstep};
use super::{TILE_SIZE, Texels};

#[derive(Clone, Copy)]
pub struct Wisp {
    /// `[x, y, half width, half height, strength]`, lying along the flow's mean direction.
    pub patches: &'static [[f32; 5]],
    /// The flow's mean direction, in radians, and how much it swirls.
    pub heading: f32,
    pub swirl: f32,
    /// How strongly the flow is combed into filaments, and their frequency.
    pub comb: f32,
    pub frequency: f32,
    /// How much of the thin parts is torn away.
    pub tear: f32,
    /// Greatest optical depth, about.
    pub thickness: f32,
    pub seed: u32,
}

const STRAND_STEPS: u32 = 16;
const STRAND_STRIDE: f32 = 0.022;

impl Wisp {
    pub fn draw(&self) -> Texels {
        let mut alpha = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        let mut openness = vec![0.0_f32; TILE_SIZE * TILE_SIZE];
        for (texel, (alpha, openness)) in alpha.iter_mut().zip(&mut openness).enumerate() {
            let x = place(texel % TILE_SIZE, TILE_SIZE);
            let y = -place(texel / TILE_SIZE, TILE_SIZE);
            let optical_depth = self.optical_depth(x, y);
            *alpha = 1.0 - libm::expf(-optical_depth);
            // Thin cloud is open: the luminance only sinks a little where it gathers.
            let gathered = perlin([x * 1.7, y * 1.7, 9.5], self.seed ^ 0x11);
            *openness = 0.15 * gathered - 0.1 * *alpha;
        }
        Texels { nearness: vec![0.0; alpha.len()], alpha, openness }
    }

    fn optical_depth(&self, x: f32, y: f32) -> f32 {
        let seed = self.seed;
        let bend = |salt: u32| 0.16 * perlin_fractal([x, y, 3.7], 1.6, 3, seed ^ salt);
        let (wx, wy) = (x + bend(1), y + bend(2));
        let (cos, sin) = (libm::cosf(self.heading), libm::sinf(self.heading));
        let strands = self.strands(wx, wy);
        // The body is looked up along the strands, so that its ends fray into filaments.
        let (flow_x, flow_y) = self.flow(wx, wy);
        let pull = 0.16 * strands;
        let (bx, by) = (wx + pull * flow_x, wy + pull * flow_y);
        let mut clear = 1.0;
        for &[px, py, half_width, half_height, strength] in self.patches {
            let (dx, dy) = (bx - px, by - py);
            let along = (dx * cos + dy * sin) / half_width;
            let across = (dy * cos - dx * sin) / half_height;
            let near = saturate(1.0 - (along * along + across * across).sqrt());
            clear *= 1.0 - strength * near * near * (3.0 - 2.0 * near);
        }
        let body = 1.0 - clear;
        let body = body * smoothstep(0.02, 0.34, margin(x, y));
        if body <= 0.0 {
            return 0.0;
        }
        let clumps = perlin_fractal([wx, wy, 6.1], 2.2, 4, seed ^ 4);
        // Tearing bites where the body is thin and leaves the middle whole; the softness of
        // what remains is squared in, since a threshold alone would leave cut edges.
        // Filaments show in places only: combed all over, fog becomes cloth.
        let combed = smoothstep(-0.35, 0.45, perlin([wx * 2.1, wy * 2.1, 4.4], seed ^ 7));
        let texture = saturate(0.5 + 1.0 * clumps + self.comb * combed * strands);
        let kept = saturate(body - self.tear * (1.0 - body) * (1.0 - texture));
        let feathered = kept * smoothstep(0.0, 0.5, kept);
        self.thickness * feathered * (0.35 + 1.2 * texture)
    }

    /// Noise averaged along the flow through a point, about -1 to 1.
    fn strands(&self, x: f32, y: f32) -> f32 {
        let mut sum = self.grain(x, y);
        for way in [-1.0_f32, 1.0] {
            let (mut px, mut py) = (x, y);
            for step in 0..STRAND_STEPS {
                let (vx, vy) = self.flow(px, py);
                px += way * STRAND_STRIDE * vx;
                py += way * STRAND_STRIDE * vy;
                // Strands end softly.
                let weight = 1.0 - (step + 1) as f32 / (STRAND_STEPS + 1) as f32;
                sum += weight * self.grain(px, py);
            }
        }
        3.0 * sum / (STRAND_STEPS + 1) as f32
    }

    fn grain(&self, x: f32, y: f32) -> f32 {
        perlin_fractal([x, y, 1.3], self.frequency, 2, self.seed ^ 5)
    }

    /// A unit vector: the heading, and the curl of a potential, which never makes sinks.
    fn flow(&self, x: f32, y: f32) -> (f32, f32) {
        const NUDGE: f32 = 0.01;
        let potential = |x: f32, y: f32| perlin([x * 1.5, y * 1.5, 7.9], self.seed ^ 6);
        let here = potential(x, y);
        let curl_x = (potential(x, y + NUDGE) - here) / NUDGE;
        let curl_y = (here - potential(x + NUDGE, y)) / NUDGE;
        let vx = libm::cosf(self.heading) + self.swirl * curl_x;
        let vy = libm::sinf(self.heading) + self.swirl * curl_y;
        let length = (vx * vx + vy * vy).sqrt().max(1e-4);
        (vx / length, vy / length)
    }
}
