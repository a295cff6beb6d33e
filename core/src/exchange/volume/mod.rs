//! Clouds as volumes: grids of extinction for path tracers, which light them themselves.
//!
//! Each cloud has a file of its own, but for Mitsuba those that touch have one together: it holds one medium at a place.
//! Along the timeline each moment has such files of its own, all of the same number, so that programs find them as a
//! sequence. Where a cloud shows nothing, its volume is one clear voxel. How near opacity comes to the sprites' is said of
//! each ([`crate::density::chord`]).

mod mitsuba;

use super::{ExportError, Files, Leaving, Note, OptionKind, OptionRow, numbered};
use crate::density::{Density, DensityError, DensityGrid, Fineness, MOST_VOXELS, Vapour, chord};
use crate::formats::{mitsuba_vol, vdb};
use crate::property::Number;
use crate::scene::CloudId;
use crate::weather::{CloudNow, Moment, SceneNow, WeatherRules};
use glam::{DVec3, UVec3};
use std::collections::BTreeSet;
use std::io::{self, Write};

const LONGEST: Number = Number::new("Longest side", &(4.0..=1024.0), "voxels", "Of the largest cloud.");
const VOXEL_M: Number =
    Number::new("Voxel", &(0.0..=10_000.0), "m", "The side of a voxel; 0 for what `longest` gives.");
const FRAMES: Number = Number::new("Frames", &(1.0..=10_000.0), "", "How many moments.");
const STEP_S: Number = Number::new("Step", &(0.001..=86_400.0), "s", "From one moment to the next.");

const fn number(name: &'static str, number: Number, usual: f64, doc: &'static str) -> OptionRow {
    OptionRow { name, kind: OptionKind::Number(number, usual), doc }
}

const LONGEST_ROW: OptionRow = number("longest", LONGEST, 128.0, "How many voxels the largest cloud is long:");
const VOXEL_ROW: OptionRow = number("voxel_m", VOXEL_M, 0.0, "The side of a voxel, where 0 leaves it to longest:");
const FRAMES_ROW: OptionRow = number("frames", FRAMES, 1.0, "How many moments of the timeline, from --at on:");
const STEP_ROW: OptionRow = number("step_s", STEP_S, 1.0, "How long from one moment to the next:");

pub(super) const VOL_OPTIONS: &[OptionRow] = &[LONGEST_ROW, VOXEL_ROW, FRAMES_ROW, STEP_ROW];
pub(super) const VDB_OPTIONS: &[OptionRow] = &[
    LONGEST_ROW,
    VOXEL_ROW,
    FRAMES_ROW,
    STEP_ROW,
    OptionRow {
        name: "z_up",
        kind: OptionKind::Flag(false),
        doc: "Whether z is up and y forward, as in Blender, in place of y up and z backward:",
    },
];

/// Nearer to the world's origin than that, positions count from it, metres: f32 holds them within a centimetre.
const NEAR_M: f64 = 100_000.0;
/// Positions count from a whole multiple of that otherwise.
const ROUND_M: f64 = 1000.0;

/// A volume in the files of a moment.
struct Volume {
    name: String,
    grid: DensityGrid,
}

/// Clouds that share a volume.
struct Body {
    clouds: Vec<CloudId>,
    name: String,
}

/// Mitsuba's volumes, and a scene of them for each moment.
pub(super) fn write_vol(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let bodies = touching(leaving);
    write(leaving, files, &bodies, &mut |out, grid, origin| mitsuba_vol::write(out, grid, origin), true)
}

/// OpenVDB's volumes.
pub(super) fn write_vdb(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let z_up = leaving.options.flag("z_up");
    let body = |cloud: &CloudNow<'_>| Body { clouds: vec![cloud.placed.id], name: cloud.placed.name.clone() };
    let bodies: Vec<Body> = with_sprites(leaving.now).map(body).collect();
    write(leaving, files, &bodies, &mut |out, grid, origin| vdb::write(out, grid, origin, z_up), false)
}

type WriteGrid<'a> = dyn FnMut(&mut dyn Write, &DensityGrid, DVec3) -> io::Result<()> + 'a;

fn write(
    leaving: &Leaving<'_>,
    files: &mut dyn Files,
    bodies: &[Body],
    write_grid: &mut WriteGrid<'_>,
    with_scene: bool,
) -> Result<Vec<Note>, ExportError> {
    let Leaving { options, moment, .. } = *leaving;
    if bodies.is_empty() {
        return Err(ExportError::Nothing("sprites"));
    }
    let (frames, step_s) = (options.number("frames") as usize, options.number("step_s"));
    let origin = origin(leaving);
    let mut notes = Vec::new();
    let mut worst = 0.0_f32;
    for frame in 0..frames {
        let moment = Moment { clock_s: moment.clock_s + frame as f64 * step_s, ..moment };
        let later = (frame > 0).then(|| now_at(leaving, moment));
        let now = later.as_ref().unwrap_or(leaving.now);
        let mut placed = Vec::with_capacity(bodies.len());
        for (at, body) in bodies.iter().enumerate() {
            let volume = frame_name(&numbered(leaving.name, at + 1), frame, frames);
            let (density, clouds) = density_of(leaving, now, body)?;
            if frame == 0 {
                notes.push(told(&body.name, clouds, &density, origin));
            }
            let (grid, median) = match density {
                Some(Density { grid, error, .. }) => (grid, error.median),
                None => (DensityGrid::clear(UVec3::ONE, 1.0, origin), 0.0),
            };
            worst = worst.max(median);
            files.add(&volume, &mut |out| write_grid(out, &grid, origin))?;
            // The scene needs to know where it is, not what is in it.
            placed.push(Volume { name: volume, grid: DensityGrid { extinction: Vec::new(), ..grid } });
            leaving.watch.reach((frame * bodies.len() + at + 1) as f32 / (frames * bodies.len()) as f32);
        }
        if with_scene {
            let name = mitsuba::name_of(&frame_name(leaving.name, frame, frames));
            let bytes = mitsuba::scene(leaving, now, &placed, origin);
            files.add(&name, &mut |out| out.write_all(&bytes))?;
        }
    }
    if bodies.len() > 1 {
        let last = numbered(leaving.name, bodies.len());
        notes.push(Note::changed(format!("{} volumes", bodies.len()), format!("each has a file, the last is {last}")));
    }
    if frames > 1 {
        let last = frame_name(leaving.name, frames - 1, frames);
        let how = format!("each has files of its own, to {last}; at worst the median error is {}", percent(worst));
        notes.push(Note::changed(format!("{frames} moments"), how));
    }
    if origin != DVec3::ZERO {
        let DVec3 { x, y, z } = origin;
        notes.push(Note::changed("positions", format!("they count from ({x}, {y}, {z}) m in the world")));
    }
    notes.push(Note::changed("sprites", "each is a soft ball; extinction is a metre⁻¹, the same for all colours"));
    notes.push(Note::left_out("the artist's light on clouds", "whoever renders a volume lights it"));
    Ok(notes)
}

/// What a body of clouds is at a moment, and how many clouds that are; none if nothing shows.
fn density_of(leaving: &Leaving<'_>, now: &SceneNow<'_>, body: &Body) -> Result<(Option<Density>, usize), ExportError> {
    let clouds: Vec<&CloudNow<'_>> = now.clouds.iter().filter(|cloud| body.clouds.contains(&cloud.placed.id)).collect();
    let vapour = Vapour { clouds: &clouds, atlas: leaving.atlas, light: &now.light };
    match vapour.density(fineness(leaving), &leaving.watch.part()) {
        Ok(density) => Ok((Some(density), clouds.len())),
        Err(DensityError::Nothing) => Ok((None, clouds.len())),
        Err(DensityError::Cancelled) => Err(ExportError::Cancelled),
        Err(DensityError::TooFine(voxels)) => Err(ExportError::TooMuch {
            what: format!("“{}” in {voxels} voxels", body.name),
            most: format!("{MOST_VOXELS}; make voxel_m larger"),
        }),
    }
}

pub(super) fn fineness(leaving: &Leaving<'_>) -> Fineness {
    match leaving.options.number(VOXEL_ROW.name) {
        side if side > 0.0 => Fineness::VoxelM(side as f32),
        _ => Fineness::Longest(leaving.options.number(LONGEST_ROW.name) as u32),
    }
}

/// Those with sprites, shown or not.
pub(super) fn with_sprites<'a, 'b>(now: &'b SceneNow<'a>) -> impl Iterator<Item = &'b CloudNow<'a>> {
    now.clouds.iter().filter(|cloud| is_written(cloud))
}

/// Whether a cloud has a volume.
pub(super) fn is_written(cloud: &CloudNow<'_>) -> bool {
    !cloud.placed.sprites.is_empty()
}

/// The scene at another moment, with the clouds that are to leave.
fn now_at<'a>(leaving: &Leaving<'a>, moment: Moment) -> SceneNow<'a> {
    let derived = leaving.derived;
    let meant: BTreeSet<CloudId> = leaving.now.clouds.iter().map(|cloud| cloud.placed.id).collect();
    let mut now = SceneNow::new(leaving.scene, (derived.clouds(), derived.timeline()), moment, WeatherRules::default());
    now.clouds.retain(|cloud| meant.contains(&cloud.placed.id));
    now
}

/// What positions count from: the world's origin, or a round place near the first cloud.
pub(super) fn origin(leaving: &Leaving<'_>) -> DVec3 {
    let places = || with_sprites(leaving.now).map(|cloud| cloud.origin());
    let far = places().map(|place| place.abs().max_element()).fold(0.0, f64::max);
    match places().next() {
        Some(first) if far > NEAR_M => (first / ROUND_M).round() * ROUND_M,
        _ => DVec3::ZERO,
    }
}

/// Clouds whose boxes touch at the moment that was asked for, together; each where the first of them stands.
fn touching(leaving: &Leaving<'_>) -> Vec<Body> {
    let now = leaving.now;
    let clouds: Vec<&CloudNow<'_>> = with_sprites(now).collect();
    let bounds = |cloud: &&CloudNow<'_>| Vapour { clouds: &[*cloud], atlas: leaving.atlas, light: &now.light }.bounds();
    let bounds: Vec<Option<[DVec3; 2]>> = clouds.iter().map(bounds).collect();
    let touch = |a: usize, b: usize| match (bounds[a], bounds[b]) {
        (Some([low, high]), Some([other_low, other_high])) => {
            low.cmple(other_high).all() && other_low.cmple(high).all()
        }
        _ => false,
    };
    let mut body_of: Vec<usize> = (0..clouds.len()).collect();
    for a in 0..clouds.len() {
        for b in 0..a {
            if touch(a, b) && body_of[a] != body_of[b] {
                let (kept, gone) = (body_of[a].min(body_of[b]), body_of[a].max(body_of[b]));
                body_of.iter_mut().filter(|body| **body == gone).for_each(|body| *body = kept);
            }
        }
    }
    let firsts = (0..clouds.len()).filter(|at| body_of[*at] == *at);
    let body = |first: usize| {
        let members = || clouds.iter().zip(&body_of).filter(|(_, body)| **body == first).map(|(cloud, _)| *cloud);
        Body { clouds: members().map(|cloud| cloud.placed.id).collect(), name: clouds[first].placed.name.clone() }
    };
    firsts.map(body).collect()
}

/// A file's name with the number of its moment: `sky_0001.vol`; of one moment alone, as it is.
fn frame_name(name: &str, frame: usize, frames: usize) -> String {
    match name.rsplit_once('.') {
        _ if frames <= 1 => name.into(),
        Some((stem, ending)) => format!("{stem}_{:04}.{ending}", frame + 1),
        None => format!("{name}_{:04}", frame + 1),
    }
}

/// What a volume is, and how near it comes.
fn told(name: &str, clouds: usize, density: &Option<Density>, origin: DVec3) -> Note {
    let what = match clouds {
        0 | 1 => format!("“{name}”"),
        _ => format!("“{name}” and {} that touch it", clouds - 1),
    };
    let Some(Density { grid, factor, error }) = density else {
        return Note::changed(what, "nothing of it shows: a clear voxel");
    };
    let DVec3 { x, y, z } = grid.corner - origin;
    let [width, height, depth] = grid.size.to_array();
    let (voxel_m, chords) = (grid.voxel_m, chord::CHORDS);
    let [median, mean, p99] = [error.median, error.mean, error.p99].map(percent);
    Note::changed(
        what,
        format!(
            "{width} × {height} × {depth} voxels of {voxel_m:.3} m from ({x:.2}, {y:.2}, {z:.2}), densities times \
             {factor:.2}; along {chords} chords opacity differs from the sprites' by {median} (median), \
             {mean} (mean), {p99} (99th percentile)"
        ),
    )
}

fn percent(share: f32) -> String {
    format!("{:.1} %", 100.0 * share)
}
