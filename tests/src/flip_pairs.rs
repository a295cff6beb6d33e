//! Five pairs of small pictures that ꟻLIP is judged by: tests/flip/NAME_reference.png and NAME_test.png.
//!
//! Renderings of shipped scenes, and what methods and mishaps make of them: another order of sprites, a pixel's shift,
//! blur, noise, other colours. `renew flip` draws them; tests/flip_reference.py then asks the published tool what it
//! says of them and writes tests/flip/figures.json. The bytes stay as they are checked in: they need not be renewed
//! when a renderer changes.

use crate::authoring;
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::random::draw;
use cloudwright_core::raster::{develop, fast, truth};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Moment;

const SIZE: [u32; 2] = [128, 72];

/// Name, reference and test of each.
pub fn make() -> Vec<(&'static str, Picture, Picture)> {
    let sorted = |scene, camera| render(scene, camera, 0.0, fast::picture);
    let variant = |name, scene, camera, alter: fn(&Picture, usize, usize) -> [i32; 3]| {
        let reference = sorted(scene, camera);
        let test = altered(&reference, alter);
        (name, reference, test)
    };
    vec![
        ("sorted", render("overcast", "deck", 0.0, true_picture), sorted("overcast", "deck")),
        ("recoloured", sorted("cumulonimbus_dusk", "main"), render("cumulonimbus_dusk", "main", 0.5, fast::picture)),
        variant("shifted", "single_cumulus", "main", |picture, x, y| pixel(picture, x.saturating_sub(1), y)),
        variant("blurred", "altocumulus", "above", blurred),
        variant("noisy", "fair_weather", "main", noisy),
    ]
}

fn true_picture(frame: &Frame<'_>) -> Picture {
    develop(&truth::linear_picture(frame, truth::SIDE, &Watch::default()), frame.now.exposure)
}

/// A shipped scene from one of its cameras, so many hours later than it is saved for.
fn render(scene: &str, camera: &str, later_h: f64, by: fn(&Frame<'_>) -> Picture) -> Picture {
    let scene = authoring::SCENES.iter().find(|(name, _)| *name == scene).map(|(_, make)| make()).unwrap_or_default();
    let derived = Derived::new(&scene);
    let by_name = scene.cameras.iter().find(|each| each.name == camera);
    let camera = by_name.cloned().unwrap_or_else(|| scene.cameras[0].clone());
    by(&Frame::new(
        &scene,
        &derived,
        Atlas::built_in(),
        &Sight { moment: Moment::at_hour(scene.time_of_day_h + later_h), ..Sight::still(&camera, SIZE) },
    ))
}

fn altered(picture: &Picture, alter: impl Fn(&Picture, usize, usize) -> [i32; 3]) -> Picture {
    let width = picture.width as usize;
    let opaque = |[r, g, b]: [i32; 3]| [r, g, b, 255].map(|channel| channel.clamp(0, 255) as u8);
    let pixels = (0..picture.pixels.len()).map(|i| opaque(alter(picture, i % width, i / width)));
    Picture { pixels: pixels.collect(), ..*picture }
}

/// Red, green and blue; those beyond the edges as at them.
fn pixel(picture: &Picture, x: usize, y: usize) -> [i32; 3] {
    let (x, y) = (x.min(picture.width as usize - 1), y.min(picture.height as usize - 1));
    let [r, g, b, _] = picture.pixels[y * picture.width as usize + x].map(i32::from);
    [r, g, b]
}

/// The mean of five by five pixels.
fn blurred(picture: &Picture, x: usize, y: usize) -> [i32; 3] {
    let around = (0..25).map(|i| pixel(picture, (x + i % 5).saturating_sub(2), (y + i / 5).saturating_sub(2)));
    let sum = around.fold([0; 3], |sum, color| std::array::from_fn(|c| sum[c] + color[c]));
    sum.map(|channel| (channel + 12) / 25)
}

/// Up to 16 steps more or less, for each channel of one pixel in four.
fn noisy(picture: &Picture, x: usize, y: usize) -> [i32; 3] {
    let [r, g, b, chosen] = draw(5, 0, x as u32, y as u32);
    let noise = [r, g, b].map(|bits| if chosen % 4 == 0 { (bits % 33) as i32 - 16 } else { 0 });
    let color = pixel(picture, x, y);
    std::array::from_fn(|c| color[c] + noise[c])
}
