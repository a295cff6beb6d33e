//! Manual and definitions as checked in: what `UPDATE_MANUAL=1` writes, and nothing else.

use cloudwright_scripts::manual;
use std::path::PathBuf;

fn check(name: &str, text: &str) {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../scripts").join(name);
    if std::env::var_os("UPDATE_MANUAL").is_some() {
        std::fs::write(&path, text).expect("writable");
    }
    let there = std::fs::read_to_string(&path).unwrap_or_default();
    assert!(
        there == text,
        "scripts/{name} is stale: UPDATE_MANUAL=1 cargo test -p cloudwright-tests --test scripts manual"
    );
}

#[test]
fn the_manual_is_not_stale() {
    let manual = manual::manual().expect("what ships is read");
    for wanted in ["`grid(", "### Kind `weather`", "(`cumulus_field`)"] {
        assert!(manual.contains(wanted), "{wanted}");
    }
    check("MANUAL.md", &manual);
}

#[test]
fn the_definitions_are_not_stale() {
    let definitions = manual::definitions();
    for wanted in ["module static;", "/// Columns and rows so many metres apart.", "fn grid("] {
        assert!(definitions.contains(wanted), "{wanted}");
    }
    check("definitions/cloudwright.d.rhai", &definitions);
}
