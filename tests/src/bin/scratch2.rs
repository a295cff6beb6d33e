//! scratch
use cloudwright_core::derived::Derived;
use cloudwright_core::frame::Frame;
use cloudwright_core::raster::fast;
use cloudwright_core::sprites::Atlas;
fn main() {
    let name = std::env::args().nth(1).unwrap();
    let cam = std::env::args().nth(2).unwrap_or("main".into());
    let scene = (cloudwright_tests::authoring::SCENES.iter().find(|s| s.0 == name).unwrap().1)();
    let derived = Derived::new(&scene);
    let camera = scene.camera_named(&cam).unwrap();
    let mut best = std::time::Duration::MAX;
    for _ in 0..30 {
        let t = std::time::Instant::now();
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), camera, scene.time_of_day_h, [1280, 720]);
        std::hint::black_box(fast::picture(&frame));
        best = best.min(t.elapsed());
    }
    println!("{best:?}");
}
