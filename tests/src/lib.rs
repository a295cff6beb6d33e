//! Shared by the tests and benches: scenes built in code, and comparisons.

pub mod gpu;
