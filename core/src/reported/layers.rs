//! The layers that a sky needs: kind of cloud, base, thickness and cover, from a report's groups.
//!
//! Heights part the genera as in the WMO's *International Cloud Atlas* (temperate regions): low clouds below 2 km,
//! middle ones to 6 km, high ones above. Which genus it is a report does not say, but for CB and TCU: the choice here is
//! by what is usual at that height and cover, and by what falls. Thicknesses are round numbers out of the Atlas'
//! descriptions, as reports have none.

use crate::formats::metar::{Cover, Descriptor, LayerKind, Phenomenon, Report, Weather};
use schemars::JsonSchema;
use serde::Serialize;

/// A kind of cloud.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Genus {
    /// On the ground.
    Fog,
    /// A low grey sheet.
    Stratus,
    /// A low sheet of rolls and pads.
    Stratocumulus,
    /// Heaps.
    Cumulus,
    /// Cumulus congestus, reported as TCU.
    ToweringCumulus,
    /// With an anvil; reported as CB.
    Cumulonimbus,
    /// A thick sheet that rains or snows without a pause.
    Nimbostratus,
    /// A middle layer of small pads.
    Altocumulus,
    /// A middle sheet.
    Altostratus,
    /// High threads.
    Cirrus,
    /// A high veil.
    Cirrostratus,
}

impl Genus {
    /// How thick it is taken to be, metres.
    pub(super) fn thickness_m(self, base_m: f64) -> f64 {
        match self {
            Self::Fog => 100.0,
            Self::Stratus => 300.0,
            Self::Stratocumulus => 500.0,
            Self::Cumulus => 800.0,
            Self::ToweringCumulus => 4000.0,
            // To the tropopause of the standard atmosphere, 11 km.
            Self::Cumulonimbus => (11_000.0 - base_m).max(4000.0),
            Self::Nimbostratus => 3000.0,
            Self::Altocumulus => 400.0,
            Self::Altostratus => 1500.0,
            Self::Cirrus => 800.0,
            Self::Cirrostratus => 600.0,
        }
    }

    /// Whether it grows through layers above it.
    fn towers(self) -> bool {
        matches!(self, Self::ToweringCumulus | Self::Cumulonimbus)
    }
}

/// A layer that a sky needs.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct PlannedLayer {
    /// Its kind of cloud.
    pub genus: Genus,
    /// As it stands in the report; none where clouds are told without a cover, or of several reports.
    pub cover: Option<Cover>,
    /// Of its base above the station, metres.
    pub base_m: f64,
    /// Whether the report has no base for it: it is then where air that rises from the ground condenses, or at 1,000 m.
    pub base_assumed: bool,
    /// From base to top, metres.
    pub thickness_m: f64,
    /// Eighths of the sky that it should cover: the middle of its group.
    pub oktas: f64,
}

/// No layer is thinner, metres.
const THIN_M: f64 = 50.0;
/// No heaps are: they grow into the layer above, as fair-weather cumulus do under a deck.
const HEAP_M: f64 = 200.0;

/// The layers of a report's sky, lowest first. A layer of which not even the cover is known is left out; one that only
/// says CB or TCU stands for few of them.
pub fn layers(report: &Report) -> Vec<PlannedLayer> {
    let mut planned: Vec<PlannedLayer> =
        fog(report).into_iter().chain(report.layers.iter().filter_map(|layer| plan(report, layer))).collect();
    planned.sort_by(|a, b| a.base_m.total_cmp(&b.base_m));
    // A sheet ends where the next layer begins, as one sees that one through its gaps.
    let bases: Vec<f64> = planned.iter().map(|layer| layer.base_m).collect();
    for layer in planned.iter_mut().filter(|layer| !layer.genus.towers()) {
        let above = bases.iter().find(|base| **base >= layer.base_m + THIN_M);
        let least = if layer.genus == Genus::Cumulus { HEAP_M } else { THIN_M };
        let room = above.map_or(f64::INFINITY, |base| base - layer.base_m);
        layer.thickness_m = layer.thickness_m.min(room.max(least));
    }
    planned
}

fn plan(report: &Report, layer: &crate::formats::metar::Layer) -> Option<PlannedLayer> {
    let cover = match (layer.cover, layer.kind) {
        (Some(cover), _) => cover,
        (None, LayerKind::Plain) => return None,
        (None, _) => Cover::Few,
    };
    // Fog that hides the sky is one thing with the fog on the ground.
    if cover == Cover::Hidden && fog(report).is_some() {
        return None;
    }
    let [fewest, most] = cover.oktas().map(f64::from);
    let base_m = layer.base_m.unwrap_or_else(|| condensation_m(report));
    let genus = genus(report, cover, layer.kind, base_m);
    let thickness_m = genus.thickness_m(base_m);
    Some(PlannedLayer {
        genus,
        cover: layer.cover,
        base_m,
        base_assumed: layer.base_m.is_none(),
        thickness_m,
        oktas: 0.5 * (fewest + most),
    })
}

pub(super) fn genus(report: &Report, cover: Cover, kind: LayerKind, base_m: f64) -> Genus {
    let any = |phenomena: &[Phenomenon]| {
        let steady = report.weather.iter().filter(|weather| !weather.is(Descriptor::Showers));
        steady.into_iter().any(|weather| phenomena.iter().any(|each| weather.has(*each)))
    };
    let rains = any(&[Phenomenon::Rain, Phenomenon::Snow, Phenomenon::IcePellets, Phenomenon::Unknown]);
    let drizzles = any(&[Phenomenon::Drizzle, Phenomenon::SnowGrains, Phenomenon::Mist, Phenomenon::Fog]);
    let closed = matches!(cover, Cover::Overcast | Cover::Hidden);
    match kind {
        LayerKind::Cumulonimbus => return Genus::Cumulonimbus,
        LayerKind::Towering => return Genus::ToweringCumulus,
        LayerKind::Plain => {}
    }
    match (cover, base_m) {
        (_, base) if base < 6000.0 && closed && rains => Genus::Nimbostratus,
        (Cover::Hidden, _) => Genus::Stratus,
        (Cover::Few | Cover::Scattered, base) if base < 300.0 && drizzles => Genus::Stratus,
        (Cover::Few | Cover::Scattered, base) if base < 2000.0 => Genus::Cumulus,
        (Cover::Broken, base) if base < 300.0 => Genus::Stratus,
        (Cover::Overcast, base) if base < 600.0 || base < 2000.0 && drizzles => Genus::Stratus,
        (_, base) if base < 2000.0 => Genus::Stratocumulus,
        (Cover::Overcast, base) if base < 6000.0 => Genus::Altostratus,
        (_, base) if base < 6000.0 => Genus::Altocumulus,
        (Cover::Few | Cover::Scattered, _) => Genus::Cirrus,
        _ => Genus::Cirrostratus,
    }
}

/// Where rising air condenses: 125 m for each degree from temperature to dew point (Espy, MODEL §9).
fn condensation_m(report: &Report) -> f64 {
    match (report.temperature_c, report.dew_point_c) {
        (Some(temperature), Some(dew_point)) => (125.0 * (temperature - dew_point)).clamp(THIN_M, 4000.0),
        _ => 1000.0,
    }
}

/// Fog at the station as a layer on the ground: as deep as one sees up, where that is told; shallow fog (MI) below eye
/// level, patches (BC) and banks (PR) over about half of the ground.
fn fog(report: &Report) -> Option<PlannedLayer> {
    let fog = report.weather.iter().find(|weather| weather.has(Phenomenon::Fog))?;
    let (usual_m, oktas) = match fog {
        _ if fog.is(Descriptor::Shallow) => (2.0, 8.0),
        _ if [Descriptor::Patches, Descriptor::Partial].iter().any(|each| fog.is(*each)) => (50.0, 4.0),
        Weather { .. } => (Genus::Fog.thickness_m(0.0), 8.0),
    };
    let hidden = report.layers.iter().find(|layer| layer.cover == Some(Cover::Hidden)).and_then(|layer| layer.base_m);
    let thickness_m = hidden.map_or(usual_m, |up| up.max(THIN_M));
    Some(PlannedLayer { genus: Genus::Fog, cover: None, base_m: 0.0, base_assumed: false, thickness_m, oktas })
}
