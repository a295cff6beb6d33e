//! A scene as an OpenUSD stage, for 3D programs, renderers and engines: as text (`.usda`) with the sheet of tiles beside it,
//! or both in one file (`.usdz`).
//!
//! Metres and axes are ours, a second is 24 time codes. Clouds are Xforms where they are at one moment, with samples in time
//! where they drift. A cloud's sprites are one mesh of quads that face one camera, from the farthest to the nearest, with
//! the light of that moment at their corners as `displayColor` and `displayOpacity`: meshes, as some programs show no
//! instances. Cameras and camera paths are cameras, with samples where they move; the sun is a distant light. A mesh's
//! [`materials`] show the sheet, and say how far its cloud has formed; or clouds are [`volumes`] of files beside this one.
//!
//! Colours are linear light times the scene's exposure, and may be brighter than 1: the tone curve is the viewer's.

mod cameras;
mod clouds;
mod materials;
mod volumes;

use super::motion::{Course, Motion, does_more};
use super::sheet;
use super::sun::Sun;
use super::{ExportError, Files, Leaving, Note, OptionKind, OptionRow};
use crate::formats::stored_zip;
use crate::formats::usda::{Names, Number, Text, Tuple, quoted};
use glam::{DQuat, DVec3};

/// Time codes a second, and frames.
const CODES_PER_SECOND: f64 = 24.0;
/// Places are in steps of a millimetre.
const PLACE_STEPS: f64 = 1e3;
/// Turns, and what is measured in shares, in millionths.
const FINE_STEPS: f64 = 1e6;
/// Seen from below, degrees.
const SUN_ANGLE_DEG: f64 = 0.53;
/// The prim that holds all others.
const ROOT: &str = "/Sky";

const VOLUMES: &str = "volumes";
pub(super) const WRITE_OPTIONS: &[OptionRow] = &[OptionRow {
    name: VOLUMES,
    kind: OptionKind::Flag(false),
    doc: "Whether clouds are volumes of the .vdb files of the same name beside it, in place of sprites:",
}];

pub(super) fn write(leaving: &Leaving<'_>, files: &mut dyn Files) -> Result<Vec<Note>, ExportError> {
    let Leaving { scene, now, name, .. } = *leaving;
    let (stem, ending) = name.rsplit_once('.').unwrap_or((name, ""));
    let volumes = leaving.options.flag(VOLUMES);
    let sheet_name = format!("{}_atlas.png", plain(stem));
    let motion = Motion::new(scene, leaving.derived);
    let courses: Vec<Course> = now.clouds.iter().map(|cloud| motion.course(cloud.placed)).collect();
    let mut text = Text::new(&stage(&scene.name, motion.end_s()));
    let mut whole = Some(());
    text.prim("def Xform \"Sky\"", &[display_name(&scene.name), "kind = \"assembly\"".into()], |text| {
        cameras::write(text, scene, &motion);
        sun(text, &Sun::of(now));
        whole = if volumes {
            volumes::write(text, leaving, stem, &courses)
        } else {
            clouds::write(text, leaving, &sheet_name, &courses)
        };
    });
    whole.ok_or(ExportError::Cancelled)?;
    let text = text.finish();
    let sheet = || sheet::png(leaving.atlas);
    if ending.eq_ignore_ascii_case("usdz") {
        let root = format!("{}.usda", plain(stem));
        let mut held = vec![(root.as_str(), text.as_bytes())];
        let sheet = if volumes { Vec::new() } else { sheet() };
        if !volumes {
            held.push((&sheet_name, &sheet));
        }
        let zip = stored_zip::write(&held)?;
        files.add(name, &mut |out| out.write_all(&zip))?;
    } else {
        files.add(name, &mut |out| out.write_all(text.as_bytes()))?;
        if !volumes {
            let sheet = sheet();
            files.add(&sheet_name, &mut |out| out.write_all(&sheet))?;
        }
    }
    Ok(notes(volumes, &courses))
}

/// The stage's metadata.
fn stage(name: &str, end_s: f64) -> Vec<String> {
    let end = Number((end_s * CODES_PER_SECOND).ceil(), 1.0);
    vec![
        format!(
            "customLayerData = {{\n        string generator = \"Cloudwright\"\n        string title = {}\n    }}",
            quoted(name)
        ),
        "defaultPrim = \"Sky\"".into(),
        format!("endTimeCode = {end}"),
        format!("framesPerSecond = {CODES_PER_SECOND}"),
        "metersPerUnit = 1".into(),
        "startTimeCode = 0".into(),
        format!("timeCodesPerSecond = {CODES_PER_SECOND}"),
        "upAxis = \"Y\"".into(),
    ]
}

/// What a thing is called.
fn display_name(name: &str) -> String {
    format!("displayName = {}", quoted(name))
}

/// A file's name that any system and reader can have: without signs but these.
fn plain(stem: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || matches!(c, '-' | '_' | '.' | ' ');
    stem.chars().map(|c| if is_plain(c) { c } else { '_' }).collect()
}

/// A place with samples, and a turn with samples if it has one.
fn placed(text: &mut Text, (place, places): (DVec3, &[(f64, DVec3)]), turn: Option<(DQuat, &[(f64, DQuat)])>) {
    let tuple = |place: DVec3| Tuple::of(place.to_array(), PLACE_STEPS);
    let mut order = vec!["\"xformOp:translate\""];
    if let Some((turn, turns)) = turn {
        let tuple = |DQuat { x, y, z, w }: DQuat| Tuple::of([w, x, y, z], FINE_STEPS);
        text.set("quatf xformOp:orient", tuple(turn));
        if !turns.is_empty() {
            text.samples("quatf xformOp:orient", turns.iter().map(|(time, turn)| (code(*time), tuple(*turn))));
        }
        order.push("\"xformOp:orient\"");
    }
    text.set("double3 xformOp:translate", tuple(place));
    if !places.is_empty() {
        let samples = places.iter().map(|(time, place)| (code(*time), tuple(*place)));
        text.samples("double3 xformOp:translate", samples);
    }
    text.set("uniform token[] xformOpOrder", format!("[{}]", order.join(", ")));
}

/// The time code of a second.
fn code(time_s: f64) -> f64 {
    time_s * CODES_PER_SECOND
}

/// The sun, if it is up: its light is what falls on a face that looks at it, whatever its angle.
fn sun(text: &mut Text, sun: &Sun) {
    if sun.light <= 0.0 {
        return;
    }
    text.prim("def DistantLight \"Sun\"", &[], |text| {
        text.set("float inputs:angle", SUN_ANGLE_DEG);
        text.set("color3f inputs:color", Tuple::of(sun.color.map(f64::from), FINE_STEPS));
        text.set("float inputs:intensity", Number(sun.light, FINE_STEPS));
        text.set("bool inputs:normalize", 1);
        placed(text, (DVec3::ZERO, &[]), Some((sun.turn, &[])));
    });
}

fn notes(volumes: bool, courses: &[Course]) -> Vec<Note> {
    let mut notes = vec![Note::left_out("sky, haze and tone curve", "the viewer has its own")];
    if volumes {
        let how = "this file names them; `export SCENE -o NAME.vdb` makes them";
        notes.push(Note::changed("clouds", format!("volumes of .vdb files beside this one: {how}")));
    } else {
        notes.push(Note::changed("sprites", "they face one camera, in the light of one moment"));
        let how = "a tile's shades are their mean, opacity a sprite's mean, or that of a cloud that forms; corners have it in full";
        notes.push(Note::changed("material", how));
    }
    notes.extend(does_more(courses));
    notes
}

/// A scope of things, each with a name of its own.
fn scope(text: &mut Text, name: &str, fill: impl FnOnce(&mut Text, &mut Names)) {
    text.prim(&format!("def Scope \"{name}\""), &[], |text| fill(text, &mut Names::default()));
}
