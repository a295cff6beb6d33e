//! The CPU renderer against the sprites pass on each adapter there is, on the same draw lists in the same run:
//! `cargo bench -p cloudwright-tests --bench gpu_frames`.
//! Medians of several frames, taken in turn; a table, because software rasterizers need seconds for what hardware does
//! in a blink, and a fixed number of samples would not suit both.

#![allow(clippy::print_stdout)] // A bench's answer is its table.

use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::fast;
use cloudwright_core::scene::{Camera, Scene};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_render::{Gpu, GpuRenderer};
use cloudwright_tests::authoring;
use cloudwright_tests::gpu::{Backend, field};
use glam::DVec3;
use std::time::{Duration, Instant};

const FRAMES: usize = 7;

fn main() {
    // `cargo test --benches` passes no --bench: then one small scene shows that the bench still runs.
    let full = std::env::args().any(|arg| arg == "--bench");
    println!(
        "{:28} {:>8}  {:26} {:>9} {:>9} {:>9} {:>7}",
        "view, 1280×720", "sprites", "adapter", "pass/ms", "frame/ms", "CPU/ms", "CPU is"
    );
    let backends = Backend::all();
    let beside = |height| Camera { pitch_deg: 5.0, ..Camera::free(DVec3::new(0.0, height, 0.0)) };
    if !full {
        return measure("small field", &field(2), &beside(700.0), &backends);
    }
    for (name, make) in authoring::SCENES {
        let scene = make();
        let cameras = scene.cameras.iter().filter(|camera| camera.name == "main" || *name == "overcast");
        for camera in cameras {
            measure(&format!("{name}, {}", camera.name), &scene, camera, &backends);
        }
    }
    for side in [40, 88] {
        measure(&format!("field of {side} × {side}"), &field(side), &beside(700.0), &backends);
    }
}

fn measure(name: &str, scene: &Scene, camera: &Camera, backends: &[Backend]) {
    let derived = Derived::new(scene);
    let frame = Frame::new(scene, &derived, Atlas::built_in(), &Sight::still(camera, [1280, 720]));
    for backend in backends {
        match &backend.opened {
            Ok(opened) => {
                let mut renderer = opened.1.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                measure_on(name, &opened.0, &mut renderer, &frame);
            }
            Err(reason) => println!("{name:28} {:>8}  {} is not there: {reason}", "", backend.name),
        }
    }
}

fn measure_on(name: &str, gpu: &Gpu, renderer: &mut GpuRenderer, frame: &Frame<'_>) {
    let [mut pass, mut whole, mut cpu] = [Vec::new(), Vec::new(), Vec::new()];
    // In turn, so that a slow minute of the machine hits all alike; the first round warms up.
    for round in 0..=FRAMES {
        let times = [
            renderer.sprites_pass_time(gpu, frame).map_or(Duration::MAX, |time| time.duration),
            timed(|| drop(renderer.picture(gpu, frame))),
            timed(|| drop(fast::picture(frame))),
        ];
        if round > 0 {
            [&mut pass, &mut whole, &mut cpu].into_iter().zip(times).for_each(|(list, time)| list.push(time));
        }
    }
    let [pass, whole, cpu] = [pass, whole, cpu].map(|mut times| {
        times.sort_unstable();
        times[FRAMES / 2].as_secs_f64() * 1e3
    });
    let label: String = gpu.label().chars().take(26).collect();
    let sprites = frame.list.sprites.len();
    println!("{name:28} {sprites:>8}  {label:26} {pass:>9.1} {whole:>9.1} {cpu:>9.1} {:>6.1}×", pass / cpu);
}

fn timed(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}
