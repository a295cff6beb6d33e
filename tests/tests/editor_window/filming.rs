//! *Render flight…*: the frames of the command line, from the window.

use crate::Window;
use cloudwright::cli;
use cloudwright::command::Command;
use cloudwright::editor::Reply;
use cloudwright_tests::root;
use egui::accesskit::Role;
use egui_kittest::kittest::NodeT;
use std::path::Path;

/// A scene that ships, with a path and cameras, in a folder of its own.
fn flown(folder: &Path) -> Window {
    let scene = folder.join("sky.cloudscene");
    std::fs::copy(root().join("assets/scenes/fair_weather.cloudscene"), &scene).expect("it ships");
    let mut window = Window::open();
    window.harness.state_mut().open_path(&scene);
    window.settle();
    window
}

impl Window {
    fn ask_film(&mut self, [width, height]: [u32; 2]) {
        self.command(Command::RenderFlight);
        self.set("Width", width.into());
        self.set("Height", height.into());
    }

    fn tick(&mut self, what: &str) {
        self.node(Role::CheckBox, what).click();
        self.settle();
    }

    fn film_to(&mut self, to: &Path, said: &str) {
        self.answer(Reply::Path(to.into()));
        self.press("Render…");
        self.wait(said, |window| window.shows(said));
    }
}

/// What `cloudwright fly` makes of the scene in `folder`.
fn flown_by_command_line(folder: &Path, output: &str, options: &[&str]) {
    let (scene, output) = (folder.join("sky.cloudscene"), folder.join(output));
    let mut args = vec!["cloudwright", "fly", scene.to_str().expect("text"), "-o"];
    args.extend(output.to_str());
    args.extend(["--size", "96x54", "--renderer", "cpu"]);
    args.extend(options);
    cli::run(args.into_iter().map(Into::into));
}

#[test]
fn a_films_frames_are_those_of_the_command_line() {
    let folder = tempfile::tempdir().expect("a folder");
    let at = |name: &str| folder.path().join(name);
    let mut window = flown(folder.path());
    let path = window.scene().paths[0].name.clone();
    let camera = window.scene().cameras[0].name.clone();
    let check = |window: &mut Window, name: &str, options: &[&str]| {
        window.film_to(&at(name), "Written: 2 frames, 0 kept");
        let same = format!("same_{name}");
        flown_by_command_line(folder.path(), &same, options);
        let frames: Vec<_> =
            std::fs::read_dir(at(name)).expect("made").flatten().map(|frame| frame.file_name()).collect();
        assert_eq!(frames.len(), 2, "{name}");
        for frame in frames {
            let [by_window, by_line] =
                [name, &same].map(|folder| std::fs::read(at(folder).join(&frame)).expect("there"));
            assert!(by_window == by_line, "{name}: {frame:?}");
        }
    };
    window.ask_film([96, 54]);
    window.choose("Film", &format!("Path {path}"));
    window.choose("File", "Frames, PNG (.png)");
    window.tick("Only some of its frames");
    window.set("First frame", 4.0);
    window.set("Last frame", 5.0);
    assert!(window.shows("2 frames of a film"));
    check(&mut window, "png", &["--path", &path, "--frames", "4-5"]);
    window.ask_film([96, 54]);
    window.choose("Film", &format!("Path {path}"));
    window.choose("File", "Frames, OpenEXR (.exr)");
    window.tick("With layers");
    window.tick("Fade sprites over each other");
    window.set("Frames a second", 2.0);
    window.tick("Only some of its frames");
    window.set("First frame", 1.0);
    window.set("Last frame", 2.0);
    let options =
        ["--path", &path, "--frames", "1-2", "--fps", "2", "--format", "exr", "--layers", "--sorting", "crossfade"];
    check(&mut window, "exr", &options);
    window.ask_film([96, 54]);
    window.choose("Film", &format!("Camera {camera}"));
    window.choose("File", "Frames, PNG (.png)");
    window.set("Duration", 0.5);
    assert!(window.shows("2 frames of a film of 0.50 s"), "at 2 a second, as it was set last");
    check(&mut window, "still", &["--still", &camera, "--seconds", "0.5", "--fps", "2"]);
}

/// The scene has changed since: whoever films again says whether frames that are there are to show that.
#[test]
fn frames_that_are_there_are_lost_or_kept_by_choice_alone() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = flown(folder.path());
    let frames = folder.path().join("frames");
    let draw = |window: &mut Window, there: &str, said: &str| {
        window.ask_film([96, 54]);
        window.choose("File", "Frames, PNG (.png)");
        window.choose("Frames there already", there);
        window.tick("Only some of its frames");
        window.set("Last frame", 1.0);
        window.film_to(&frames, said);
    };
    draw(&mut window, "Stop and say so", "Written: 2 frames, 0 kept");
    let first = || std::fs::read_dir(&frames).expect("made").flatten().map(|frame| frame.path()).min().expect("one");
    let before = std::fs::read(first()).expect("there");
    std::fs::write(first(), [&before[..], b"mine"].concat()).expect("written");
    draw(&mut window, "Stop and say so", "2 frames of these names are in");
    assert!(std::fs::read(first()).expect("there").ends_with(b"mine"));
    window.press("Cancel");
    draw(&mut window, "Keep: go on with a film", "Written: 0 frames, 2 kept");
    assert!(std::fs::read(first()).expect("there").ends_with(b"mine"));
    draw(&mut window, "Draw anew", "Written: 2 frames, 0 kept");
    assert!(std::fs::read(first()).expect("there") == before);
}

#[test]
fn a_film_that_is_stopped_or_refused_says_so() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = flown(folder.path());
    let before = (window.file(), window.undo_name());
    std::fs::write(folder.path().join("taken.mp4"), "mine").expect("written");
    window.ask_film([97, 54]);
    window.film_to(&folder.path().join("odd.mp4"), "odd width or height");
    window.set("Width", 96.0);
    window.film_to(&folder.path().join("none/sky.mp4"), "none");
    // Nobody was asked about what a name gets its ending for.
    window.film_to(&folder.path().join("taken"), "there is a file of that name already");
    window.choose("File", "Frames, PNG (.png)");
    window.film_to(&folder.path().join("sky.mp4"), "frames go into a folder");
    window.choose("Method", "truth");
    window.choose("Samples a pixel", "16");
    window.set("Width", 1280.0);
    window.set("Height", 720.0);
    window.answer(Reply::Path(folder.path().join("stopped")));
    window.press("Render…");
    let progress = window.node(Role::ProgressIndicator, "Progress of Render…").accesskit_node().numeric_value();
    assert!(progress.is_some_and(|share| share < 50.0), "hundreds of frames are to come: {progress:?}");
    window.press("Stop");
    window.wait("that it has stopped", |window| window.shows("Stopped: the frames drawn so far are there"));
    assert_eq!(std::fs::read(folder.path().join("taken.mp4")).expect("there"), b"mine");
    window.press("Cancel");
    assert_eq!((window.file(), window.undo_name()), before, "a film changes nothing");
}

#[test]
fn a_film_tells_how_long_it_will_still_take() {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = flown(folder.path());
    let path = window.scene().paths[0].name.clone();
    window.ask_film([96, 54]);
    window.choose("Film", &format!("Path {path}"));
    window.choose("File", "Frames, PNG (.png)");
    window.answer(Reply::Path(folder.path().join("frames")));
    window.press("Render…");
    window.wait("an estimate", |window| window.shows(" left"));
    window.press("Stop");
    window.wait("the question again", |window| window.shows("Stopped: the frames drawn so far"));
    assert!(!window.shows(" left"));
}
