//! What of the page's scene is told as JSON: names, cameras, where things stand in the block, and the constants of our
//! rules.

use super::super::Leaving;
use super::block::{Block, Section};
use super::clouds::Listed;
use super::light;
use crate::baked::DIRECTIONS;
use crate::camera::{NEAR_M, View};
use crate::scene::Camera;
use crate::sprites::{MIP_LEVELS, TILE_SIZE};
use crate::weather::shadows;
use crate::{facing, raster, shading, sky, tone, weather};
use serde::Serialize;
use std::collections::BTreeMap;

#[derive(Debug, Serialize)]
pub(super) struct Header<'a> {
    format: &'static str,
    version: u32,
    name: &'a str,
    cameras: Vec<NamedCamera<'a>>,
    start: Start,
    /// Where the clock begins again; 0 if it moves nothing.
    end_s: f64,
    /// The seconds of the clock at which the block has a day's light.
    days_s: Vec<f64>,
    ground_altitude_m: Option<f64>,
    rows_an_hour: usize,
    light_fields: &'a [(&'static str, usize)],
    mean_opacities: Vec<f32>,
    swings_s: [f64; 3],
    constants: BTreeMap<&'static str, f64>,
    sections: &'a [Section],
    clouds: Vec<Listed>,
}

/// A camera as it is at the moment.
#[derive(Debug, Serialize)]
struct NamedCamera<'a> {
    name: &'a str,
    position: [f64; 3],
    heading_deg: f64,
    pitch_deg: f64,
    roll_deg: f64,
    field_of_view_deg: f64,
}

/// What the page shows first.
#[derive(Debug, Serialize)]
struct Start {
    /// Index of the camera.
    camera: usize,
    clock_s: f64,
    /// None: the scene's own.
    time_h: Option<f64>,
}

/// What the clock is to the page.
#[derive(Debug)]
pub(super) struct Times {
    /// Where it begins again; 0 if it moves nothing.
    pub(super) end_s: f64,
    /// When there is a day's light.
    pub(super) days_s: Vec<f64>,
}

impl<'a> Header<'a> {
    pub(super) fn new(
        leaving: &Leaving<'a>,
        view: &View,
        block: &'a Block,
        Times { end_s, days_s }: Times,
        clouds: Vec<Listed>,
    ) -> Self {
        let Leaving { scene, derived, moment, now, atlas, .. } = *leaving;
        let timeline = derived.timeline();
        let cameras: Vec<(&str, Camera)> = scene
            .cameras
            .iter()
            .map(|camera| (camera.name.as_str(), timeline.camera_at(camera, moment.clock_s)))
            .collect();
        let is_first = |(_, camera): &(&str, Camera)| View::new(camera, view.width, view.height) == *view;
        let start = Start {
            camera: cameras.iter().position(is_first).unwrap_or(0),
            clock_s: moment.clock_s,
            time_h: moment.time_h,
        };
        let named = |(name, camera): (&'a str, Camera)| NamedCamera {
            name,
            position: camera.position.to_array(),
            heading_deg: camera.heading_deg,
            pitch_deg: camera.pitch_deg,
            roll_deg: camera.roll_deg,
            field_of_view_deg: camera.field_of_view_deg,
        };
        Self {
            format: "cloudwright-web",
            version: 1,
            name: &scene.name,
            cameras: cameras.into_iter().map(named).collect(),
            start,
            end_s,
            days_s,
            ground_altitude_m: now.ground.as_ref().map(|ground| ground.altitude_m),
            rows_an_hour: light::ROWS_AN_HOUR,
            light_fields: &light::FIELDS,
            mean_opacities: (0..crate::sprites::TILES).map(|tile| atlas.mean_opacity(tile)).collect(),
            swings_s: weather::SWINGS_S,
            constants: constants(),
            sections: &block.sections,
            clouds,
        }
    }
}

/// The numbers of our rules, by the names that the page's scripts and shaders have for them.
fn constants() -> BTreeMap<&'static str, f64> {
    let [pole_from, pole_to] = facing::upright::POLE;
    let [disc_from, disc_to] = sky::SUN_DISC_COSINES;
    let [cell_0, cell_1, cell_2, cell_3] = sky::GROUND_CELLS_M;
    let singles = [
        ("NEAR_M", NEAR_M),
        ("LOCK_SHARE", facing::LOCK_SHARE),
        ("SHELL", facing::SHELL),
        ("POLE_FROM", pole_from),
        ("POLE_TO", pole_to),
        ("RELAXING", facing::upright::RELAXING),
        ("REACH", weather::REACH),
        ("SWAY", weather::SWAY),
        ("CONDENSING", weather::CONDENSING),
        ("HORIZON_SINE", sky::HORIZON_SINE),
        ("GLOW_KEPT", sky::GLOW_KEPT),
        ("GLOW_FROM_COSINE", sky::GLOW_FROM_COSINE),
        ("SUN_DISC_COSINE_FROM", disc_from),
        ("SUN_DISC_COSINE_TO", disc_to),
        ("GROUND_PERIOD_M", sky::GROUND_PERIOD_M as f32),
        ("GROUND_CELL_0_M", cell_0),
        ("GROUND_CELL_1_M", cell_1),
        ("GROUND_CELL_2_M", cell_2),
        ("GROUND_CELL_3_M", cell_3),
        ("SHOULDER", tone::SHOULDER),
        ("TILE_SIZE", TILE_SIZE as f32),
        ("LAST_MIP", (MIP_LEVELS - 1) as f32),
        ("FINER", raster::FINER),
        ("MOST_OPAQUE", shading::MOST_OPAQUE),
        ("BEFORE_THE_EYE", shading::BEFORE_THE_EYE),
        ("SCATTERED", shading::SCATTERED),
        ("STRAIGHT", shading::STRAIGHT),
        ("SKY_KEPT_OUT", shading::SKY_KEPT_OUT),
        ("FROM_BELOW", shading::FROM_BELOW),
        ("FORWARD", shading::FORWARD),
        ("HALO", shading::HALO),
        ("BAKED_PARTS", DIRECTIONS.parts() as f32),
        ("SHADOW_TEXELS", shadows::MOST_TEXELS as f32),
        ("SUN_RADIUS", shadows::SUN_RADIUS),
        ("UNDER_A_CLOUD_SCATTERED", shadows::UNDER_A_CLOUD[0]),
        ("UNDER_A_CLOUD_STRAIGHT", shadows::UNDER_A_CLOUD[1]),
    ];
    singles.into_iter().map(|(name, value)| (name, f64::from(value))).collect()
}
