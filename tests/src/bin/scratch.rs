//! scratch
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::{fast, plain, prepare};
use cloudwright_core::sprites::Atlas;
use std::time::Instant;
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let cam = std::env::args().nth(2).unwrap_or("main".into());
    let scene = (cloudwright_tests::authoring::SCENES.iter().find(|s| s.0 == name).unwrap().1)();
    let t = Instant::now();
    let derived = Derived::new(&scene);
    println!("derive {:?}", t.elapsed());
    let camera = scene.camera_named(&cam).unwrap();
    for _ in 0..4 {
        let t = Instant::now();
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), camera, scene.time_of_day_h, [1280, 720]);
        let t0 = t.elapsed();
        let t = Instant::now();
        let p = prepare(&frame);
        let t1 = t.elapsed();
        let t = Instant::now();
        let l = fast::clouds(&frame, fast::STOP_BELOW);
        let t2 = t.elapsed();
        let t = Instant::now();
        let pic = fast::picture(&frame);
        let t3 = t.elapsed();
        println!(
            "{} sprites: frame {t0:?} prepare {t1:?} clouds {t2:?} picture {t3:?} {} {}",
            p.len(),
            l.width,
            pic.width
        );
    }
    let frame = Frame::new(&scene, &derived, Atlas::built_in(), camera, scene.time_of_day_h, [1280, 720]);
    let a = plain::linear_picture(&frame);
    let b = fast::linear_picture(&frame);
    let mut e: Vec<f32> = a
        .pixels
        .iter()
        .zip(&b.pixels)
        .map(|(a, b)| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs()))
        .collect();
    e.sort_by(f32::total_cmp);
    println!("plain vs fast linear: 50% {} 99.9% {} max {}", e[e.len() / 2], e[e.len() * 999 / 1000], e[e.len() - 1]);
    let a = plain::clouds(&frame);
    let b = fast::clouds(&frame, fast::NEVER_STOP);
    let mut e: Vec<f32> = a
        .pixels
        .iter()
        .zip(&b.pixels)
        .map(|(a, b)| (a.r - b.r).abs().max((a.g - b.g).abs()).max((a.b - b.b).abs()).max((a.a - b.a).abs()))
        .collect();
    e.sort_by(f32::total_cmp);
    println!(
        "plain vs fast clouds no stop: 50% {} 99.9% {} max {}",
        e[e.len() / 2],
        e[e.len() * 999 / 1000],
        e[e.len() - 1]
    );
}
