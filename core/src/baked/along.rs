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

/// A ball as rays of one direction meet it, with all of [`Ball::depth_beyond`] that is the same for them.
#[derive(Debug, Clone, Copy)]
struct Met {
    /// How far along the direction it reaches, metres.
    reaches: f32,
    center: Vec3,
    inverse_half: [f32; 2],
    /// The direction in its own space, unit.
    along: Vec3,
    /// Three quarters of its depth.
    depth: f32,
}

impl Met {
    fn new(ball: &Ball, direction: Vec3, reaches: f32) -> Self {
        let [across, upwards] = ball.inverse_half;
        let along = Vec3::new(direction.x * across, direction.y * upwards, direction.z * across);
        Self {
            reaches,
            center: ball.center,
            inverse_half: ball.inverse_half,
            along: along / along.length_squared().sqrt(),
            depth: 0.75 * ball.depth,
        }
    }

    /// As [`Ball::depth_beyond`].
    #[inline]
    fn depth_beyond(&self, point: Vec3) -> f32 {
        let [across, upwards] = self.inverse_half;
        let off = point - self.center;
        self.depth * beyond(Vec3::new(off.x * across, off.y * upwards, off.z * across), self.along)
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

    fn fill(&mut self, balls: &[Ball], on_plane: impl Fn(&Ball) -> Vec2) {
        let mut entries: Vec<(u32, f32, u32)> = Vec::new();
        for (index, ball) in balls.iter().enumerate().filter(|(_, ball)| ball.depth > 0.0) {
            let at = on_plane(ball);
            let ([left, top], [right, bottom]) = (self.cell(at - ball.reach()), self.cell(at + ball.reach()));
            let reaches = ball.center.dot(self.direction) + ball.reach();
            for row in top..=bottom {
                let cells = (left..=right).map(|column| (row * self.size[0] + column) as u32);
                entries.extend(cells.map(|cell| (cell, reaches, index as u32)));
            }
        }
        entries.sort_unstable_by(|a, b| a.0.cmp(&b.0).then(b.1.total_cmp(&a.1)).then(a.2.cmp(&b.2)));
        for (cell, ..) in &entries {
            self.begins[*cell as usize + 1] += 1;
        }
        for cell in 1..self.begins.len() {
            self.begins[cell] += self.begins[cell - 1];
        }
        let met = |(_, reaches, index): (u32, f32, u32)| Met::new(&balls[index as usize], self.direction, reaches);
        self.balls = entries.into_iter().map(met).collect();
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
