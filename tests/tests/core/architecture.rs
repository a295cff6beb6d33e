//! The house's absences, and its floors (ARCHITECTURE, invariants 1 and 2).

mod imports;
mod words;

use cloudwright_tests::root;
use imports::{Imports, room};
use std::collections::BTreeSet;
use std::fs;
use std::path::Path;
use words::words;

fn sources(folder: &Path, found: &mut Vec<(String, String)>) {
    for entry in fs::read_dir(folder).expect("a folder of sources").flatten() {
        let path = entry.path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push((path.display().to_string(), fs::read_to_string(&path).expect("a source")));
        }
    }
}

/// No source of `package` has one of `words` outside comments.
fn check_absent(package: &str, words: &[&str]) {
    let mut found = Vec::new();
    sources(&root().join(package).join("src"), &mut found);
    assert!(!found.is_empty(), "no sources in {package}");
    for (path, text) in found {
        for (number, line) in text.lines().enumerate() {
            let code = line.split("//").next().unwrap_or_default();
            for word in words {
                assert!(!code.contains(word), "{path}:{}: {word} has no place in {package}", number + 1);
            }
        }
    }
}

/// `package` names none of `crates` among its dependencies.
fn check_independent(package: &str, crates: &[&str]) {
    let manifest = fs::read_to_string(root().join(package).join("Cargo.toml")).expect("a manifest");
    for name in crates {
        let named = manifest.lines().any(|line| line.split(['.', '=', ' ']).next() == Some(name));
        assert!(!named, "{package} must not depend on {name}");
    }
}

#[test]
fn core_has_no_files_clock_net_or_gpu() {
    check_absent(
        "core",
        &["std::fs", "std::time", "std::net", "std::env", "std::thread", "std::process", "Instant::now"],
    );
    check_independent("core", &["wgpu", "egui", "eframe", "rhai", "rfd", "cloudwright-render"]);
}

#[test]
fn render_and_scripts_do_not_know_each_other() {
    check_independent("render", &["cloudwright-scripts", "egui", "eframe", "rhai", "cloudwright"]);
    check_independent("scripts", &["cloudwright-render", "wgpu", "egui", "eframe", "cloudwright"]);
    check_absent("render", &["std::fs"]);
    // A clock is what a script's run is measured by; a plugin itself has none.
    check_absent("scripts", &["std::fs", "std::net", "std::env", "std::process", "print!("]);
    check_independent("core", &["cloudwright-scripts"]);
}

#[test]
fn only_storage_touches_files() {
    let mut found = Vec::new();
    sources(&root().join("app/src"), &mut found);
    for (path, text) in found.iter().filter(|(path, _)| !path.contains("/src/storage/")) {
        for word in ["std::fs", "File::open", "File::create", "fs::write", "fs::read"] {
            let code = text.lines().filter(|line| !line.trim_start().starts_with("//"));
            assert!(!code.collect::<String>().contains(word), "{path}: {word} belongs in storage/");
        }
    }
}

/// The rooms of app from above: none imports from a room above it, nor from another one beside it.
const APP: [&[&str]; 13] = [
    &["cli"],
    &["editor"],
    &["panel", "viewport"],
    &["widget"],
    &["state"],
    &["exchange"],
    &["reports"],
    &["rendering", "thumbnail"],
    &["saving"],
    &["opening", "plugins", "signals"],
    &["chart", "manual", "storage"],
    &["command"],
    &[
        "picture_hdr",
        "picture_kind",
        "picture_png",
        "renderer",
        "scripting",
        "starter",
        "theme",
        "units",
        "visible",
        "worker",
    ],
];

/// The rooms of core from above, in the same way.
const CORE: [&[&str]; 19] = [
    &["exchange", "fit_light", "thin"],
    &["draw", "method"],
    &["measure", "variants"],
    &["raster"],
    &["frame"],
    &["sight"],
    &["model_in_view", "preset", "reported"],
    &["formats", "traced"],
    &["density"],
    &["posed_sprite", "view_history"],
    &["arrange", "rules", "shading", "sky"],
    &["document", "draw_list"],
    &["detail", "facing", "problem"],
    &["derived", "flight"],
    &["weather"],
    &["panorama"],
    &["camera", "property", "sprites"],
    &["baked", "image", "model_mesh", "scene", "tone"],
    &["change", "color", "math", "random", "spelling", "version", "watch"],
];

/// No import within `package` leads to a room that is no floor below.
fn check_floors(package: &str, floors: &[&[&str]]) {
    let imports = Imports::of(&root().join(package).join("src"));
    let floor = |file: &str| floors.iter().position(|rooms| rooms.contains(&room(file)));
    for (from, to, path) in imports.iter().filter(|(from, to, _)| ![*from, *to].contains(&"lib.rs")) {
        let [Some(own), Some(other)] = [floor(from), floor(to)] else {
            panic!("{from} or {to} of {package} has no floor");
        };
        assert!(own < other || room(from) == room(to), "{package}/src/{from} imports {path}, which is no floor below");
    }
}

#[test]
fn no_import_runs_back() {
    check_floors("app", &APP);
    check_floors("core", &CORE);
}

#[test]
fn variants_are_reached_only_where_methods_are_chosen() {
    let imports = Imports::of(&root().join("core/src"));
    let reach = imports.iter().filter(|(from, to, _)| room(to) == "variants" && room(from) != "variants");
    let from: BTreeSet<&str> = reach.map(|(from, ..)| from).collect();
    assert_eq!(from, ["draw.rs", "method/table.rs"].into());
}

/// Sources of app with one of `names` in them lie in one of `places`, and in each of these are some.
fn check_confined(names: &[&str], places: &[&str]) {
    let src = root().join("app/src");
    let mut found = Vec::new();
    sources(&src, &mut found);
    let src = src.display().to_string() + "/";
    let named: Vec<&str> = found
        .iter()
        .filter(|(_, text)| words(text).iter().any(|word| names.contains(word)))
        .map(|(path, _)| path.trim_start_matches(&src))
        .collect();
    for path in &named {
        assert!(places.iter().any(|place| path.starts_with(place)), "app/src/{path}: {names:?} have no place there");
    }
    for place in places {
        assert!(named.iter().any(|path| path.starts_with(place)), "{place} needs none of {names:?} any more");
    }
}

#[test]
fn window_and_device_are_known_only_where_they_are_needed() {
    check_confined(&["wgpu"], &["editor/window.rs", "viewport/picture/by_gpu.rs"]);
    check_confined(
        &["egui", "eframe"],
        &["cli/edit.rs", "command/", "editor/", "panel/", "state/", "theme/", "thumbnail.rs", "viewport/", "widget/"],
    );
}

#[test]
fn nothing_imports_itself_round_about() {
    let mut circles = String::new();
    for package in ["core", "render", "scripts", "app"] {
        let files = Imports::of(&root().join(package).join("src"));
        assert!(files.iter().count() > 0, "nothing imports anything in {package}");
        for (what, imports) in [("rooms", files.of_rooms()), ("files", files)] {
            circles.extend(imports.circles().iter().map(|circle| format!("{what} of {package}: {circle}")));
        }
    }
    assert!(circles.is_empty(), "{circles}");
}
