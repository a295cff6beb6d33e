//! The house's absences (ARCHITECTURE, invariants 1 and 2).

use cloudwright_tests::root;
use std::fs;
use std::path::Path;

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
