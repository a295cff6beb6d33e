//! `tests/hostile/`: scripts that mean harm, or are merely wrong. The first line of each says what must be told, in parts
//! that `;` divides. Each stops, and there is nothing to apply. That it stops within 2 s, however busy the machine, is what
//! its process is for (`app/tests/cage/`, which runs them too).
//!
//! What only a process of its own can hold is in `tests/hostile/caged/`, and no row here: the sum of many values that are
//! each within the limits (call levels × variables × size), and what grows without the engine's notice.

use crate::{scene, turn};
use cloudwright_scripts::{Fault, Patience, Plugin, ScriptError};
use cloudwright_tests::root;
use std::fs;
use std::time::{Duration, Instant};

/// For what would be told in time on a machine that is not busy.
const LONG: Duration = Duration::from_secs(60);

fn refused(source: &str, patience: Duration) -> Result<(), ScriptError> {
    let plugin = Plugin::read(source)?;
    let patience = Patience { until: Some(Instant::now() + patience), ..Patience::usual() };
    plugin.run(&scene(), &plugin.values(), &patience).map(drop)
}

#[test]
fn each_is_stopped_with_its_message() {
    let _turn = turn();
    let mut count = 0;
    let mut wrong = String::new();
    let mut paths: Vec<_> = fs::read_dir(root().join("tests/hostile")).expect("a folder").flatten().collect();
    paths.sort_by_key(fs::DirEntry::path);
    for path in paths.into_iter().map(|entry| entry.path()).filter(|path| path.is_file()) {
        let source = fs::read_to_string(&path).expect("text");
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let wanted = source.lines().next().and_then(|line| line.strip_prefix("// expect: ")).expect("what it must say");
        let is_told = |text: &str| wanted.split(';').all(|part| text.contains(part.trim()));
        let mut said = refused(&source, Patience::USUAL);
        if said.as_ref().is_err_and(|error| error.message.contains("takes too long") && !is_told(&error.to_string())) {
            said = refused(&source, LONG);
        }
        count += 1;
        match said {
            Ok(()) => wrong += &format!("{name}: it went through\n"),
            Err(error) => {
                let text = error.to_string();
                if error.fault == Fault::Broken || !is_told(&text) {
                    wrong += &format!("{name}: no “{wanted}” in: {text}\n");
                }
                let placeless = ["run_is_no_function.rhai", "a_fault_at_the_end.rhai"].contains(&name.as_str());
                if error.place.is_none() && !placeless {
                    wrong += &format!("{name}: no place in: {text}\n");
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong}");
    assert!(count >= 60, "{count}");
}

/// Lists in lists as deep as they may get, however fast the machine: walked and dropped without the stack's end.
#[ignore = "takes a minute where nothing is optimised; run it when STACK_BYTES or LIST_ITEMS change"]
#[test]
fn the_deepest_lists_are_walked_and_dropped() {
    let head = r#"const PLUGIN = #{ name: "Deep", kind: "edit", sentence: "For tests." };"#;
    let source = format!("{head}\nfn run(p) {{ let a = []; loop {{ a = [a]; }} }}");
    let plugin = Plugin::read(&source).expect("a plugin");
    let until = Some(Instant::now() + Duration::from_secs(120));
    let patience = Patience { until, ..Patience::usual() };
    let error = plugin.run(&scene(), &plugin.values(), &patience).expect_err("too deep");
    assert_eq!(error.fault, Fault::Limit, "{error}");
    assert!(error.message.contains("Size of array"), "{error}");
}
