//! What one step of a drag costs on the window's thread: `cargo bench -p cloudwright-tests --bench editor`.
//!
//! From a value under the hand to the new draw list, in `overcast` (200 boxes, clouds of some 400 sprites), phase by
//! phase: medians of many steps, in milliseconds and as a multiple of the floor: choosing and sorting the sprites in
//! view, which any new picture needs. Target: from a changed colour level or sprite size to the new draw list in 5 ms.
//!
//! Then whole frames of the editor while a box is dragged there by its field: layout, labels and all, without painting.
//! Target: none over 33 ms. The picture is drawn by all cores meanwhile, so frames wait for one now and then, on a busy
//! machine for long; Linux says how long, and what is left is the frame's own.
//!
//! Then the same for a sky of 4,000 clouds, and its opening. Target: a step in 10 ms, draw list apart.

#![allow(clippy::print_stdout)] // A bench's answer is its table.

use cloudwright::editor::{Editor, NativeDialogs, Start};
use cloudwright::renderer::RendererChoice;
use cloudwright::state::{Item, Selection};
use cloudwright_core::camera::View;
use cloudwright_core::derived::Derived;
use cloudwright_core::detail::{Detail, Subset};
use cloudwright_core::document::{Document, Edit, ListEdit};
use cloudwright_core::draw_list::{Choice, DrawList, Hidden};
use cloudwright_core::facing::{FacingMemory, FacingRule, Poses};
use cloudwright_core::formats::scene_file;
use cloudwright_core::problem;
use cloudwright_core::scene::{Cloud, CloudBox, CloudModel, Scene};
use cloudwright_core::sprites::Atlas;
use cloudwright_core::weather::WeatherRules;
use cloudwright_tests::{authoring, small_scenes};
use egui::accesskit::Role;
use egui::{Event, Modifiers, PointerButton};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable;
use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

const PHASES: [&str; 7] = ["apply", "check", "share", "derive", "list", "total", "commit"];

/// A scene with another value at each step.
type Step = fn(&Scene, u32) -> Edit;

const DRAGS: [(&str, Step); 4] = [
    ("a colour level", |scene, step| {
        let mut model = scene.models[0].clone();
        model.color_levels[2].color.a = 0.5 + 0.001 * step as f32;
        Edit::Model(ListEdit::Replace(model))
    }),
    ("a box's sprite size", |scene, step| {
        let CloudModel { id, boxes, .. } = &scene.models[0];
        let width = boxes[0].width.map(|width| width + f64::from(step));
        Edit::Box(*id, ListEdit::Replace(CloudBox { width, ..boxes[0].clone() }))
    }),
    ("a box's place", |scene, _| {
        let CloudModel { id, boxes, .. } = &scene.models[0];
        let center = boxes[0].center + glam::DVec3::X;
        Edit::Box(*id, ListEdit::Replace(CloudBox { center, ..boxes[0].clone() }))
    }),
    ("a cloud's place", |scene, _| {
        let cloud = scene.clouds[0].clone();
        Edit::Cloud(ListEdit::Replace(Cloud { position: cloud.position + glam::DVec3::X, ..cloud }))
    }),
];

fn main() {
    // `cargo test --benches` passes no --bench: then a few steps show that the bench still runs.
    let steps = if std::env::args().any(|arg| arg == "--bench") { 200 } else { 2 };
    let overcast =
        authoring::SCENES.iter().find(|(name, _)| *name == "overcast").map(|(_, make)| make()).unwrap_or_default();
    let (model, cloud_box) = (overcast.models[0].id, overcast.models[0].boxes[0].id);
    report("overcast", &overcast, steps, (Item::Box(model, cloud_box), "Centre x"));
    let crowd = small_scenes::crowd(4000);
    report("4,000 clouds", &crowd, steps, (Item::Cloud(crowd.clouds[0].id), "Position x"));
}

/// What each drag costs in `scene`, and a frame while the value of `field` is dragged.
fn report(name: &str, scene: &Scene, steps: u32, field: (Item, &str)) {
    println!("{:22}{}", format!("{name}, ms"), PHASES.map(|phase| format!("{phase:>15}")).concat());
    for (name, step) in DRAGS {
        let medians = measure(scene, step, steps);
        let floor = medians[4];
        let cells = medians.map(|ms| format!("{ms:>8.3} {:>5.2}×", ms / floor));
        println!("{name:22}{}", cells.concat());
    }
    let (opened, frames) = frames(scene, steps, field);
    println!(
        "frames while “{}” is dragged: {}\n    less the waiting for a core: {}\n    the first ones after opening: {}\n",
        field.1,
        spread(frames.iter().map(|frame| frame.took)),
        spread(frames.iter().map(|frame| frame.took.saturating_sub(frame.waited))),
        opened.map(|frame| format!("{:.1} ms", ms(frame.took))).join(", ")
    );
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}

/// The middle, the 99th of a hundred, and the longest.
fn spread(times: impl Iterator<Item = Duration>) -> String {
    let mut times: Vec<Duration> = times.collect();
    times.sort_unstable();
    let at = |share: f64| times.get((times.len() as f64 * share) as usize).or(times.last()).copied().map_or(0.0, ms);
    format!("median {:.1} ms, 99 % within {:.1} ms, longest {:.1} ms", at(0.5), at(0.99), at(1.0))
}

/// What a frame took, and how much of that it could have run but had no core.
#[derive(Clone, Copy)]
struct FrameTime {
    took: Duration,
    waited: Duration,
}

/// How long this thread has waited for a core since it began; nothing where the system doesn't say.
fn waited() -> Duration {
    let said = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    Duration::from_nanos(said.split_whitespace().nth(1).and_then(|ns| ns.parse().ok()).unwrap_or_default())
}

/// What the first frames take, and each frame while the number of that label of the selected item is dragged.
fn frames(scene: &Scene, steps: u32, (item, label): (Item, &str)) -> ([FrameTime; 4], Vec<FrameTime>) {
    let folder = tempfile::tempdir().expect("a folder");
    let path = folder.path().join("dragged.cloudscene");
    std::fs::write(&path, scene_file::write(scene).expect("finite numbers")).expect("writable");
    let start = Start {
        scene: Some(path),
        start_page: false,
        renderer: RendererChoice::Cpu,
        device: None,
        file_dialogs: Box::new(NativeDialogs),
        folders: None,
    };
    let mut harness: Harness<'_, Editor> = Harness::builder()
        .with_size([1280.0, 800.0])
        .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start));
    let timed = |harness: &mut Harness<'_, Editor>| {
        let (begun, waited_before) = (Instant::now(), waited());
        harness.step();
        FrameTime { took: begun.elapsed(), waited: waited().saturating_sub(waited_before) }
    };
    let opened = std::array::from_fn(|_| timed(&mut harness));
    harness.state_mut().select(Selection::of([item]));
    harness.run_steps(4);
    let field = harness.get_by_role_and_label(Role::SpinButton, label).rect().center();
    harness.event(Event::PointerMoved(field));
    let (button, modifiers) = (PointerButton::Primary, Modifiers::NONE);
    harness.event(Event::PointerButton { pos: field, button, pressed: true, modifiers });
    harness.step();
    let frame = |step: u32| {
        harness.event(Event::PointerMoved(field + egui::vec2(step as f32, 0.0)));
        timed(&mut harness)
    };
    (opened, (1..=steps).map(frame).collect())
}

fn measure(scene: &Scene, step: Step, steps: u32) -> [f64; PHASES.len()] {
    let mut document = Document::new(scene.clone());
    let mut derived = Arc::new(Derived::new(scene));
    let view = View::new(&scene.cameras[0], 1280, 720);
    let mut times: [Vec<Duration>; PHASES.len()] = Default::default();
    for number in 0..steps {
        let drawn = Arc::clone(&derived); // A picture is being drawn from it.
        let mut phase = 0;
        let edit = step(document.scene(), number);
        let mut clock = Instant::now();
        let begun = clock;
        let mut lap = |times: &mut [Vec<Duration>; PHASES.len()]| {
            times[phase].push(clock.elapsed());
            phase += 1;
            clock = Instant::now();
        };
        document.begin("Drag");
        let change = document.apply(edit).unwrap_or_default();
        lap(&mut times);
        black_box(problem::stays_sound(document.scene(), &change));
        lap(&mut times);
        black_box(Arc::new(document.scene().clone()));
        lap(&mut times);
        Arc::make_mut(&mut derived).update(document.scene(), &change);
        lap(&mut times);
        let clouds = &derived.clouds_at(0.0, WeatherRules::default());
        let poses = &Poses::new(&FacingRule::BOUNDED, clouds, derived.shapes(), &view, &FacingMemory::default());
        let subset = &Subset::new(Detail::FULL, clouds, Atlas::built_in());
        let choice = Choice { clouds, poses, subset, hidden: &Hidden::default(), haze_length_m: f32::INFINITY };
        black_box(DrawList::new(&choice, &view, None));
        lap(&mut times);
        times[5].push(begun.elapsed());
        let ended = Instant::now();
        let _ = document.commit();
        times[6].push(ended.elapsed());
        drop(drawn);
    }
    times.map(|mut times| {
        times.sort_unstable();
        times[times.len() / 2].as_secs_f64() * 1e3
    })
}
