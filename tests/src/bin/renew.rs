//! Makes what is checked in again: `renew atlas | scenes | presets | models | schema | shortcuts | manual | flip |
//! charts | pictures DIR`.
//!
//! Run in the project's root. Tests say when one of them, charts and pictures apart, is stale.

use cloudwright::cli::schemas;
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::raster::fast;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_scripts::manual;
use cloudwright_tests::atlas;
use cloudwright_tests::authoring::{self, NamedScene};
use cloudwright_tests::{flip_pairs, with_shortcuts};
use std::error::Error;
use std::fs::{self, File};
use std::path::Path;
use std::process::Command;

fn main() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = std::env::args().skip(1).collect();
    match args.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["atlas"] => {
            write_png("assets/atlas/clouds.png".as_ref(), 512, 512, &atlas::generate_sheet(atlas::BUILT_IN_SEED))
        }
        ["scenes"] => write_scenes("assets/scenes", authoring::SCENES),
        ["presets"] => write_scenes("assets/presets", authoring::PRESETS),
        ["models"] => write_models(),
        ["schema"] => write_schemas(),
        ["shortcuts"] => Ok(fs::write("README.md", with_shortcuts(&fs::read_to_string("README.md")?)?)?),
        ["manual"] => write_manual(),
        ["flip"] => write_flip_pairs("tests/flip".as_ref()),
        ["charts"] => charts(),
        ["pictures", folder] => pictures(folder.as_ref(), ""),
        ["pictures", folder, only] => pictures(folder.as_ref(), only),
        _ => Err("usage: renew atlas | scenes | presets | models | schema | shortcuts | manual | flip | charts | \
                 pictures DIR [SCENE]"
            .into()),
    }
}

fn write_manual() -> Result<(), Box<dyn Error>> {
    fs::write("scripts/MANUAL.md", manual::manual()?)?;
    fs::create_dir_all("scripts/definitions")?;
    Ok(fs::write("scripts/definitions/cloudwright.d.rhai", manual::definitions())?)
}

fn write_schemas() -> Result<(), Box<dyn Error>> {
    fs::write("assets/scene.schema.json", scene_file::json_schema()?)?;
    fs::create_dir_all("assets/schemas")?;
    let write = |(name, text)| fs::write(format!("assets/schemas/{name}.schema.json"), text);
    Ok(schemas::all()?.into_iter().try_for_each(write)?)
}

fn write_models() -> Result<(), Box<dyn Error>> {
    fs::create_dir_all("assets/models")?;
    Ok(fs::write("assets/models/aircraft.glb", authoring::aircraft::glb())?)
}

fn write_scenes(folder: &str, scenes: &[NamedScene]) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    scenes.iter().try_for_each(|(name, scene)| {
        let path = format!("{folder}/{name}.{}", scene_file::EXTENSION);
        Ok(fs::write(path, scene_file::write(&scene())?)?)
    })
}

/// What is in assets/charts, measured anew on this machine, which should have nothing else to do meanwhile.
fn charts() -> Result<(), Box<dyn Error>> {
    const METHODS: &str = "truth,fast,four-samples,crossfade,early-stop,three-quarters,half,quarter,eight-bits,view-plane,\
                           no-lock,dot-product,no-mips";
    // Elsewhere no cloud forms, and these draw what others do.
    const STEPPED: &str = ",stepped-as-printed,stepped-mended";
    for (name, scene, more) in [
        ("single_cumulus", "single_cumulus", ""),
        ("overcast", "overcast", ""),
        ("dusk", "cumulonimbus_dusk", ""),
        ("forming", "forming", STEPPED),
    ] {
        let methods = format!("{METHODS}{more}");
        let folder = format!("assets/charts/{name}");
        // A broken-off or older measurement is not gone on with.
        for file in ["chart.json", "chart.html"] {
            let _ = fs::remove_file(format!("{folder}/{file}"));
        }
        let scene = format!("assets/scenes/{scene}.{}", scene_file::EXTENSION);
        let chart = ["chart", &scene, "-o", &folder, "--size", "320x180", "--methods", &methods];
        let run = ["run", "--quiet", "--release", "--package", "cloudwright", "--"];
        if !Command::new("cargo").args(run).args(chart).status()?.success() {
            return Err(format!("{name} could not be charted").into());
        }
    }
    Ok(())
}

/// Every camera of every shipped scene whose name has `only` in it.
fn pictures(folder: &Path, only: &str) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for (name, scene) in authoring::SCENES.iter().filter(|(name, _)| name.contains(only)) {
        let scene = scene();
        let derived = Derived::new(&scene);
        for camera in &scene.cameras {
            let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(camera, [1280, 720]));
            let Picture { width, height, .. } = fast::picture(&frame);
            let start = std::time::Instant::now();
            let picture = fast::picture(&frame);
            eprintln!("{name} {}: {} sprites, {:.1?}", camera.name, frame.list.sprites.len(), start.elapsed());
            write_png(&folder.join(format!("{name}_{}.png", camera.name)), width, height, picture.as_bytes())?;
        }
    }
    Ok(())
}

fn write_flip_pairs(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for (name, reference, test) in flip_pairs::make() {
        for (picture, of) in [(reference, "reference"), (test, "test")] {
            write_png(&folder.join(format!("{name}_{of}.png")), picture.width, picture.height, picture.as_bytes())?;
        }
    }
    Ok(())
}

fn write_png(path: &Path, width: u32, height: u32, rgba: &[u8]) -> Result<(), Box<dyn Error>> {
    let mut encoder = png::Encoder::new(std::io::BufWriter::new(File::create(path)?), width, height);
    encoder.set_color(png::ColorType::Rgba);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    Ok(encoder.write_header()?.write_image_data(rgba)?)
}
