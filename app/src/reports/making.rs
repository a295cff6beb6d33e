//! A sky as reports have it: air and hour as properties, each layer's clouds by a plugin, as many as cover what they should.
//!
//! A plugin makes a layer at its fullest. Its clouds stand in the order in which they fill the sky, so that the first of
//! them are the layer at less: how many is measured, not guessed, and they form and dissipate between the reports.

use crate::scripting::{self, Request};
use cloudwright_core::arrange;
use cloudwright_core::derived::Derived;
use cloudwright_core::document::{Document, Edit, EditError, ListEdit};
use cloudwright_core::measure::{EYE_M, Observer, sky_cover};
use cloudwright_core::property::NoSuchProperty;
use cloudwright_core::reported::{self, ApplyError, Genus, Place, PlannedLayer, Sky, Strand, Told, Unordered};
use cloudwright_core::scene::{Cloud, CloudId, Date, KeyValue, ModelId, Region, Scene, Site, Thing, TrackKey, Weather};
use cloudwright_core::weather::Moment;
use cloudwright_scripts::{ParameterKind, Patience, Plugin, ScriptError, Values, shipped};
use glam::DVec3;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::atomic::Ordering;
use std::time::Duration;

/// How reports become a sky.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Making {
    /// How many seconds of the reports go by in one of the scene's clock.
    pub speed: f64,
    /// Another one is another sky of the same reports.
    pub seed: u64,
    /// Whether the clouds that are there stay.
    pub keeps_clouds: bool,
    /// Whether the scene moves to the reports' place: as they tell it, or roughly, by the station's name.
    pub moves_site: bool,
    /// The day, if it is known.
    pub date: Option<Date>,
}

/// A layer that was made.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct MadeLayer {
    /// It at its fullest.
    #[serde(flatten)]
    pub layer: PlannedLayer,
    /// The plugin that made it; none if there is nothing to make: fog below eye level, and what the haze hides.
    pub plugin: Option<&'static str>,
    /// Its clouds, in the order in which they cover the sky.
    pub clouds: Vec<CloudId>,
    /// What covers how much, at each report; told beside the layer's own cover.
    #[serde(rename = "covers")]
    pub cover: Vec<Cover>,
}

/// How much of the sky a layer covers at one time, eighths.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Cover {
    /// Of the scene's clock.
    pub time_s: f64,
    /// As the reports have it.
    pub asked_oktas: f64,
    /// As it is seen from below, the layer alone.
    pub measured_oktas: f64,
}

impl MadeLayer {
    /// When it covers most, as the reports have it.
    pub fn fullest(&self) -> Option<Cover> {
        self.cover.iter().copied().reduce(|a, b| if b.asked_oktas > a.asked_oktas { b } else { a })
    }
}

/// What became of reports.
#[derive(Debug, Clone, PartialEq)]
pub struct Made {
    /// What they ask for, with the clock's seconds.
    pub skies: Vec<(f64, Sky)>,
    /// The layers.
    pub layers: Vec<MadeLayer>,
}

/// Reports that no sky could be made of.
#[derive(Debug, thiserror::Error)]
pub enum MakeError {
    /// They are no timeline.
    #[error(transparent)]
    Unordered(#[from] Unordered),
    /// A plugin failed.
    #[error("{plugin}: {error}")]
    Plugin {
        /// Its name.
        plugin: &'static str,
        /// How.
        error: ScriptError,
    },
    /// A fault of ours.
    #[error(transparent)]
    Broken(#[from] ApplyError),
}

impl From<EditError> for MakeError {
    fn from(error: EditError) -> Self {
        Self::Broken(error.into())
    }
}

impl From<NoSuchProperty> for MakeError {
    fn from(error: NoSuchProperty) -> Self {
        Self::Broken(error.into())
    }
}

/// A sky of many layers takes no longer; whoever waits may end it before.
pub const MOST_TIME: Duration = Duration::from_secs(60);

/// How wide a layer lies, in heights of its base, and what it is at least and at most, metres.
const WIDTHS: f64 = 8.0;
const WIDTH_M: [f64; 2] = [12_000.0, 40_000.0];
/// How wide a field of heaps is at most, in heights of theirs: low ones are small, and a field is of so many.
const HEAPS: f64 = 25.0;
/// How far within the border of its field a drifting cloud is whole, as a share of its width.
const BORDER: f64 = 0.12;
/// Fog that is not as deep lies below an observer's eye.
const EYE_LEVEL_M: f64 = 10.0;
/// A thinner deck has gaps: fog that hides the sky is made as thick.
const FOG_M: f64 = 300.0;
/// Keys of bases that differ by less are left out, metres.
const SAME_BASE_M: f64 = 1.0;

/// Has `document`'s scene take the sky of `told`, as one undo point.
///
/// # Errors
/// If the reports are no timeline, or a plugin fails, or `patience` ends; the document is then as before.
pub fn make(document: &mut Document, told: &[Told], making: &Making, patience: &Patience) -> Result<Made, MakeError> {
    document.begin("Weather from a report");
    let made = made(document, told, making, patience);
    closed(document, made)
}

/// Has `document`'s scene take `sky`, as one undo point of that name.
///
/// # Errors
/// If a plugin fails, or `patience` ends; the document is then as before.
pub fn make_sky(
    document: &mut Document,
    name: &str,
    sky: Sky,
    making: &Making,
    patience: &Patience,
) -> Result<Made, MakeError> {
    document.begin(name);
    let made = laid(document, vec![(0.0, sky)], making, patience);
    closed(document, made)
}

/// Keeps what was made, or takes back what was begun.
fn closed(document: &mut Document, made: Result<Made, MakeError>) -> Result<Made, MakeError> {
    match made {
        Ok(made) => {
            document.commit()?;
            Ok(made)
        }
        Err(error) => {
            document.cancel();
            Err(error)
        }
    }
}

fn made(document: &mut Document, told: &[Told], making: &Making, patience: &Patience) -> Result<Made, MakeError> {
    let site = site(&document.scene().site, told, making);
    let here = Place { latitude_deg: site.latitude_deg, longitude_deg: site.longitude_deg };
    document.apply(Edit::Site(site))?;
    let skies = reported::skies(told, here, document.scene())?;
    laid(document, skies, making, patience)
}

fn laid(
    document: &mut Document,
    skies: Vec<(f64, Sky)>,
    making: &Making,
    patience: &Patience,
) -> Result<Made, MakeError> {
    let speed = making.speed.clamp(*reported::SPEEDS.start(), *reported::SPEEDS.end());
    reported::take_air(document, &skies, speed)?;
    if !making.keeps_clouds {
        clear(document)?;
    }
    let strands = reported::strands(skies.iter().map(|(_, sky)| sky.layers.as_slice()));
    let times: Vec<f64> = skies.iter().map(|(time_s, _)| time_s / speed).collect();
    let widest = strands.iter().filter_map(Strand::fullest).map(|layer| width_m(&layer)).fold(0.0, f64::max);
    if widest > 0.0 {
        let region =
            Region { width_m: widest, depth_m: widest, border_m: BORDER * widest, center_x_m: 0.0, center_z_m: 0.0 };
        let weather = Weather { region: Some(region), ..document.scene().weather };
        document.apply(Edit::Weather(weather))?;
    }
    let mut layers = Vec::new();
    for (index, strand) in strands.iter().enumerate() {
        layers.extend(lay(document, strand, &times, making.seed.wrapping_add(index as u64), patience)?);
    }
    Ok(Made { skies: times.into_iter().zip(skies.into_iter().map(|(_, sky)| sky)).collect(), layers })
}

/// Where and on which day the scene is: at the mean of the stations' places, if it moves there.
fn site(before: &Site, told: &[Told], making: &Making) -> Site {
    let date = making.date.unwrap_or(before.date);
    let mut places: BTreeMap<&str, Place> = BTreeMap::new();
    for Told { report, place } in told {
        if let Some(place) = place.or_else(|| reported::roughly(&report.station)) {
            places.insert(&report.station, place);
        }
    }
    let count = places.len() as f64;
    if !making.moves_site || places.is_empty() {
        return Site { date, ..before.clone() };
    }
    // On both sides of the date line, a mean would lie on the other side of the Earth.
    let first_deg = places.values().next().map_or(0.0, |place| place.longitude_deg);
    let mean = |of: &dyn Fn(&Place) -> f64| places.values().map(of).sum::<f64>() / count;
    let east_deg = mean(&|place| (place.longitude_deg - first_deg + 180.0).rem_euclid(360.0) - 180.0);
    let longitude_deg = (first_deg + east_deg + 180.0).rem_euclid(360.0) - 180.0;
    let latitude_deg = mean(&|place| place.latitude_deg);
    Site { latitude_deg, longitude_deg, utc_offset_h: (longitude_deg / 15.0).round(), date }
}

/// All clouds go, and the models that were placed by them.
fn clear(document: &mut Document) -> Result<(), MakeError> {
    let scene = document.scene();
    let placed: BTreeSet<ModelId> = scene.clouds.iter().map(|cloud| cloud.model).collect();
    let clouds = scene.clouds.iter().map(|cloud| Thing::Cloud(cloud.id));
    let doomed: Vec<Thing> = clouds.chain(placed.into_iter().map(Thing::Model)).collect();
    for edit in arrange::delete::things(scene, &doomed).edits {
        document.apply(edit)?;
    }
    Ok(())
}

fn width_m(layer: &PlannedLayer) -> f64 {
    let wide = (WIDTHS * layer.base_m).clamp(WIDTH_M[0], WIDTH_M[1]);
    match layer.genus {
        // A thunder cloud has room of its own, and is seen from afar.
        Genus::Cumulonimbus => WIDTH_M[1],
        Genus::Cumulus => wide.min(HEAPS * layer.thickness_m),
        _ => wide,
    }
}

/// Which plugin makes that kind of cloud.
fn plugin_of(layer: &PlannedLayer) -> Option<&'static str> {
    Some(match layer.genus {
        Genus::Fog if layer.thickness_m < EYE_LEVEL_M => return None,
        Genus::Fog | Genus::Stratocumulus | Genus::Nimbostratus | Genus::Altostratus => "stratocumulus_deck",
        Genus::Stratus => "stratus_sheet",
        Genus::Cumulus | Genus::ToweringCumulus => "cumulus_field",
        Genus::Cumulonimbus => "cumulonimbus",
        Genus::Altocumulus | Genus::Cirrus | Genus::Cirrostratus => "altocumulus_sheet",
    })
}

/// Makes a layer, and has it come and go as it should.
fn lay(
    document: &mut Document,
    strand: &Strand,
    times: &[f64],
    seed: u64,
    patience: &Patience,
) -> Result<Option<MadeLayer>, MakeError> {
    let Some(layer) = strand.fullest() else { return Ok(None) };
    let Some(plugin) = plugin_of(&layer) else {
        return Ok(Some(MadeLayer { layer, plugin: None, clouds: Vec::new(), cover: Vec::new() }));
    };
    let mut clouds = run(document, plugin, &layer, seed, patience)?;
    let derived = Derived::new(document.scene());
    let observer = Observer {
        from: Some(DVec3::new(0.0, ground_m(document.scene()) + EYE_M, 0.0)),
        least_elevation_deg: (2.0 * layer.base_m).atan2(width_m(&layer)).to_degrees(),
        moment: Moment::default(),
    };
    let measured = |count: usize| {
        let meant: BTreeSet<CloudId> = clouds[..count].iter().copied().collect();
        8.0 * sky_cover(document.scene(), &derived, &observer, |cloud| meant.contains(&cloud.id)).covered
    };
    // Few covers are asked for, again and again.
    let mut known: Vec<(f64, usize, f64)> = Vec::new();
    let mut counts = Vec::with_capacity(times.len());
    let mut cover = Vec::with_capacity(times.len());
    for (asked_oktas, time_s) in strand.oktas().zip(times) {
        if patience.cancelled.load(Ordering::Relaxed) {
            return Err(MakeError::Plugin { plugin, error: ScriptError::stopped() });
        }
        let found = known.iter().find(|(asked, ..)| *asked == asked_oktas).copied();
        let (_, count, measured_oktas) = found.unwrap_or_else(|| {
            let (count, oktas) = nearest(asked_oktas, clouds.len(), &measured);
            known.push((asked_oktas, count, oktas));
            (asked_oktas, count, oktas)
        });
        counts.push(count);
        cover.push(Cover { time_s: *time_s, asked_oktas, measured_oktas });
    }
    // The last few that a plugin placed may have been too many.
    let most = counts.iter().copied().max().unwrap_or_default();
    let surplus: Vec<Thing> = clouds.drain(most..).map(Thing::Cloud).collect();
    for edit in arrange::delete::things(document.scene(), &surplus).edits {
        document.apply(edit)?;
    }
    come_and_go(document, &clouds, &counts, times)?;
    rise_and_fall(document, &clouds, strand, &layer, times)?;
    Ok(Some(MadeLayer { layer, plugin: Some(plugin), clouds, cover }))
}

fn ground_m(scene: &Scene) -> f64 {
    scene.ground.as_ref().map_or(0.0, |ground| ground.altitude_m)
}

/// How many of `all` clouds cover what is nearest to `asked` oktas, and what they do; by halving, as each one more hides
/// more.
fn nearest(asked: f64, all: usize, measured: &impl Fn(usize) -> f64) -> (usize, f64) {
    if asked <= 0.0 {
        return (0, 0.0);
    }
    let (mut low, mut high) = ((0, 0.0), (all, measured(all)));
    if high.1 <= asked {
        return high;
    }
    while high.0 - low.0 > 1 {
        let middle = low.0.midpoint(high.0);
        let oktas = measured(middle);
        if oktas < asked { low = (middle, oktas) } else { high = (middle, oktas) }
    }
    if (asked - low.1).abs() < (high.1 - asked).abs() { low } else { high }
}

/// Has the plugin of that name make `layer`; gives its clouds in the order in which it placed them.
fn run(
    document: &mut Document,
    name: &'static str,
    layer: &PlannedLayer,
    seed: u64,
    patience: &Patience,
) -> Result<Vec<CloudId>, MakeError> {
    let failed = |error| MakeError::Plugin { plugin: name, error };
    let source = shipped::named(name).map_or("", |shipped| shipped.source);
    let plugin = Plugin::read(source).map_err(failed)?;
    let values = values(&plugin, layer, seed, document.scene()).map_err(failed)?;
    let there: BTreeSet<CloudId> = document.scene().clouds.iter().map(|cloud| cloud.id).collect();
    let request = Request { plugin: &plugin, scene: document.scene(), selected: &[], values: &values };
    let outcome = scripting::run(request, patience).map_err(failed)?;
    for edit in outcome.edits {
        document.apply(edit)?;
    }
    let new = document.scene().clouds.iter().map(|cloud| cloud.id).filter(|id| !there.contains(id));
    Ok(new.collect())
}

/// What a plugin is told of a layer: what it has a parameter for, as far as it goes.
fn values(plugin: &Plugin, layer: &PlannedLayer, seed: u64, scene: &Scene) -> Result<Values, ScriptError> {
    let parameters = &plugin.description.parameters;
    let width_m = width_m(layer);
    let base_m = layer.base_m + ground_m(scene);
    let told = [
        ("oktas", layer.oktas),
        ("base_m", base_m),
        ("thickness_m", if layer.genus == Genus::Fog { layer.thickness_m.max(FOG_M) } else { layer.thickness_m }),
        ("width_m", width_m),
        ("depth_m", width_m),
        // Beside the towers; no part of the cover.
        ("heaps", 0.0),
        ("wind_from_deg", scene.weather.wind_from_deg),
        ("seed", (seed % 1_000_000) as f64),
    ];
    let mut values = plugin.values();
    for (name, value) in told {
        let Some(parameter) = parameters.iter().find(|parameter| parameter.name == name) else { continue };
        let value = match &parameter.kind {
            ParameterKind::Number(span) | ParameterKind::Integer(span) => value.clamp(span.hard[0], span.hard[1]),
            _ => value,
        };
        values.set(parameters, name, &value.to_string())?;
    }
    Ok(values)
}

/// Clouds form where the next report has more of them, and dissipate where it has fewer: the last ones come last and go
/// first.
fn come_and_go(document: &mut Document, clouds: &[CloudId], counts: &[usize], times: &[f64]) -> Result<(), MakeError> {
    for (index, cloud) in clouds.iter().enumerate() {
        let is_there = |count: &usize| if index < *count { 1.0 } else { 0.0 };
        let shares: Vec<KeyValue> = counts.iter().map(|count| KeyValue::One(is_there(count))).collect();
        for part in ["core", "edges"] {
            key(document, &format!("cloud/{cloud}/formed/{part}"), &shares, times)?;
        }
    }
    Ok(())
}

/// Bases stand where the reports have them, whatever temperature and dew point would make of them.
fn rise_and_fall(
    document: &mut Document,
    clouds: &[CloudId],
    strand: &Strand,
    made: &PlannedLayer,
    times: &[f64],
) -> Result<(), MakeError> {
    if times.len() < 2 {
        return Ok(());
    }
    let there =
        strand.at.iter().zip(times).filter_map(|(layer, time_s)| Some((layer.as_ref()?.base_m - made.base_m, *time_s)));
    let (risen_m, times): (Vec<f64>, Vec<f64>) = there.unzip();
    let moves = risen_m.iter().any(|risen_m| risen_m.abs() >= SAME_BASE_M);
    for id in clouds {
        let cloud = document.scene().clouds.iter().find(|cloud| cloud.id == *id);
        let Some(cloud) = cloud.cloned() else { continue };
        let DVec3 { x, y, z } = cloud.position;
        document.apply(Edit::Cloud(ListEdit::Replace(Cloud { base_share: 0.0, ..cloud })))?;
        if moves {
            let places: Vec<KeyValue> = risen_m.iter().map(|risen_m| KeyValue::Three([x, y + risen_m, z])).collect();
            key(document, &format!("cloud/{id}/position"), &places, &times)?;
        }
    }
    Ok(())
}

/// A track of that property, unless it would stay as it is: of a whole cloud all that is there is whole.
fn key(document: &mut Document, property: &str, values: &[KeyValue], times: &[f64]) -> Result<(), MakeError> {
    if values.iter().all(|value| *value == KeyValue::One(1.0)) {
        return Ok(());
    }
    let keys = times.iter().zip(values).map(|(time_s, value)| TrackKey::new(*time_s, *value)).collect();
    Ok(reported::take_track(document, property.parse()?, keys)?)
}
