//! A simulator's weather preset as a sky, by the same table of genera as a report's.
//!
//! A preset tells cover, base and top itself, and what falls by its rate; which genus that is it tells as little as a
//! report. Where its layers reach to no top of their own (the simulator fills them with towers), the genus' usual thickness
//! is taken. Layers on the ground are fog; those that overlap there are one.

use super::layers::genus;
use super::{Air, Genus, PlannedLayer, Sky};
use crate::formats::metar::{Cover, Intensity, LayerKind, Phenomenon, Report, Weather as Fallen, Wind, WindFrom};
use crate::formats::wpr::{CloudLayer, Preset};
use crate::scene::Scene;

/// A knot, metres a second.
pub const KNOT_MPS: f64 = 1852.0 / 3600.0;
/// 0 °C.
pub const FREEZING_K: f64 = 273.15;
/// Of the standard atmosphere, kelvins for each metre (ISO 2533).
pub const LAPSE_K_PER_M: f64 = 0.0065;

/// Nothing is left of a thinner layer, or of one that covers less.
const LEAST_M: f64 = 50.0;
const LEAST_OKTAS: f64 = 0.25;
/// Bases below this are on the ground, metres.
const ON_GROUND_M: f64 = 30.0;
/// From such a thickness on, clouds that leave gaps are towers, metres.
const TOWER_M: f64 = 2500.0;
/// And thunder clouds, if there is lightning, metres.
const THUNDER_M: f64 = 5000.0;
/// Thinner air is no tower, however high the layer reaches: density, 0 to 1.
const DENSE: f64 = 0.5;
/// Towers stand on low bases, metres.
const TOWER_BASE_M: f64 = 3000.0;
/// No cloud is higher: a layer that reaches above has no top of its own, metres.
const HIGHEST_M: f64 = 20_000.0;
/// Such a layer ends at the tropopause of the standard atmosphere, metres, or is as thick as this if it begins above.
const TROPOPAUSE_M: f64 = 11_000.0;
const ABOVE_M: f64 = 600.0;

impl Sky {
    /// What `preset` says to `scene`, whose hour and dew point stay.
    pub fn of_preset(preset: &Preset, scene: &Scene) -> Self {
        let ground_m = scene.ground.as_ref().map_or(0.0, |ground| ground.altitude_m);
        let below_m = if preset.above_ground { 0.0 } else { ground_m };
        let report = report(preset, ground_m);
        let mut layers: Vec<PlannedLayer> =
            preset.clouds.iter().filter_map(|layer| plan(&report, preset, layer, below_m)).collect();
        layers.sort_by(|a, b| a.base_m.total_cmp(&b.base_m));
        let air = Air { time_of_day_h: scene.time_of_day_h, ..Air::of(&report, scene) };
        Self { layers: with_one_fog(layers), air }
    }
}

/// The preset's wind, temperature and precipitation at the ground.
fn report(preset: &Preset, ground_m: f64) -> Report {
    let lowest = preset.winds.iter().min_by(|a, b| a.altitude_m.total_cmp(&b.altitude_m));
    let wind = lowest.map(|wind| Wind {
        from: WindFrom::Deg(wind.from_deg.rem_euclid(360.0)),
        speed_mps: (wind.speed_kt * KNOT_MPS).max(0.0),
        gust_mps: wind.gust.map(|gust| (gust.speed_kt * KNOT_MPS).max(0.0)),
    });
    let temperature_c = preset.temperature_k.map(|kelvin| kelvin - FREEZING_K - LAPSE_K_PER_M * ground_m);
    let falls = preset.precipitation_mm_per_h.is_some_and(|rate| rate > 0.0);
    let freezes = temperature_c.is_some_and(|celsius| celsius < 0.0);
    let fallen = || Fallen {
        intensity: Intensity::Moderate,
        nearby: false,
        descriptors: Vec::new(),
        phenomena: vec![if freezes { Phenomenon::Snow } else { Phenomenon::Rain }],
    };
    Report {
        station: String::new(),
        day: 1,
        hour: 0,
        minute: 0,
        wind,
        visibility: None,
        layers: Vec::new(),
        clear: None,
        weather: if falls { vec![fallen()] } else { Vec::new() },
        temperature_c,
        dew_point_c: None,
        pressure_hpa: preset.pressure_pa.map(|pascal| pascal / 100.0),
    }
}

fn plan(report: &Report, preset: &Preset, layer: &CloudLayer, below_m: f64) -> Option<PlannedLayer> {
    let oktas = 8.0 * layer.coverage.clamp(0.0, 1.0);
    let (bottom_m, top_m) = (layer.bottom_m - below_m, layer.top_m - below_m);
    let base_m = bottom_m.max(0.0);
    let top_m = if top_m > HIGHEST_M { TROPOPAUSE_M.max(base_m + ABOVE_M) } else { top_m };
    let full_m = top_m - base_m;
    if base_m > HIGHEST_M {
        return None;
    }
    if oktas < LEAST_OKTAS || layer.density <= 0.0 || full_m < LEAST_M {
        return None;
    }
    let cover = match oktas {
        few if few <= 2.5 => Cover::Few,
        scattered if scattered <= 4.5 => Cover::Scattered,
        broken if broken < 7.5 => Cover::Broken,
        _ => Cover::Overcast,
    };
    let thunders = preset.thunderstorm.is_some_and(|share| share > 0.0);
    let is_dense = layer.density >= DENSE;
    let kind = match cover {
        _ if bottom_m <= ON_GROUND_M => LayerKind::Plain,
        _ if thunders && is_dense && base_m < TOWER_BASE_M && full_m >= THUNDER_M => LayerKind::Cumulonimbus,
        Cover::Few | Cover::Scattered if is_dense && base_m < TOWER_BASE_M && full_m >= TOWER_M => LayerKind::Towering,
        _ => LayerKind::Plain,
    };
    let genus = if bottom_m <= ON_GROUND_M { Genus::Fog } else { genus(report, cover, kind, base_m) };
    // A layer is as thick as the preset has it, unless that is no thickness of such a cloud.
    let usual_m = genus.thickness_m(base_m);
    let thickness_m = if genus == Genus::Fog { full_m } else { full_m.min(2.0 * usual_m) };
    Some(PlannedLayer { genus, cover: Some(cover), base_m, base_assumed: false, thickness_m, oktas })
}

/// Layers of fog stand on the same ground: they are one, as deep as the deepest and as full as the fullest.
fn with_one_fog(layers: Vec<PlannedLayer>) -> Vec<PlannedLayer> {
    let (fogs, mut others): (Vec<_>, Vec<_>) = layers.into_iter().partition(|layer| layer.genus == Genus::Fog);
    let joined = fogs.into_iter().reduce(|a, b| PlannedLayer {
        thickness_m: a.thickness_m.max(b.thickness_m),
        ..if b.oktas > a.oktas { b } else { a }
    });
    others.splice(0..0, joined);
    others
}
