//! A cloud that forms or dissipates, as saved.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How a cloud comes or goes: its core first and its edges after, or the other way round (W).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Formation {
    /// Which way.
    pub change: FormationChange,
    /// When it begins, seconds of the scene's clock.
    pub start_s: f64,
    /// How long the core takes from clear to solid, seconds.
    pub core_s: f64,
    /// How long the edges take to follow, seconds.
    pub edges_s: f64,
    /// The core's opacity at which the edges begin.
    pub threshold: f64,
}

/// Whether a cloud comes or goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FormationChange {
    /// It comes.
    Forming,
    /// It goes.
    Dissipating,
}
