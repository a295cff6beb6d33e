//! A report as a run would make it, with pictures to look at.
//!
//! The figures are plausible, not measured; the pictures are drawings of a shipped scene, done wrong in the way that each
//! method would. So the page can be judged before anything is measured, and its tests need no minute of measuring.

use cloudwright::chart::Family::{self, Failing, Other, Shipped, Truth};
use cloudwright::chart::html::{DEFAULT_TOLERANCE, Look, Page};
use cloudwright::chart::report::{Cost, Error, FrameCounts, LeftOut, MethodFigures, Report, Stability, Viewpoint};
use cloudwright_core::derived::Derived;
use cloudwright_core::draw_list::DrawSprite;
use cloudwright_core::frame::Frame;
use cloudwright_core::image::Picture;
use cloudwright_core::raster::{develop, fast, truth};
use cloudwright_core::sight::Sight;
use cloudwright_core::sprites::Atlas;
use cloudwright_core::watch::Watch;
use cloudwright_tests::authoring::SCENES;
use glam::Vec3;

/// A method of the example.
pub struct Example {
    pub name: &'static str,
    pub family: Family,
    pub about: &'static str,
    /// Frame time (ms), FLIP, excess change.
    pub figures: [f64; 3],
    spoil: fn(&mut Vec<DrawSprite>),
    /// Levels of a channel.
    levels: u32,
}

const fn example(
    (name, family): (&'static str, Family),
    about: &'static str,
    figures: [f64; 3],
    spoil: fn(&mut Vec<DrawSprite>),
) -> Example {
    Example { name, family, about, figures, spoil, levels: 256 }
}

fn not_at_all(_: &mut Vec<DrawSprite>) {}

fn sort_from(list: &mut [DrawSprite], eye: Vec3) {
    list.sort_by(|a, b| b.center.distance_squared(eye).total_cmp(&a.center.distance_squared(eye)));
}

/// Ten, as many as a run has by default.
pub static EXAMPLES: [Example; 10] = [
    example(
        ("truth", Truth),
        "Each ray's fragments in their own order, 16 samples a pixel.",
        [2840.0, 0.0, 0.0],
        not_at_all,
    ),
    example(("shipped fast", Shipped), "Tiles on all cores, sorted by distance.", [21.4, 0.0062, 0.000_41], not_at_all),
    example(
        ("plain", Other),
        "One fragment at a time: the oracle of the fast way.",
        [188.0, 0.0061, 0.000_41],
        not_at_all,
    ),
    example(("gpu", Other), "The adapter blends what the CPU sorted.", [6.9, 0.0079, 0.000_44], not_at_all),
    Example {
        levels: 24,
        ..example(
            ("8-bit blending", Failing),
            "Each blend rounds to 8 bits; hundreds of them add up to bands.",
            [6.2, 0.034, 0.0011],
            not_at_all,
        )
    },
    example(("no lock", Failing), "Sprites near the eye keep turning to it.", [21.1, 0.0088, 0.0063], not_at_all),
    example(
        ("lazy sorting (SkyWorks)", Failing),
        "Sorts anew after 36.9° of turn or 10 units of travel.",
        [19.8, 0.017, 0.0024],
        |list| sort_from(list, Vec3::new(900.0, 200.0, -300.0)),
    ),
    example(
        ("lazy sorting (SimGear)", Failing),
        "One pass of bubble sort a frame, less often while nothing changes.",
        [20.3, 0.041, 0.0038],
        |list| sort_from(list, Vec3::new(-2500.0, 900.0, -4000.0)),
    ),
    example(
        ("half the sprites", Other),
        "Every second sprite, to see what is to be saved.",
        [11.6, 0.058, 0.0009],
        |list| {
            let mut i = 0;
            list.retain(|_| {
                i += 1;
                i % 2 == 0
            });
        },
    ),
    example(
        ("view-plane facing", Failing),
        "Sprites lie in the plane of the picture and turn with the head.",
        [20.9, 0.0112, 0.0047],
        |list| list.iter_mut().for_each(|s| s.center *= 1.004),
    ),
];

/// The report of [`EXAMPLES`], its front not yet marked.
pub fn report() -> Report {
    let method = |example: &Example| {
        let [frame_ms, flip, excess] = example.figures;
        let setting = |name: &str, value: &str| (name.to_owned(), value.to_owned());
        let gpu = example.levels < 256 || example.name == "gpu";
        let sprites = if example.name == "half the sprites" { 3382 } else { 6764 };
        MethodFigures {
            name: example.name.into(),
            settings: [
                setting("renderer", if gpu { "GPU" } else { "CPU" }),
                setting("sorting", if example.name.starts_with("lazy") { "lazy" } else { "each frame" }),
                setting("facing", if example.name.starts_with("view") { "view plane" } else { "eye point" }),
            ]
            .into(),
            cost: Cost {
                frame_ms: Some(frame_ms),
                cpu_ms: Some(if gpu { 1.9 } else { frame_ms * 1.86 }),
                gpu_ms: gpu.then_some(frame_ms * 0.8),
                counts: FrameCounts {
                    sprites,
                    corners_shaded: 4 * sprites,
                    fragments: Some(614.2 * sprites as f64),
                    overdraw_mean: Some(18.03 * sprites as f64 / 6764.0),
                    overdraw_p99: Some(64.0),
                    bytes_uploaded: if gpu { 56 * sprites } else { 0 },
                    keys_sorted: sprites,
                },
            },
            error: Error {
                flip_mean: Some(flip),
                flip_p99: Some((flip * 7.3).min(1.0)),
                rmse: Some(flip * 0.42),
                opacity_max: Some(flip * 1.3),
            },
            stability: Some(Stability {
                excess_mean: Some(excess),
                excess_p999: Some(excess * 31.0),
                worst_frame: Some(excess * 6.2),
            }),
            known_to_fail: example.family == Failing,
            on_front: false,
            frames: Vec::new(),
        }
    };
    Report {
        scene: "cumulonimbus_dusk".into(),
        size: [640, 360],
        adapter: "llvmpipe (LLVM 15.0.6, 256 bits)".into(),
        view: Some(Viewpoint::Path("fly-through".into())),
        methods: EXAMPLES.iter().map(method).collect(),
        left_out: vec![LeftOut {
            name: "dual-source".into(),
            reason: "the adapter has no dual-source blending; choose another one".into(),
        }],
        input: String::new(),
        unfinished: false,
    }
}

/// A picture of each method and how far it is off; the first is the truth.
pub struct Drawn {
    pub pictures: Vec<Picture>,
    pub errors: Vec<Vec<f32>>,
}

impl Drawn {
    /// In `size`, the truth with `side` × `side` samples a pixel.
    pub fn new(size: [u32; 2], side: u32) -> Self {
        let scene = SCENES.iter().find(|(name, _)| *name == "cumulonimbus_dusk").expect("a shipped scene").1();
        let derived = Derived::new(&scene);
        let camera = scene.cameras.first().expect("a shipped scene has a camera");
        let frame = Frame::new(&scene, &derived, Atlas::built_in(), &Sight::still(camera, size));
        let pictures: Vec<Picture> = EXAMPLES
            .iter()
            .map(|example| {
                if example.family == Truth {
                    return develop(&truth::linear_picture(&frame, side, &Watch::default()), frame.now.exposure);
                }
                let mut frame = frame.clone();
                (example.spoil)(&mut frame.list.sprites);
                let mut picture = fast::picture(&frame);
                let coarse = |c: u8| (u32::from(c) * example.levels / 256 * 255 / (example.levels - 1)) as u8;
                picture.pixels.iter_mut().for_each(|p| *p = [coarse(p[0]), coarse(p[1]), coarse(p[2]), 255]);
                picture
            })
            .collect();
        let off = |picture: &Picture| -> Vec<f32> {
            let of = |(a, b): (&[u8; 4], &[u8; 4])| (0..3).map(|i| f32::from(a[i].abs_diff(b[i]))).fold(0.0, f32::max);
            picture.pixels.iter().zip(&pictures[0].pixels).map(of).map(|off| off / 255.0).collect()
        };
        let errors = pictures.iter().map(off).collect();
        Self { pictures, errors }
    }

    /// What the page shows of them.
    pub fn looks(&self) -> Vec<Look<'_>> {
        let drawn = self.pictures.iter().zip(&self.errors);
        EXAMPLES
            .iter()
            .zip(drawn)
            .map(|(&Example { name, family, about, .. }, (picture, errors))| Look {
                name,
                family,
                about,
                picture: Some(picture),
                errors,
            })
            .collect()
    }
}

/// The page of a report, its truth and looks.
pub fn page<'a>(report: &'a Report, truth: &'a Picture, looks: &'a [Look<'a>]) -> Page<'a> {
    Page { report, truth, looks, tolerance: DEFAULT_TOLERANCE }
}
