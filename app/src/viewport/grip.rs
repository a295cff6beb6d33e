//! How near to a handle a press means it, for all that can be grabbed in the viewport.

use egui::{Mesh, Pos2, Rect, Vec2};

/// A press so near takes it, points: a hand is no finer.
pub(super) const REACH: f32 = 9.0;
/// A press so near that misses it was still meant for it, points: it takes nothing else, and deselects nothing.
pub(super) const BESIDE: f32 = 18.0;

/// Where the pointer takes each of these handles: as far as [`REACH`], but no farther than half the way to the next one, so
/// that the nearest has it.
pub(super) fn grips(middles: &[Pos2]) -> Vec<Rect> {
    let apart = |a: Pos2, b: Pos2| (a.x - b.x).abs().max((a.y - b.y).abs());
    let grip = |(index, at): (usize, &Pos2)| {
        let others = middles.iter().enumerate().filter(|(other, _)| *other != index);
        let nearest = others.map(|(_, other)| apart(*at, *other)).fold(f32::INFINITY, f32::min);
        Rect::from_center_size(*at, Vec2::splat(nearest.clamp(1.0, 2.0 * REACH)))
    };
    middles.iter().enumerate().map(grip).collect()
}

/// The point of what a mesh shows that lies nearest to `at`; none if it shows nothing.
pub(super) fn nearest_of(mesh: &Mesh, at: Pos2) -> Option<Pos2> {
    let corner = |index: u32| mesh.vertices.get(index as usize);
    let nearest = |corners: &[u32]| {
        let corners = [corner(*corners.first()?)?, corner(*corners.get(1)?)?, corner(*corners.get(2)?)?];
        let shows = corners.iter().any(|corner| corner.color.a() > 0);
        shows.then(|| nearest_of_triangle(at, corners.map(|corner| corner.pos)))
    };
    let near = mesh.indices.chunks_exact(3).filter_map(nearest).filter(|near| near.is_finite());
    near.min_by(|a, b| a.distance_sq(at).total_cmp(&b.distance_sq(at)))
}

fn nearest_of_triangle(at: Pos2, [a, b, c]: [Pos2; 3]) -> Pos2 {
    let side = |from: Pos2, to: Pos2| (to.x - from.x) * (at.y - from.y) - (to.y - from.y) * (at.x - from.x);
    let sides = [side(a, b), side(b, c), side(c, a)];
    let has_area = (b - a).x * (c - a).y != (b - a).y * (c - a).x;
    if has_area && (sides.iter().all(|side| *side >= 0.0) || sides.iter().all(|side| *side <= 0.0)) {
        return at;
    }
    let near = [(a, b), (b, c), (c, a)].map(|(from, to)| nearest_of_line(at, from, to));
    near.into_iter().min_by(|a, b| a.distance_sq(at).total_cmp(&b.distance_sq(at))).unwrap_or(a)
}

/// The point of a line from `from` to `to` that lies nearest to `at`.
pub(super) fn nearest_of_line(at: Pos2, from: Pos2, to: Pos2) -> Pos2 {
    let along = to - from;
    let share = (at - from).dot(along) / along.length_sq();
    from + along * if share.is_finite() { share.clamp(0.0, 1.0) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Color32, pos2};

    #[test]
    fn the_nearest_handle_has_the_pointer() {
        let middles = [pos2(0.0, 0.0), pos2(6.0, 2.0), pos2(100.0, 0.0), pos2(100.0, 0.0)];
        let grips = grips(&middles);
        assert_eq!(grips[0].size(), Vec2::splat(6.0));
        assert!(grips[0].right() <= grips[1].left(), "they don't lie on one another");
        assert_eq!(grips[2].size(), Vec2::splat(1.0), "what lies on another can still be reached");
        assert_eq!(super::grips(&middles[..1])[0].size(), Vec2::splat(2.0 * REACH));
    }

    #[test]
    fn the_nearest_point_lies_in_it_or_on_its_rim() {
        let mut mesh = Mesh::default();
        assert_eq!(nearest_of(&mesh, pos2(0.0, 0.0)), None);
        for corner in [pos2(0.0, 0.0), pos2(10.0, 0.0), pos2(0.0, 10.0), pos2(20.0, 20.0)] {
            mesh.colored_vertex(corner, Color32::WHITE);
        }
        mesh.add_triangle(0, 1, 2);
        // Without an area, as feathered ends have it.
        mesh.add_triangle(3, 3, 3);
        // A far side that is not seen.
        for corner in [pos2(26.0, 18.0), pos2(26.0, 20.0), pos2(24.0, 19.0)] {
            mesh.colored_vertex(corner, Color32::TRANSPARENT);
        }
        mesh.add_triangle(4, 5, 6);
        for (at, near) in [
            (pos2(2.0, 3.0), pos2(2.0, 3.0)),
            (pos2(4.0, -7.0), pos2(4.0, 0.0)),
            (pos2(-3.0, -4.0), pos2(0.0, 0.0)),
            (pos2(7.0, 7.0), pos2(5.0, 5.0)),
            (pos2(25.0, 19.0), pos2(20.0, 20.0)),
        ] {
            let found = nearest_of(&mesh, at).expect("it covers something");
            assert!(found.distance(near) < 1e-4, "{found} for {at}");
        }
    }
}
