//! What four panels look like, as small pictures: the ones with widgets of their own. Drawn by Vulkan; without it they
//! show as ignored, or as failed with CLOUDWRIGHT_REQUIRE_GPU=1. `UPDATE_SNAPSHOTS=1` renews tests/snapshots/.
//!
//! A failing one leaves NAME.new.png and NAME.diff.png beside the one that was wanted.

use cloudwright::command::Command;
use cloudwright::editor::{Ask, Editor, FileDialogs, Reply, Start};
use cloudwright::renderer::RendererChoice;
use cloudwright::state::{Item, Selection};
use cloudwright_tests::gpu::{Backend, required};
use cloudwright_tests::root;
use egui_kittest::{Harness, SnapshotOptions, try_image_snapshot_options};
use image::imageops::crop_imm;
use libtest_mimic::{Arguments, Completion, Failed, Trial};
use std::process::ExitCode;
use std::sync::mpsc::Sender;

/// Name, the panel's command, and whether the light look is on.
const CASES: [(&str, Command, bool); 5] = [
    ("colour_levels", Command::LevelsPanel, false),
    ("shading_groups", Command::GroupsPanel, false),
    ("sky", Command::SkyPanel, false),
    ("sky_light", Command::SkyPanel, true),
    ("flight", Command::FlightPanel, false),
];
/// Where they are docked in a window of 1280 × 800: left, top, width, height.
const PANEL: [u32; 4] = [936, 418, 344, 352];
/// Pixels at glyphs' edges that another rasterizer may round otherwise.
const FEW: usize = 60;

fn main() -> ExitCode {
    let mut arguments = Arguments::from_args();
    arguments.test_threads = Some(1);
    let vulkan = Backend::all().into_iter().find(|backend| backend.name == "vulkan");
    let missing = match vulkan.map(|backend| backend.opened) {
        Some(Ok(_)) => None,
        Some(Err(reason)) => Some(reason),
        None => Some("no Vulkan".into()),
    };
    let trials = CASES.map(|(name, command, light)| {
        let missing = missing.clone();
        Trial::ignorable_test(name, move || match missing {
            Some(reason) if required() => Err(Failed::from(reason)),
            Some(_) => Ok(Completion::Ignored { reason: Some("no Vulkan adapter".into()) }),
            None => check(name, command, light).map(|()| Completion::Completed),
        })
    });
    libtest_mimic::run(&arguments, trials.into()).exit_code()
}

/// Nobody asks for files here.
struct NoDialogs;

impl FileDialogs for NoDialogs {
    fn ask(&mut self, _: &Ask, answer: Sender<Reply>, wake: Box<dyn FnOnce() + Send>) {
        let _ = answer.send(Reply::Cancelled);
        wake();
    }
}

fn check(name: &str, command: Command, light: bool) -> Result<(), Failed> {
    let start = Start {
        scene: None,
        start_page: false,
        renderer: RendererChoice::Cpu,
        device: None,
        file_dialogs: Box::new(NoDialogs),
        folders: None,
    };
    let mut harness: Harness<'_, Editor> = Harness::builder()
        .with_size([1280.0, 800.0])
        .wgpu()
        .build_eframe(move |creation| Editor::new(&creation.egui_ctx, start));
    let context = harness.ctx.clone();
    context.set_theme(if light { egui::Theme::Light } else { egui::Theme::Dark });
    harness.run_steps(4);
    let model = &harness.state().session().scene().models[0];
    let chosen = Item::Box(model.id, model.boxes[2].id);
    harness.state_mut().select(Selection::of([chosen]));
    if command == Command::FlightPanel {
        for step in [Command::AddPath, Command::FrameAll, Command::KeyAfterLast, Command::AddAircraft] {
            harness.state_mut().perform(step, &context);
        }
    }
    harness.state_mut().perform(command, &context);
    harness.run_steps(4);
    let picture = harness.render().map_err(Failed::from)?;
    let [left, top, width, height] = PANEL;
    let panel = crop_imm(&picture, left, top, width, height).to_image();
    let options = SnapshotOptions::new().output_path(root().join("tests/snapshots")).max_failed_pixels(FEW);
    try_image_snapshot_options(&panel, name, &options).map_err(|error| Failed::from(error.to_string()))
}
