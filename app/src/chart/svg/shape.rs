//! What a mark looks like.

use crate::chart::{Family, class};
use std::fmt::Write;

/// A family's mark: truth a diamond, shipped a ringed disc, others a disc, failing a triangle.
pub(super) fn shape(out: &mut String, family: Family, [x, y]: [f64; 2], radius: f64) {
    let class = class(family);
    let polygon = |points: &[[f64; 2]]| {
        let points = points.iter().map(|[dx, dy]| format!("{:.1},{:.1}", x + dx * radius, y + dy * radius));
        format!(r#"<polygon class="mark {class}" points="{}"/>"#, points.collect::<Vec<_>>().join(" "))
    };
    let disc = |radius: f64| format!(r#"<circle class="mark {class}" cx="{x:.1}" cy="{y:.1}" r="{radius:.1}"/>"#);
    let drawn = match family {
        Family::Truth => polygon(&[[0.0, -1.3], [1.3, 0.0], [0.0, 1.3], [-1.3, 0.0]]),
        Family::Shipped => {
            let ring = radius * 1.55;
            disc(radius) + format!(r#"<circle class="ring" cx="{x:.1}" cy="{y:.1}" r="{ring:.1}"/>"#).as_str()
        }
        Family::Other => disc(radius),
        Family::Failing => polygon(&[[0.0, -1.25], [1.2, 0.95], [-1.2, 0.95]]),
    };
    let _ = writeln!(out, "{drawn}");
}
