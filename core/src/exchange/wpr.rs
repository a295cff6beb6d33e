//! A scene's weather as a preset of Microsoft Flight Simulator, and what a preset has that a scene has not.
//!
//! Layers are measured: clouds whose bases lie near one another are one, whose cover is what of the sky it hides, seen from
//! the ground under its middle; the preset has room for three. Wind and temperature are the scene's at that time.

use super::{Arrived, Arriving, Content, ExportError, Files, Leaving, Note, OptionKind, OptionRow, numbered};
use crate::formats::Misread;
use crate::formats::wpr::{CLOUD_LAYERS, CloudLayer, NOWHERE_M, Preset, WIND_KT, WindLayer, Wpr};
use crate::measure::{Observer, sky_cover};
use crate::reported::{FREEZING_K, KNOT_MPS, LAPSE_K_PER_M};
use crate::scene::{CloudId, Scene};
use crate::weather::{CloudNow, Moment, WeatherRules};
use std::collections::BTreeSet;

pub(super) const WRITE_OPTIONS: &[OptionRow] = &[OptionRow {
    name: "each_key",
    kind: OptionKind::Flag(false),
    doc: "Whether each time at which a track has a key has a preset of its own:",
}];

/// A preset for each key: of more, the first.
const MOST_PRESETS: usize = 100;
/// Bases that lie nearer to each other are of one layer, metres.
const ONE_LAYER_M: f64 = 300.0;
/// Of the standard atmosphere; a scene knows no pressure.
const PRESSURE_PA: f64 = 101_325.0;

/// A cloud's part of a layer.
struct Slab {
    id: CloudId,
    bottom_m: f64,
    top_m: f64,
}

/// The weather at the moment that was asked for, or at each key's.
pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let asked = leaving.moment.clock_s;
    let times = if leaving.options.flag("each_key") { key_times(leaving.scene, asked) } else { vec![asked] };
    let mut notes = Vec::new();
    for (at, clock_s) in times.iter().take(MOST_PRESETS).enumerate() {
        if leaving.watch.is_cancelled() {
            return Err(ExportError::Cancelled);
        }
        let (mut preset, told) = preset_at(leaving, *clock_s);
        if times.len() > 1 {
            preset.name = format!("{} {clock_s:.0} s", preset.name);
        }
        for note in told {
            if !notes.contains(&note) {
                notes.push(note);
            }
        }
        let bytes = Wpr::of(&preset).write();
        files.add(&numbered(leaving.name, at + 1), &mut |out| out.write_all(&bytes))?;
        leaving.watch.reach((at + 1) as f32 / times.len() as f32);
    }
    if times.len() > MOST_PRESETS {
        notes.push(Note::left_out(
            format!("{} keys", times.len() - MOST_PRESETS),
            format!("{MOST_PRESETS} leave at once"),
        ));
    }
    if times.len() > 1 {
        notes.push(Note::changed(format!("{} times", times.len().min(MOST_PRESETS)), "each has a preset of its own"));
    }
    notes.push(Note::assumed("pressure", "1013.25 hPa, which a scene does not say"));
    notes.push(Note::assumed("density of clouds", "1, as the scene's sprites say it in another way"));
    Ok(notes)
}

/// Those of all tracks, in order.
fn key_times(scene: &Scene, otherwise: f64) -> Vec<f64> {
    let mut times: Vec<f64> = scene.tracks.iter().flat_map(|track| track.keys.iter().map(|key| key.time_s)).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    if times.is_empty() { vec![otherwise] } else { times }
}

fn preset_at(leaving: &Leaving<'_>, clock_s: f64) -> (Preset, Vec<Note>) {
    let Leaving { scene, derived, now, moment, .. } = leaving;
    let meant: BTreeSet<CloudId> = now.clouds.iter().map(|cloud| cloud.placed.id).collect();
    let clouds = derived.clouds_at(clock_s, WeatherRules::default());
    let mut slabs: Vec<Slab> =
        clouds.iter().filter(|cloud| meant.contains(&cloud.placed.id) && cloud.shows()).map(slab).collect();
    slabs.sort_by(|a, b| a.bottom_m.total_cmp(&b.bottom_m));
    let observer = Observer { moment: Moment { clock_s, ..*moment }, ..Observer::default() };
    let cover = |layer: &[Slab]| {
        let ids: BTreeSet<CloudId> = layer.iter().map(|slab| slab.id).collect();
        sky_cover(scene, derived, &observer, |cloud| ids.contains(&cloud.id)).covered
    };
    let mut layers: Vec<CloudLayer> = parted(&slabs)
        .into_iter()
        .map(|layer| CloudLayer {
            coverage: cover(layer).clamp(0.0, 1.0),
            density: 1.0,
            scattering: 0.0,
            bottom_m: middle(layer.iter().map(|slab| slab.bottom_m)),
            top_m: middle(layer.iter().map(|slab| slab.top_m)),
        })
        .collect();
    let fullest = layers.iter().map(|layer| layer.coverage).fold(0.0, f64::max);
    let nowhere = CloudLayer { bottom_m: NOWHERE_M, top_m: NOWHERE_M, ..CloudLayer::default() };
    layers.resize(CLOUD_LAYERS, nowhere);
    let scene = derived.timeline().surroundings_at(scene, clock_s);
    let ground_m = scene.ground.as_ref().map_or(0.0, |ground| ground.altitude_m);
    let mut notes = Vec::new();
    let asked_kt = scene.weather.wind_speed_mps / KNOT_MPS;
    let speed_kt = asked_kt.clamp(*WIND_KT.start(), *WIND_KT.end());
    if speed_kt != asked_kt {
        notes.push(Note::changed("wind", format!("{asked_kt:.0} kt is cut to {speed_kt:.0}, the simulator's most")));
    }
    let wind = WindLayer {
        altitude_m: ground_m,
        from_deg: scene.weather.wind_from_deg.rem_euclid(360.0),
        speed_kt,
        gust: None,
    };
    let preset = Preset {
        name: scene.name.clone(),
        image: match fullest {
            none if none < 0.03 => "clear_sky",
            some if some < 0.6 => "few_clouds",
            _ => "overcast",
        }
        .into(),
        pressure_pa: Some(PRESSURE_PA),
        temperature_k: Some(scene.weather.temperature_c + FREEZING_K + LAPSE_K_PER_M * ground_m),
        aerosol_density: Some(0.0),
        pollution: Some(0.0),
        precipitation_mm_per_h: Some(0.0),
        snow_m: Some(0.0),
        thunderstorm: Some(0.0),
        above_ground: false,
        clouds: layers,
        winds: vec![wind],
        unknown: Vec::new(),
    };
    (preset, notes)
}

fn slab(cloud: &CloudNow<'_>) -> Slab {
    let placed = cloud.placed;
    let altitude = |y: f32| cloud.origin().y + f64::from(cloud.point_now(placed.center.with_y(y)).y);
    Slab { id: placed.id, bottom_m: altitude(placed.bottom), top_m: altitude(placed.top) }
}

/// Slabs in order of their bases, parted where the gaps between those are widest: into as many layers as a preset has room
/// for, or fewer if nothing else lies apart.
fn parted(slabs: &[Slab]) -> Vec<&[Slab]> {
    let mut gaps: Vec<(f64, usize)> =
        slabs.windows(2).zip(1..).map(|(pair, at)| (pair[1].bottom_m - pair[0].bottom_m, at)).collect();
    gaps.retain(|(gap, _)| *gap >= ONE_LAYER_M);
    gaps.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    gaps.truncate(CLOUD_LAYERS - 1);
    let mut cuts: Vec<usize> = gaps.into_iter().map(|(_, at)| at).collect();
    cuts.sort_unstable();
    let ends = cuts.iter().copied().chain([slabs.len()]);
    let starts = [0].into_iter().chain(cuts.iter().copied());
    starts.zip(ends).map(|(from, to)| &slabs[from..to]).filter(|layer| !layer.is_empty()).collect()
}

/// The value that as many are below as above.
fn middle(values: impl Iterator<Item = f64>) -> f64 {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or_default()
}

/// What a preset says, and what of it no scene takes.
pub(super) fn read(arriving: &Arriving<'_>) -> Result<Arrived, Misread> {
    let preset = Wpr::read(arriving.bytes)?.preset()?;
    let mut notes = Vec::new();
    let is_some = |value: Option<f64>| value.is_some_and(|value| value > 0.0);
    let dropped: Vec<&str> = [
        ("aerosols", is_some(preset.aerosol_density)),
        ("pollution", is_some(preset.pollution)),
        ("falling rain or snow", is_some(preset.precipitation_mm_per_h)),
        ("snow on the ground", is_some(preset.snow_m)),
        ("lightning", is_some(preset.thunderstorm)),
        ("gusts", preset.winds.iter().any(|wind| wind.gust.is_some_and(|gust| gust.speed_kt > 0.0))),
        ("winds above the lowest", preset.winds.len() > 1),
    ]
    .into_iter()
    .filter_map(|(what, is_there)| is_there.then_some(what))
    .collect();
    if !dropped.is_empty() {
        notes.push(Note::left_out(dropped.join(", "), ""));
    }
    if !preset.unknown.is_empty() {
        let mut names = preset.unknown.clone();
        names.sort_unstable();
        names.dedup();
        names.truncate(8);
        notes.push(Note::left_out(names.join(", "), "they are not understood"));
    }
    if preset.clouds.iter().any(|layer| layer.coverage > 0.0 && layer.density > 0.0 && layer.density != 1.0) {
        notes.push(Note::changed("density of clouds", "it decides whether they tower, and is then the clouds' own"));
    }
    Ok(Arrived { content: Content::Weather(Box::new(preset)), notes })
}
