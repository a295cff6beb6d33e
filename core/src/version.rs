//! Numbers that tell states apart: a renderer uploads again when the number it drew from is not the one it is given.

use std::sync::atomic::{AtomicU64, Ordering};

/// Equal only for the same state. Never saved; two runs may differ in it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Version(u64);

impl Version {
    /// A number that no state has had.
    pub fn fresh() -> Self {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        Self(NEXT.fetch_add(1, Ordering::Relaxed))
    }
}
