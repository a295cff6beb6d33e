//! `tests/hostile/`: scripts that mean harm, or are merely wrong. The first line of each says what must be told, in parts
//! that `;` divides. Each stops within 2 s, and there is nothing to apply.
//!
//! What only a process of its own can hold, and so is no row yet: the sum of many values that are each within the
//! limits (call levels × variables × size), and whatever breaks the engine itself rather than a limit.

use crate::{scene, turn};
use cloudwright_scripts::{Fault, Patience, Plugin, ScriptError};
use cloudwright_tests::root;
use std::fs;
use std::time::{Duration, Instant};

const MOST: Duration = Duration::from_secs(2);

fn refused(source: &str) -> Result<(), ScriptError> {
    let plugin = Plugin::read(source)?;
    plugin.run(&scene(), &plugin.values(), &Patience::usual()).map(|_| ())
}

#[test]
fn each_is_stopped_with_its_message() {
    let _turn = turn();
    let mut count = 0;
    let mut wrong = String::new();
    let mut paths: Vec<_> = fs::read_dir(root().join("tests/hostile")).expect("a folder").flatten().collect();
    paths.sort_by_key(fs::DirEntry::path);
    for path in paths.into_iter().map(|entry| entry.path()) {
        let source = fs::read_to_string(&path).expect("text");
        let name = path.file_name().expect("a name").to_string_lossy().into_owned();
        let wanted = source.lines().next().and_then(|line| line.strip_prefix("// expect: ")).expect("what it must say");
        let start = Instant::now();
        let said = refused(&source);
        let took = start.elapsed();
        count += 1;
        match said {
            Ok(()) => wrong += &format!("{name}: it went through\n"),
            Err(error) => {
                let text = error.to_string();
                if error.fault == Fault::Broken || !wanted.split(';').all(|part| text.contains(part.trim())) {
                    wrong += &format!("{name}: no “{wanted}” in: {text}\n");
                }
                let placeless = ["run_is_no_function.rhai", "a_fault_at_the_end.rhai"].contains(&name.as_str());
                if error.place.is_none() && !placeless {
                    wrong += &format!("{name}: no place in: {text}\n");
                }
            }
        }
        if took > MOST {
            wrong += &format!("{name}: took {took:?}\n");
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
