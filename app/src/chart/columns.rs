//! Every figure of a method once: tables and cards read it here.

use super::report::{Figure, MethodFigures, Stability};

/// One figure of a method.
pub struct Column {
    /// What it belongs to: a heading over several columns.
    pub group: &'static str,
    /// In a table, under its group's heading.
    pub name: &'static str,
    /// Where it stands alone; none if it does not stand in a card.
    pub in_card: Option<&'static str>,
    /// "ms", or nothing.
    pub unit: &'static str,
    /// Its value.
    pub of: fn(&MethodFigures) -> Figure,
}

/// In the order of the report.
pub const COLUMNS: &[Column] = &[
    column("Cost", "frame", Some("frame"), "ms", |m| m.cost.frame_ms),
    column("Cost", "CPU", None, "ms", |m| m.cost.cpu_ms),
    column("Cost", "GPU", Some("GPU"), "ms", |m| m.cost.gpu_ms),
    column("Error", "FLIP, mean", Some("FLIP, mean"), "", |m| m.error.flip_mean),
    column("Error", "FLIP, 99 %", Some("FLIP, 99 %"), "", |m| m.error.flip_p99),
    column("Error", "RMSE", Some("RMSE, linear"), "", |m| m.error.rmse),
    column("Error", "opacity, worst", Some("opacity, worst"), "", |m| m.error.opacity_max),
    column("Excess change", "mean", Some("excess change"), "", |m| stability(m)?.excess_mean),
    column("Excess change", "99.9 %", None, "", |m| stability(m)?.excess_p999),
    column("Excess change", "worst frame", Some("worst frame"), "", |m| stability(m)?.worst_frame),
    column("Counts", "sprites", Some("sprites"), "", |m| Some(m.cost.counts.sprites as f64)),
    column("Counts", "corners shaded", None, "", |m| Some(m.cost.counts.corners_shaded as f64)),
    column("Counts", "fragments", None, "", |m| m.cost.counts.fragments),
    column("Counts", "overdraw, mean", Some("overdraw"), "", |m| m.cost.counts.overdraw_mean),
    column("Counts", "overdraw, 99 %", None, "", |m| m.cost.counts.overdraw_p99),
    column("Counts", "bytes uploaded", None, "", |m| Some(m.cost.counts.bytes_uploaded as f64)),
    column("Counts", "keys sorted", None, "", |m| Some(m.cost.counts.keys_sorted as f64)),
];

const fn column(
    group: &'static str,
    name: &'static str,
    in_card: Option<&'static str>,
    unit: &'static str,
    of: fn(&MethodFigures) -> Figure,
) -> Column {
    Column { group, name, in_card, unit, of }
}

fn stability(method: &MethodFigures) -> Option<&Stability> {
    method.stability.as_ref()
}

/// Those that at least one of `methods` has a figure for.
pub fn filled(methods: &[MethodFigures]) -> Vec<&'static Column> {
    let filled = |column: &&Column| methods.iter().any(|method| (column.of)(method).is_some_and(f64::is_finite));
    COLUMNS.iter().filter(filled).collect()
}
