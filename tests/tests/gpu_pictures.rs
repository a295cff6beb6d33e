//! scratch
use cloudwright_core::raster::plain;
use cloudwright_tests::gpu::{Backend, cases};

fn main() {
    for backend in Backend::all() {
        let opened = match &backend.opened {
            Ok(o) => o,
            Err(e) => {
                eprintln!("{}: {e}", backend.name);
                continue;
            }
        };
        let (gpu, renderer) = &**opened;
        eprintln!("{} {:?}", gpu.label(), gpu.device().features());
        let mut renderer = renderer.lock().unwrap();
        for case in cases() {
            case.with_frame(|frame| {
                let want = plain::clouds(frame);
                let got = renderer.clouds(gpu, frame).unwrap();
                let mut max = [0.0_f32; 4];
                for (a, b) in want.pixels.iter().zip(&got.pixels) {
                    for (m, d) in max.iter_mut().zip([a.r - b.r, a.g - b.g, a.b - b.b, a.a - b.a]) {
                        *m = m.max(d.abs());
                    }
                }
                let top = want.pixels.iter().map(|p| p.r.max(p.g).max(p.b)).fold(0.0, f32::max);
                let wl = plain::linear_picture(frame);
                let gl = renderer.linear_picture(gpu, frame).unwrap();
                let (mut rel, mut at) = (0.0_f32, 0);
                for (i, (a, b)) in wl.pixels.iter().zip(&gl.pixels).enumerate() {
                    for (x, y) in a.to_array().into_iter().zip(b.to_array()) {
                        let d = (x - y).abs() / x.max(1e-3);
                        if d > rel {
                            (rel, at) = (d, i);
                        }
                    }
                }
                let wp = plain::picture(frame);
                let gp = renderer.picture(gpu, frame).unwrap();
                let mut hist = [0_usize; 256];
                for (a, b) in wp.pixels.iter().zip(&gp.pixels) {
                    hist[(0..4).map(|c| a[c].abs_diff(b[c])).max().unwrap() as usize] += 1;
                }
                let hist: Vec<_> = hist.iter().enumerate().filter(|(_, n)| **n > 0).collect();
                eprintln!(
                    "{:28} sprites {:4} top {top:.2} clouds {max:.5?} linear rel {rel:.5} at {},{} {:?} {:?}, picture {hist:?}",
                    case.name,
                    frame.list.sprites.len(),
                    at as u32 % 192,
                    at as u32 / 192,
                    wl.pixels[at],
                    gl.pixels[at],
                );
            });
        }
    }
}
