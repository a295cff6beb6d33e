//! Balls sorted for one direction, so that a ray looks at few of them.

use super::ball::{Ball, beyond};
use glam::{Vec2, Vec3};

/// Cells along the longer side of the plane at most.
const MOST_CELLS: f32 = 96.0;
/// Optical depth that counts as no light at all.
const DARK: f32 = 60.0;

/// The balls in cells of the plane across a direction. In a cell, those that reach farthest along it come first.
#[derive(Debug)]
pub(super) struct Along {
    direction: Vec3,
    axes: [Vec3; 2],
    corner: Vec2,
    cells_a_metre: f32,
    size: [usize; 2],
    /// Where each cell's balls begin in `balls`; one more at the end.
    begins: Vec<u32>,
    balls: Vec<Met>,
}

/// Balls that a ray looks at side by side.
const LANES: usize = 8;

/// Balls as rays of one direction meet them, with all of [`Ball::depth_beyond`] that is the same for those. A place that no
/// ball has is deep by nothing.
#[derive(Debug, Clone, Copy)]
struct Met {
    /// How far along the direction any of them reaches, metres.
    reaches: f32,
    center: [[f32; LANES]; 3],
    /// Across and upwards.
    inverse_half: [[f32; LANES]; 2],
    /// The direction in each one's own space, unit.
    along: [[f32; LANES]; 3],
    /// Three quarters of their depths.
    depth: [f32; LANES],
}

impl Met {
    const NONE: Self = Self {
        reaches: f32::MIN,
        center: [[0.0; LANES]; 3],
        inverse_half: [[1.0; LANES]; 2],
        along: [[0.0; LANES]; 3],
        depth: [0.0; LANES],
    };

    fn set(&mut self, lane: usize, ball: &Ball, along: Vec3) {
        for axis in 0..3 {
            (self.center[axis][lane], self.along[axis][lane]) = (ball.center[axis], along[axis]);
        }
        (self.inverse_half[0][lane], self.inverse_half[1][lane]) = (ball.inverse_half[0], ball.inverse_half[1]);
        self.depth[lane] = 0.75 * ball.depth;
    }

    /// The sum of all [`Ball::depth_beyond`]: the same sums, place by place, so that a processor does them side by side.
    #[inline]
    fn depth_beyond(&self, point: Vec3) -> f32 {
        let Self { center, inverse_half: [across, upwards], along, depth, .. } = self;
        let (mut begins, mut squared) = ([0.0; LANES], [0.0; LANES]);
        for lane in 0..LANES {
            let x = (point.x - center[0][lane]) * across[lane];
            let y = (point.y - center[1][lane]) * upwards[lane];
            let z = (point.z - center[2][lane]) * across[lane];
            begins[lane] = x * along[0][lane] + y * along[1][lane] + z * along[2][lane];
            squared[lane] = x * x + y * y + z * z;
        }
        let mut depths = [0.0; LANES];
        for lane in 0..LANES {
            depths[lane] = depth[lane] * beyond(begins[lane], squared[lane]);
        }
        depths.iter().sum()
    }
}

impl Along {
    pub(super) fn new(direction: Vec3, balls: &[Ball]) -> Self {
        let (right, above) = direction.any_orthonormal_pair();
        let on_plane = |ball: &Ball| Vec2::new(ball.center.dot(right), ball.center.dot(above));
        let low = balls.iter().map(|ball| on_plane(ball) - ball.reach()).fold(Vec2::MAX, Vec2::min);
        let high = balls.iter().map(|ball| on_plane(ball) + ball.reach()).fold(Vec2::MIN, Vec2::max);
        let span = (high - low).max(Vec2::splat(1e-3));
        let mean_reach = balls.iter().map(Ball::reach).sum::<f32>() / balls.len().max(1) as f32;
        let cell = (span.max_element() / MOST_CELLS).max(mean_reach * 0.5).max(1e-3);
        let size = [span.x, span.y].map(|side| ((side / cell).ceil() as usize).clamp(1, MOST_CELLS as usize));
        let mut along = Self {
            direction,
            axes: [right, above],
            corner: low,
            cells_a_metre: 1.0 / cell,
            size,
            begins: vec![0; size[0] * size[1] + 1],
            balls: Vec::new(),
        };
        along.fill(balls, on_plane);
        along
    }

    /// Counts each cell's balls, then puts them where they belong, the farthest reaching first.
    fn fill(&mut self, balls: &[Ball], on_plane: impl Fn(&Ball) -> Vec2) {
        let mut in_order: Vec<(f32, &Ball)> = balls
            .iter()
            .filter(|ball| ball.depth > 0.0)
            .map(|ball| (ball.center.dot(self.direction) + ball.reach(), ball))
            .collect();
        in_order.sort_by(|(a, _), (b, _)| b.total_cmp(a));
        let width = self.size[0];
        let covered = |along: &Self, ball: &Ball| {
            let (at, reach) = (on_plane(ball), ball.reach());
            let ([left, top], [right, bottom]) = (along.cell(at - reach), along.cell(at + reach));
            (top..=bottom).flat_map(move |row| row * width + left..row * width + right + 1)
        };
        let mut counts = vec![0_usize; self.size[0] * self.size[1]];
        for (_, ball) in &in_order {
            covered(self, ball).for_each(|cell| counts[cell] += 1);
        }
        for (cell, count) in counts.iter_mut().enumerate() {
            self.begins[cell + 1] = self.begins[cell] + count.div_ceil(LANES) as u32;
            *count = 0;
        }
        let chunks = self.begins.last().map_or(0, |end| *end as usize);
        let mut met = vec![Met::NONE; chunks];
        for (reaches, ball) in in_order {
            let along = ball.along(self.direction);
            for cell in covered(self, ball) {
                let at = &mut met[self.begins[cell] as usize + counts[cell] / LANES];
                at.set(counts[cell] % LANES, ball, along);
                at.reaches = at.reaches.max(reaches);
                counts[cell] += 1;
            }
        }
        self.balls = met;
    }

    fn cell(&self, at: Vec2) -> [usize; 2] {
        let place = (at - self.corner) * self.cells_a_metre;
        [(place.x.max(0.0) as usize).min(self.size[0] - 1), (place.y.max(0.0) as usize).min(self.size[1] - 1)]
    }

    /// Optical depth of all that lies along the direction from `point` on.
    pub(super) fn depth_from(&self, point: Vec3) -> f32 {
        let [column, row] = self.cell(Vec2::new(point.dot(self.axes[0]), point.dot(self.axes[1])));
        let cell = row * self.size[0] + column;
        let begins = point.dot(self.direction);
        let mut depth = 0.0;
        for met in &self.balls[self.begins[cell] as usize..self.begins[cell + 1] as usize] {
            if met.reaches <= begins || depth >= DARK {
                break;
            }
            depth += met.depth_beyond(point);
        }
        depth
    }
}
