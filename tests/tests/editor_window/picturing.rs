//! Pictures out of the window: into files that are those of the command line, and onto the clipboard.

use crate::Window;
use cloudwright::cli;
use cloudwright::command::Command;
use cloudwright::editor::{Ask, Reply};
use cloudwright::storage::Folders;
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui::{ColorImage, Key, Modifiers, OutputCommand};
use egui_kittest::kittest::Queryable;
use std::cell::RefCell;
use std::path::Path;
use std::sync::Arc;

impl Window {
    /// A saved scene in that folder.
    fn saved_in(folder: &Path, folders: Option<Folders>) -> Self {
        let mut window = Self::open_with(folders);
        window.settle();
        window.answer(Reply::Path(folder.join("sky.cloudscene")));
        window.press("Save");
        window
    }

    pub(crate) fn choose(&mut self, what: &str, value: &str) {
        self.node(Role::ComboBox, what).click();
        self.settle();
        self.harness.get_all_by_label(value).last().expect("a choice").click_accesskit();
        self.settle();
        // A list stays open until the pointer clicks.
        self.node(Role::ComboBox, what).click();
        self.settle();
    }

    fn value(&self, role: Role, label: &str) -> String {
        self.node(role, label).value().unwrap_or_default()
    }

    fn ask_picture(&mut self, [width, height]: [u32; 2]) {
        self.keys(Modifiers::NONE, Key::F12);
        self.set("Width", width.into());
        self.set("Height", height.into());
    }

    fn render_to(&mut self, to: &Path) {
        self.answer(Reply::Path(to.into()));
        self.press("Render…");
    }

    fn render(&mut self, to: &Path) -> Vec<u8> {
        self.render_to(to);
        let written = format!("Written: {}", to.display());
        self.wait("the picture", |window| window.shows(&written) || window.shows("Nothing was written"));
        std::fs::read(to).expect("it was written")
    }
}

/// What `cloudwright render` makes of the scene in `folder`.
fn by_command_line(folder: &Path, output: &str, options: &[&str]) -> Vec<u8> {
    let (scene, output) = (folder.join("sky.cloudscene"), folder.join(output));
    let mut args = vec!["cloudwright", "render", scene.to_str().expect("text"), "-o"];
    args.extend(output.to_str());
    args.extend(["--size", "96x54", "--renderer", "cpu"]);
    args.extend(options);
    cli::run(args.into_iter().map(Into::into));
    std::fs::read(output).expect("it was written")
}

#[test]
fn the_file_is_that_of_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    std::fs::copy(root().join("assets/scenes/fair_weather.cloudscene"), at("sky.cloudscene")).expect("it ships");
    let mut window = Window::open();
    window.harness.state_mut().open_path(&at("sky.cloudscene"));
    window.settle();
    let camera = window.scene().cameras[0].name.clone();
    let check = |name: &str, window: &mut Window, options: &[&str]| {
        let by_window = window.render(&at(name));
        assert!(by_window == by_command_line(folder.path(), &format!("same_{name}"), options), "{name}");
        by_window
    };
    // The view looks through the scene's first camera yet.
    window.ask_picture([96, 54]);
    assert_eq!(window.value(Role::ComboBox, "Camera"), "The view as it is");
    let view = check("view.png", &mut window, &[]);
    let asked = window.script.asked.borrow().last().cloned();
    assert_eq!(asked, Some(Ask::Picture(at("sky.png"))), "it proposes the scene's name");
    window.ask_picture([96, 54]);
    window.choose("Samples a pixel", "4");
    window.choose("Camera", &camera);
    let smooth = check("smooth.png", &mut window, &["--camera", &camera, "--samples", "4"]);
    assert!(view != smooth);
    for _ in 0..3 {
        window.command(Command::SecondOn);
    }
    let at_s = "3";
    window.ask_picture([96, 54]);
    window.choose("Samples a pixel", "As the method has");
    window.choose("Method", "half");
    window.choose("Camera", &camera);
    assert!(window.shows("as it is at 3.0 s of the clock"));
    check("later.png", &mut window, &["--at", at_s, "--method", "half"]);
    window.ask_picture([96, 54]);
    window.choose("Method", "As it ships");
    window.choose("Camera", &camera);
    window.choose("File", "OpenEXR (.exr)");
    check("light.exr", &mut window, &["--at", at_s]);
    window.ask_picture([96, 54]);
    window.choose("Camera", &camera);
    window.node(Role::CheckBox, "With layers").click();
    window.settle();
    check("layers.exr", &mut window, &["--at", at_s, "--layers"]);
    // A file's ending says its kind, whatever was proposed.
    window.ask_picture([96, 54]);
    window.node(Role::CheckBox, "With layers").click();
    window.settle();
    window.choose("Camera", &camera);
    check("light.hdr", &mut window, &["--at", at_s]);
}

#[test]
fn the_view_and_the_hour_that_is_tried_out_are_drawn() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::saved_in(folder.path(), None);
    let draw = |window: &mut Window, name: &str| {
        window.ask_picture([96, 54]);
        window.render(&folder.path().join(name))
    };
    let before = draw(&mut window, "before.png");
    window.command(Command::PlayTime);
    window.harness.run_steps(30);
    window.command(Command::PlayTime);
    let hour = draw(&mut window, "hour.png");
    assert!(before != hour, "by another light");
    window.command(Command::SceneHour);
    assert!(before == draw(&mut window, "again.png"));
    window.command(Command::FrameAll);
    assert!(before != draw(&mut window, "elsewhere.png"), "from elsewhere");
}

#[test]
fn what_is_stopped_or_refused_leaves_no_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::saved_in(folder.path(), None);
    let scene = folder.path().join("sky.cloudscene");
    let saved = std::fs::read(&scene).expect("there");
    let before = (window.file(), window.undo_name());
    let names = || std::fs::read_dir(folder.path()).expect("there").count();
    window.ask_picture([96, 54]);
    for (to, why) in [
        (scene.clone(), "end its name in .png"),
        (folder.path().join("none/sky.png"), "none"),
        (folder.path().join("sky.gif"), "end its name in .png"),
    ] {
        window.render_to(&to);
        window.wait("a refusal", |window| window.shows("Nothing was written") && window.shows(why));
    }
    // Nobody was asked about what a name gets its ending for.
    std::fs::write(folder.path().join("mine.png"), "mine").expect("written");
    window.render_to(&folder.path().join("mine"));
    window.wait("a refusal", |window| window.shows("mine.png"));
    assert_eq!(std::fs::read(folder.path().join("mine.png")).expect("there"), b"mine");
    window.set("Width", 16_384.0);
    window.set("Height", 16_384.0);
    window.render_to(&folder.path().join("large.png"));
    window.wait("a refusal", |window| window.shows("million samples"));
    window.set("Width", 1920.0);
    window.set("Height", 1080.0);
    window.choose("Method", "truth");
    window.choose("Samples a pixel", "16");
    window.render_to(&folder.path().join("stopped.png"));
    window.press("Stop");
    window
        .wait("the question again", |window| window.harness.query_by_role_and_label(Role::Button, "Render…").is_some());
    std::thread::sleep(std::time::Duration::from_millis(500));
    window.settle();
    assert_eq!((names(), std::fs::read(&scene).expect("there")), (2, saved));
    window.press("Cancel");
    assert_eq!((window.file(), window.undo_name()), before, "a picture changes nothing");
}

#[test]
fn what_was_chosen_is_remembered() {
    let home = tempfile::tempdir().expect("a folder");
    let folders = || Some(Folders::within(&home.path().join("user")));
    let mut window = Window::saved_in(home.path(), folders());
    window.ask_picture([96, 54]);
    window.choose("Samples a pixel", "9");
    window.choose("File", "Radiance HDR (.hdr)");
    window.render(&home.path().join("sky.hdr"));
    window.harness.state_mut().leave();
    let mut window = Window::open_with(folders());
    window.settle();
    window.command(Command::RenderPicture);
    let sides = ["Width", "Height"].map(|side| window.value(Role::SpinButton, side));
    let choices = ["Samples a pixel", "File"].map(|choice| window.value(Role::ComboBox, choice));
    assert_eq!(
        (sides, choices),
        (["96 px", "54 px"].map(String::from), ["9", "Radiance HDR (.hdr)"].map(String::from))
    );
}

impl Window {
    /// What *Copy picture* puts onto the clipboard.
    fn copied_picture(&mut self) -> Arc<ColorImage> {
        let copied = RefCell::new(None);
        // It is in one frame's output.
        let context = self.harness.ctx.clone();
        self.harness.state_mut().perform(Command::CopyPicture, &context);
        self.wait("the picture", |window| {
            for command in &window.harness.output().platform_output.commands {
                if let OutputCommand::CopyImage(image) = command {
                    *copied.borrow_mut() = Some(Arc::new(image.clone()));
                }
            }
            copied.borrow().is_some()
        });
        copied.into_inner().expect("it was copied")
    }
}

#[test]
fn an_orthographic_view_is_drawn_as_it_is_seen() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = Window::saved_in(folder.path(), None);
    window.command(Command::FrameAll);
    window.command(Command::FrontView);
    window.command(Command::Orthographic);
    window.settle();
    let seen = window.copied_picture();
    let mut off = |name: &str| {
        window.ask_picture(seen.size.map(|side| u32::try_from(side).expect("small")));
        let drawn = image::load_from_memory(&window.render(&folder.path().join(name))).expect("a picture").to_rgb8();
        assert_eq!([drawn.width(), drawn.height()].map(|side| side as usize), seen.size);
        let pairs = drawn.pixels().zip(&seen.pixels);
        let off = pairs.map(|(a, b)| (0..3).map(|i| f64::from(a.0[i].abs_diff(b.to_array()[i]))).sum::<f64>());
        let off = off.sum::<f64>() / seen.pixels.len() as f64;
        window.command(Command::Orthographic);
        off
    };
    let [parallel, perspective] = ["parallel.png", "perspective.png"].map(&mut off);
    assert!(parallel < 1.0 && perspective > 2.0, "{parallel} and {perspective}");
}

#[test]
fn the_views_picture_is_copied_as_an_image() {
    let mut window = Window::open();
    window.settle();
    let image = window.copied_picture();
    assert!(window.shows(&format!("Copied the picture, {} × {} pixels", image.size[0], image.size[1])));
    assert!(image.size[0] > 300 && image.size[1] > 300, "{:?}", image.size);
    assert!(image.pixels.iter().any(|pixel| *pixel != image.pixels[0]), "clouds and sky");
}
