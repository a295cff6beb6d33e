//! The sky that reports ask for: air and layers, of one station or between several.

use super::{Air, PlannedLayer, layers, strands};
use crate::formats::metar::Report;
use crate::scene::Scene;
use schemars::JsonSchema;
use serde::Serialize;

/// A sky at one time.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct Sky {
    /// Its layers of clouds, lowest first.
    pub layers: Vec<PlannedLayer>,
    /// Its air.
    pub air: Air,
}

/// Layers that cover less are left out, eighths of the sky.
const LEAST_OKTAS: f64 = 0.5;

impl Sky {
    /// What `report` says to `scene`.
    pub fn of(report: &Report, scene: &Scene) -> Self {
        Self { layers: layers(report), air: Air::of(report, scene) }
    }

    /// Between skies that weigh so much each: air and cover are means by weight, a layer's base and thickness those of the
    /// skies that have it; directions of the wind are so as vectors. Its time of day is the first sky's. None of none.
    pub fn between(weighed: &[(f64, Self)]) -> Option<Self> {
        let (_, first) = weighed.first()?;
        let whole: f64 = weighed.iter().map(|(weight, _)| weight).sum();
        if weighed.len() == 1 || whole <= 0.0 {
            return Some(first.clone());
        }
        let mut between: Vec<PlannedLayer> = Vec::new();
        for strand in strands(weighed.iter().map(|(_, sky)| sky.layers.as_slice())) {
            let there = || strand.at.iter().zip(weighed).filter_map(|(layer, (weight, _))| Some((*weight, (*layer)?)));
            let of =
                |value: fn(&PlannedLayer) -> f64| there().map(|(weight, layer)| weight * value(&layer)).sum::<f64>();
            let (weight, oktas) = (of(|_| 1.0), of(|layer| layer.oktas) / whole);
            if let Some(fullest) = strand.fullest().filter(|_| oktas >= LEAST_OKTAS) {
                let (base_m, thickness_m) = (of(|l| l.base_m) / weight, of(|l| l.thickness_m) / weight);
                between.push(PlannedLayer { cover: None, base_m, thickness_m, oktas, ..fullest });
            }
        }
        between.sort_by(|a, b| a.base_m.total_cmp(&b.base_m));
        let airs: Vec<(f64, Air)> = weighed.iter().map(|(weight, sky)| (*weight, sky.air)).collect();
        Some(Self { layers: between, air: Air::between(&airs) })
    }
}
