//! What tests, benches and asset makers share. Ships nothing.

pub mod atlas;
pub mod authoring;
