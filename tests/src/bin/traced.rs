//! Prints as JSON what our path tracer makes of a scene's vapour by its sun alone: what tests/judges/traced.py compares.
//! usage: traced SCENE CAMERA HOUR WIDTH HEIGHT SAMPLES LONGEST

use cloudwright_core::density::{Fineness, Vapour};
use cloudwright_core::derived::Derived;
use cloudwright_core::formats::scene_file;
use cloudwright_core::frame::Frame;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::traced::{Medium, Surroundings, trace};
use cloudwright_core::watch::Watch;
use serde_json::json;
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [file, camera, hour, width, height, samples, longest] = &words[..] else {
        return Err("usage: traced SCENE CAMERA HOUR WIDTH HEIGHT SAMPLES LONGEST".into());
    };
    let mut scene = scene_file::read(&std::fs::read(file)?).map_err(|problems| format!("{file}: {problems:?}"))?;
    scene.time_of_day_h = hour.parse()?;
    let camera = scene.cameras.iter().find(|one| one.name == *camera).ok_or("no such camera")?;
    let derived = Derived::new(&scene);
    let sight = Sight::still(camera, [width.parse()?, height.parse()?]);
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), &sight);
    let clouds: Vec<_> = frame.now.clouds.iter().collect();
    let vapour = Vapour { clouds: &clouds, atlas: Atlas::built_in(), light: &frame.now.light };
    let density = vapour.density(Fineness::Longest(longest.parse()?), &Watch::default())?;
    let around = Surroundings { above: 0.0, below: 0.0, suns: vec![frame.now.light.direction] };
    let traced = trace(&Medium::new(&density.grid), &sight.view(), &around, samples.parse()?, &Watch::default());
    let answer = json!({ "alpha": traced.alpha, "sun": traced.suns[0] });
    writeln!(std::io::stdout().lock(), "{answer}")?;
    Ok(())
}
