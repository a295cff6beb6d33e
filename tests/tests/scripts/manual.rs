//! Manual and definitions as they are checked in.

use cloudwright_scripts::manual;

#[test]
fn manual_and_definitions_are_not_stale() {
    let manual = manual::manual().expect("what ships is read");
    let definitions = manual::definitions();
    for wanted in ["`grid(", "### Kind `weather`", "(`cumulus_field`)"] {
        assert!(manual.contains(wanted), "{wanted}");
    }
    for wanted in ["module static;", "/// Columns and rows so many metres apart.", "fn grid("] {
        assert!(definitions.contains(wanted), "{wanted}");
    }
    for (name, checked_in, made) in [
        ("MANUAL.md", include_str!("../../../scripts/MANUAL.md"), manual),
        ("cloudwright.d.rhai", include_str!("../../../scripts/definitions/cloudwright.d.rhai"), definitions),
    ] {
        assert!(checked_in == made, "{name} is stale: run `cargo run -p cloudwright-tests --bin renew -- manual`");
    }
}
