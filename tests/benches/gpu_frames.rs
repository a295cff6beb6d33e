//! Time of the sprites pass and of a whole frame on each adapter there is: `cargo bench --bench gpu_frames`.
//! Medians of several frames after two to warm up; a table, because software rasterizers need seconds for what hardware
//! does in a blink, and a fixed number of samples would not suit both.

#![allow(clippy::print_stdout)] // A bench's answer is its table.

use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::fast;
use cloudwright_core::scene::Camera;
use cloudwright_core::sprites::Atlas;
use cloudwright_render::{Gpu, Renderer};
use cloudwright_tests::gpu::{Backend, field};
use glam::DVec3;
use std::time::{Duration, Instant};

const FRAMES: usize = 5;

fn main() {
    // `cargo test --benches` passes no --bench: then one small scene shows that the bench still runs.
    let full = std::env::args().any(|arg| arg == "--bench");
    let sides: &[u32] = if full { &[4, 12, 40, 88] } else { &[2] };
    println!("{:36} {:>9} {:>8} {:>11} {:>11}", "adapter", "sprites", "in view", "sprites/ms", "frame/ms");
    let backends = Backend::all();
    for side in sides {
        let scene = field(*side);
        let derived = Derived::new(&scene);
        let camera = Camera { pitch_deg: 5.0, ..Camera::free(DVec3::new(0.0, 700.0, 0.0)) };
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &camera, 10.0, [1280, 720]);
        let total = derived.clouds().iter().map(|cloud| cloud.sprites.len()).sum();
        let cpu = median(|| timed(|| drop(fast::picture(&frame))));
        row("CPU renderer", total, &frame, None, cpu);
        for backend in &backends {
            match &backend.opened {
                Ok(opened) => {
                    let mut renderer = opened.1.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
                    measure(&opened.0, &mut renderer, total, &frame);
                }
                Err(reason) => println!("{:36} not there: {reason}", backend.name),
            }
        }
    }
}

fn measure(gpu: &Gpu, renderer: &mut Renderer, total: usize, frame: &Frame<'_>) {
    for _ in 0..2 {
        if let Err(error) = renderer.sprites_pass_time(gpu, frame) {
            println!("{:36} {total:9} {error}", gpu.label());
            return;
        }
    }
    let pass = median(|| renderer.sprites_pass_time(gpu, frame).map_or(Duration::MAX, |time| time.duration));
    let whole = median(|| timed(|| drop(renderer.picture(gpu, frame))));
    row(&gpu.label(), total, frame, Some(pass), whole);
}

fn row(name: &str, total: usize, frame: &Frame<'_>, pass: Option<Duration>, whole: Duration) {
    let ms = |time: Duration| format!("{:.1}", time.as_secs_f64() * 1e3);
    let in_view = frame.list.sprites.len();
    println!("{name:36} {total:9} {in_view:8} {:>11} {:>11}", pass.map_or("–".into(), ms), ms(whole));
}

fn timed(work: impl FnOnce()) -> Duration {
    let start = Instant::now();
    work();
    start.elapsed()
}

fn median(mut measure: impl FnMut() -> Duration) -> Duration {
    let mut times: Vec<Duration> = (0..FRAMES).map(|_| measure()).collect();
    times.sort_unstable();
    times[FRAMES / 2]
}
