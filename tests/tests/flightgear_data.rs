//! FlightGear's own clouds, where its data are installed (Debian: flightgear-data-base); shown as ignored where not. They
//! are GPL: read here, and no part of this project.

use cloudwright_core::exchange::{Arriving, Content, Format};
use cloudwright_core::formats::flightgear;
use libtest_mimic::{Arguments, Failed, Trial};
use std::path::PathBuf;

/// The folder of the data: FG_ROOT, or where Debian has it.
fn file() -> PathBuf {
    let root = std::env::var_os("FG_ROOT").map_or_else(|| "/usr/share/games/flightgear".into(), PathBuf::from);
    root.join("Environment/cloudlayers.xml")
}

fn main() {
    let is_there = file().is_file();
    let trial = Trial::test("all_kinds_and_layers_become_ours", all_become_ours).with_ignored_flag(!is_there);
    libtest_mimic::run(&Arguments::from_args(), vec![trial]).exit();
}

fn all_become_ours() -> Result<(), Failed> {
    let bytes = std::fs::read(file())?;
    let format = Format::to_read(None, "cloudlayers.xml", &bytes)?;
    let options = format.usual_for_reading();
    let arrived = format.read(&Arriving { bytes: &bytes, name: "cloudlayers", options: &options })?;
    let Content::Clouds(clouds) = &arrived.content else { return Err("no clouds".into()) };
    let layers = flightgear::read(&bytes)?;
    assert_eq!((layers.clouds.len(), layers.layers.len(), clouds.len()), (10, 6, 10));
    for (kind, made) in layers.clouds.iter().zip(clouds) {
        let own = &made.model.boxes[0];
        assert_eq!((own.sprite_count, own.width), (kind.sprites, kind.sprite_width_m), "{}", kind.name);
        let mean = 0.5 * (kind.width_m[0] + kind.width_m[1]);
        assert_eq!(own.size.x, (mean - kind.sprite_width_m[0]).max(0.0), "{}", kind.name);
    }
    // The layers' clouds stand in six rows; two kinds are in no layer.
    let mut rows: Vec<i64> =
        clouds.iter().flat_map(|made| &made.places).map(|at| (at.z / 12_000.0).round() as i64).collect();
    rows.sort_unstable();
    rows.dedup();
    assert_eq!((rows.len(), clouds.iter().filter(|made| made.places.is_empty()).count()), (6, 2));
    // Sums of what the file leaves to the reader are rounded to thousandths when they are written.
    let once = flightgear::write(&layers);
    assert!(flightgear::write(&flightgear::read(&once)?) == once, "what is written once is written again");
    Ok(())
}
