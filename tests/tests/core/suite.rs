//! The suite where methods fail: what ships keeps every bound, each method that is known to fail breaks those that it
//! must, and no picture has a pixel that is no number.

use cloudwright_core::method::{Family, METHODS};
use cloudwright_tests::suite::{judge, report, situations};
use std::collections::BTreeSet;

#[test]
fn the_table_is_as_it_says() {
    let rows = judge();
    let faults: Vec<String> =
        rows.iter().flat_map(|row| row.faults.iter().map(|fault| format!("{}: {fault}", row.situation.name))).collect();
    assert!(faults.is_empty(), "{}\n\n{}", faults.join("\n"), report(&rows));
}

/// A method that nothing shows to fail would be none that fails.
#[test]
fn every_failing_method_breaks_something() {
    let broken: BTreeSet<&str> = situations().flat_map(|situation| situation.breaks).copied().collect();
    for method in METHODS.iter().filter(|method| method.family == Family::Failing) {
        assert!(broken.contains(method.name), "{}", method.name);
    }
}

#[test]
fn names_are_unique() {
    let names: BTreeSet<&str> = situations().map(|situation| situation.name).collect();
    assert_eq!(names.len(), situations().count());
}
