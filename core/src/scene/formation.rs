//! How a cloud comes and goes (W): its core first, its edges when the core is dense enough; or backwards.
//!
//! Only the terms are saved; what they make of the cloud at an instant follows from them in closed form.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A change of a whole cloud over time. What the file leaves out has its default.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Formation {
    /// Which way it goes.
    pub change: FormationChange,
    /// When it begins, seconds since play or flight began.
    pub start_s: f64,
    /// How long the core takes from clear to its full opacity, or back, seconds.
    pub core_s: f64,
    /// How long the edges take, seconds.
    pub edges_s: f64,
    /// The core's opacity at which the edges begin to form, or have gone: 0.01 to 1. W's falloff is ½.
    pub threshold: f64,
}

impl Formation {
    /// When nothing of the change is left to come, seconds.
    pub fn end_s(&self) -> f64 {
        self.start_s + self.core_s.max(self.threshold * self.core_s + self.edges_s)
    }
}

/// Which way a cloud changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum FormationChange {
    /// From nothing to the whole cloud, its core first.
    #[default]
    Forming,
    /// From the whole cloud to nothing, its edges first.
    Dissipating,
}

/// How far a cloud has formed, as numbers to set or to key. What the file leaves out has its default: the whole cloud.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct HowFarFormed {
    /// The core's opacity, 0 to 1.
    pub core: f64,
    /// How far the edges have come, 0 to 1.
    pub edges: f64,
}

impl Default for HowFarFormed {
    fn default() -> Self {
        Self { core: 1.0, edges: 1.0 }
    }
}

impl Default for Formation {
    fn default() -> Self {
        Self { change: FormationChange::Forming, start_s: 0.0, core_s: 20.0, edges_s: 30.0, threshold: 0.5 }
    }
}
