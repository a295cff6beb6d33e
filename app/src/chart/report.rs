//! `chart.json`: what each method costs and gets wrong, for other programs and for a later run that goes on.
//!
//! The structs are the file: a field here is a field there, in this order, after a head that names format and version.
//! Times are milliseconds; errors and stability are those of `cloudwright_core::measure`, none of which has a unit.

use cloudwright_core::formats::{pretty_json, schema};
use cloudwright_core::problem::Problem;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// What the head says.
pub const FORMAT: &str = "cloudwright-chart";
/// What is written, and all that is read.
pub const VERSION: u64 = 1;

/// A measured number, finite and not negative; none if it could not be measured. Written as `null` if it isn't finite.
pub type Figure = Option<f64>;

/// All that was measured of one scene in one view.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct Report {
    /// The scene's name, as a headline.
    pub scene: String,
    /// Width and height of the pictures, pixels.
    pub size: [u32; 2],
    /// What drew: a graphics adapter, or the CPU.
    pub adapter: String,
    /// What was looked at or flown along.
    #[serde(flatten)]
    pub view: Option<Viewpoint>,
    /// In the order in which they were asked for.
    pub methods: Vec<MethodFigures>,
    /// Methods that could not be measured.
    #[serde(default)]
    pub left_out: Vec<LeftOut>,
    /// Tells what was drawn, scene and program, from anything else; empty if that is not known.
    #[serde(default)]
    pub input: String,
    /// Whether there is more to measure: the run was interrupted.
    #[serde(default)]
    pub unfinished: bool,
}

/// From where, by its name in the scene; in the file, `"camera": NAME` or `"path": NAME`.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Viewpoint {
    /// A still.
    Camera(String),
    /// A flight.
    Path(String),
}

/// One way to draw, measured.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct MethodFigures {
    /// Its name in the table of methods.
    pub name: String,
    /// What it does, in words: "sorting" → "by distance".
    pub settings: BTreeMap<String, String>,
    /// Whether it is drawn only to show what it gets wrong: no one can choose it, so it is never on the front.
    #[serde(default)]
    pub known_to_fail: bool,
    /// What it takes.
    pub cost: Cost,
    /// What it gets wrong.
    pub error: Error,
    /// How it flickers along a path; none if there was no path.
    pub stability: Option<Stability>,
    /// Whether no other method is both cheaper and truer; [`Report::mark_front`] says.
    #[serde(default)]
    pub on_front: bool,
    /// What its frames told, one for each place along the path or one for a still; `error` and `stability` sum them up.
    #[serde(default)]
    pub frames: Vec<FrameFigures>,
}

/// What a method takes.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct Cost {
    /// Wall time of a frame, median, milliseconds.
    pub frame_ms: Figure,
    /// The part of it that the CPU works, milliseconds.
    pub cpu_ms: Figure,
    /// By the adapter's own clock, milliseconds; none without an adapter that has one.
    pub gpu_ms: Figure,
    /// What no machine changes.
    pub counts: FrameCounts,
}

/// Work that is the same on every machine.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct FrameCounts {
    /// Sprites drawn.
    pub sprites: u64,
    /// Sprite corners whose light was computed.
    pub corners_shaded: u64,
    /// Fragments blended: an area, so no whole number.
    pub fragments: Figure,
    /// How often a pixel is blended over, on average.
    pub overdraw_mean: Figure,
    /// The same for the pixel that 99 of 100 don't exceed.
    pub overdraw_p99: Figure,
    /// Bytes sent to the adapter for a frame.
    pub bytes_uploaded: u64,
    /// Sprites put in order for a frame.
    pub keys_sorted: u64,
}

/// What a method gets wrong, against the truth.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct Error {
    /// FLIP, mean over the pixels of all frames, 0 to 1.
    pub flip_mean: Figure,
    /// FLIP of the pixel that 99 of 100 don't exceed, in the frame where that is most.
    pub flip_p99: Figure,
    /// Root of the mean squared error in linear light.
    pub rmse: Figure,
    /// Largest error in opacity, 0 to 1.
    pub opacity_max: Figure,
}

/// How much more a method changes from frame to frame than the truth does, in linear light.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct Stability {
    /// Mean over all pixels and frames.
    pub excess_mean: Figure,
    /// What 999 of 1000 pixels don't exceed, from the frame to the next one where that is most.
    pub excess_p999: Figure,
    /// The mean over the pixels of the worst frame.
    pub worst_frame: Figure,
}

/// One frame by one method, against the truth.
#[derive(Debug, Clone, PartialEq, Default, Serialize, JsonSchema, Deserialize)]
pub struct FrameFigures {
    /// Of the scene's clock, seconds: since a path's start.
    pub at_s: f64,
    /// Wall time of drawing it, once, for figures; what a method costs is measured apart, but for the truth.
    pub drawn_ms: Figure,
    /// How much there is to see in it: the standard deviation of the truth's green, 0 to ½ of what a display shows. It
    /// helps to choose the frame that the page shows.
    #[serde(default)]
    pub contrast: f64,
    /// What it gets wrong.
    pub error: Error,
    /// Mean excess change to the next frame; none for a still.
    pub excess_mean: Figure,
    /// What 999 of 1000 pixels don't exceed of it.
    pub excess_p999: Figure,
}

/// A method that could not be measured.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, JsonSchema, Deserialize)]
pub struct LeftOut {
    /// As it was asked for.
    pub name: String,
    /// Why, and what to do about it.
    pub reason: String,
}

impl MethodFigures {
    /// Frame time and mean FLIP, if both were measured: its place in the chart.
    pub fn cost_and_error(&self) -> Option<[f64; 2]> {
        finite(self.cost.frame_ms, self.error.flip_mean)
    }

    /// The same, if one can choose it.
    pub fn choice(&self) -> Option<[f64; 2]> {
        self.cost_and_error().filter(|_| !self.known_to_fail)
    }

    /// Frame time and mean excess change, if both were measured: its place in the chart of stability.
    pub fn cost_and_excess(&self) -> Option<[f64; 2]> {
        finite(self.cost.frame_ms, self.stability.as_ref()?.excess_mean)
    }
}

fn finite(cost: Figure, error: Figure) -> Option<[f64; 2]> {
    Some([cost?, error?]).filter(|point| point.iter().all(|x| x.is_finite()))
}

#[derive(Serialize, JsonSchema)]
struct File<'a> {
    format: &'static str,
    version: u64,
    #[serde(flatten)]
    report: &'a Report,
}

#[derive(Deserialize)]
struct Head {
    format: String,
    version: u64,
}

/// The file's text.
///
/// # Errors
/// None in practice: every report can be said in JSON.
pub fn write(report: &Report) -> Result<String, serde_json::Error> {
    let file = File { format: FORMAT, version: VERSION, report };
    serde_json::to_value(&file).map(|value| pretty_json::write(&value))
}

/// The JSON Schema of the file.
///
/// # Errors
/// None in practice: every schema can be said in JSON.
pub fn json_schema() -> Result<String, serde_json::Error> {
    schema::text_of::<File<'static>>()
}

/// Reads what [`write()`] wrote.
///
/// # Errors
/// What is wrong with it, and in which line.
pub fn read(bytes: &[u8]) -> Result<Report, Problem> {
    let again = "take the file away to have it measured anew";
    let head: Head = serde_json::from_slice(bytes).map_err(|error| problem(&error, again))?;
    if head.format != FORMAT {
        let message = format!("the format is “{}”", head.format);
        return Err(Problem::error("format", message, format!("a chart says \"format\": \"{FORMAT}\"")));
    }
    if head.version != VERSION {
        let message = format!("version {} of the format is not known here", head.version);
        return Err(Problem::error("version", message, format!("this Cloudwright reads version {VERSION}")));
    }
    serde_json::from_slice(bytes).map_err(|error| problem(&error, again))
}

fn problem(error: &serde_json::Error, hint: &str) -> Problem {
    let text = error.to_string();
    let message = text.rsplit_once(" at line ").map_or(text.as_str(), |(message, _)| message);
    Problem::error(format!("line {}, column {}", error.line(), error.column()), message, hint)
}
