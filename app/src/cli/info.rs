//! `cloudwright info`: what a scene holds, counted.

use super::answer;
use super::failure::Failure;
use crate::opening;
use crate::units::counted;
use crate::visible::{self, one_line};
use cloudwright_core::derived::Derived;
use cloudwright_core::flight::PathCurve;
use cloudwright_core::measure::{Observer, sky_cover};
use cloudwright_core::scene::{Beyond, CameraPath, CloudId, ModelId, PathId, Prop, Scene, Track};
use cloudwright_core::sprites::PlacedCloud;
use glam::DVec3;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::HashMap;
use std::fmt::Write;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:
  cloudwright info fair_weather.cloudscene
  cloudwright info --json fair_weather.cloudscene

Cover is measured, not counted: eighths of the sky in which clouds are seen, from the ground under their middle at second
0, above 10 degrees. Of tracks: what they move, their keys, the seconds of the first and the last, and what they do before and after.")]
pub(super) struct Arguments {
    /// Scene to count
    scene: PathBuf,
    /// Answer as JSON; lengths in metres
    #[arg(long)]
    json: bool,
}

#[derive(Serialize, JsonSchema)]
pub(super) struct SceneCounts {
    name: String,
    models: usize,
    boxes: usize,
    cameras: Vec<String>,
    paths: Vec<PathCounts>,
    /// What stands, by its name and its file's.
    props: Vec<PropNames>,
    tracks: Vec<TrackCounts>,
    total: Total,
    /// Clouds in hidden folders, which nothing here counts.
    hidden_clouds: usize,
    /// Eighths of the sky that clouds cover at second 0, seen from the ground under their middle, above 10°.
    coverage_oktas: f64,
    clouds: Vec<CloudCounts>,
}

#[derive(Serialize, JsonSchema)]
struct PathCounts {
    name: String,
    /// From its first key to its last.
    duration_s: f64,
    keys: usize,
    /// The names of those that fly along it.
    aircraft: Vec<String>,
}

#[derive(Serialize, JsonSchema)]
struct PropNames {
    name: String,
    model: String,
}

#[derive(Serialize, JsonSchema)]
struct TrackCounts {
    /// The address of what it moves.
    property: String,
    keys: usize,
    from_s: f64,
    to_s: f64,
    before: Beyond,
    after: Beyond,
}

#[derive(Serialize, JsonSchema)]
struct Total {
    clouds: usize,
    /// Each model's as often as it is placed.
    boxes: usize,
    sprites_tried: usize,
    sprites: usize,
    groups: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<Bounds>,
}

#[derive(Serialize, JsonSchema)]
struct CloudCounts {
    id: u64,
    name: String,
    model: String,
    boxes: usize,
    sprites_tried: usize,
    sprites: usize,
    groups: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    bounds: Option<Bounds>,
}

/// The box along the world's axes that holds the spheres of all kept sprites, metres.
#[derive(Serialize, JsonSchema, Clone, Copy)]
struct Bounds {
    #[schemars(with = "[f64; 3]")]
    low: DVec3,
    #[schemars(with = "[f64; 3]")]
    high: DVec3,
}

impl Bounds {
    fn of(cloud: &PlacedCloud) -> Option<Self> {
        let spheres = cloud.sprites.iter().map(|sprite| {
            let center = cloud.origin + sprite.position.as_dvec3();
            Self { low: center - f64::from(sprite.radius()), high: center + f64::from(sprite.radius()) }
        });
        let whole = spheres.reduce(Self::join)?;
        let to_centimetres = |p: DVec3| (p * 100.0).round() / 100.0;
        Some(Self { low: to_centimetres(whole.low), high: to_centimetres(whole.high) })
    }

    fn join(self, other: Self) -> Self {
        Self { low: self.low.min(other.low), high: self.high.max(other.high) }
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<(), Failure> {
    let scene = opening::open_scene(&arguments.scene)?;
    let derived = Derived::new(&scene);
    let covered = sky_cover(&scene, &derived, &Observer::default(), |_| true).covered;
    let counts = SceneCounts { coverage_oktas: (800.0 * covered).round() / 100.0, ..count(&scene, derived.clouds()) };
    answer(&if arguments.json { json_text(&counts)? } else { as_text(&counts) })
}

fn count(scene: &Scene, placed: &[PlacedCloud]) -> SceneCounts {
    let models = scene.models_by_id();
    let model_of: HashMap<CloudId, ModelId> = scene.clouds.iter().map(|cloud| (cloud.id, cloud.model)).collect();
    let clouds: Vec<CloudCounts> = placed
        .iter()
        .map(|cloud| {
            let model = model_of.get(&cloud.id).and_then(|model| models.get(model));
            CloudCounts {
                id: cloud.id.0,
                name: cloud.name.clone(),
                model: model.map(|model| model.name.clone()).unwrap_or_default(),
                boxes: model.map_or(0, |model| model.boxes.len()),
                sprites_tried: cloud.candidate_count,
                sprites: cloud.sprites.len(),
                groups: cloud.groups.len(),
                bounds: Bounds::of(cloud),
            }
        })
        .collect();
    SceneCounts {
        name: scene.name.clone(),
        models: scene.models.len(),
        boxes: scene.models.iter().map(|model| model.boxes.len()).sum(),
        cameras: scene.cameras.iter().map(|camera| camera.name.clone()).collect(),
        paths: paths(scene),
        props: scene.props.iter().map(prop).collect(),
        tracks: scene.tracks.iter().map(count_track).collect(),
        hidden_clouds: scene.clouds.iter().filter(|cloud| !scene.is_seen(cloud)).count(),
        coverage_oktas: 0.0,
        total: Total {
            clouds: clouds.len(),
            boxes: clouds.iter().map(|cloud| cloud.boxes).sum(),
            sprites_tried: clouds.iter().map(|cloud| cloud.sprites_tried).sum(),
            sprites: clouds.iter().map(|cloud| cloud.sprites).sum(),
            groups: clouds.iter().map(|cloud| cloud.groups).sum(),
            bounds: clouds.iter().filter_map(|cloud| cloud.bounds).reduce(Bounds::join),
        },
        clouds,
    }
}

fn paths(scene: &Scene) -> Vec<PathCounts> {
    let mut aircraft: HashMap<PathId, Vec<String>> = HashMap::new();
    for each in &scene.aircraft {
        aircraft.entry(each.path).or_default().push(each.name.clone());
    }
    let count = |path: &CameraPath| PathCounts {
        name: path.name.clone(),
        duration_s: PathCurve::new(path).duration_s(),
        keys: path.keys.len(),
        aircraft: aircraft.remove(&path.id).unwrap_or_default(),
    };
    scene.paths.iter().map(count).collect()
}

fn prop(prop: &Prop) -> PropNames {
    PropNames { name: prop.name.clone(), model: prop.model.clone() }
}

fn count_track(track: &Track) -> TrackCounts {
    let [from_s, to_s] = [track.keys.first(), track.keys.last()].map(|key| key.map_or(0.0, |key| key.time_s));
    let (keys, before, after) = (track.keys.len(), track.before, track.after);
    TrackCounts { property: track.property.clone(), keys, from_s, to_s, before, after }
}

const fn beyond_in_words(beyond: Beyond) -> &'static str {
    match beyond {
        Beyond::Hold => "holds",
        Beyond::Repeat => "repeats",
        Beyond::Swing => "swings",
    }
}

fn as_text(counts: &SceneCounts) -> String {
    let SceneCounts {
        name,
        models,
        boxes,
        cameras,
        paths,
        props,
        tracks,
        total,
        hidden_clouds,
        coverage_oktas,
        clouds,
    } = counts;
    let [models, boxes] = [counted(*models, "model", "models"), counted(*boxes, "box", "boxes")];
    let mut out = one_line(&format!("{name}: {models}, {boxes}, {}", counted(total.clouds, "cloud", "clouds")));
    let _ = writeln!(out, "\ncameras: {}", one_line(&cameras.join(", ")));
    if *hidden_clouds > 0 {
        let clouds = counted(*hidden_clouds, "cloud", "clouds");
        let _ = writeln!(out, "hidden: {clouds} in hidden folders, not counted here");
    }
    let above = Observer::LEAST_ELEVATION_DEG;
    let _ = writeln!(
        out,
        "cover: {coverage_oktas:.1} oktas of the sky above {above}°, from the ground under their middle\n"
    );
    if !paths.is_empty() {
        let _ = writeln!(out, "{:<24} {:>10} {:>6}  aircraft", "path", "seconds", "keys");
        for PathCounts { name, duration_s, keys, aircraft } in paths {
            let [name, aircraft] = [name, &aircraft.join(", ")].map(|text| one_line(text));
            let aircraft = if aircraft.is_empty() { "none" } else { &aircraft };
            let _ = writeln!(out, "{name:<24} {duration_s:>10.1} {keys:>6}  {aircraft}");
        }
        out.push('\n');
    }
    if !props.is_empty() {
        let props: Vec<String> = props.iter().map(|PropNames { name, model }| format!("{name} ({model})")).collect();
        let _ = writeln!(out, "props: {}\n", one_line(&props.join(", ")));
    }
    write_tracks(&mut out, tracks);
    let _ = writeln!(out, "{:<24} {:>6} {:>8} {:>8} {:>6}  bounds, m", "cloud", "boxes", "tried", "sprites", "groups");
    for cloud in clouds {
        let CloudCounts { name, boxes, sprites_tried, sprites, groups, bounds, .. } = cloud;
        let name = one_line(name);
        let bounds = in_words(*bounds);
        let _ = writeln!(out, "{name:<24} {boxes:>6} {sprites_tried:>8} {sprites:>8} {groups:>6}  {bounds}");
    }
    let Total { boxes, sprites_tried, sprites, groups, bounds, .. } = total;
    let bounds = in_words(*bounds);
    let _ = writeln!(out, "{:<24} {boxes:>6} {sprites_tried:>8} {sprites:>8} {groups:>6}  {bounds}", "total");
    out
}

fn write_tracks(out: &mut String, tracks: &[TrackCounts]) {
    if tracks.is_empty() {
        return;
    }
    let _ = writeln!(out, "{:<32} {:>6} {:>10} {:>10}  {:<8} after", "track", "keys", "from, s", "to, s", "before");
    for TrackCounts { property, keys, from_s, to_s, before, after } in tracks {
        let property = one_line(property);
        let [before, after] = [*before, *after].map(beyond_in_words);
        let _ = writeln!(out, "{property:<32} {keys:>6} {from_s:>10.1} {to_s:>10.1}  {before:<8} {after}");
    }
    out.push('\n');
}

fn in_words(bounds: Option<Bounds>) -> String {
    let Some(Bounds { low, high }) = bounds else { return "none".into() };
    let axis = |low: f64, high: f64| format!("{low:.0} to {high:.0}");
    format!("x {}, y {}, z {}", axis(low.x, high.x), axis(low.y, high.y), axis(low.z, high.z))
}

/// Any answer as JSON text.
pub(super) fn json_text(value: &impl Serialize) -> Result<String, Failure> {
    serde_json::to_string_pretty(value)
        .map(|text| visible::json(&text) + "\n")
        .map_err(|error| Failure::Stdout(error.into()))
}
