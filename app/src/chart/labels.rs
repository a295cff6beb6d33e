//! Names beside their marks, none over another.
//!
//! Greedy, the important ones first: each name tries eight places around its mark at growing distances and takes the
//! one that hides least; further out, a line leads to the mark. Christensen, Marks and Shieber 1995 compare such ways:
//! greedy is the plainest and enough for a dozen names.

/// A place on the picture, pixels.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Rect {
    pub x: f64,
    pub y: f64,
    pub width: f64,
    pub height: f64,
}

/// A name to place.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// The mark's middle.
    pub at: [f64; 2],
    /// Half of the mark's size.
    pub radius: f64,
    /// The text's width and height.
    pub size: [f64; 2],
}

/// Where a name stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct PlacedLabel {
    pub rect: Rect,
    /// The leading line's end at the name, if the name is away from its mark.
    pub leader: Option<[f64; 2]>,
}

/// Right, left, above, below, and between: (−1, 0 or 1 of the name's half size and the gap).
const SIDES: [[f64; 2]; 8] =
    [[1.0, 0.0], [-1.0, 0.0], [1.0, -1.0], [-1.0, -1.0], [1.0, 1.0], [-1.0, 1.0], [0.0, -1.0], [0.0, 1.0]];
/// From the mark's rim to the name, pixels.
const GAPS_PX: [f64; 8] = [4.0, 14.0, 26.0, 42.0, 62.0, 86.0, 112.0, 140.0];
/// A name this far away is led to its mark by a line, pixels.
const LED_FROM_PX: f64 = 10.0;
/// What a place costs: a square pixel of a name outside or over another name, which only a crowd without a free place
/// may have; one of a mark that is hidden; a pixel of the front under a name; a line that is crossed.
const UNREADABLE: f64 = 1000.0;
const HIDDEN: f64 = 10.0;
const UNDER_LINE: f64 = 2.0;
const CROSSING: f64 = 60.0;

impl Rect {
    fn around([x, y]: [f64; 2], [width, height]: [f64; 2]) -> Self {
        Self { x: x - width / 2.0, y: y - height / 2.0, width, height }
    }

    /// Area in common.
    pub fn overlap(&self, other: &Self) -> f64 {
        let along = |a: f64, a_length: f64, b: f64, b_length: f64| (a + a_length).min(b + b_length) - a.max(b);
        let width = along(self.x, self.width, other.x, other.width);
        let height = along(self.y, self.height, other.y, other.height);
        if width > 0.0 && height > 0.0 { width * height } else { 0.0 }
    }

    fn area(&self) -> f64 {
        self.width * self.height
    }

    fn nearest(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [x.clamp(self.x, self.x + self.width), y.clamp(self.y, self.y + self.height)]
    }

    /// How much of the line from `a` to `b` lies inside, pixels. The line is clipped by each pair of sides in turn
    /// (Liang and Barsky 1984).
    fn covers(&self, a: [f64; 2], b: [f64; 2]) -> f64 {
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (from, to, low, length) in [(a[0], b[0], self.x, self.width), (a[1], b[1], self.y, self.height)] {
            let along = to - from;
            if along == 0.0 {
                if from < low || from > low + length {
                    return 0.0;
                }
                continue;
            }
            let (first, second) = ((low - from) / along, (low + length - from) / along);
            enters = enters.max(first.min(second));
            leaves = leaves.min(first.max(second));
        }
        (leaves - enters).max(0.0) * (b[0] - a[0]).hypot(b[1] - a[1])
    }
}

/// Places `wanted` within `bounds`, in that order, off all marks, `taken` places and, if it can be, `lines`.
pub(crate) fn place(wanted: &[Wanted], bounds: Rect, taken: &[Rect], lines: &[[[f64; 2]; 2]]) -> Vec<PlacedLabel> {
    let marks: Vec<Rect> = wanted.iter().map(|name| Rect::around(name.at, [name.radius * 2.0; 2])).collect();
    let mut names: Vec<PlacedLabel> = Vec::new();
    for (own, name) in wanted.iter().enumerate() {
        let cost = |placed: &PlacedLabel| {
            let rect = &placed.rect;
            let outside = rect.area() - rect.overlap(&bounds);
            let on_marks: f64 = marks.iter().map(|mark| rect.overlap(mark)).sum();
            let on_names: f64 =
                taken.iter().chain(names.iter().map(|other| &other.rect)).map(|r| rect.overlap(r)).sum();
            let on_lines: f64 = lines.iter().map(|[a, b]| rect.covers(*a, *b)).sum();
            let leaders = names.iter().enumerate().filter_map(|(i, other)| Some((wanted[i].at, other.leader?)));
            let on_leaders = leaders.filter(|(a, b)| rect.covers(*a, *b) > 0.0).count() as f64;
            let own_leader = placed.leader.map_or(0.0, |end| {
                let hidden = marks.iter().enumerate().filter(|(i, _)| *i != own).map(|(_, mark)| mark);
                let hidden = hidden.chain(names.iter().map(|other| &other.rect));
                let crossed = hidden.filter(|rect| rect.covers(name.at, end) > 0.0).count() as f64;
                let length = (end[0] - name.at[0]).hypot(end[1] - name.at[1]);
                crossed * CROSSING + length * 0.5
            });
            let cost = UNREADABLE * (outside + on_names)
                + HIDDEN * on_marks
                + UNDER_LINE * on_lines
                + CROSSING * on_leaders
                + own_leader;
            // In whole pixels, or the noise of sums would choose between equals.
            cost.round() as i64
        };
        // The first of equals: near, and to the right.
        let best = candidates(name).min_by_key(cost);
        names.extend(best);
    }
    names
}

fn candidates(name: &Wanted) -> impl Iterator<Item = PlacedLabel> {
    let Wanted { at, radius, size } = *name;
    GAPS_PX.into_iter().flat_map(move |gap| {
        SIDES.into_iter().map(move |[x, y]| {
            let away = radius + gap;
            // On a diagonal, half of the gap goes each way, so that the corner is as near as a side.
            let slant = if x != 0.0 && y != 0.0 { 0.6 } else { 1.0 };
            let middle = [at[0] + x * (away * slant + size[0] / 2.0), at[1] + y * (away * slant + size[1] / 2.0)];
            let rect = Rect::around(middle, size);
            PlacedLabel { rect, leader: (gap > LED_FROM_PX).then(|| rect.nearest(at)) }
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn check(bounds: Rect, size: [f64; 2], places: &[[f64; 2]]) {
        let wanted: Vec<Wanted> = places.iter().map(|at| Wanted { at: *at, radius: 5.0, size }).collect();
        let placed = place(&wanted, bounds, &[], &[]);
        assert_eq!(placed.len(), wanted.len());
        for (i, a) in placed.iter().enumerate() {
            assert!((a.rect.overlap(&bounds) - a.rect.area()).abs() < 1e-6, "{i} of {places:?} leaves the picture");
            for (j, b) in placed.iter().enumerate().skip(i + 1) {
                assert!(a.rect.overlap(&b.rect) == 0.0, "{i} lies over {j} of {places:?}");
            }
        }
    }

    #[test]
    fn names_lie_apart() {
        let window = Rect { x: 0.0, y: 0.0, width: 600.0, height: 400.0 };
        let telephone = Rect { x: 40.0, y: 50.0, width: 300.0, height: 370.0 };
        for (bounds, size) in [(window, [120.0, 15.0]), (telephone, [140.0, 15.0])] {
            let at = |x: f64, y: f64| [bounds.x + x * bounds.width, bounds.y + y * bounds.height];
            check(bounds, size, &[]);
            check(bounds, size, &[at(0.5, 0.5)]);
            for corner in [at(0.0, 0.0), at(1.0, 0.0), at(0.0, 1.0), at(1.0, 1.0)] {
                check(bounds, size, &[corner]);
            }
            check(bounds, size, &[at(0.5, 0.5); 8]);
            check(bounds, size, &std::array::from_fn::<_, 10, _>(|i| at(0.4 + 0.01 * i as f64, 0.5 + 0.01 * i as f64)));
            check(bounds, size, &std::array::from_fn::<_, 10, _>(|i| at(0.1, 0.8 - 0.005 * i as f64)));
        }
    }
}
