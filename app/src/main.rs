//! The `cloudwright` program.
fn main() {}
