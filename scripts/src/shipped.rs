//! The plugins within the program, each an example worth reading.

/// One of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shipped {
    /// Of its file, and on the command line.
    pub name: &'static str,
    /// The script.
    pub source: &'static str,
}

/// All that there are, by name.
pub const SHIPPED: &[Shipped] = &[
    Shipped { name: "diurnal_cycle", source: include_str!("../plugins/diurnal_cycle.rhai") },
    Shipped { name: "golden_hour", source: include_str!("../plugins/golden_hour.rhai") },
    Shipped { name: "scatter_clouds", source: include_str!("../plugins/scatter_clouds.rhai") },
    Shipped { name: "sprite_table", source: include_str!("../plugins/sprite_table.rhai") },
];

/// The one of that name.
pub fn named(name: &str) -> Option<&'static Shipped> {
    SHIPPED.iter().find(|shipped| shipped.name == name)
}
