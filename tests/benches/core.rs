//! The core's phases: `cargo bench -p cloudwright-tests --bench core`.
//!
//! Targets on an idle machine of two cores: 20,000 sprites populated in 30 ms on one core, and time a sprite at 10⁶
//! below three times that at 10⁴; 80,000 corners shaded in 5 ms on one core; 10⁶ keys sorted in 40 ms; lock and fade of
//! 20,000 sprites stepped in 1 ms on one core, and for nothing where the cloud is out of reach; two pictures of 1280 × 720
//! pixels compared by ꟻLIP in 150 ms, in linear light in 10 ms, both on one core; a .cld file of 6,000 sprites written in
//! 50 ms, and read in 50 ms; a picture with its layers drawn and packed as OpenEXR in twice the time of the PNG.

use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::draw::layers;
use cloudwright_core::draw_list::{DrawSprite, FACES_EYE, sort_back_to_front};
use cloudwright_core::exchange::{Arriving, Files, Format, Leaving};
use cloudwright_core::facing::{FacingMemory, FacingRule, Pose, corners};
use cloudwright_core::formats::picture_exr::{self, About, Eye};
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::measure::{Counts, PIXELS_PER_DEGREE, flip, linear_error, wrong_order};
use cloudwright_core::random::{draw, unit};
use cloudwright_core::raster::fast;
use cloudwright_core::raster::layers::Later;
use cloudwright_core::scene::{Camera, CloudModel, CullRadius, Scene};
use cloudwright_core::shading::corner_light;
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::{Atlas, PlacedCloud, populate};
use cloudwright_core::watch::Watch;
use cloudwright_core::weather::Light;
use cloudwright_core::weather::Moment;
use cloudwright_core::weather::{CloudNow, SceneNow, WeatherRules};
use cloudwright_tests::authoring;
use cloudwright_tests::small_scenes::heap;
use criterion::{BatchSize, Criterion, Throughput, criterion_group, criterion_main};
use glam::{DVec3, Vec3};
use std::hint::black_box;
use std::io::{self, Write};

/// A model of boxes of 1,000 sprites, as densely strewn whatever their number, of which a good half survives the cull.
fn model_of(sprites: u32) -> CloudModel {
    let mut model = heap(1).models.remove(0);
    let cloud_box = model.boxes.remove(0);
    model.boxes = (0..(sprites / 1000).max(1))
        .map(|i| {
            let mut cloud_box = cloud_box.clone();
            cloud_box.id.0 = u64::from(i) + 1;
            cloud_box.center = DVec3::new(f64::from(i % 32) * 400.0, 0.0, f64::from(i / 32) * 400.0);
            cloud_box.size = DVec3::splat(400.0);
            cloud_box.sprite_count = sprites.min(1000);
            cloud_box
        })
        .collect();
    model
}

fn populating(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("populate and cull, one core");
    group.sample_size(10);
    for sprites in [10_000, 20_000, 100_000, 1_000_000] {
        let model = model_of(sprites);
        group.throughput(Throughput::Elements(u64::from(sprites)));
        group.bench_function(format!("{sprites}"), |bencher| bencher.iter(|| populate(black_box(&model), 7)));
    }
}

fn shading(criterion: &mut Criterion) {
    let scene =
        authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make()).unwrap_or_default();
    let derived = Derived::new(&scene);
    let light = Light::at(&scene, 17.0);
    let shade_cloud = |cloud: &PlacedCloud| -> f32 {
        let corner_sum = |sprite: &cloudwright_core::sprites::Sprite| -> f32 {
            let quad = corners(
                sprite.position,
                Pose::facing_eye(sprite.position, Vec3::Y).facing(0.0),
                sprite.width,
                sprite.height,
            );
            let group = &cloud.groups[sprite.group as usize];
            quad.into_iter()
                .map(|corner| corner_light(corner, &CloudNow::at_rest(cloud), group, &light).color().rgb.r)
                .sum()
        };
        cloud.sprites.iter().map(corner_sum).sum()
    };
    let sprites: usize = derived.clouds().iter().map(|cloud| cloud.sprites.len()).sum();
    let mut group = criterion.benchmark_group("face and shade corners, one core");
    group.throughput(Throughput::Elements(4 * sprites as u64));
    group.bench_function(format!("{}", 4 * sprites), |bencher| {
        bencher.iter(|| derived.clouds().iter().map(shade_cloud).sum::<f32>());
    });
}

fn sorting(criterion: &mut Criterion) {
    let point = |i: u32| Vec3::from_array(std::array::from_fn(|axis| unit(draw(3, 3, i, 0)[axis]) as f32 * 20_000.0));
    let sprites: Vec<DrawSprite> = (0..1_000_000)
        .map(|i| DrawSprite { cloud: i / 400, sprite: i % 400, center: point(i), pose: FACES_EYE })
        .collect();
    let mut group = criterion.benchmark_group("sort back to front");
    group.sample_size(20);
    group.bench_function("1000000", |bencher| {
        bencher.iter_batched(|| sprites.clone(), |mut sprites| sort_back_to_front(&mut sprites), BatchSize::LargeInput);
    });
}

fn drawing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("CPU picture, 1280×720");
    group.sample_size(20);
    for (name, make) in authoring::SCENES {
        let scene = make();
        let derived = Derived::new(&scene);
        let draw_from =
            |camera: &Camera| Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(camera, [1280, 720]));
        for camera in scene.cameras.iter().filter(|camera| camera.name == "main") {
            group.bench_function(*name, |bencher| bencher.iter(|| fast::picture(&draw_from(camera))));
        }
    }
}

/// Drawn and packed, as `cloudwright render` does it.
fn packing(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("picture as a file, 1280×720");
    group.sample_size(10);
    for (name, make) in authoring::SCENES.iter().filter(|(name, _)| ["fair_weather", "overcast"].contains(name)) {
        let scene = make();
        let derived = Derived::new(&scene);
        let sight = Sight::still(&scene.cameras[0], [1280, 720]);
        let (view, later) = (sight.view(), Later::new(&scene, &derived, &sight));
        let frame = || Frame::new(&scene, &derived, Atlas::built_in(), &sight);
        group.bench_function(format!("{name}, PNG"), |bencher| {
            bencher.iter(|| packed_as_png(&fast::picture(&frame())));
        });
        group.bench_function(format!("{name}, OpenEXR"), |bencher| {
            bencher.iter(|| picture_exr::picture(&fast::linear_picture(&frame()), &about(&view)));
        });
        group.bench_function(format!("{name}, OpenEXR with layers"), |bencher| {
            bencher.iter(|| {
                let layered = layers(&frame(), &later).expect("drawn fast");
                picture_exr::layers(&layered, &about(&view))
            });
        });
    }
}

fn about(view: &View) -> About<'_> {
    About { comment: "a picture", eye: Eye::Camera(view), frames_a_second: None }
}

fn packed_as_png(picture: &Picture) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, picture.width, picture.height);
    encoder.set_color(png::ColorType::Rgb);
    let rgb: Vec<u8> = picture.pixels.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect();
    encoder.write_header().and_then(|mut writer| writer.write_image_data(&rgb)).expect("it is in memory");
    bytes
}

/// A step of a view's history: 20,000 sprites around the eye, straight above it, and out of reach.
fn flying(criterion: &mut Criterion) {
    let mut scene = heap(1);
    let model = model_of(36_000);
    scene.clouds[0].model = model.id;
    scene.models = vec![model].into();
    let derived = Derived::new(&scene);
    let cloud = &derived.clouds()[0];
    let middle = cloud.origin + cloud.center.as_dvec3();
    let clouds = derived.clouds_at(0.0, WeatherRules::default());
    let mut group = criterion.benchmark_group("one step of lock and fade, one core");
    group.throughput(Throughput::Elements(cloud.sprites.len() as u64));
    for (name, from_middle) in [
        ("within", DVec3::ZERO),
        ("overhead", DVec3::new(0.0, -2000.0, 0.0)),
        ("out of reach", DVec3::new(60_000.0, 0.0, 0.0)),
    ] {
        let mut memory = FacingMemory::default();
        let mut along_m = 0.0;
        group.bench_function(format!("{} {name}", cloud.sprites.len()), |bencher| {
            bencher.iter(|| {
                along_m = (along_m + 1.3) % 400.0;
                let eye = middle + from_middle + DVec3::X * along_m;
                memory.step(&FacingRule::BOUNDED, &clouds, derived.shapes(), eye, Vec3::Y);
                memory.sprite_count()
            });
        });
    }
}

fn measuring(criterion: &mut Criterion) {
    let scene = authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make());
    let scene = scene.unwrap_or_default();
    let derived = Derived::new(&scene);
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
    let frame_at = |time_h| {
        Frame::new(
            &scene,
            &derived,
            Atlas::built_in(),
            &Sight { moment: Moment::at_hour(time_h), ..Sight::still(&scene.cameras[0], [1280, 720]) },
        )
    };
    let frames = [frame_at(12.0), frame_at(12.25)];
    let shown = frames.each_ref().map(fast::picture);
    let linear = frames.each_ref().map(fast::linear_picture);
    let mut group = criterion.benchmark_group("measure 1280×720, one core");
    group.sample_size(20);
    group.bench_function("FLIP", |bencher| {
        bencher.iter(|| pool.install(|| flip(&shown[0], &shown[1], PIXELS_PER_DEGREE).map(|map| map.mean())));
    });
    group.bench_function("linear error", |bencher| {
        bencher.iter(|| pool.install(|| linear_error(&linear[0], &linear[1])));
    });
    group.sample_size(10);
    group.bench_function("wrong order", |bencher| bencher.iter(|| pool.install(|| wrong_order(&frames[0]))));
    group.bench_function("counts", |bencher| bencher.iter(|| pool.install(|| Counts::of(&frames[0]))));
}

fn exchanging(criterion: &mut Criterion) {
    let scene = sprites_of(6000);
    let derived = Derived::new(&scene);
    let now = SceneNow::new(&scene, (derived.clouds(), derived.timeline()), Moment::default(), WeatherRules::default());
    let format = Format::to_write(Some("cld"), "a.cld").expect("a format");
    let (to_write, to_read) = (format.usual_for_writing(), format.usual_for_reading());
    let leaving = Leaving {
        scene: &scene,
        derived: &derived,
        moment: Moment::default(),
        now: &now,
        atlas: Atlas::built_in(),
        view: None,
        name: "a.cld",
        options: &to_write,
        watch: &Watch::default(),
    };
    let write = || {
        let mut files = InMemory::default();
        format.write(&leaving, &mut files).expect("it leaves");
        files.0
    };
    let bytes = write();
    let mut group = criterion.benchmark_group(format!(".cld of {} sprites", (bytes.len() - 67) / 44));
    group.bench_function("write", |bencher| bencher.iter(write));
    let arriving = Arriving { bytes: &bytes, name: "a", options: &to_read };
    group.bench_function("read", |bencher| bencher.iter(|| format.read(black_box(&arriving)).expect("sound")));
}

/// A cloud of that many sprites, none of which is culled.
fn sprites_of(count: u32) -> Scene {
    let mut scene = heap(1);
    let model = scene.models.get_mut(0).expect("a model");
    model.boxes = model_of(count).boxes;
    model.cull_radius = CullRadius::Metres(0.0);
    scene
}

/// One file.
#[derive(Default)]
struct InMemory(Vec<u8>);

impl Files for InMemory {
    fn add(&mut self, _: &str, fill: &mut dyn FnMut(&mut dyn Write) -> io::Result<()>) -> io::Result<()> {
        fill(&mut self.0)
    }
}

criterion_group!(benches, populating, shading, sorting, flying, drawing, packing, measuring, exchanging);
criterion_main!(benches);
